// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include "../command_line/Points.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Openings/flow_extensions.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends.h>
#include <CGAL/Tubular_meshing/Pipelines/Element_target.h>
#include <CGAL/Tubular_meshing/Repair/carry_labels.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

using command_line::point_of;
namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Point_3 Point_3;

namespace {

tubular::Repair_mode repair_mode(const Options& o) {
  typedef tubular::Repair_mode Mode;
  return o.repair == "off" ? Mode::off : o.repair == "wrap" ? Mode::wrap : Mode::automatic;
}

tubular::Volume_mesher volume_mesher(const Options& o) {
  if (o.volume_mesher.empty())
    return tubular::default_volume_mesher();
  return o.volume_mesher == "tetgen" ? tubular::Volume_mesher::tetgen
         : o.volume_mesher == "ccdt" ? tubular::Volume_mesher::ccdt
                                     : tubular::Volume_mesher::mesh_3;
}

// The inlet's name, where it is not given by a point.
std::string name_of_inlet(const Options& o) {
  Point_3 point;
  return command_line::parse_point(o.inlet, point) ? std::string() : o.inlet;
}

// Where the inlet is to be, if that was said: by a point, or by the name of an end, which may be its number.
std::optional<Point_3> inlet_of(const Run& run) {
  Point_3 point;
  if (command_line::parse_point(run.options.inlet, point))
    return point;
  if (run.labels.inlet != tubular::Labelled_ends::none)
    return run.labels.ends[run.labels.inlet].center;
  return std::nullopt;
}

// Where the centerlines that are to be computed begin and end, beside the openings.
std::vector<Point_3> seeds_of(const Run& run) {
  const Options& o = run.options;
  if (!o.seeds.empty())
    return command_line::read_points(o.seeds);
  std::vector<Point_3> seeds;
  if (o.outlets.empty())
    return seeds;
  seeds.push_back(*inlet_of(run));
  for (const std::string& p : o.outlets)
    seeds.push_back(point_of(p));
  return seeds;
}

tubular::Tubular_model with_computed_centerlines(const Run& run, const tubular::Surface& surface) {
  const auto np = tubular::parameters::loops(run.options.loops).seeds(seeds_of(run)).labelled_ends(run.labels);
  if (!run.extensions.openings.empty()) // the inlet has moved
    return tubular::make_tubular_model(surface, np.inlet(run.extensions.openings.front().center));
  if (const auto inlet = inlet_of(run))
    return tubular::make_tubular_model(surface, np.inlet(*inlet));
  return tubular::make_tubular_model(surface, np);
}

tubular::Tubular_model with_given_centerlines(const Run& run, const tubular::Surface& surface,
                                              const tubular::Centerline_polylines& lines) {
  const auto np = tubular::parameters::labelled_ends(run.labels);
  if (const auto inlet = inlet_of(run))
    return tubular::make_tubular_model(surface, lines, np.inlet(*inlet));
  return tubular::make_tubular_model(surface, lines, np);
}

// All that meshers take: each type of mesh reads what matters to it.
auto mesher_parameters(const Run& run, Stage_clock& clock) {
  const Options& o = run.options;
  return tubular::parameters::points_per_circumference(o.points_per_circumference)
      .min_size(o.min_size)
      .max_size(o.max_size)
      .gradation(o.gradation)
      .size_requests(run.sizes)
      .surface_mesher(o.meshes_patches() ? tubular::Surface_mesher::parametric : tubular::Surface_mesher::mesh_3)
      .volume_mesher(volume_mesher(o))
      .in_child_process(true)
      .boundary_layer_prisms(o.is_anisotropic() ? 0 : o.boundary_layer_prisms)
      .boundary_layer_thickness(o.boundary_layer)
      .first_height(o.first_layer())
      .growth(o.growth)
      .smoothing_ratio(o.smoothing_ratio)
      .curvature_points(o.curvature_points)
      .number_of_threads(o.threads)
      .observer([&clock](const char* stage) { clock.begin(stage); });
}

tubular::Surface_elements surface_elements(const Options& o) {
  return o.is_anisotropic_surface()      ? tubular::Surface_elements::anisotropic_triangles
         : o.surface_elements == "quads" ? tubular::Surface_elements::quads
                                         : tubular::Surface_elements::triangles;
}

// The surface as a mesh that has no cells, for the report.
tubular::Mixed_mesh without_cells(const tubular::Remeshed_surface& surface, const tubular::Tubular_model& model) {
  tubular::Mixed_mesh mesh;
  tubular::surface_to_mixed_mesh(surface, mesh);
  mesh.patch_names = tubular::patch_names(model);
  mesh.patch_ids = model.patch_ids;
  return mesh;
}

// The surface is opened where its labels say that vessels end; they say which end is which.
void open_labelled_ends(Run& run, const tubular::IO::Surface_data& data, tubular::Surface& surface) {
  const std::string inlet = name_of_inlet(run.options);
  if (!inlet.empty() && data.labels.empty())
    throw tubular::Parameter_error("No end of the surface is called \"" + inlet +
                                   "\": its file has no names or numbers of faces; give a point, X,Y,Z.");
  if (data.labels.empty())
    return;
  tubular::Face_patch_map label = surface.add_property_map<tubular::Surface::Face_index, int>("f:input_label", 0).first;
  tubular::carry_labels(data.points, data.triangles, data.labels.label, surface, label);
  tubular::Labelled_ends_options options;
  options.label_names = data.labels.names;
  options.label_source = data.labels.source;
  options.wall_label = data.labels.wall;
  options.inlet_name = inlet;
  run.labels = tubular::internal::open_labelled_ends(surface, label, options);
  run.labels.array = data.labels.array;
  surface.remove_property_map(label);
}

// Renames patches, but for those that are among others, which have been renamed already.
void rename(const Options& o, tubular::Label_names& names, const tubular::Label_names& done) {
  for (auto& n : names)
    for (const std::string& r : o.renames)
      if (done.count(n.first) == 0 && r.substr(0, r.find('=')) == n.second) {
        n.second = r.substr(r.find('=') + 1);
        break;
      }
}

std::string list_of(const tubular::Label_names& names) {
  std::string list;
  for (const auto& n : names)
    list += (list.empty() ? "" : ", ") + n.second;
  return list;
}

// Before the work of meshing: each name that is to be changed is there, and no two come to be the same.
void check_renames(const Run& run) {
  const Options& o = run.options;
  const tubular::Label_names lumen = tubular::patch_names(run.model);
  tubular::Label_names names = lumen;
  rename(o, names, {});
  if (o.has_wall())
    tubular::add_wall_patch_names(names, o.second_wall.thickness > 0);
  tubular::Label_names known = names;
  for (const auto& n : lumen)
    known[n.first] = n.second;
  for (const std::string& r : o.renames) {
    const std::string name = r.substr(0, r.find('='));
    if (std::none_of(known.begin(), known.end(), [&](const auto& n) { return n.second == name; }))
      throw tubular::Parameter_error("There is no patch called \"" + name + "\" to be renamed: there are " +
                                     list_of(known) + ".");
  }
  rename(o, names, lumen);
  std::set<std::string> different;
  for (const auto& n : names)
    if (!different.insert(n.second).second)
      throw tubular::Parameter_error("Two patches would be called \"" + n.second + "\": give them different names.");
}

// Sizes that are asked for by place, by branch, and by an array of the surface's file.
tubular::Size_requests size_requests(const Options& o, const tubular::IO::Surface_data& data) {
  tubular::Size_requests sizes;
  for (const std::string& text : o.refined_balls) {
    const auto x = command_line::numbers_of<5>(text);
    sizes.balls.push_back({Point_3(x[0], x[1], x[2]), x[3], x[4]});
  }
  for (const std::string& text : o.refined_branches) {
    const auto x = command_line::numbers_of<2>(text);
    sizes.branches.push_back({std::size_t(x[0]), x[1]});
  }
  if (o.size_array.empty())
    return sizes;
  const auto array = data.point_arrays.find(o.size_array);
  if (array == data.point_arrays.end()) {
    std::string known;
    for (const auto& a : data.point_arrays)
      known += (known.empty() ? "" : ", ") + a.first;
    throw tubular::Input_error("The surface has no point array \"" + o.size_array + "\" of one number a point" +
                               (known.empty() ? ", nor any other." : "; it has " + known + "."));
  }
  tubular::request_sizes(data.points, data.triangles, array->second, sizes);
  return sizes;
}

void make_mesh(Run& run, tubular::Mesher& mesher) {
  if (run.options.makes_surface_only()) {
    run.surface = mesher.surface(surface_elements(run.options));
    run.mesh = without_cells(run.surface, run.model);
    return;
  }
  run.mesh = run.options.is_anisotropic() ? mesher.anisotropic()
             : run.options.is_mixed()     ? mesher.mixed()
                                          : mesher.isotropic();
  run.surface = mesher.kept_surface();
  run.meshing = mesher.report();
}

void add_wall(Run& run, Stage_clock& clock) {
  const Options& o = run.options;
  if (!o.has_wall())
    return;
  clock.begin("wall");
  const auto or_as_the_wall = [](auto given, auto of_the_wall) { return given > 0 ? given : of_the_wall; };
  run.wall = tubular::extrude_wall(run.mesh, tubular::Centerline_field(run.model.centerlines),
                                   tubular::parameters::wall_thickness(o.wall.thickness)
                                       .wall_layers(o.wall.number)
                                       .wall_growth(o.wall.growth)
                                       .tetrahedral_wall(o.wall_elements == "tetrahedra")
                                       .second_wall_thickness(o.second_wall.thickness)
                                       .second_wall_layers(or_as_the_wall(o.second_wall.number, o.wall.number))
                                       .second_wall_growth(or_as_the_wall(o.second_wall.growth, o.wall.growth))
                                       .number_of_threads(o.threads));
  rename(o, run.mesh.patch_names, run.model.patch_names);
}

std::size_t number_of_elements(const Run& run) {
  return run.options.makes_surface_only() ? std::size_t(run.surface.surface.number_of_faces())
                                          : run.mesh.number_of_cells();
}

} // namespace

tubular::Surface read_surface(Run& run, Stage_clock& clock) {
  const Options& o = run.options;
  clock.begin("read");
  const tubular::IO::Surface_data data = tubular::IO::read_surface_data(o.surface, o.faces);
  run.notes = data.notes;
  clock.begin("repair");
  tubular::Surface surface;
  run.repairs = tubular::repair_surface(data.points, data.triangles, surface,
                                        tubular::parameters::repair_mode(repair_mode(o)).smooth(o.smooth));
  open_labelled_ends(run, data, surface);
  run.sizes = size_requests(o, data);
  return surface;
}

void extend_openings(Run& run, tubular::Surface& surface, Stage_clock& clock) {
  const Options& o = run.options;
  if (!(o.flow_extensions > 0))
    return;
  clock.begin("flow extensions");
  const auto inlet = inlet_of(run);
  run.extensions.openings =
      inlet ? tubular::find_openings(surface, tubular::parameters::inlet(*inlet)) : tubular::find_openings(surface);
  const std::vector<std::size_t> end_of = run.labels.match(run.extensions.openings);
  run.extensions.lengths = tubular::add_flow_extensions(surface, run.extensions.openings,
                                                        tubular::parameters::extension_length(o.flow_extensions));
  for (std::size_t i = 0; i < end_of.size(); ++i)
    if (end_of[i] != tubular::Labelled_ends::none)
      run.labels.ends[end_of[i]].center = run.extensions.openings[i].center;
}

void prepare_model(Run& run, const tubular::Surface& surface, Stage_clock& clock) {
  if (run.options.centerlines.empty()) {
    clock.begin("centerlines");
    run.model = with_computed_centerlines(run, surface);
  } else {
    tubular::Centerline_polylines lines;
    tubular::IO::read_centerlines(run.options.centerlines, lines);
    clock.begin("branches, openings");
    run.model = with_given_centerlines(run, surface, lines);
  }
  if (run.options.renames.empty())
    return;
  check_renames(run);
  run.model.patch_names = tubular::patch_names(run.model);
  rename(run.options, run.model.patch_names, {});
  for (auto& opening : run.model.openings)
    opening.name = run.model.patch_names.at(opening.patch);
}

void make_mesh(Run& run, Stage_clock& clock) {
  tubular::Mesher mesher(run.model, mesher_parameters(run, clock));
  const double elements = run.options.elements;
  if (elements == 0) {
    make_mesh(run, mesher);
    add_wall(run, clock);
    return;
  }
  double& points = run.options.points_per_circumference;
  const auto first = run.options.is_anisotropic() ? tubular::Element_target::first_points_of_layers
                                                  : tubular::Element_target::first_points;
  const double power = run.options.makes_surface_only() ? 2
                       : run.options.is_anisotropic()   ? tubular::Element_target::power_of_layers
                                                        : 3;
  tubular::Element_target target(elements, first(elements, points, mesher.estimated_number_of_tetrahedra()), power);
  for (;;) {
    points = target.points();
    mesher.set_points_per_circumference(points);
    make_mesh(run, mesher);
    add_wall(run, clock);
    if (target.add(number_of_elements(run)))
      return;
  }
}

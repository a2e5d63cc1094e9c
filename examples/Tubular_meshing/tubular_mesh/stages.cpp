// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include "walls.h"

#include "../command_line/Points.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Openings/cut_round_ends.h>
#include <CGAL/Tubular_meshing/Openings/flow_extensions.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Pipelines/Element_target.h>
#include <CGAL/Tubular_meshing/Pipelines/Sampled_estimator.h>
#include <CGAL/Tubular_meshing/Quadratic/make_quadratic_mesh.h>
#include <CGAL/Tubular_meshing/Repair/carry_labels.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
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

tubular::Hexahedral_method hexahedral_method(const Options& o) {
  return o.hex_method == "blocks" ? tubular::Hexahedral_method::blocks : tubular::Hexahedral_method::subdivision;
}

tubular::Hexahedral_fallback hexahedral_fallback(const Options& o) {
  typedef tubular::Hexahedral_fallback Fallback;
  if (!o.blocks_output.empty())
    return Fallback::none;
  return o.hex_fallback == "subdivision" ? Fallback::subdivision
         : o.hex_fallback == "mixed"     ? Fallback::mixed
                                         : Fallback::none;
}

// The inlet's name, where it is not given by a point.
std::string name_of_inlet(const Options& o) {
  Point_3 point;
  return command_line::parse_point(o.inlet, point) ? std::string() : o.inlet;
}

std::vector<Point_3> points_of(const std::vector<std::string>& texts) {
  std::vector<Point_3> points;
  for (const std::string& text : texts)
    points.push_back(point_of(text));
  return points;
}

// Without the inlet, where it has a name.
Named_points named_points(const Options& o) {
  Named_points points;
  Point_3 inlet;
  if (command_line::parse_point(o.inlet, inlet))
    points.inlet = inlet;
  points.blind_ends = points_of(o.blind_ends);
  points.ends = o.seeds.empty() ? points_of(o.outlets) : command_line::read_points(o.seeds);
  return points;
}

// The inlet, which a label may name, comes before the outlets.
void begin_at_inlet(Run& run) {
  Named_points& points = run.points;
  if (!points.inlet && run.labels.inlet != tubular::Labelled_ends::none)
    points.inlet = run.labels.ends[run.labels.inlet].center;
  if (!run.options.outlets.empty() && points.inlet)
    points.ends.insert(points.ends.begin(), *points.inlet);
}

// That are openings whatever their size.
std::vector<Point_3> points_at_openings(const Named_points& points) {
  std::vector<Point_3> all = points.ends;
  if (points.inlet)
    all.push_back(*points.inlet);
  return all;
}

std::size_t number_of_parts(const Options& o) {
  return o.parts == "all" ? 0 : o.parts == "largest" ? 1 : std::size_t(std::stoul(o.parts));
}

tubular::Tubular_model with_computed_centerlines(const Run& run, const tubular::Surface& surface) {
  const auto np = tubular::parameters::loops(!run.options.no_loops)
                      .seeds(run.points.ends)
                      .blind_ends(run.points.blind_ends)
                      .single_opening(run.options.single_opening)
                      .number_of_threads(run.options.threads)
                      .labelled_ends(run.labels);
  const auto make = [&](const auto& parameters) {
    return run.is_sampled ? tubular::make_model_without_centerlines(surface, parameters)
                          : tubular::make_tubular_model(surface, parameters);
  };
  if (!run.extensions.openings.empty()) // the inlet has moved
    return make(np.inlet(run.extensions.openings.front().center));
  return run.points.inlet ? make(np.inlet(*run.points.inlet)) : make(np);
}

tubular::Tubular_model with_given_centerlines(const Run& run, const tubular::Surface& surface) {
  const auto np = tubular::parameters::labelled_ends(run.labels);
  if (!run.points.inlet)
    return tubular::make_tubular_model(surface, run.lines, np);
  return tubular::make_tubular_model(surface, run.lines, np.inlet(*run.points.inlet));
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
      .hexahedral_method(hexahedral_method(o))
      .hexahedral_fallback(hexahedral_fallback(o))
      .preserve_volume(o.preserve_volume && !o.is_quadratic()) // whose corners are on the smooth surface
      .number_of_threads(o.threads)
      .observer([&clock](const char* stage) { clock.begin(stage); });
}

tubular::Surface_elements surface_elements(const Options& o) {
  return o.is_anisotropic_surface()                 ? tubular::Surface_elements::anisotropic_triangles
         : o.surface_elements == "quads"            ? tubular::Surface_elements::quads
         : o.surface_elements == "structured-quads" ? tubular::Surface_elements::structured_quads
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

void make_mesh(Run& run, tubular::Mesher& mesher) {
  if (run.options.makes_surface_only()) {
    run.surface = mesher.surface(surface_elements(run.options));
    run.meshing = mesher.report();
    run.mesh = without_cells(run.surface, run.model);
    return;
  }
  run.mesh = run.options.is_anisotropic()  ? mesher.anisotropic()
             : run.options.is_mixed()      ? mesher.mixed()
             : run.options.is_hexahedral() ? mesher.hexahedral()
                                           : mesher.isotropic();
  run.surface = mesher.kept_surface();
  run.blocks = mesher.block_structure();
  run.meshing = mesher.report();
}

void add_wall(Run& run, tubular::Mesher& mesher, Stage_clock& clock) {
  const Options& o = run.options;
  if (!o.has_wall())
    return;
  clock.begin("wall");
  const auto radius = [&](const tubular::Point_3& p) { return mesher.local_radius(p); };
  const auto or_as_the_wall = [](auto given, auto of_the_wall) { return given > 0 ? given : of_the_wall; };
  run.wall = tubular::extrude_wall(run.mesh, radius,
                                   tubular::parameters::wall_thickness(run.walls.thickness)
                                       .wall_materials(run.walls.materials)
                                       .wall_layers(o.wall_layers())
                                       .wall_growth(o.wall_growth())
                                       .tetrahedral_wall(o.wall_elements == "tetrahedra")
                                       .second_wall_thickness(run.walls.second_thickness)
                                       .second_wall_layers(or_as_the_wall(o.second_wall.number, o.wall_layers()))
                                       .second_wall_growth(or_as_the_wall(o.second_wall.growth, o.wall_growth()))
                                       .number_of_threads(o.threads));
}

std::size_t number_of_elements(const Run& run) {
  return run.options.makes_surface_only() ? std::size_t(run.surface.surface.number_of_faces())
                                          : run.mesh.number_of_cells();
}

tubular::Mesh_type mesh_type(const Options& o) {
  typedef tubular::Mesh_type Type;
  return o.makes_surface_only() ? Type::surface
         : o.is_anisotropic()   ? Type::anisotropic
         : o.is_mixed()         ? Type::mixed
         : o.is_hexahedral()    ? Type::hexahedral
                                : Type::isotropic;
}

// The layers that add_wall() adds to the mesh.
void add_wall(tubular::Mesh_estimate& estimate, const Options& o) {
  if (!o.has_wall())
    return;
  const int second = !o.has_second_wall() ? 0 : o.second_wall.number > 0 ? o.second_wall.number : o.wall_layers();
  estimate.add_wall(o.wall_layers() + second, o.wall_elements == "tetrahedra");
}

std::deque<tubular::Mesher> meshers_of(std::vector<Part>& parts, Stage_clock& clock) {
  std::deque<tubular::Mesher> meshers;
  for (Part& part : parts)
    meshers.emplace_back(part.run.model, mesher_parameters(part.run, clock));
  return meshers;
}

// What tells how many cells there will be: along the centerlines, or by samples of the wall.
typedef std::variant<tubular::Mesher, tubular::Sampled_estimator> Estimator;

std::deque<Estimator> estimators_of(std::vector<Part>& parts, Stage_clock& clock) {
  std::deque<Estimator> estimators;
  for (Part& part : parts) {
    const auto parameters = mesher_parameters(part.run, clock);
    if (!part.run.is_sampled) {
      estimators.emplace_back(std::in_place_type<tubular::Mesher>, part.run.model, parameters);
      continue;
    }
    clock.begin("estimate");
    estimators.emplace_back(std::in_place_type<tubular::Sampled_estimator>, part.run.model, parameters);
  }
  return estimators;
}

// Tells who follows the run how much there is to do, by the mesh size, which is needed in any case.
void expect_meshing(const std::vector<Part>& parts, std::deque<tubular::Mesher>& meshers, Stage_clock& clock) {
  const Options& o = parts.front().run.options;
  if (!clock.listener() || !clock.listener()->wants_estimate() || o.elements > 0 || o.is_anisotropic_surface())
    return;
  double triangles = 0, tetrahedra = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    triangles += double(parts[k].run.model.surface.number_of_faces());
    tetrahedra += meshers[k].estimated_number_of_tetrahedra();
  }
  clock.listener()->expect_meshing(o, triangles, tetrahedra);
}

} // namespace

tubular::Surface read_surface(Run& run, Stage_clock& clock) {
  clock.begin("read");
  const tubular::IO::Surface_data data = tubular::IO::read_surface_data(run.options.surface, run.options.faces);
  tubular::Surface surface = repair(run, data, clock);
  take_requests(run, data, surface);
  return surface;
}

tubular::Surface repair(Run& run, const tubular::IO::Surface_data& data, Stage_clock& clock) {
  const Options& o = run.options;
  const std::vector<Point_3> at_openings = points_at_openings(named_points(o));
  if (clock.listener())
    clock.listener()->expect_preparation(o, double(data.triangles.size()));
  clock.begin("repair");
  tubular::Surface surface;
  run.repairs = tubular::repair_surface(data.points, data.triangles, surface,
                                        tubular::parameters::repair_mode(repair_mode(o))
                                            .smooth(o.smooth)
                                            .number_of_parts(number_of_parts(o))
                                            .filled_holes(points_of(o.filled_holes))
                                            .kept_openings(at_openings));
  return surface;
}

void take_requests(Run& run, const tubular::IO::Surface_data& data, tubular::Surface& surface) {
  const Options& o = run.options;
  run.notes = data.notes;
  run.points = named_points(o);
  open_labelled_ends(run, data, surface);
  begin_at_inlet(run);
  run.sizes = size_requests(o, data);
  run.walls = wall_requests(o, data);
  if (!o.centerlines.empty())
    tubular::IO::read_centerlines(o.centerlines, run.lines);
}

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
    add_names_of(data.point_arrays, known);
    throw tubular::Input_error("The surface has no point array \"" + o.size_array + "\" of one number a point" +
                               (known.empty() ? ", nor any other." : "; it has " + known + "."));
  }
  tubular::request_sizes(data.points, data.triangles, array->second, sizes);
  return sizes;
}

void cut_ends(Run& run, tubular::Surface& surface, Stage_clock& clock) {
  const Options& o = run.options;
  if (o.cut_ends) {
    clock.begin("ends");
    run.round_ends = tubular::cut_round_ends(
        surface, tubular::parameters::ends_to_cut(run.points.ends).blind_ends(run.points.blind_ends));
  } else if (o.flow_extensions > 0) { // else the model does it
    clock.begin("ends");
    run.round_ends = tubular::open_round_ends(surface, run.points.ends, run.points.blind_ends);
  } else
    return;
  if (!run.points.ends.empty()) { // there are openings at all of them now
    run.points.inlet = run.points.ends.front();
    run.points.ends.clear();
  }
}

void extend_openings(Run& run, tubular::Surface& surface, Stage_clock& clock) {
  const Options& o = run.options;
  if (!(o.flow_extensions > 0))
    return;
  clock.begin("flow extensions");
  const auto np = tubular::parameters::blind_ends(run.points.blind_ends);
  run.extensions.openings = run.points.inlet ? tubular::find_openings(surface, np.inlet(*run.points.inlet))
                                             : tubular::find_openings(surface, np);
  const std::vector<std::size_t> end_of = run.labels.match(run.extensions.openings);
  run.extensions.lengths = tubular::add_flow_extensions(surface, run.extensions.openings,
                                                        tubular::parameters::extension_length(o.flow_extensions));
  for (std::size_t i = 0; i < end_of.size(); ++i)
    if (end_of[i] != tubular::Labelled_ends::none)
      run.labels.ends[end_of[i]].center = run.extensions.openings[i].center;
}

bool is_to_be_sampled(const Run& run, std::size_t triangles, Stage_clock& clock) {
  const Options& o = run.options;
  const std::size_t many = 100000; // fewer take no more than some seconds
  const bool asks_for_branches = o.verbose || !o.refined_branches.empty() || !run.walls.of_branches.empty();
  return o.dry_run && triangles >= many && !asks_for_branches && run.lines.lines.empty() && run.sizes.empty() &&
         tubular::Sampled_estimator::can_estimate(tubular::Mesher_options(mesher_parameters(run, clock)));
}

void prepare_model(Run& run, const tubular::Surface& surface, Stage_clock& clock) {
  const bool are_given = !run.lines.lines.empty();
  clock.begin(are_given ? "branches, openings" : run.is_sampled ? "openings" : "centerlines");
  run.model = are_given ? with_given_centerlines(run, surface) : with_computed_centerlines(run, surface);
  for (const auto& end : run.model.round_ends)
    if (std::none_of(run.round_ends.begin(), run.round_ends.end(), [&](const auto& known) { // kept before, too
          return !end.is_cut && !known.is_cut &&
                 CGAL::squared_distance(end.center, known.center) < end.radius * end.radius;
        }))
      run.round_ends.push_back(end);
}

// The power of N that the number of elements goes with.
double power_of_points(const Options& o) {
  return o.makes_surface_only() ? 2 : o.is_anisotropic() ? tubular::Element_target::power_of_layers : 3;
}

/* What is expected of the meshes of all parts, once N is set for the number of elements that is wanted. estimate(k),
 * points() and set_points(k, N) are those of what estimates. */
template <class Estimate, class Points, class SetPoints>
std::vector<tubular::Mesh_estimate> fitted_estimates(std::vector<Part>& parts, const Estimate& estimate,
                                                     const Points& points, const SetPoints& set_points) {
  const Options& o = parts.front().run.options;
  std::vector<tubular::Mesh_estimate> estimates;
  const auto expected = [&](double points) {
    estimates.clear();
    double elements = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      parts[k].run.options.points_per_circumference = points;
      set_points(k, points);
      estimates.push_back(estimate(k));
      add_wall(estimates.back(), o);
      elements += o.makes_surface_only() ? estimates.back().facets() : estimates.back().cells();
    }
    return elements;
  };
  if (o.elements == 0)
    expected(points());
  else
    tubular::Element_target::first_points(o.elements, points(), power_of_points(o), expected);
  return estimates;
}

std::vector<tubular::Mesh_estimate> estimate_meshes(std::vector<Part>& parts, Stage_clock& clock) {
  const Options& o = parts.front().run.options;
  std::deque<Estimator> estimators = estimators_of(parts, clock);
  return fitted_estimates(
      parts,
      [&](std::size_t k) {
        return std::visit([&](auto& e) { return e.estimate(mesh_type(o), surface_elements(o)); }, estimators[k]);
      },
      [&] { return std::visit([](auto& e) { return e.points_per_circumference(); }, estimators.front()); },
      [&](std::size_t k, double points) {
        std::visit([&](auto& e) { e.set_points_per_circumference(points); }, estimators[k]);
      });
}

void make_meshes(std::vector<Part>& parts, Stage_clock& clock) {
  std::deque<tubular::Mesher> meshers = meshers_of(parts, clock);
  expect_meshing(parts, meshers, clock);
  const auto make_all = [&] {
    std::size_t elements = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      make_mesh(parts[k].run, meshers[k]);
      add_wall(parts[k].run, meshers[k], clock);
      elements += number_of_elements(parts[k].run);
    }
    return elements;
  };
  const Options& o = parts.front().run.options;
  if (o.elements == 0) {
    make_all();
    return;
  }
  fitted_estimates(
      parts, [&](std::size_t k) { return meshers[k].estimate(mesh_type(o), surface_elements(o)); },
      [&] { return meshers.front().points_per_circumference(); },
      [&](std::size_t k, double points) { meshers[k].set_points_per_circumference(points); });
  tubular::Element_target target(o.elements, meshers.front().points_per_circumference(), power_of_points(o));
  for (;;) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      parts[k].run.options.points_per_circumference = target.points();
      meshers[k].set_points_per_circumference(target.points());
    }
    if (target.add(make_all()))
      return;
  }
}

// Measured anew, as the meshers are gone.
tubular::Local_radius local_radius(const Run& run) {
  return tubular::Local_radius(tubular::Centerline_field(run.model.centerlines),
                               tubular::Wall_distance(run.model.surface, run.model.patch, tubular::labels::wall),
                               tubular::parameters::number_of_threads(run.options.threads));
}

void curve(Run& run, Stage_clock& clock) {
  const Options& o = run.options;
  if (!o.is_quadratic())
    return;
  clock.begin("quadratic elements");
  run.curving = tubular::make_quadratic_mesh(
      std::move(run.mesh), run.model.surface, run.model.patch, local_radius(run), run.quadratic,
      tubular::parameters::complete_elements(o.complete_elements).number_of_threads(o.threads));
  run.mesh = tubular::Mixed_mesh();
  if (run.curving.invalid == 0)
    return;
  const Point_3& p = run.curving.invalid_place;
  std::ostringstream place;
  place << "(" << p.x() << ", " << p.y() << ", " << p.z() << ")";
  throw tubular::Meshing_error(std::to_string(run.curving.invalid) +
                               " cells are not valid as elements of order 2, even with straight edges, one near " +
                               place.str() + ": make a finer mesh, or leave --order 2 away.");
}

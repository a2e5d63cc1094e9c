// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include "../command_line/Points.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Openings/cut_round_ends.h>
#include <CGAL/Tubular_meshing/Openings/flow_extensions.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>

#include <array>
#include <cstddef>
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

std::vector<Point_3> points_of(const std::vector<std::string>& texts) {
  std::vector<Point_3> points;
  for (const std::string& text : texts)
    points.push_back(point_of(text));
  return points;
}

Named_points named_points(const Options& o) {
  Named_points points;
  if (!o.inlet.empty())
    points.inlet = point_of(o.inlet);
  points.blind_ends = points_of(o.blind_ends);
  if (!o.seeds.empty())
    points.ends = command_line::read_points(o.seeds);
  else if (!o.outlets.empty()) {
    points.ends = points_of(o.outlets);
    points.ends.insert(points.ends.begin(), *points.inlet);
  }
  return points;
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
  const auto np = tubular::parameters::loops(run.options.loops)
                      .seeds(run.points.ends)
                      .blind_ends(run.points.blind_ends)
                      .single_opening(run.options.single_opening);
  if (!run.extensions.openings.empty()) // the inlet has moved
    return tubular::make_tubular_model(surface, np.inlet(run.extensions.openings.front().center));
  if (run.points.inlet)
    return tubular::make_tubular_model(surface, np.inlet(*run.points.inlet));
  return tubular::make_tubular_model(surface, np);
}

tubular::Tubular_model with_given_centerlines(const Run& run, const tubular::Surface& surface) {
  if (!run.points.inlet)
    return tubular::make_tubular_model(surface, run.lines);
  return tubular::make_tubular_model(surface, run.lines, tubular::parameters::inlet(*run.points.inlet));
}

// All that meshers take: each type of mesh reads what matters to it.
auto mesher_parameters(const Options& o, Stage_clock& clock) {
  return tubular::parameters::points_per_circumference(o.points_per_circumference)
      .min_size(o.min_size)
      .max_size(o.max_size)
      .gradation(o.gradation)
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
tubular::Mixed_mesh without_cells(const tubular::Remeshed_surface& surface, std::size_t number_of_openings) {
  tubular::Mixed_mesh mesh;
  tubular::surface_to_mixed_mesh(surface, mesh);
  mesh.patch_names = tubular::lumen_patch_names(int(number_of_openings));
  return mesh;
}

} // namespace

tubular::Surface read_surface(Run& run, Stage_clock& clock) {
  clock.begin("read");
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  tubular::IO::read_triangle_soup(run.options.surface, points, triangles);
  run.points = named_points(run.options);
  clock.begin("repair");
  tubular::Surface surface;
  run.repairs = tubular::repair_surface(points, triangles, surface,
                                        tubular::parameters::repair_mode(repair_mode(run.options))
                                            .smooth(run.options.smooth)
                                            .number_of_parts(number_of_parts(run.options))
                                            .filled_holes(points_of(run.options.filled_holes))
                                            .kept_openings(points_at_openings(run.points)));
  if (!run.options.centerlines.empty())
    tubular::IO::read_centerlines(run.options.centerlines, run.lines);
  return surface;
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
  run.extensions.openings = run.points.inlet
                                ? tubular::find_openings(surface, tubular::parameters::inlet(*run.points.inlet))
                                : tubular::find_openings(surface);
  run.extensions.lengths = tubular::add_flow_extensions(surface, run.extensions.openings,
                                                        tubular::parameters::extension_length(o.flow_extensions));
}

void prepare_model(Run& run, const tubular::Surface& surface, Stage_clock& clock) {
  const bool are_given = !run.lines.lines.empty();
  clock.begin(are_given ? "branches, openings" : "centerlines");
  run.model = are_given ? with_given_centerlines(run, surface) : with_computed_centerlines(run, surface);
  const auto& ends = run.model.round_ends;
  run.round_ends.insert(run.round_ends.end(), ends.begin(), ends.end());
}

void make_mesh(Run& run, Stage_clock& clock) {
  tubular::Mesher mesher(run.model, mesher_parameters(run.options, clock));
  if (run.options.makes_surface_only()) {
    run.surface = mesher.surface(surface_elements(run.options));
    run.mesh = without_cells(run.surface, run.model.openings.size());
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
}

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include "../command_line/Points.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Openings/flow_extensions.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/base/labels.h>

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

// Where the centerlines that are to be computed begin and end, beside the openings.
std::vector<Point_3> seeds_of(const Options& o) {
  if (!o.seeds.empty())
    return command_line::read_points(o.seeds);
  std::vector<Point_3> seeds;
  if (o.outlets.empty())
    return seeds;
  seeds.push_back(point_of(o.inlet));
  for (const std::string& p : o.outlets)
    seeds.push_back(point_of(p));
  return seeds;
}

tubular::Tubular_model with_computed_centerlines(const Run& run, const tubular::Surface& surface) {
  const auto np = tubular::parameters::loops(run.options.loops).seeds(seeds_of(run.options));
  if (!run.extensions.openings.empty()) // the inlet has moved
    return tubular::make_tubular_model(surface, np.inlet(run.extensions.openings.front().center));
  if (!run.options.inlet.empty())
    return tubular::make_tubular_model(surface, np.inlet(point_of(run.options.inlet)));
  return tubular::make_tubular_model(surface, np);
}

tubular::Tubular_model with_given_centerlines(const Run& run, const tubular::Surface& surface,
                                              const tubular::Centerline_polylines& lines) {
  if (run.options.inlet.empty())
    return tubular::make_tubular_model(surface, lines);
  return tubular::make_tubular_model(surface, lines, tubular::parameters::inlet(point_of(run.options.inlet)));
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
      .preserve_volume(o.preserve_volume)
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
  clock.begin("repair");
  tubular::Surface surface;
  run.repairs =
      tubular::repair_surface(points, triangles, surface,
                              tubular::parameters::repair_mode(repair_mode(run.options)).smooth(run.options.smooth));
  return surface;
}

void extend_openings(Run& run, tubular::Surface& surface, Stage_clock& clock) {
  const Options& o = run.options;
  if (!(o.flow_extensions > 0))
    return;
  clock.begin("flow extensions");
  run.extensions.openings = o.inlet.empty()
                                ? tubular::find_openings(surface)
                                : tubular::find_openings(surface, tubular::parameters::inlet(point_of(o.inlet)));
  run.extensions.lengths = tubular::add_flow_extensions(surface, run.extensions.openings,
                                                        tubular::parameters::extension_length(o.flow_extensions));
}

void prepare_model(Run& run, const tubular::Surface& surface, Stage_clock& clock) {
  if (run.options.centerlines.empty()) {
    clock.begin("centerlines");
    run.model = with_computed_centerlines(run, surface);
    return;
  }
  tubular::Centerline_polylines lines;
  tubular::IO::read_centerlines(run.options.centerlines, lines);
  clock.begin("branches, openings");
  run.model = with_given_centerlines(run, surface, lines);
}

void make_mesh(Run& run, Stage_clock& clock) {
  tubular::Mesher mesher(run.model, mesher_parameters(run.options, clock));
  if (run.options.makes_surface_only()) {
    run.surface = mesher.surface(surface_elements(run.options));
    run.meshing = mesher.report();
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
  const tubular::Local_radius radius(tubular::Centerline_field(run.model.centerlines),
                                     tubular::Wall_distance(run.model.surface, run.model.patch, tubular::labels::wall),
                                     tubular::parameters::number_of_threads(o.threads));
  const auto or_as_the_wall = [](auto given, auto of_the_wall) { return given > 0 ? given : of_the_wall; };
  run.wall = tubular::extrude_wall(run.mesh, radius,
                                   tubular::parameters::wall_thickness(o.wall.thickness)
                                       .wall_layers(o.wall.number)
                                       .wall_growth(o.wall.growth)
                                       .tetrahedral_wall(o.wall_elements == "tetrahedra")
                                       .second_wall_thickness(o.second_wall.thickness)
                                       .second_wall_layers(or_as_the_wall(o.second_wall.number, o.wall.number))
                                       .second_wall_growth(or_as_the_wall(o.second_wall.growth, o.wall.growth))
                                       .number_of_threads(o.threads));
}

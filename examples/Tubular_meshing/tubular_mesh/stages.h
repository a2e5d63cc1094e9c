// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_STAGES_H
#define TUBULAR_MESH_STAGES_H

// The stages of a run that take long, to compile as well: each is a translation unit of its own.

#include "Options.h"
#include "Stage_clock.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/Repair/Repair_report.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <functional>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<Point_3> Surface;
namespace tubular = CGAL::Tubular_meshing;

// The surface, mended.
tubular::Repair_report read_surface(const Options& o, Surface& surface, Stage_clock& clock);

/* Straight tubes at the openings. The list is of the openings where they are now, the inlet first, and of the tubes'
 * lengths; empty where none were asked for. */
struct Flow_extensions {
  std::vector<tubular::Opening> openings;
  std::vector<double> lengths;
};
Flow_extensions extend_openings(const Options& o, Surface& surface, Stage_clock& clock);

// The surface with its openings, and its centerlines, given or computed.
tubular::Tubular_model prepare(const Options& o, const Surface& surface, const Flow_extensions& extensions,
                               Stage_clock& clock);

// The surface mesh alone.
tubular::Remeshed_surface make_surface_mesh(const Options& o, const tubular::Tubular_model& model, Stage_clock& clock);

// The cells of the lumen; with the parametric surface mesher, `surface` becomes the surface mesh. `boundary_layer` is
// told of layers of prisms or hexahedra.
tubular::Mixed_mesh make_mesh(const Options& o, const tubular::Tubular_model& model, tubular::Remeshed_surface& surface,
                              tubular::Layer_report& boundary_layer, Stage_clock& clock);

// What this is for the types that need another mesher.
tubular::Mixed_mesh make_anisotropic_mesh(const Options& o, const tubular::Tubular_model& model, Stage_clock& clock);
tubular::Mixed_mesh make_mixed_mesh(const Options& o, const tubular::Tubular_model& model,
                                    tubular::Remeshed_surface& surface, tubular::Layer_report& boundary_layer,
                                    Stage_clock& clock);

// The walls around it.
tubular::Layer_report add_wall(const Options& o, const tubular::Tubular_model& model, tubular::Mixed_mesh& mesh,
                               Stage_clock& clock);

// The mesher that was asked for, or the default.
tubular::Volume_mesher volume_mesher(const Options& o);

// Why a volume mesher is not there; empty if it is.
std::string why_not_filled_by(const std::string& volume_mesher);

// The named parameters that all of these take.
inline auto meshing_parameters(const Options& o, Stage_clock& clock) {
  return tubular::parameters::points_per_circumference(o.points_per_circumference)
      .min_size(o.min_size)
      .max_size(o.max_size)
      .gradation(o.gradation)
      .number_of_threads(o.threads)
      .in_child_process(true)
      .observer([&clock](const char* stage) { clock.begin(stage); });
}

// Those of anisotropic meshes.
inline auto metric_parameters(const Options& o, Stage_clock& clock) {
  return meshing_parameters(o, clock)
      .boundary_layer_thickness(o.boundary_layer)
      .first_height(o.first_layer())
      .growth(o.growth)
      .smoothing_ratio(o.smoothing_ratio)
      .curvature_points(o.curvature_points);
}

// Those of the lumen's cells between a surface that is kept.
inline auto lumen_parameters(const Options& o, tubular::Layer_report& boundary_layer, Stage_clock& clock) {
  return meshing_parameters(o, clock)
      .volume_mesher(volume_mesher(o))
      .boundary_layer_prisms(o.boundary_layer_prisms)
      .boundary_layer_thickness(o.boundary_layer)
      .first_height(o.first_layer())
      .growth(o.growth)
      .boundary_layer_report(std::ref(boundary_layer));
}

#endif // TUBULAR_MESH_STAGES_H

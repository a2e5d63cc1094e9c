// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_FILL_WITHIN_LAYERS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_FILL_WITHIN_LAYERS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Layers/append_mesh.h>
#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Model_in_its_frame.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Stage_observer.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <functional>
#include <utility>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// Whether layers of cells are wanted inside the lumen.
template <class NamedParameters> bool wants_boundary_layer(const NamedParameters& np) {
  return choose(np, internal_np::boundary_layer_prisms, 0) != 0;
}

/* Meshes the lumen by fill(surface, patch, mesh): all of it, or, where layers are wanted along the wall, what they
 * leave of it. All in the model's frame. */
template <class Fill, class NamedParameters>
void fill_within_layers(const Remeshed_surface& surface, const Model_in_its_frame& framed, const Fill& fill,
                        Mixed_mesh& mesh, const NamedParameters& np) {
  typedef std::reference_wrapper<Layer_report> Report;
  if (!wants_boundary_layer(np))
    return fill(surface.surface, surface.patch, mesh);
  stage_observer(np)("boundary layer");
  auto layer = extrude_boundary_layer(surface.surface, surface.patch, Centerline_field(framed.centerlines()), np);
  Layer_report unheard;
  Layer_report& report = choose(np, internal_np::boundary_layer_report, Report(unheard));
  report = layer.report;
  report.worst_place = framed.from_frame(report.worst_place);
  Mixed_mesh inside;
  try {
    fill(layer.inner, layer.patch, inside);
  } catch (const Meshing_error&) { // its places are in the frame
    throw Meshing_error("Inside of the boundary layers the lumen cannot be filled: ask for fewer or thinner layers, or "
                        "for a finer mesh.");
  }
  append_mesh(layer.layers, inside, layer.mesh_points);
  mesh = std::move(layer.layers);
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_FILL_WITHIN_LAYERS_H

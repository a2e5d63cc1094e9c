// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_BOUNDARY_LAYER_IMPL_H
#define CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_BOUNDARY_LAYER_IMPL_H

#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Layers/internal/Boundary_layer_maker.h>
#include <CGAL/Tubular_meshing/Layers/internal/labelled_facets.h>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE Boundary_layer extrude_boundary_layer(const Surface& surface, Face_patch_map patch,
                                                                  Length_function radius,
                                                                  const Extrude_boundary_layer_options& options) {
  const Boundary_layer_heights heights(options);
  Boundary_layer result;
  Boundary_layer_maker(labelled_facets(surface, patch), heights, result).run(radius);
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_BOUNDARY_LAYER_IMPL_H

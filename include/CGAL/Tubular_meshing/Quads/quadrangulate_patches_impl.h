// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_PATCHES_IMPL_H
#define CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_PATCHES_IMPL_H

#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher.h>
#include <CGAL/Tubular_meshing/Quads/internal/surface/Quad_piece_mesher.h>
#include <CGAL/Tubular_meshing/Quads/internal/surface/make_quad_report.h>
#include <CGAL/Tubular_meshing/Quads/quadrangulate_patches.h>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE Remeshed_surface quadrangulate_patches(const Surface& surface, const Surface_cut& cut,
                                                                   const std::vector<Patch_parameterization>& maps,
                                                                   Length_function size,
                                                                   const Quadrangulate_patches_options& options) {
  Quad_piece_mesher mesher(surface, cut, maps, size, options.quad_caps, options.number_of_threads);
  Remeshed_surface result = mesh_by_pieces(mesher);
  result.quads = make_quad_report(result, mesher.kinds());
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_PATCHES_IMPL_H

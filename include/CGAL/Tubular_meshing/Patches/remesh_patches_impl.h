// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_REMESH_PATCHES_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_REMESH_PATCHES_IMPL_H

#include <CGAL/Tubular_meshing/Patches/remesh_patches.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Metric_sizes.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Surface_sizes.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Triangle_piece_mesher.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <vector>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE Remeshed_surface remesh_patches_by_size(const Surface& surface, const Surface_cut& cut,
                                                                    const std::vector<Patch_parameterization>& maps,
                                                                    Length_function size,
                                                                    const Remesh_patches_options& options) {
  const Isotropic_sizes sizes(maps, size);
  Triangle_piece_mesher mesher(surface, cut, maps, sizes, options.even_curves, options.number_of_threads);
  return mesh_by_pieces(mesher);
}

CGAL_TUBULAR_MESHING_INLINE Remeshed_surface remesh_patches_by_metric(const Surface& surface, const Surface_cut& cut,
                                                                      const std::vector<Patch_parameterization>& maps,
                                                                      Metric_function metric,
                                                                      const Remesh_patches_options& options) {
  const Metric_sizes sizes(surface, cut, maps, metric);
  Triangle_piece_mesher mesher(surface, cut, maps, sizes, options.even_curves, options.number_of_threads);
  Remeshed_surface result = mesh_by_pieces(mesher);
  for (auto v : result.surface.vertices())
    result.metrics.push_back(metric(result.surface.point(v)));
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_REMESH_PATCHES_IMPL_H

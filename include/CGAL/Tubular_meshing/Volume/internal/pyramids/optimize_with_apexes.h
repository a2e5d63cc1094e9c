// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_OPTIMIZE_WITH_APEXES_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_OPTIMIZE_WITH_APEXES_H

#include <CGAL/Tubular_meshing/Volume/internal/Vertex_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Kept_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/remesh_worst.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/write_inside.h>
#include <CGAL/Tubular_meshing/Volume/internal/optimize_in_passes.h>
#include <CGAL/Tubular_meshing/Volume/internal/pyramids/Apex_optimizer.h>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Improves tetrahedra as optimize_inside() does, and the pyramids on whose sides they stand with them: the sides, which
 * are labelled facets of the tetrahedra, stay as triangles, but their apexes move. */
inline void optimize_with_apexes(Mixed_mesh& mesh, int passes, int threads) {
  const Kept_boundary boundary;
  Tetrahedron_store store(mesh);
  const auto move_vertices = [&](int) {
    Apex_optimizer apexes(store, mesh.pyramids, threads);
    Vertex_optimizer<Kept_boundary> vertices(store, boundary, threads);
    for (int sweep = 0; sweep < 2; ++sweep) {
      apexes.sweep();
      vertices.sweep();
    }
  };
  optimize_in_passes(store, boundary, passes, move_vertices, [&] { remesh_worst(store, remeshed_below); });
  write_inside(store, mesh);
}

} // namespace internal

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_OPTIMIZE_WITH_APEXES_H

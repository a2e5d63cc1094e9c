// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_OPTIMIZE_INSIDE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_OPTIMIZE_INSIDE_H

#include <CGAL/Tubular_meshing/Volume/internal/Vertex_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/remesh_worst.h>
#include <CGAL/Tubular_meshing/Volume/internal/Topology_optimizer.h>

#include <cstdint>

namespace CGAL::Tubular_meshing::internal {

/* A surface that is to stay as it is, as the optimizers see it: no vertex moves on it (see Vertex_optimizer), no edge
 * of it is flipped (see Topology_optimizer). */
struct Kept_boundary {
  typedef Tetrahedron_store::Index Index;

  bool is_fixed(const Vector_3d&, int) const { return true; }
  Vector_3d to_patch(const Vector_3d& p, std::int32_t) const { return p; }
  Vector_3d to_rim(const Vector_3d& p, std::int32_t, std::int32_t) const { return p; }

  bool operator()(Index, Index, Index, Index, std::int32_t) const { return false; }
};

/* Improves tetrahedra, their labelled facets staying as they are. Where pyramids stand on the other side of some, these
 * are improved with them: the facets stay as triangles, but their apexes move. */
inline void optimize_inside(Tetrahedron_store& store, int passes, int threads, const Element_block<5>& pyramids = {}) {
  // flips and sweeps alone leave a few tetrahedra of boundary vertices at 0.15 to 0.25
  const double remeshed_below = 0.4;
  const Kept_boundary boundary;
  const auto move_vertices = [&](int) {
    Vertex_optimizer<Kept_boundary> apexes(store, boundary, pyramids, threads);
    Vertex_optimizer<Kept_boundary> vertices(store, boundary, threads);
    for (int sweep = 0; sweep < 2; ++sweep) {
      apexes.sweep();
      vertices.sweep();
    }
  };
  optimize_in_passes(store, boundary, passes, threads, move_vertices,
                     [&] { remesh_worst(store, remeshed_below, threads); });
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_OPTIMIZE_INSIDE_H

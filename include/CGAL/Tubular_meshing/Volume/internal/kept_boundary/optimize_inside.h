// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_OPTIMIZE_INSIDE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_OPTIMIZE_INSIDE_H

#include <CGAL/Tubular_meshing/Volume/internal/Vertex_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Vertex_insertion.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Vertex_removal.h>
#include <CGAL/Tubular_meshing/Volume/internal/optimize_in_passes.h>
#include <CGAL/Tubular_meshing/Volume/internal/pyramids/Apex_optimizer.h>

#include <cstddef>
#include <cstdint>
#include <vector>

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

/* Takes inner vertices away from the tetrahedra below `threshold`, or adds some, where that makes the worst of those
 * around better: for the few that flips and moves cannot improve. The boundary stays as it is. */
inline void remesh_worst(Tetrahedron_store& store, double threshold) {
  typedef Tetrahedron_store::Index Index;
  const auto is_bad = [&](Index t) { return store.is_alive(t) && gamma_of(store, store[t].v) < threshold; };
  std::vector<Index> todo = store.tetrahedra(is_bad);
  Vertex_removal remove(store);
  Vertex_insertion insert(store);
  Tetrahedron_store::Index_list come;
  // each change raises the worst quality of a cavity by a step, so this ends; the bound is against rounding
  const std::size_t most = 20 * todo.size();
  for (std::size_t k = 0; k < todo.size() && k < most; ++k)
    if (is_bad(todo[k]) && (remove(todo[k], come) || insert(todo[k], come)))
      for (Index t : come)
        if (is_bad(t))
          todo.push_back(t);
}

/* Improves tetrahedra, their labelled facets staying as they are. Where pyramids stand on the other side of some, these
 * are improved with them: the facets stay as triangles, but their apexes move. */
inline void optimize_inside(Mixed_mesh& mesh, int passes, int threads, const Element_block<5>& pyramids = {}) {
  // flips and sweeps alone leave a few tetrahedra of boundary vertices at 0.15 to 0.25
  const double remeshed_below = 0.4;
  const Kept_boundary boundary;
  Tetrahedron_store store(mesh);
  const auto move_vertices = [&](int) {
    Apex_optimizer apexes(store, pyramids, threads);
    Vertex_optimizer<Kept_boundary> vertices(store, boundary, threads);
    for (int sweep = 0; sweep < 2; ++sweep) {
      apexes.sweep();
      vertices.sweep();
    }
  };
  optimize_in_passes(store, boundary, passes, move_vertices, [&] { remesh_worst(store, remeshed_below); });
  store.write_inside_to(mesh);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_OPTIMIZE_INSIDE_H

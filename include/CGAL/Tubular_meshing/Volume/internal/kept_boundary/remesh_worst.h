// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_REMESH_WORST_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_REMESH_WORST_H

#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Vertex_insertion.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Vertex_removal.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Takes inner vertices away from the tetrahedra below `threshold`, or adds some, where that makes the worst of those
 * around better: for the few that flips and moves cannot improve. The boundary stays as it is. Returns the number of
 * changes. */
inline std::size_t remesh_worst(Tetrahedron_store& store, double threshold) {
  typedef Tetrahedron_store::Index Index;
  const auto is_bad = [&](Index t) { return store.is_alive(t) && gamma_of(store, store[t].v) < threshold; };
  std::vector<Index> todo;
  for (Index t = 0; t < store.number_of_slots(); ++t)
    if (is_bad(t))
      todo.push_back(t);
  Vertex_removal remove(store);
  Vertex_insertion insert(store);
  Tetrahedron_store::Index_list come;
  std::size_t changes = 0;
  // each change raises the worst quality of a cavity by a step, so this ends; the bound is against rounding
  const std::size_t most = 20 * todo.size();
  for (std::size_t k = 0; k < todo.size() && k < most; ++k) {
    if (!is_bad(todo[k]) || !(remove(todo[k], come) || insert(todo[k], come)))
      continue;
    ++changes;
    for (Index t : come)
      if (is_bad(t))
        todo.push_back(t);
  }
  return changes;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_REMESH_WORST_H

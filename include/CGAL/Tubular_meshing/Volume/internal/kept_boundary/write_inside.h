// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_WRITE_INSIDE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_WRITE_INSIDE_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>

#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Writes a store whose inside alone has changed back to its mesh: the labelled triangles stay in their order, and with
 * their vertices in theirs. */
inline void write_inside(const Tetrahedron_store& store, Mixed_mesh& mesh) {
  Element_block<3> triangles = std::move(mesh.triangles);
  const std::vector<Tetrahedron_store::Index> number = store.write_to(mesh);
  for (auto& t : triangles.vertices)
    t = {number[t[0]], number[t[1]], number[t[2]]};
  mesh.triangles = std::move(triangles);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_WRITE_INSIDE_H

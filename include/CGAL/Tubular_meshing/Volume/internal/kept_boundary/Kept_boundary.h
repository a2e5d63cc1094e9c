// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_KEPT_BOUNDARY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_KEPT_BOUNDARY_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>

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

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_KEPT_BOUNDARY_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_REMESHING_FLIPS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_REMESHING_FLIPS_H

#include <CGAL/Tubular_meshing/Volume/internal/Surface_flip_guard.h>
#include <CGAL/Tubular_meshing/Volume/internal/Topology_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_mesh.h>

#include <cstdint>

namespace CGAL::Tubular_meshing::internal {

/* Flips that change the surface are refused where it is to stay. */
struct Remeshing_flip_guard {
  Surface_flip_guard shape;
  bool keep_boundary;

  bool operator()(Tetrahedron_store::Index a, Tetrahedron_store::Index b, Tetrahedron_store::Index c,
                  Tetrahedron_store::Index d, std::int32_t patch) const {
    return !keep_boundary && shape(a, b, c, d, patch);
  }
};

struct Metric_measure {
  typedef Tetrahedron_store::Index Index;
  const Metric_mesh* mesh;
  double tetrahedron(Index a, Index b, Index c, Index d) const { return mesh->tetrahedron(a, b, c, d); }
  double triangle(Index a, Index b, Index c) const { return mesh->triangle(a, b, c); }
};

typedef Topology_optimizer<Remeshing_flip_guard, Metric_measure> Remeshing_flips;

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_REMESHING_FLIPS_H

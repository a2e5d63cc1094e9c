// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_CAP_FACET_H
#define CGAL_TUBULAR_MESHING_RIMS_CAP_FACET_H

#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/wall_at_cap.h>

#include <cstddef>

namespace CGAL::Tubular_meshing::internal {

/* Whether a cap looks like a facet of a surface of few triangles, as decimation leaves them of domes: it has no vertices
 * but those of a rim of few edges, which do not lie in a plane, and is not as round, or its wall not as upright on it, as
 * at the end of a coarse tube that has been closed. */
inline bool is_facet(const Opening_site& cap, const Wall_at_cap& wall) {
  const double flat_to_rounding = 0.005; // of the radius; of single precision, or of files of six digits
  const std::size_t enough_edges = 12;   // as a vessel has round itself, and hardly a facet
  const double min_roundness = 0.75, max_wall_cosine = 0.25;
  const Rim_shape& s = cap.shape;
  const bool has_inner_vertices = cap.cap.size() + 2 != cap.rim.size(); // Euler's formula, of a disk
  if (has_inner_vertices || cap.rim.size() >= enough_edges || s.sag <= flat_to_rounding * s.radius)
    return false;
  return 4 * CGAL_PI * s.area < min_roundness * s.perimeter * s.perimeter || !wall.stands(max_wall_cosine);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_CAP_FACET_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_OPTIMIZE_IN_PASSES_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_OPTIMIZE_IN_PASSES_H

#include <CGAL/Tubular_meshing/Volume/internal/Topology_optimizer.h>

namespace CGAL::Tubular_meshing::internal {

/* Flips in turn with moves of vertices, move_vertices(pass), each of which ends with finish_pass(). */
template <class Guard, class Move, class Finish>
void optimize_in_passes(Tetrahedron_store& store, const Guard& guard, int passes, const Move& move_vertices,
                        const Finish& finish_pass) {
  // slivers first, then whatever is clearly below the mean that comes out
  const double first_flips_below = 0.5, later_flips_below = 0.6;
  Topology_optimizer<Guard>(store, guard).improve_below(first_flips_below);
  for (int pass = 0; pass < passes; ++pass) {
    move_vertices(pass);
    Topology_optimizer<Guard>(store, guard).improve_below(later_flips_below);
    finish_pass();
  }
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_OPTIMIZE_IN_PASSES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_OPTIMIZE_IN_PASSES_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_OPTIMIZE_IN_PASSES_H

#include <CGAL/Tubular_meshing/Volume/internal/Topology_optimizer.h>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// Where flips start from: slivers first, then whatever is clearly below the mean that comes out.
constexpr double first_flips_below = 0.5;
constexpr double later_flips_below = 0.6;

// Flips and sweeps alone leave a few tetrahedra of boundary vertices at 0.15 to 0.25: where the boundary is kept, those
// are remeshed.
constexpr double remeshed_below = 0.4;

/* Flips in turn with moves of vertices, move_vertices(pass), each of which ends with finish_pass(). */
template <class Guard, class Move, class Finish>
void optimize_in_passes(Tetrahedron_store& store, const Guard& guard, int passes, const Move& move_vertices,
                        const Finish& finish_pass) {
  Topology_optimizer<Guard>(store, guard).improve_below(first_flips_below);
  for (int pass = 0; pass < passes; ++pass) {
    move_vertices(pass);
    Topology_optimizer<Guard>(store, guard).improve_below(later_flips_below);
    finish_pass();
  }
}

} // namespace internal

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_OPTIMIZE_IN_PASSES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_FOLLOW_BLIND_VESSELS_H
#define CGAL_TUBULAR_MESHING_PATCHES_FOLLOW_BLIND_VESSELS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Blind_vessel_finder.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Cut_surface.h>

#include <CGAL/Surface_mesh.h>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Adds lines into vessels that end without an opening, to centerlines that lead to the openings: without one, such a
 * vessel would be meshed at the size of the vessel that it leaves, and not be cut. O(n log n) a generation. */
template <class NamedParameters>
void follow_blind_vessels(CGAL::Surface_mesh<Point_3>& surface, Face_patch_map patch,
                          Centerline_computation& computation, Centerline_graph& graph, const NamedParameters& np) {
  const int most_generations = 6; // blind vessels may leave blind vessels
  for (int generation = 0; generation < most_generations; ++generation) {
    bool is_longer = false;
    {
      const Cut_surface uncut(surface, patch);
      for (const auto& vessel : Blind_vessel_finder(uncut, graph).find())
        is_longer = computation.add_end(vessel.tip) || is_longer;
    }
    if (!is_longer)
      return;
    computation.make_graph(graph, np);
  }
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_FOLLOW_BLIND_VESSELS_H

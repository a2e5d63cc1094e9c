// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_FOLLOW_BLIND_VESSELS_H
#define CGAL_TUBULAR_MESHING_PATCHES_FOLLOW_BLIND_VESSELS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>

#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The tips of vessels that end without an opening and have no centerline, each in the order of its vessel's first face.
 * The surface is as it was afterwards. O(n log n). */
std::vector<Vertex> tips_of_blind_vessels(Surface& surface, Face_patch_map patch, const Centerline_graph& graph);

/* Adds lines into vessels that end without an opening, to centerlines that lead to the openings: without one, such a
 * vessel would be meshed at the size of the vessel that it leaves, and not be cut. O(n log n) a generation.
 *
 * `computation` is a Centerline_computation. */
template <class Computation, class Parameters>
void follow_blind_vessels(Surface& surface, Face_patch_map patch, Computation& computation, Centerline_graph& graph,
                          const Parameters& parameters) {
  const int most_generations = 6; // blind vessels may leave blind vessels
  for (int generation = 0; generation < most_generations; ++generation) {
    if (!computation.add_ends(tips_of_blind_vessels(surface, patch, graph)))
      return;
    computation.make_graph(graph, parameters);
  }
}

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/follow_blind_vessels_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_FOLLOW_BLIND_VESSELS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_BLOSSOM_RECOMBINATION_H
#define CGAL_TUBULAR_MESHING_QUADS_BLOSSOM_RECOMBINATION_H

#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuads
 *
 * Whether the library was built with LEMON, which recombine_triangles() needs. CMake sees to that where it finds LEMON;
 * otherwise define `CGAL_TUBULAR_MESHING_WITH_LEMON`. LEMON 1.3 is C++17 at most: later, this is false. LEMON is free
 * software under the Boost licence.
 */
bool has_lemon();

namespace internal {

/* Two nodes that may be matched, at a cost that is not negative. */
struct Node_pair {
  int first, second;
  double cost;
};

/* Among the matchings of as many nodes as possible, one of the smallest cost (to 2⁻²⁰ a pair): the indices of its
 * pairs, ascending. J. Edmonds' blossom algorithm, O(n m log n); on the duals of triangle meshes, 0.4 s for 100,000
 * nodes. Throws Meshing_error without LEMON. */
std::vector<std::size_t> minimum_cost_matching(std::size_t number_of_nodes, const std::vector<Node_pair>& pairs);

} // namespace internal
} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quads/blossom_recombination_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUADS_BLOSSOM_RECOMBINATION_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PARTITION_INTERNAL_DUAL_GRAPH_H
#define CGAL_TUBULAR_MESHING_PARTITION_INTERNAL_DUAL_GRAPH_H

#include <CGAL/Tubular_meshing/base/Cell_neighbours.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The cells of a mesh as vertices and the faces between them as edges, in compressed rows: those across the faces of
 * cell c are neighbours[first[c]] to neighbours[first[c + 1] - 1]. Numbers have 32 bits, as METIS's have. */
class Dual_graph {
public:
  std::vector<std::int32_t> first, neighbours;

  explicit Dual_graph(const Mixed_mesh& mesh) {
    const cells::Numbered_cells numbered(mesh);
    if (numbered.number_of_faces() > std::size_t((std::numeric_limits<std::int32_t>::max)()))
      throw Input_error("The mesh cannot be partitioned: its cells have more than 2147483647 faces.");
    const cells::Cell_neighbours across(numbered);
    if (across.has_crowded_face())
      throw Input_error("The mesh cannot be partitioned: three of its cells share a face; repair the mesh.");
    first.reserve(numbered.size() + 1);
    first.push_back(0);
    neighbours.reserve(numbered.number_of_faces());
    std::size_t face = 0;
    for (std::size_t c = 0; c < numbered.size(); ++c) {
      for (const std::size_t end = face + numbered.number_of_faces(c); face < end; ++face)
        if (across.across(face) != cells::no_cell)
          neighbours.push_back(std::int32_t(across.across(face)));
      first.push_back(std::int32_t(neighbours.size()));
    }
  }

  std::size_t size() const { return first.size() - 1; }

  /* Goes from cell to cell through those faces that are open(from, to), as far as they lead, then on from the lowest
   * cell that is left. Calls f(cell, is_first_of_piece) for each cell once; neighbours follow each other closely. O(n). */
  template <class Open, class F> void traverse(const Open& open, F f) const {
    std::vector<bool> found(size(), false);
    std::vector<std::int32_t> queue;
    for (std::size_t start = 0; start < size(); ++start) {
      if (found[start])
        continue;
      queue.assign(1, std::int32_t(start));
      found[start] = true;
      for (std::size_t i = 0; i < queue.size(); ++i) {
        const std::int32_t c = queue[i];
        f(std::size_t(c), i == 0);
        for (std::int32_t k = first[std::size_t(c)]; k < first[std::size_t(c) + 1]; ++k) {
          const std::int32_t other = neighbours[std::size_t(k)];
          if (!found[std::size_t(other)] && open(std::size_t(c), std::size_t(other))) {
            found[std::size_t(other)] = true;
            queue.push_back(other);
          }
        }
      }
    }
  }

  bool is_connected() const {
    std::size_t pieces = 0;
    traverse([](std::size_t, std::size_t) { return true; }, [&](std::size_t, bool begins) { pieces += begins; });
    return pieces == 1;
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PARTITION_INTERNAL_DUAL_GRAPH_H

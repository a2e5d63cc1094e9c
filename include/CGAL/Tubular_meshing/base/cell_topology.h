// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_CELL_TOPOLOGY_H
#define CGAL_TUBULAR_MESHING_BASE_CELL_TOPOLOGY_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::array<int, 3> Triangle_corners;
typedef std::array<int, 4> Quad_corners;
typedef std::array<int, 4> Corner; // a vertex and the three it shares an edge with, right handed

/* The faces of the cell with N vertices, counterclockwise from outside, and the corners at which its Jacobian is taken;
 * numbered as in Mixed_mesh. A pyramid's apex, where four edges meet, has no Jacobian of its own. */
template <std::size_t N> class Cell_topology {
public:
  static const std::vector<Triangle_corners>& triangles() { return tables().triangles; }
  static const std::vector<Quad_corners>& quads() { return tables().quads; }
  static const std::vector<Corner>& corners() { return tables().corners; }

private:
  struct Tables {
    std::vector<Triangle_corners> triangles;
    std::vector<Quad_corners> quads;
    std::vector<Corner> corners;
  };

  static const Tables& tables() {
    if constexpr (N == 4) {
      static const Tables tetrahedron = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, {}, {{0, 1, 2, 3}}};
      return tetrahedron;
    } else if constexpr (N == 5) {
      static const Tables pyramid = {{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
                                     {{0, 3, 2, 1}},
                                     {{0, 1, 3, 4}, {1, 2, 0, 4}, {2, 3, 1, 4}, {3, 0, 2, 4}}};
      return pyramid;
    } else if constexpr (N == 6) {
      static const Tables prism = {
          {{0, 2, 1}, {3, 4, 5}},
          {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
          {{0, 1, 2, 3}, {1, 2, 0, 4}, {2, 0, 1, 5}, {3, 5, 4, 0}, {4, 3, 5, 1}, {5, 4, 3, 2}}};
      return prism;
    } else {
      static const Tables hexahedron = {
          {},
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
          {{0, 1, 3, 4},
           {1, 2, 0, 5},
           {2, 3, 1, 6},
           {3, 0, 2, 7},
           {4, 7, 5, 0},
           {5, 4, 6, 1},
           {6, 5, 7, 2},
           {7, 6, 4, 3}}};
      return hexahedron;
    }
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_CELL_TOPOLOGY_H

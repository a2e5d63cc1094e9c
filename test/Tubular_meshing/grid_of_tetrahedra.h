// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_TEST_GRID_OF_TETRAHEDRA_H
#define CGAL_TUBULAR_MESHING_TEST_GRID_OF_TETRAHEDRA_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

/* A box of n[0] × n[1] × n[2] cells, of six tetrahedra each, all of region 1. `point(i, j, k)` is called once for each
 * vertex, k first; `label(axis, end)` is the patch of a side, 0 for none. */
template <class Make_point, class Label>
CGAL::Tubular_meshing::Mixed_mesh grid_of_tetrahedra(const std::array<int, 3>& n, const Make_point& point,
                                                     const Label& label) {
  CGAL::Tubular_meshing::Mixed_mesh m;
  std::vector<std::array<int, 3>> place;
  const auto at = [&](int i, int j, int k) { return std::uint32_t((i * (n[1] + 1) + j) * (n[2] + 1) + k); };
  for (int i = 0; i <= n[0]; ++i)
    for (int j = 0; j <= n[1]; ++j)
      for (int k = 0; k <= n[2]; ++k) {
        m.points.push_back(point(i, j, k));
        place.push_back({i, j, k});
      }
  // the ways from a cell's first corner to its last along three edges; odd ones would turn the tetrahedron over
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 0; k < n[2]; ++k)
        for (int o = 0; o < 6; ++o) {
          std::array<int, 3> corner = {i, j, k};
          std::array<std::uint32_t, 4> t = {at(i, j, k), 0, 0, 0};
          for (int s = 0; s < 3; ++s) {
            ++corner[orders[o][s]];
            t[s + 1] = at(corner[0], corner[1], corner[2]);
          }
          if (o >= 3)
            std::swap(t[2], t[3]);
          m.tetrahedra.push_back(t, 1);
        }
  for (const auto& t : m.tetrahedra.vertices)
    for (int f = 0; f < 4; ++f) {
      const auto& c = CGAL::Tubular_meshing::internal::Tetrahedron_store::facet_corners(f);
      for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
          if (label(axis, end) != 0 &&
              std::all_of(c.begin(), c.end(), [&](int v) { return place[t[v]][axis] == end * n[axis]; }))
            m.triangles.push_back({t[c[0]], t[c[1]], t[c[2]]}, label(axis, end));
    }
  return m;
}

#endif // CGAL_TUBULAR_MESHING_TEST_GRID_OF_TETRAHEDRA_H

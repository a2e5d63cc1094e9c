// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_TRIANGLE_ADJACENCY_H
#define CGAL_TUBULAR_MESHING_PLANE_TRIANGLE_ADJACENCY_H

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::array<int, 3> Patch_triangle;

/* Halfedges of indexed triangles need no storage: number 3 t + i goes from corner i of triangle t to the next one, and
 * stands for corner i as well. */
inline int triangle_of(int halfedge) {
  return halfedge / 3;
}
inline int next_halfedge(int h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
inline int previous_halfedge(int h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}
inline int source_of(const std::vector<Patch_triangle>& triangles, int h) {
  return triangles[std::size_t(h / 3)][std::size_t(h % 3)];
}
inline int target_of(const std::vector<Patch_triangle>& triangles, int h) {
  return source_of(triangles, next_halfedge(h));
}

/* For each halfedge the one on the other side, −1 on the border. O(n log n).
 * Throws Input_error if an edge has more than two triangles, or two that are turned differently. */
inline std::vector<int> opposite_halfedges(const std::vector<Patch_triangle>& triangles) {
  std::vector<std::pair<std::uint64_t, int>> edges;
  edges.reserve(3 * triangles.size());
  for (int h = 0; h < int(3 * triangles.size()); ++h) {
    const auto ends = std::minmax({std::uint64_t(source_of(triangles, h)), std::uint64_t(target_of(triangles, h))});
    edges.emplace_back(ends.first << 32 | ends.second, h);
  }
  std::sort(edges.begin(), edges.end());
  std::vector<int> opposite(edges.size(), -1);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (edges[i].first != edges[i + 1].first)
      continue;
    const int a = edges[i].second, b = edges[i + 1].second;
    if ((i + 2 < edges.size() && edges[i + 2].first == edges[i].first) ||
        source_of(triangles, a) == source_of(triangles, b))
      throw Input_error("The edge between the vertices " + std::to_string(source_of(triangles, a)) + " and " +
                        std::to_string(target_of(triangles, a)) +
                        " of a patch has more than two triangles, or two that are turned differently; repair the "
                        "surface first (repair_surface()).");
    opposite[std::size_t(a)] = b;
    opposite[std::size_t(b)] = a;
    ++i;
  }
  return opposite;
}

/* The halfedges that leave each vertex: `halfedges[first[v]]` up to `halfedges[first[v + 1]]`, in ascending order. */
struct Outgoing_halfedges {
  std::vector<int> first, halfedges;

  Outgoing_halfedges() = default;
  Outgoing_halfedges(const std::vector<Patch_triangle>& triangles, std::size_t number_of_vertices)
      : first(number_of_vertices + 1, 0)
      , halfedges(3 * triangles.size()) {
    for (const Patch_triangle& t : triangles)
      for (int v : t)
        ++first[std::size_t(v) + 1];
    for (std::size_t v = 0; v < number_of_vertices; ++v)
      first[v + 1] += first[v];
    std::vector<int> end(first.begin(), first.end() - 1);
    for (int h = 0; h < int(halfedges.size()); ++h)
      halfedges[std::size_t(end[std::size_t(source_of(triangles, h))]++)] = h;
  }

  const int* begin(int v) const { return halfedges.data() + first[std::size_t(v)]; }
  const int* end(int v) const { return halfedges.data() + first[std::size_t(v) + 1]; }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_TRIANGLE_ADJACENCY_H

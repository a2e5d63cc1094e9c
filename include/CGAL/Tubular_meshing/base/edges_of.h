// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_EDGES_OF_H
#define CGAL_TUBULAR_MESHING_BASE_EDGES_OF_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The edges of those triangles or tetrahedra of which `counts(label)` holds, lower vertex first, in order. They are
 * gathered at their lower vertices, where there are a few dozen: O(n log d) for d there, four bytes a side of an element
 * beside the result. */
template <std::size_t N, class Counts>
std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_of(const Element_block<N>& elements, const Counts& counts) {
  static_assert(N <= 4, "any two vertices are joined");
  const auto for_each_side = [&](const auto& visit) {
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (counts(elements.label[k]))
        for (std::size_t i = 0; i < N; ++i)
          for (std::size_t j = 0; j < i; ++j) {
            const auto ends = std::minmax(elements.vertices[k][i], elements.vertices[k][j]);
            visit(ends.first, ends.second);
          }
  };
  std::vector<std::size_t> end_at; // of a vertex; while they are filled, where it goes on
  for_each_side([&](std::uint32_t a, std::uint32_t b) {
    if (b + std::size_t(2) > end_at.size())
      end_at.resize((std::max)(b + std::size_t(2), 2 * end_at.size()), 0);
    ++end_at[a + std::size_t(1)];
  });
  for (std::size_t v = 1; v < end_at.size(); ++v)
    end_at[v] += end_at[v - 1];
  std::vector<std::uint32_t> others(end_at.empty() ? 0 : end_at.back());
  for_each_side([&](std::uint32_t a, std::uint32_t b) { others[end_at[a]++] = b; });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t v = 0, begin = 0; v < end_at.size() && begin < others.size(); begin = end_at[v++]) {
    const auto first = others.begin() + std::ptrdiff_t(begin), last = others.begin() + std::ptrdiff_t(end_at[v]);
    std::sort(first, last);
    for (auto b = first, end = std::unique(first, last); b != end; ++b)
      edges.emplace_back(std::uint32_t(v), *b);
  }
  return edges;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_EDGES_OF_H

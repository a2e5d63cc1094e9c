// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_EDGES_OF_H
#define CGAL_TUBULAR_MESHING_BASE_EDGES_OF_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The edges of those triangles or tetrahedra of which `counts(label)` holds, lower vertex first, in order; vertices are
 * numbered below `number_of_vertices`. They are gathered at their lower vertices, where there are a few dozen:
 * O(n log d) for d there, four bytes a side of an element beside the result. On all threads; the result does not depend
 * on their number. */
template <std::size_t N, class Counts>
std::vector<std::pair<std::uint32_t, std::uint32_t>>
edges_of(const Element_block<N>& elements, std::size_t number_of_vertices, const Counts& counts, int threads) {
  static_assert(N <= 4, "any two vertices are joined");
  if (elements.size() > (std::numeric_limits<std::uint32_t>::max)() / (N * (N - 1) / 2))
    throw Input_error("The mesh has more edges than can be numbered: part it.");
  const auto for_each_side = [&](const auto& visit) {
    for_each_range(elements.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        if (counts(elements.label[k]))
          for (std::size_t i = 0; i < N; ++i)
            for (std::size_t j = 0; j < i; ++j) {
              const auto ends = std::minmax(elements.vertices[k][i], elements.vertices[k][j]);
              visit(ends.first, ends.second);
            }
    });
  };
  std::vector<std::atomic<std::uint32_t>> number(number_of_vertices); // of what a vertex has so far
  std::vector<std::uint32_t> begin(number_of_vertices + 1, 0);
  const auto sum_up = [&] {
    for (std::size_t v = 0; v < number_of_vertices; ++v)
      begin[v + 1] = begin[v] + number[v];
  };
  for_each_side([&](std::uint32_t a, std::uint32_t) { number[a].fetch_add(1, std::memory_order_relaxed); });
  sum_up();
  for (auto& n : number)
    n = 0;
  std::vector<std::uint32_t> others(begin.back());
  for_each_side([&](std::uint32_t a, std::uint32_t b) {
    others[begin[a] + number[a].fetch_add(1, std::memory_order_relaxed)] = b;
  });
  const std::vector<std::uint32_t> with_repetitions = begin;
  for_each_range(number_of_vertices, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t v = from; v < to; ++v) {
      const auto first = others.begin() + std::ptrdiff_t(with_repetitions[v]);
      const auto last = others.begin() + std::ptrdiff_t(with_repetitions[v + 1]);
      std::sort(first, last);
      number[v] = std::uint32_t(std::unique(first, last) - first);
    }
  });
  sum_up();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges(begin.back());
  for_each_range(number_of_vertices, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t v = from; v < to; ++v)
      for (std::size_t k = 0; k < begin[v + 1] - begin[v]; ++k)
        edges[begin[v] + k] = {std::uint32_t(v), others[with_repetitions[v] + k]};
  });
  return edges;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_EDGES_OF_H

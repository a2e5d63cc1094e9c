// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_IS_ORIENTED_SURFACE_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_IS_ORIENTED_SURFACE_H

#include <CGAL/Tubular_meshing/base/Triangle_soup.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Whether the steps round a point, each from one neighbour to the next as one of its triangles has them, make one way,
 * open or closed. They are sorted in passing. */
template <class Iterator> bool is_one_way(Iterator first, Iterator last) {
  typedef typename std::iterator_traits<Iterator>::value_type Step;
  std::sort(first, last);
  if (std::adjacent_find(first, last, [](const Step& s, const Step& t) { return s.first == t.first; }) != last)
    return false; // two triangles run along the same edge in the same direction
  const auto step_from = [&](std::size_t from) {
    const Iterator i =
        std::lower_bound(first, last, from, [](const Step& s, std::size_t value) { return s.first < value; });
    return i != last && i->first == from ? i : last;
  };
  std::vector<char> is_end(std::size_t(last - first), 0); // whether a step begins where another one ends
  for (Iterator i = first; i != last; ++i)
    if (const Iterator next = step_from(i->second); next != last) {
      if (is_end[std::size_t(next - first)])
        return false;
      is_end[std::size_t(next - first)] = 1;
    }
  const auto open = std::find(is_end.begin(), is_end.end(), 0);
  const Iterator begin = open == is_end.end() ? first : first + (open - is_end.begin());
  std::ptrdiff_t steps = 0;
  for (Iterator i = begin; i != last && (i != begin || steps == 0); i = step_from(i->second))
    ++steps;
  return steps == last - first;
}

/* Whether triangles make a surface as they are: an edge is a side of two of them at most, which run along it in opposite
 * directions, and those at a point are all round it, or one after the other from one border to the next. O(n log d) for
 * at most d triangles at a point. */
inline bool is_oriented_surface(const std::vector<Index_triangle>& triangles, std::size_t number_of_points) {
  std::vector<std::size_t> begin(number_of_points + 1, 0);
  for (const Index_triangle& t : triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      return false;
    for (std::size_t v : t)
      ++begin[v + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::pair<std::size_t, std::size_t>> steps(3 * triangles.size());
  std::vector<std::size_t> next(begin.begin(), begin.end());
  for (const Index_triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      steps[next[t[k]]++] = {t[(k + 1) % 3], t[(k + 2) % 3]};
  for (std::size_t v = 0; v < number_of_points; ++v)
    if (!is_one_way(steps.begin() + std::ptrdiff_t(begin[v]), steps.begin() + std::ptrdiff_t(begin[v + 1])))
      return false;
  return true;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_IS_ORIENTED_SURFACE_H

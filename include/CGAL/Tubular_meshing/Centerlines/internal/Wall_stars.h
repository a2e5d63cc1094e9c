// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_WALL_STARS_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_WALL_STARS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The triangles at each of n vertices, in order. Built in O(n). */
class Wall_stars {
public:
  typedef std::uint32_t Index;
  typedef std::array<std::size_t, 3> Triangle;

  /* `triangles` has to live as long as this. */
  Wall_stars(std::size_t n, const std::vector<Triangle>& triangles)
      : triangles_(triangles)
      , first_(n + 1, 0)
      , corners_(3 * triangles.size()) {
    for (const Triangle& t : triangles)
      for (std::size_t v : t)
        ++first_[v + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        corners_[next[triangles[t][k]]++] = {Index(t), Index(k)};
  }

  std::size_t size() const { return first_.size() - 1; }

  /* Calls f(triangle, k) for each triangle that has v for its k-th vertex. */
  template <class F> void for_each_triangle(std::size_t v, const F& f) const {
    for (Index i = first_[v]; i < first_[v + 1]; ++i)
      f(triangles_[corners_[i].triangle], std::size_t(corners_[i].place));
  }

  /* Calls f(w) for each vertex w with an edge to v; more than once where several triangles have it. */
  template <class F> void for_each_neighbor(std::size_t v, const F& f) const {
    for_each_triangle(v, [&](const Triangle& t, std::size_t k) {
      f(t[(k + 1) % 3]);
      f(t[(k + 2) % 3]);
    });
  }

private:
  struct Corner {
    Index triangle, place;
  };

  const std::vector<Triangle>& triangles_;
  std::vector<Index> first_; // where the corners of each vertex begin
  std::vector<Corner> corners_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_WALL_STARS_H

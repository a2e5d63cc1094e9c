// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SOUP_EDGES_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SOUP_EDGES_H

#include <CGAL/Tubular_meshing/base/Triangle_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline double length(const Coordinates& v) {
  return std::sqrt(dot(v, v));
}
inline double distance_between(const Coordinates& a, const Coordinates& b) {
  return length(minus(a, b));
}
inline double triangle_area(const Triangle_soup& soup, const Index_triangle& t) {
  return length(cross(minus(soup.points[t[1]], soup.points[t[0]]), minus(soup.points[t[2]], soup.points[t[0]]))) / 2;
}

/* The edges of a soup with the sides of triangles at each: side 3 t + k runs from corner k of triangle t to the next.
 * Edges are in the order of their smaller, then their larger end. O(n log d) for at most d edges at a point. */
class Soup_edges {
public:
  struct Side {
    std::size_t other_end, side;
  };
  struct Edge {
    std::size_t a, b; ///< a < b
    const Side *first, *last;
    std::size_t count() const { return std::size_t(last - first); }
  };

  explicit Soup_edges(const Triangle_soup& soup)
      : begin_(soup.points.size() + 1, 0) {
    for (const Index_triangle& t : soup.triangles)
      for (int k = 0; k < 3; ++k)
        ++begin_[(std::min)(t[k], t[(k + 1) % 3]) + 1];
    for (std::size_t v = 1; v < begin_.size(); ++v)
      begin_[v] += begin_[v - 1];
    std::vector<std::size_t> end(begin_.begin(), begin_.end() - 1);
    sides_.resize(3 * soup.triangles.size());
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto ends = std::minmax(soup.triangles[f][k], soup.triangles[f][(k + 1) % 3]);
        sides_[end[ends.first]++] = Side{ends.second, 3 * f + k};
      }
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v)
      std::sort(sides_.begin() + std::ptrdiff_t(begin_[v]), sides_.begin() + std::ptrdiff_t(begin_[v + 1]),
                [](const Side& s, const Side& t) {
                  return std::make_pair(s.other_end, s.side) < std::make_pair(t.other_end, t.side);
                });
  }

  template <class Visitor> void for_each(const Visitor& visit) const {
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v)
      for (std::size_t i = begin_[v]; i < begin_[v + 1];) {
        std::size_t j = i;
        while (j < begin_[v + 1] && sides_[j].other_end == sides_[i].other_end)
          ++j;
        visit(Edge{v, sides_[i].other_end, sides_.data() + i, sides_.data() + j});
        i = j;
      }
  }

private:
  std::vector<std::size_t> begin_;
  std::vector<Side> sides_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SOUP_EDGES_H

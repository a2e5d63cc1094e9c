// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_SORT_IN_SPACE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_SORT_IN_SPACE_H

#include <CGAL/Tubular_meshing/Volume/internal/order_in_space.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Sorts tetrahedra along a Hilbert curve through their centers. TetGen lists them in the order of its memory blocks;
 * sorted, they are optimized in two thirds of the time. O(n log n). */
inline void sort_in_space(const std::vector<Point_3>& points, std::vector<std::array<std::uint32_t, 4>>& tetrahedra) {
  std::vector<Point_3> centers; // four times them
  centers.reserve(tetrahedra.size());
  for (const auto& t : tetrahedra) {
    const Point_3 &p = points[t[0]], &q = points[t[1]], &r = points[t[2]], &s = points[t[3]];
    centers.emplace_back(p.x() + q.x() + r.x() + s.x(), p.y() + q.y() + r.y() + s.y(), p.z() + q.z() + r.z() + s.z());
  }
  std::vector<std::size_t> order(tetrahedra.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  order_in_space(centers, order);
  std::vector<std::array<std::uint32_t, 4>> sorted;
  sorted.reserve(tetrahedra.size());
  for (std::size_t i : order)
    sorted.push_back(tetrahedra[i]);
  tetrahedra = std::move(sorted);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_SORT_IN_SPACE_H

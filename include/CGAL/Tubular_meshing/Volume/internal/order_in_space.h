// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_ORDER_IN_SPACE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_ORDER_IN_SPACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Sorts the numbers of points along a Hilbert curve through the points, on `threads` threads (0: as many as there are
 * cores); the order does not depend on them. O(n log n). */
inline void order_in_space(const std::vector<Point_3>& points, std::vector<std::size_t>& numbers, int threads) {
  const auto point = make_property_map(points);
  const Spatial_sort_traits_adapter_3<Kernel, decltype(point)> traits(point);
  if (threads != 1)
    run_on(threads, [&] { hilbert_sort<Parallel_if_available_tag>(numbers.begin(), numbers.end(), traits); });
  else
    hilbert_sort(numbers.begin(), numbers.end(), traits);
}

// Value i becomes the one that was number order[i].
template <class Value> void put_in_order(const std::vector<std::size_t>& order, std::vector<Value>& values) {
  std::vector<Value> result;
  result.reserve(order.size());
  for (std::size_t i : order)
    result.push_back(values[i]);
  values.swap(result);
}

/* Sorts tetrahedra in the same way, by their centers. TetGen lists them in the order of its memory blocks; sorted, they
 * are optimized in two thirds of the time. */
inline void sort_in_space(const std::vector<Point_3>& points, std::vector<std::array<std::uint32_t, 4>>& tetrahedra,
                          int threads) {
  std::vector<Point_3> centers; // four times them
  centers.reserve(tetrahedra.size());
  for (const auto& t : tetrahedra) {
    const Point_3 &p = points[t[0]], &q = points[t[1]], &r = points[t[2]], &s = points[t[3]];
    centers.emplace_back(p.x() + q.x() + r.x() + s.x(), p.y() + q.y() + r.y() + s.y(), p.z() + q.z() + r.z() + s.z());
  }
  std::vector<std::size_t> order(tetrahedra.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  order_in_space(centers, order, threads);
  put_in_order(order, tetrahedra);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_ORDER_IN_SPACE_H

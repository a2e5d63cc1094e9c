// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_ORDER_IN_SPACE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_ORDER_IN_SPACE_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cstddef>
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

/* The order of some tetrahedra along such a curve through their centers. Sorted, they are refined in four fifths of the
 * time, and optimized in two thirds. */
inline std::vector<std::size_t> order_by_centers(const Tetrahedron_store& store,
                                                 const std::vector<Tetrahedron_store::Index>& tetrahedra, int threads) {
  std::vector<Point_3> centers(tetrahedra.size()); // four times them
  for_each_range(tetrahedra.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto& v = store[tetrahedra[i]].v;
      const Vector_3d sum = store.point(v[0]) + store.point(v[1]) + store.point(v[2]) + store.point(v[3]);
      centers[i] = Point_3(sum.x, sum.y, sum.z);
    }
  });
  std::vector<std::size_t> order(tetrahedra.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  order_in_space(centers, order, threads);
  return order;
}

/* Sorts the tetrahedra of a store, and its vertices from number `first` on as these tetrahedra have them, one after the
 * other; vertices below stay where they are. */
inline void sort_in_space(Tetrahedron_store& store, Tetrahedron_store::Index first, int threads) {
  typedef Tetrahedron_store::Index Index;
  std::vector<Index> tetrahedra = store.tetrahedra(), vertices(first);
  put_in_order(order_by_centers(store, tetrahedra, threads), tetrahedra);
  std::iota(vertices.begin(), vertices.end(), Index(0));
  std::vector<char> is_listed(store.number_of_vertices(), 0);
  for (Index t : tetrahedra)
    for (Index v : store[t].v)
      if (v >= first && !is_listed[v]) {
        is_listed[v] = 1;
        vertices.push_back(v);
      }
  store.renumber(vertices, tetrahedra, threads);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_ORDER_IN_SPACE_H

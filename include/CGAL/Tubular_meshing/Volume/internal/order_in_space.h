// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_ORDER_IN_SPACE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_ORDER_IN_SPACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// Sorts the numbers of points along a Hilbert curve through the points. O(n log n).
inline void order_in_space(const std::vector<Point_3>& points, std::vector<std::size_t>& numbers) {
  const auto point = make_property_map(points);
  hilbert_sort(numbers.begin(), numbers.end(), Spatial_sort_traits_adapter_3<Kernel, decltype(point)>(point));
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_ORDER_IN_SPACE_H

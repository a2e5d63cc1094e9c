// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_LUMEN_COLUMNS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_LUMEN_COLUMNS_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where the pieces of a local radius end, from the wall inward: they grow, as the sizes of a metric do. `from`: in radii. */
inline std::vector<double> pieces_of_radius(double from) {
  constexpr double least = 0.002, growth = 1.5, most = 0.1;
  std::vector<double> ends{from};
  for (double step = (std::max)(least, 0.1 * from); ends.back() + step < 1; step = (std::min)(growth * step, most))
    ends.push_back(ends.back() + step);
  ends.push_back(1);
  return ends;
}

/* The integral of a function of the distance d from the wall over what is between a unit of the wall's area and the middle
 * of a tube, where at d an area dA has become (1 - d / r) dA. */
template <class Function> double over_column(const std::vector<double>& ends, double radius, const Function& function) {
  double sum = 0;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double a = ends[k - 1], b = ends[k], middle = (a + b) / 2;
    sum += radius * (b - a) * (1 - middle) * function(middle * radius);
  }
  return sum;
}

/* How many facets there are on a wall for those that a metric asks for. Where they are to be long and narrow, by this ratio
 * of their sizes, those that lie between tetrahedra come out shorter, and fewer: on straight tubes, which ask for ratios of
 * 11, two in five, found on generated shapes. */
inline double realized_share(double ratio) {
  constexpr double square_of_ratio = 196, least = 0.2;
  return (std::max)(1 - ratio * ratio / square_of_ratio, least);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_LUMEN_COLUMNS_H

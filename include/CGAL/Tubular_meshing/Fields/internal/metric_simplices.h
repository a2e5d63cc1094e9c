// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_METRIC_SIMPLICES_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_METRIC_SIMPLICES_H

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Tubular_meshing::internal {

template <std::size_t N> Metric_tensor_3 mean_metric(const std::array<Metric_tensor_3, N>& metrics) {
  Metric_tensor_3 sum = metrics[0];
  for (std::size_t i = 1; i < N; ++i)
    sum += metrics[i];
  return (1. / N) * sum;
}

template <std::size_t N>
double longest_edge(const std::array<Vector_3d, N>& p, const std::array<Metric_tensor_3, N>& metrics) {
  double longest = 0;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < i; ++j)
      longest = (std::max)(longest, Metric_tensor_3::edge_length(p[i] - p[j], metrics[j], metrics[i]));
  return longest;
}

/* The radius, in the metric, of the smallest ellipsoid of it through three points: |a| |b| |a - b| over four times the
 * area, which is half the root of Gram's determinant. Infinite where they are on a line. */
inline double metric_circumradius(const std::array<Vector_3d, 3>& p, const Metric_tensor_3& m) {
  const Vector_3d a = p[1] - p[0], b = p[2] - p[0];
  const double aa = m.squared_length(a), bb = m.squared_length(b), ab = m.dot(a, b), gram = aa * bb - ab * ab;
  return gram > 0 ? std::sqrt(aa * bb * m.squared_length(a - b) / (4 * gram))
                  : (std::numeric_limits<double>::infinity)();
}

/* Through four points: the center c, from p0, solves 2 eᵢᵀ M c = eᵢᵀ M eᵢ for the edges eᵢ from p0. With y = M c the
 * radius is the root of yᵀ M⁻¹ y. Infinite where they are in a plane. */
inline double metric_circumradius(const std::array<Vector_3d, 4>& p, const Metric_tensor_3& m) {
  const Vector_3d e1 = p[1] - p[0], e2 = p[2] - p[0], e3 = p[3] - p[0];
  const Vector_3d n1 = cross(e2, e3), n2 = cross(e3, e1), n3 = cross(e1, e2);
  const double det = dot(e1, n1);
  if (det == 0)
    return (std::numeric_limits<double>::infinity)();
  const Vector_3d y = (0.5 / det) * (m.squared_length(e1) * n1 + m.squared_length(e2) * n2 + m.squared_length(e3) * n3);
  return m.inverse().length(y);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_METRIC_SIMPLICES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_METRIC_LOGARITHM_H
#define CGAL_TUBULAR_MESHING_PLANE_METRIC_LOGARITHM_H

#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Tubular_meshing {

namespace internal {

/* The tensor with the same axes whose eigenvalues are a function of those of m; f(larger, smaller) changes both. */
template <class Function> Metric_tensor_2 with_eigenvalues(const Metric_tensor_2& m, const Function& f) {
  const double mean = (m.xx + m.yy) / 2, d = (m.xx - m.yy) / 2, radius = std::hypot(d, m.xy);
  double larger = mean + radius, smaller = radius < mean ? m.determinant() / larger : mean - radius;
  const double cosine = radius > 0 ? d / radius : 1, sine = radius > 0 ? m.xy / radius : 0; // of twice the axis' angle
  f(larger, smaller);
  const double half_sum = (larger + smaller) / 2, half_difference = (larger - smaller) / 2;
  return {half_sum + half_difference * cosine, half_difference * sine, half_sum - half_difference * cosine};
}

/* Logarithms of metrics are averaged and interpolated, not metrics: a scale that grows exponentially, as on a ring, is
 * then met, and no mean is larger than what it is the mean of. Eigenvalues below 1e-12 of the larger one, of triangles
 * without an area, count as that. */
inline Metric_tensor_2 logarithm(const Metric_tensor_2& m) {
  return with_eigenvalues(m, [](double& larger, double& smaller) {
    larger = (std::max)(larger, (std::numeric_limits<double>::min)());
    smaller = (std::max)(smaller, 1e-12 * larger);
    larger = std::log(larger);
    smaller = std::log(smaller);
  });
}
inline Metric_tensor_2 exponential(const Metric_tensor_2& m) {
  return with_eigenvalues(m, [](double& larger, double& smaller) {
    larger = std::exp(larger);
    smaller = std::exp(smaller);
  });
}

} // namespace internal
} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PLANE_METRIC_LOGARITHM_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_METRIC_MEASURES_H
#define CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_METRIC_MEASURES_H

#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

typedef std::array<double, 6> Metric; // xx xy xz yy yz zz

inline double squared_metric_norm(const Metric& m, const Vector_3d& v) {
  return m[0] * v.x * v.x + m[3] * v.y * v.y + m[5] * v.z * v.z +
         2 * (m[1] * v.x * v.y + m[2] * v.x * v.z + m[4] * v.y * v.z);
}

inline double determinant(const Metric& m) {
  return m[0] * (m[3] * m[5] - m[4] * m[4]) - m[1] * (m[1] * m[5] - m[4] * m[2]) + m[2] * (m[1] * m[4] - m[3] * m[2]);
}

// eq. (16)
inline double tetrahedron_Q(const std::array<Vector_3d, 4>& p, const std::array<Metric, 4>& metric) {
  Metric mean = {};
  for (const Metric& m : metric)
    for (std::size_t k = 0; k < 6; ++k)
      mean[k] += m[k] / 4;
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      sum += squared_metric_norm(mean, p[i] - p[j]);
  const double volume = std::abs(signed_volume(p[0], p[1], p[2], p[3])) * std::sqrt((std::max)(determinant(mean), 0.));
  return volume > 0 ? sum * std::sqrt(sum) / (regular_tetrahedron_ratio * volume)
                    : (std::numeric_limits<double>::infinity)();
}

// eq. (10)
inline double metric_length(const Vector_3d& e, const Metric& at_start, const Metric& at_end) {
  static const double position[4] = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                     0.93056815579702629};
  static const double weight[4] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693};
  const double a = squared_metric_norm(at_start, e), b = squared_metric_norm(at_end, e);
  double length = 0;
  for (int k = 0; k < 4; ++k)
    length += weight[k] * std::sqrt((std::max)((1 - position[k]) * a + position[k] * b, 0.));
  return length;
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_METRIC_MEASURES_H

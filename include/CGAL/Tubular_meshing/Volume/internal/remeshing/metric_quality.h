// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_QUALITY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_QUALITY_H

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Tubular_meshing::internal {

/* A vertex as the measures see it. */
struct Metric_point {
  Vector_3d position;
  Metric_tensor_3 metric;
};

/* What eq. (16) is made of, both one for a regular tetrahedron of unit edges. */
struct Metric_shape {
  double mean_square; // of the six edges
  double volume;      // times the density, over that of the regular tetrahedron; negative for an inverted one

  // The inverse of eq. (16): 1 is best, 0 is flat, negative is inverted.
  double quality() const { return volume / (mean_square * std::sqrt(mean_square)); }
};

/* The tetrahedron spanned by u, v, w from one of its vertices, of which `determinant` is u (v x w), in the metric `mean`. */
inline Metric_shape metric_shape(const Vector_3d& u, const Vector_3d& v, const Vector_3d& w, double determinant,
                                 const Metric_tensor_3& mean) {
  const double sum =
      4 * (mean.squared_length(u) + mean.squared_length(v) + mean.squared_length(w)) - mean.squared_length(u + v + w);
  return {sum / 6, std::sqrt(2.) * determinant * mean.density()};
}
inline Metric_shape metric_shape(const Vector_3d& u, const Vector_3d& v, const Vector_3d& w,
                                 const Metric_tensor_3& mean) {
  return metric_shape(u, v, w, dot(u, cross(v, w)), mean);
}

inline double metric_quality(const Metric_point& a, const Metric_point& b, const Metric_point& c,
                             const Metric_point& d) {
  return metric_shape(b.position - a.position, c.position - a.position, d.position - a.position,
                      0.25 * (a.metric + b.metric + c.metric + d.metric))
      .quality();
}

/* Of a triangle: its area in the mean metric over the sum of its squared edges, 1 if it is regular there. */
inline double metric_quality(const Metric_point& a, const Metric_point& b, const Metric_point& c) {
  const Metric_tensor_3 mean = (1. / 3) * (a.metric + b.metric + c.metric);
  const Vector_3d u = b.position - a.position, v = c.position - a.position;
  const double uu = mean.squared_length(u), vv = mean.squared_length(v), uv = mean.dot(u, v);
  const double area = std::sqrt((std::max)(uu * vv - uv * uv, 0.)), sum = 2 * (uu + vv - uv);
  return sum > 0 ? 2 * std::sqrt(3.) * area / sum : 0;
}

/* Where the middle, in the metric, of an edge is, from 0 to 1; no nearer to its ends than a tenth. */
inline double metric_middle(const Metric_point& p, const Metric_point& q) {
  const Vector_3d e = q.position - p.position;
  const double a = p.metric.squared_length(e), b = q.metric.squared_length(e);
  if (!(std::abs(b - a) > 1e-3 * a))
    return 0.5;
  const double s = (std::pow((std::pow(a, 1.5) + std::pow(b, 1.5)) / 2, 2. / 3) - a) / (b - a);
  return (std::min)((std::max)(s, 0.1), 0.9);
}

/* The length (10) of an edge, the metric varying linearly between its ends. */
inline double metric_length(const Metric_point& a, const Metric_point& b) {
  return Metric_tensor_3::edge_length_linear(b.position - a.position, a.metric, b.metric);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_QUALITY_H

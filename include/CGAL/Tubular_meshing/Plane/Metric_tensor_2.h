// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_METRIC_TENSOR_2_H
#define CGAL_TUBULAR_MESHING_PLANE_METRIC_TENSOR_2_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPlane
 *
 * A symmetric 2×2 tensor, positive definite when it is the metric of a mesh in the plane: the matrix with rows
 * (xx, xy) and (xy, yy). A vector e has the length \f$ \sqrt{e^T M e} \f$; a size h in the direction of a unit
 * eigenvector is an eigenvalue \f$ 1/h^2 \f$. All functions take constant time and throw nothing.
 */
class Metric_tensor_2 {
public:
  double xx = 1, xy = 0, yy = 1;

  /// The identity: size one in all directions.
  Metric_tensor_2() = default;
  Metric_tensor_2(double xx, double xy, double yy)
      : xx(xx)
      , xy(xy)
      , yy(yy) {}

  /// The same size `h` in all directions.
  static Metric_tensor_2 isotropic(double h) { return {1 / (h * h), 0, 1 / (h * h)}; }

  /// Size `h_along` in the direction at `angle` (radians, from the first axis), `h_across` perpendicular to it.
  static Metric_tensor_2 from_sizes(double h_along, double h_across, double angle) {
    const double along = 1 / (h_along * h_along), across = 1 / (h_across * h_across);
    const double c = std::cos(angle), s = std::sin(angle);
    return {along * c * c + across * s * s, (along - across) * c * s, along * s * s + across * c * c};
  }

  /*! The metric (11) that an embedding induces: \f$ x_{,u}^T x_{,u} / h^2 \f$ for size `h` in space.
   * \param x_u derivative of the embedding by the first coordinate, a vector with `x()`, `y()`, `z()`
   * \param x_v derivative by the second coordinate
   * \param h the size */
  template <class Vector_3> static Metric_tensor_2 induced(const Vector_3& x_u, const Vector_3& x_v, double h) {
    const auto dot = [](const Vector_3& a, const Vector_3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); };
    const double s = 1 / (h * h);
    return {s * dot(x_u, x_u), s * dot(x_u, x_v), s * dot(x_v, x_v)};
  }

  double determinant() const { return xx * yy - xy * xy; }

  /// False also for NaN and infinity.
  bool is_positive_definite() const {
    const double d = determinant();
    return xx > 0 && yy > 0 && d > 0 && std::isfinite(xx) && std::isfinite(yy) && std::isfinite(d);
  }

  /// \f$ (a_x, a_y) M (b_x, b_y)^T \f$
  double dot(double a_x, double a_y, double b_x, double b_y) const {
    return a_x * (xx * b_x + xy * b_y) + a_y * (xy * b_x + yy * b_y);
  }
  double squared_length(double e_x, double e_y) const { return dot(e_x, e_y, e_x, e_y); }
  double length(double e_x, double e_y) const { return std::sqrt((std::max)(squared_length(e_x, e_y), 0.)); }

  /*! The length (10) of an edge e from a point with metric `m0` to one with metric `m1`, the size growing geometrically
   * between them: the logarithmic mean of the lengths in the two, as in Metric_tensor_3::edge_length(). What meshes the
   * plane asks for it most of the time: where the lengths differ little, it takes no logarithm. */
  static double edge_length(double e_x, double e_y, const Metric_tensor_2& m0, const Metric_tensor_2& m1) {
    const double l0 = m0.length(e_x, e_y), l1 = m1.length(e_x, e_y), r = std::abs(l0 - l1), sum = l0 + l1;
    if (!(sum > 0))
      return 0;
    if (r <= 0.1 * sum) // half the sum, but for a term of second order
      return sum / 2 * (1 - r * r / (3 * sum * sum) - 4 * r * r * r * r / (45 * sum * sum * sum * sum));
    return l0 > 0 && l1 > 0 ? (l0 - l1) / std::log(l0 / l1) : 0;
  }

  /// The vector of the same length at a right angle to (e_x, e_y), counterclockwise, both in the sense of the metric.
  std::array<double, 2> quarter_turn(double e_x, double e_y) const {
    const double s = 1 / std::sqrt(determinant());
    return {-s * (xy * e_x + yy * e_y), s * (xx * e_x + xy * e_y)};
  }

  /// The conformal class: the same tensor scaled to determinant one.
  Metric_tensor_2 normalized() const {
    const double s = 1 / std::sqrt(determinant());
    return {s * xx, s * xy, s * yy};
  }

  /// The two sizes, the smaller one first.
  std::array<double, 2> sizes() const {
    const double larger = (xx + yy) / 2 + std::hypot((xx - yy) / 2, xy);
    const double smaller = determinant() / larger; // which loses nothing at high ratios
    return {1 / std::sqrt(larger), 1 / std::sqrt(smaller)};
  }

  /// The angle, in \f$ (-\pi/2, \pi/2] \f$, of the direction in which the size is larger.
  double angle_of_larger_size() const { return xx == yy && xy == 0 ? 0 : std::atan2(-2 * xy, yy - xx) / 2; }

  /// The tensor with the same axes whose eigenvalues are a function of those of this one; f(larger, smaller) changes both.
  template <class Function> Metric_tensor_2 with_eigenvalues(const Function& f) const {
    const double mean = (xx + yy) / 2, d = (xx - yy) / 2, radius = std::hypot(d, xy);
    double larger = mean + radius, smaller = radius < mean ? determinant() / larger : mean - radius;
    const double cosine = radius > 0 ? d / radius : 1, sine = radius > 0 ? xy / radius : 0; // of twice the axis' angle
    f(larger, smaller);
    const double half_sum = (larger + smaller) / 2, half_difference = (larger - smaller) / 2;
    return {half_sum + half_difference * cosine, half_difference * sine, half_sum - half_difference * cosine};
  }

  /*! The matrix logarithm: symmetric, but no metric. Logarithms of metrics are averaged and interpolated, not metrics: a
   * scale that grows exponentially, as on a ring, is then met, and no mean is larger than what it is the mean of; exp()
   * leads back. Eigenvalues below 1e-12 of the larger one, of triangles without an area, count as that. */
  Metric_tensor_2 log() const {
    return with_eigenvalues([](double& larger, double& smaller) {
      larger = (std::max)(larger, (std::numeric_limits<double>::min)());
      smaller = (std::max)(smaller, 1e-12 * larger);
      larger = std::log(larger);
      smaller = std::log(smaller);
    });
  }
  Metric_tensor_2 exp() const {
    return with_eigenvalues([](double& larger, double& smaller) {
      larger = std::exp(larger);
      smaller = std::exp(smaller);
    });
  }

  /*! The log-Euclidean mean \f$ \exp((1-t) \log M_0 + t \log M_1) \f$: interpolates sizes geometrically, and is
   * positive definite whenever both are. */
  static Metric_tensor_2 interpolate(const Metric_tensor_2& m0, const Metric_tensor_2& m1, double t) {
    return ((1 - t) * m0.log() + t * m1.log()).exp();
  }

  friend Metric_tensor_2 operator+(const Metric_tensor_2& a, const Metric_tensor_2& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
  }
  friend Metric_tensor_2 operator*(double s, const Metric_tensor_2& m) { return {s * m.xx, s * m.xy, s * m.yy}; }
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PLANE_METRIC_TENSOR_2_H

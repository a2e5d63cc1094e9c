// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CURVE_SHAPE_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CURVE_SHAPE_H

#include <CGAL/Tubular_meshing/Centerlines/Branch_curve.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace CGAL::Tubular_meshing::internal {

struct Curve_shape {
  double curvature = 0;
  double torsion = 0; // positive where the curve turns as a right-handed screw
};

/* Curvature and torsion of a branch at an abscissa, of the polynomials of degree 4 that fit it best over two radii to
 * each side; near an end, over the last four. Points of centerlines are noisy, and each derivative makes noise larger.
 * Where the branch is as good as straight there is no plane that it bends in, and the torsion is 0. */
inline Curve_shape curve_shape(const Branch_curve& curve, double s) {
  constexpr int samples = 33, coefficients = 5;
  constexpr double least_bend = 0.02; // radii in a radius of curvature
  const double reach = (std::min)(2 * curve.radius(s), 0.5 * curve.length());
  if (!(reach > 0))
    return Curve_shape();
  const double middle = (std::min)((std::max)(s, reach), curve.length() - reach);
  Eigen::Matrix<double, samples, coefficients> powers;
  Eigen::Matrix<double, samples, 3> points;
  const Vector_3d origin = curve.point(s);
  for (int i = 0; i < samples; ++i) {
    const double u = 2 * (i + 0.5) / samples - 1, weight = 1 - u * u;
    const double at = middle + u * reach, x = (at - s) / reach;
    const Vector_3d p = (1 / reach) * (curve.point(at) - origin);
    double power = weight;
    for (int k = 0; k < coefficients; ++k, power *= x)
      powers(i, k) = power;
    for (int k = 0; k < 3; ++k)
      points(i, k) = weight * p[k];
  }
  const Eigen::Matrix<double, coefficients, 3> fit = powers.householderQr().solve(points);
  const auto derivative = [&](int order, double factorial) {
    return Vector_3d(factorial * fit(order, 0), factorial * fit(order, 1), factorial * fit(order, 2));
  };
  const Vector_3d first = derivative(1, 1), second = derivative(2, 2), third = derivative(3, 6);
  const Vector_3d binormal = cross(first, second);
  const double speed = norm(first), bend = squared_norm(binormal);
  Curve_shape shape;
  if (!(speed > 0))
    return shape;
  shape.curvature = std::sqrt(bend) / (speed * speed * speed) / reach;
  if (shape.curvature * curve.radius(s) > least_bend)
    shape.torsion = dot(binormal, third) / bend / reach;
  return shape;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CURVE_SHAPE_H

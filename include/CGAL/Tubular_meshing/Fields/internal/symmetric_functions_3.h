// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_SYMMETRIC_FUNCTIONS_3_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_SYMMETRIC_FUNCTIONS_3_H

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Tubular_meshing::internal {

/* Exponential and logarithm of a symmetric 3×3 matrix without its eigenvectors: the polynomial that interpolates the
 * function at the three eigenvalues, taken of the matrix. Several times faster than a decomposition. Entries have an
 * error of a few units in the last place of the largest one, hence the limits below; eigenvalues that nearly coincide,
 * which their formula gets wrong in half of their digits, cost nothing: interpolation is the better for close nodes. */

/* By the trigonometric solution of the cubic; xx xy xz yy yz zz; the smallest one first. */
inline std::array<double, 3> eigenvalues_by_cubic(const std::array<double, 6>& m) {
  const double mean = (m[0] + m[3] + m[5]) / 3, x = m[0] - mean, y = m[3] - mean, z = m[5] - mean;
  const double p2 = (x * x + y * y + z * z + 2 * (m[1] * m[1] + m[2] * m[2] + m[4] * m[4])) / 6;
  if (!(p2 > 0))
    return {mean, mean, mean};
  const double p = std::sqrt(p2);
  const double det = x * (y * z - m[4] * m[4]) - m[1] * (m[1] * z - m[4] * m[2]) + m[2] * (m[1] * m[4] - y * m[2]);
  const double angle = std::acos((std::max)(-1., (std::min)(1., det / (2 * p * p2)))) / 3; // 0 to 60 degrees
  const double c = std::cos(angle), s = std::sqrt((std::max)(0., 3 * (1 - c * c)));
  return {mean - p * (c + s), mean + p * (s - c), mean + 2 * p * c};
}

/* f0 I + f01 (m - l0 I) + f012 (m - l0 I) (m - l1 I), Newton's form. */
inline std::array<double, 6> newton_polynomial(const std::array<double, 6>& m, double l0, double l1, double f0,
                                               double f01, double f012) {
  const double ax = m[0] - l0, ay = m[3] - l0, az = m[5] - l0, bx = m[0] - l1, by = m[3] - l1, bz = m[5] - l1;
  const double xy = m[1], xz = m[2], yz = m[4];
  return {f0 + f01 * ax + f012 * (ax * bx + xy * xy + xz * xz), f01 * xy + f012 * (ax * xy + xy * by + xz * yz),
          f01 * xz + f012 * (ax * xz + xy * yz + xz * bz),      f0 + f01 * ay + f012 * (xy * xy + ay * by + yz * yz),
          f01 * yz + f012 * (xy * xz + ay * yz + yz * bz),      f0 + f01 * az + f012 * (xz * xz + yz * yz + az * bz)};
}

/* False, and nothing done, where eigenvalues of the result would differ by more than ten orders of magnitude. */
inline bool fast_exponential(const std::array<double, 6>& m, std::array<double, 6>& result) {
  const std::array<double, 3> l = eigenvalues_by_cubic(m);
  if (!(l[2] - l[0] < 23))
    return false;
  const double e0 = std::exp(l[0]), e1 = std::exp(l[1]);
  const auto quotient = [](double d) { return d > 0 ? std::expm1(d) / d : 1; };
  const double f01 = e0 * quotient(l[1] - l[0]), f12 = e1 * quotient(l[2] - l[1]);
  // what cancels here is multiplied by the square of the same small difference
  const double f012 = l[2] - l[0] > 1e-7 ? (f12 - f01) / (l[2] - l[0]) : e0 / 2;
  result = newton_polynomial(m, l[0], l[1], e0, f01, f012);
  return true;
}

/* The same where eigenvalues differ by more than four orders of magnitude, or are not positive. */
inline bool fast_logarithm(const std::array<double, 6>& m, std::array<double, 6>& result) {
  const std::array<double, 3> l = eigenvalues_by_cubic(m);
  if (!(l[0] > 1e-4 * l[2]))
    return false;
  const auto quotient = [](double a, double b) { return b > a ? std::log1p((b - a) / a) / (b - a) : 1 / a; };
  const double f01 = quotient(l[0], l[1]), f12 = quotient(l[1], l[2]);
  const double f012 = l[2] - l[0] > 1e-7 * l[2] ? (f12 - f01) / (l[2] - l[0]) : -0.5 / (l[0] * l[0]);
  result = newton_polynomial(m, l[0], l[1], std::log(l[0]), f01, f012);
  return true;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_SYMMETRIC_FUNCTIONS_3_H

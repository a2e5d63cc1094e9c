// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_NEWTON_STEPS_H
#define CGAL_TUBULAR_MESHING_BASE_NEWTON_STEPS_H

// Steps of Newton's method for one vertex, in space, in a plane, along a line.

#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Tubular_meshing::internal {

struct Symmetric_matrix_3d {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add_diagonal(double s) {
    xx += s;
    yy += s;
    zz += s;
  }
  void scale(double s) {
    for (double* entry : {&xx, &xy, &xz, &yy, &yz, &zz})
      *entry *= s;
  }
  void add(double s, const Symmetric_matrix_3d& m) {
    xx += s * m.xx;
    xy += s * m.xy;
    xz += s * m.xz;
    yy += s * m.yy;
    yz += s * m.yz;
    zz += s * m.zz;
  }
  // += s (u vᵀ + v uᵀ) / 2
  void add_product(double s, const Vector_3d& u, const Vector_3d& v) {
    xx += s * u.x * v.x;
    yy += s * u.y * v.y;
    zz += s * u.z * v.z;
    xy += s / 2 * (u.x * v.y + u.y * v.x);
    xz += s / 2 * (u.x * v.z + u.z * v.x);
    yz += s / 2 * (u.y * v.z + u.z * v.y);
  }
  // += s v vᵀ
  void add_square(double s, const Vector_3d& v) {
    const double x = s * v.x, y = s * v.y;
    xx += x * v.x;
    xy += x * v.y;
    xz += x * v.z;
    yy += y * v.y;
    yz += y * v.z;
    zz += s * v.z * v.z;
  }
  Vector_3d operator*(const Vector_3d& v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
  }
};

// The Newton step for a Hessian and a gradient.
inline Vector_3d newton_step(Symmetric_matrix_3d h, const Vector_3d& g) {
  // Cholesky's factors; where the Hessian is not definite, along the gradient with the trace as curvature
  const double trace = h.xx + h.yy + h.zz;
  const double floor = 1e-6 * trace;
  const double a = h.xx, b = h.xy / a, c = h.xz / a;
  const double d = h.yy - b * h.xy, e = (h.yz - b * h.xz) / d;
  const double f = h.zz - c * h.xz - e * e * d;
  if (!(a > floor && d > floor && f > floor))
    return (-1 / (std::max)(std::abs(trace), (std::numeric_limits<double>::min)())) * g;
  const double y0 = -g.x, y1 = -g.y - b * y0, y2 = -g.z - c * y0 - e * y1;
  const double z = y2 / f, y = y1 / d - e * z, x = y0 / a - b * y - c * z;
  return {x, y, z};
}

// The same within the plane perpendicular to the unit vector n.
inline Vector_3d tangential_step(const Symmetric_matrix_3d& h, const Vector_3d& g, const Vector_3d& n) {
  const Vector_3d axis = std::abs(n.x) < 0.6 ? Vector_3d(1, 0, 0) : Vector_3d(0, 1, 0);
  const Vector_3d u = normalized(cross(n, axis)), v = cross(n, u);
  const Vector_3d hu = h * u, hv = h * v;
  const double a = dot(hu, u), b = dot(hu, v), d = dot(hv, v), g0 = dot(g, u), g1 = dot(g, v);
  const double det = a * d - b * b;
  if (!(a > 0 && det > 1e-9 * a * a))
    return (-1 / (std::max)(std::abs(a) + std::abs(d), (std::numeric_limits<double>::min)())) * (g0 * u + g1 * v);
  return ((b * g1 - d * g0) / det) * u + ((b * g0 - a * g1) / det) * v;
}

// The same along the vector t.
inline Vector_3d step_along(const Symmetric_matrix_3d& h, const Vector_3d& g, const Vector_3d& t) {
  const double slope = dot(g, t), curvature = std::abs(dot(h * t, t));
  return curvature > 0 ? (-slope / curvature) * t : Vector_3d();
}

// Tries a step and then shorter ones: try_step(step) returns whether it was taken.
template <class Try> void backtrack(Vector_3d step, const Try& try_step) {
  for (int attempt = 0; attempt < 4 && !try_step(step); ++attempt)
    step = 0.4 * step;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_NEWTON_STEPS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_NEWTON_STEPS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_NEWTON_STEPS_H

#include <CGAL/Tubular_meshing/Volume/internal/Shape_energy.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Tubular_meshing::internal {

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

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_NEWTON_STEPS_H

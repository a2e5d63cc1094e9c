// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_SKELETON_CURVES_H
#define CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_SKELETON_CURVES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <cmath>

namespace CGAL::Tubular_meshing::internal {

// The cubic from p to q with tangents along u and v, of a speed that makes an arc out of perpendicular ones.
struct Hermite_curve {

  Hermite_curve(const Point_3& p, const Vector_3& u, const Point_3& q, const Vector_3& v)
      : p(p)
      , q(q) {
    const double speed = 1.1 * std::sqrt((q - p).squared_length());
    du = speed / std::sqrt(u.squared_length()) * u;
    dv = speed / std::sqrt(v.squared_length()) * v;
  }

  Point_3 operator()(double t) const {
    const double s = 1 - t;
    return p + t * t * (3 - 2 * t) * (q - p) + t * s * s * du - t * t * s * dv;
  }

  Point_3 p, q;
  Vector_3 du, dv;
};

// From one radius to another, with no slope at the ends.
struct Smooth_taper {
  double from, to;
  double operator()(double t) const { return from + (to - from) * t * t * (3 - 2 * t); }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_SKELETON_CURVES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_PLANE_FRAME_H
#define CGAL_TUBULAR_MESHING_BASE_PLANE_FRAME_H

#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <array>
#include <cmath>

namespace CGAL::Tubular_meshing::internal {

/* Coordinates in a plane and above it; counterclockwise is what turns so seen against the normal. */
struct Plane_frame {
  Vector_3d origin, u, v, normal;

  Plane_frame(const Vector_3d& origin, const Vector_3d& normal)
      : origin(origin)
      , u(normalized(cross(normal, std::abs(normal.x) < 0.6 ? Vector_3d(1, 0, 0) : Vector_3d(0, 1, 0))))
      , v(cross(normal, u))
      , normal(normal) {}

  std::array<double, 2> in_plane(const Vector_3d& p) const { return {dot(p - origin, u), dot(p - origin, v)}; }
  double height(const Vector_3d& p) const { return dot(p - origin, normal); }
  Vector_3d point(double x, double y, double height) const { return origin + x * u + y * v + height * normal; }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_PLANE_FRAME_H

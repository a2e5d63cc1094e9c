// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_OPPOSITE_BALL_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_OPPOSITE_BALL_H

#include <CGAL/Tubular_meshing/Fields/internal/Point_boxes.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Tubular_meshing::internal {

/* The largest radius, below the bound, of a ball that touches x in the direction n, of unit length, with no obstacle
 * inside that lies opposite, within 36 degrees of n; 0 if there is none in the ball of the bound. A ball that is small
 * enough but for a part of its squared radius, 1 - slack, is left: on a sphere, all of it is near the ball. */
inline double ball_within(const Point_boxes& obstacles, const Vector_3d& x, const Vector_3d& n, double bound,
                          double slack) {
  const double facing = 0.80901699437494742; // the cosine of 36 degrees
  double radius = bound;
  Vector_3d center = x + radius * n;
  obstacles.search(
      center,
      [&](const Point_boxes::Box& box) {
        if (box.squared_distance(center) >= slack * radius * radius)
          return false;
        // the box's own ball against the cone of what lies opposite
        const Vector_3d middle = 0.5 * (box.low + box.high), d = middle - x;
        const double along = dot(d, n), across = std::sqrt((std::max)(0., squared_norm(d) - along * along));
        return facing * (across - along) <= 0.5 * norm(box.high - box.low);
      },
      [&](const Vector_3d& q, double) {
        const Vector_3d d = q - x;
        const double along = dot(d, n), length2 = squared_norm(d);
        if (along > 0 && along * along >= facing * facing * length2 && length2 < 2 * along * radius * slack) {
          radius = length2 / (2 * along);
          center = x + radius * n;
        }
      });
  return radius < bound ? radius : 0;
}

/* The same whatever the radius; 0 if nothing lies opposite. Balls of about `first` are tried first: most need not be
 * shrunk from the size of all. `largest`: half of the extent of all obstacles. */
inline double opposite_ball(const Point_boxes& obstacles, const Vector_3d& x, const Vector_3d& n, double first,
                            double largest, double slack) {
  double radius = 0;
  for (double bound = (std::min)((std::max)(first, largest / 4096), largest); radius == 0 && bound < 5 * largest;
       bound *= 4)
    radius = ball_within(obstacles, x, n, bound, slack);
  return radius;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_OPPOSITE_BALL_H

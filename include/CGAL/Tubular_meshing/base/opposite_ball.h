// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_OPPOSITE_BALL_H
#define CGAL_TUBULAR_MESHING_BASE_OPPOSITE_BALL_H

#include <CGAL/Tubular_meshing/base/Point_boxes.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The largest radius, below the bound, of a ball that touches x in the direction n, of unit length, with no obstacle
 * inside that lies opposite, within 36 degrees of n, and for whose value counts(value) holds; 0 if there is none in the ball
 * of the bound. It is that of the obstacle whose ball is the smallest, in whatever order they are found, wherever it all lies
 * in space. */
template <class Counts>
double ball_within(const Point_boxes& obstacles, const Vector_3d& x, const Vector_3d& n, double bound,
                   const Counts& counts) {
  // 36 degrees and 1e-7 of one: a regular tube has points right there
  const double cosine = 0.809016993, sine = 0.587785254;
  const double as_near = 1 + 1e-12;
  double radius = bound;
  Vector_3d center = x + radius * n;
  obstacles.search(
      center,
      [&](const Point_boxes::Box& box) {
        if (box.squared_distance(center) > as_near * radius * radius)
          return false;
        // the box's own ball against the cone of what lies opposite
        const Vector_3d middle = 0.5 * (box.low + box.high), d = middle - x;
        const double along = dot(d, n), across = std::sqrt((std::max)(0., squared_norm(d) - along * along));
        return cosine * across - sine * along <= box.half_diagonal;
      },
      [&](const Vector_3d& q, double value) {
        const Vector_3d d = q - x;
        const double along = dot(d, n), length2 = squared_norm(d);
        if (along > 0 && along * along >= cosine * cosine * length2 && length2 < 2 * along * radius && counts(value)) {
          radius = length2 / (2 * along);
          center = x + radius * n;
        }
      });
  return radius < bound ? radius : 0;
}

inline double ball_within(const Point_boxes& obstacles, const Vector_3d& x, const Vector_3d& n, double bound) {
  return ball_within(obstacles, x, n, bound, [](double) { return true; });
}

/* The same up to four times the extent of all obstacles; 0 if nothing lies opposite. Balls of about `first` are tried first,
 * which has no influence: most need not be shrunk from the size of all. */
inline double opposite_ball(const Point_boxes& obstacles, const Vector_3d& x, const Vector_3d& n, double first,
                            double extent) {
  const double largest = 4 * extent;
  for (double bound = (std::max)(first, extent / 4096);; bound *= 4) {
    const double radius = ball_within(obstacles, x, n, (std::min)(bound, largest));
    if (radius > 0 || bound >= largest)
      return radius;
  }
}

/* The largest distance of points from their mean, which is the same in any direction. */
inline double extent_of(const std::vector<Vector_3d>& points) {
  Vector_3d mean;
  for (const Vector_3d& p : points)
    mean += (1 / double(points.size())) * p;
  double squared = 0;
  for (const Vector_3d& p : points)
    squared = (std::max)(squared, squared_norm(p - mean));
  return std::sqrt(squared);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_OPPOSITE_BALL_H

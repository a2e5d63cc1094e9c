// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_WALL_RINGS_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_WALL_RINGS_H

#include <CGAL/Tubular_meshing/Hexahedra/internal/Opening_rim.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Vessel_path.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Wall_of_lumen.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Points of the wall round a vessel, counterclockwise seen against the direction of its path, and the point inside that
 * they are seen from. */
struct Wall_ring {
  Vector_3d center;
  std::vector<Vector_3d> points;

  // Between two points, where the step is no whole number.
  Vector_3d at(double step) const {
    const double whole = std::floor(step), t = step - whole;
    const std::size_t n = points.size(), i = std::size_t(whole) % n;
    return (1 - t) * points[i] + t * points[(i + 1) % n];
  }

  // The mean angle by which its points are turned about the tangent, against evenly spaced ones that begin at u.
  double turn(const Path_frames::Frame& frame) const {
    double c = 0, s = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector_3d d = points[i] - center;
      const double x = dot(d, frame.u), y = dot(d, frame.v());
      const double angle = std::atan2(y, x) - 2 * pi * double(i) / double(points.size());
      c += std::hypot(x, y) * std::cos(angle);
      s += std::hypot(x, y) * std::sin(angle);
    }
    return std::atan2(s, c);
  }

  // How far it reaches beyond a plane.
  double reach(const Vector_3d& p, const Vector_3d& normal) const {
    double most = -(std::numeric_limits<double>::infinity)();
    for (const Vector_3d& q : points)
      most = (std::max)(most, dot(q - p, normal));
    return most;
  }
};

/* Makes rings of a number of points. */
class Wall_rings {
public:
  Wall_rings(const Wall_of_lumen& wall, const Opening_rims& rims, int around)
      : wall_(wall)
      , rims_(rims)
      , around_(around) {}

  int around() const { return around_; }

  // The wall seen from p, no farther than the bound.
  Vector_3d seen(const Vector_3d& p, const Vector_3d& direction, double bound) const {
    const double hit = wall_.along(p, direction, bound);
    return hit < bound ? p + hit * direction : wall_.nearest(p + 0.5 * bound * direction);
  }
  double reach(const Vector_3d& center) const { return 4 * wall_.distance(center); }

  /* Round a vessel: in the plane across its path, or on a cone that leads ahead. */
  Wall_ring across(const Vector_3d& center, const Path_frames::Frame& frame, double turn, double radius,
                   double ahead = 0) const {
    Wall_ring ring{center, {}};
    const double bound = (std::max)(reach(center), 3 * radius);
    for (int a = 0; a < around_; ++a) {
      const double angle = turn + 2 * pi * a / around_;
      const Vector_3d d = std::cos(angle) * frame.u + std::sin(angle) * frame.v() + ahead * frame.tangent;
      ring.points.push_back(seen(center, normalized(d), bound));
    }
    return ring;
  }

  /* Between two rings, on the wall. */
  Wall_ring between(const Wall_ring& from, const Wall_ring& to, double t, const Vector_3d& center) const {
    Wall_ring ring{center, {}};
    for (int a = 0; a < around_; ++a)
      ring.points.push_back(wall_.nearest((1 - t) * from.points[a] + t * to.points[a]));
    return ring;
  }

  /* Round an opening: at equal distances along its rim. */
  Wall_ring on_rim(int opening, const Path_frames::Frame& frame, double turn) const {
    const Opening_rim& rim = rims_.at(opening);
    std::vector<Vector_3d> points = rim.points;
    if (dot(rim.normal, frame.tangent) < 0)
      std::reverse(points.begin(), points.end());
    const std::size_t n = points.size();
    std::vector<double> abscissa{0};
    for (std::size_t i = 0; i < n; ++i)
      abscissa.push_back(abscissa.back() + norm(points[(i + 1) % n] - points[i]));
    const double length = abscissa.back();
    const auto at = [&](double a) {
      a -= std::floor(a / length) * length;
      const auto next = std::upper_bound(abscissa.begin() + 1, abscissa.end() - 1, a);
      const std::size_t i = std::size_t(next - abscissa.begin()) - 1;
      const double t = (a - abscissa[i]) / (abscissa[i + 1] - abscissa[i]);
      return (1 - t) * points[i] + t * points[(i + 1) % n];
    };
    Wall_ring ring{rim.center, {}};
    double start = 0;
    for (int round = 0; round < 8; ++round) { // until its points are turned as wanted
      ring.points.clear();
      for (int a = 0; a < around_; ++a)
        ring.points.push_back(at(start + length * a / around_));
      start -= std::remainder(ring.turn(frame) - turn, 2 * pi) / (2 * pi) * length;
    }
    return ring;
  }

private:
  const Wall_of_lumen& wall_;
  const Opening_rims& rims_;
  int around_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_WALL_RINGS_H

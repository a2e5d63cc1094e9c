// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ELLIPTIC_ANNULAR_CHART_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ELLIPTIC_ANNULAR_CHART_H

#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Coordinates of an annular patch that unroll it: X, of period 2π, grows along loop 0, Y from loop 0 to loop 1. They
 * are the angle and the logarithm of the radius in the plane, so that they are conformal if the map is, and a tube is a
 * rectangle however long it is. Counterclockwise seen from outside, as the plane is. */
class Annular_chart {
public:
  typedef Patch_parameterization Map;
  typedef Map::Point_2 Point_2;
  static constexpr double period = 2 * CGAL_PI;

  explicit Annular_chart(const Map& map)
      : map_(map)
      , sign_(map.outer_loop() == 0 ? 1 : -1) {
    if (!is_inside_of_loops())
      center_ = centroid(1 - map.outer_loop());
    is_unrolled_ = is_inside_of_loops();
  }

  // Not so if a loop winds so much in the plane that it has no middle; then there are no coordinates.
  bool is_unrolled() const { return is_unrolled_; }

  /* Places in chart coordinates, in a row: angles go on from one to the next by the shorter way. */
  std::vector<Eigen::Vector2d> row(const std::vector<Patch_location>& locations) const {
    std::vector<Eigen::Vector2d> result;
    for (const Patch_location& at : locations) {
      Eigen::Vector2d w = coordinates(map_.uv(at));
      if (!result.empty())
        w.x() += period * std::round((result.back().x() - w.x()) / period);
      result.push_back(w);
    }
    return result;
  }

  Patch_location locate(const Eigen::Vector2d& w, int hint) const {
    const Eigen::Vector2d u = center_ + std::exp(-sign_ * w.y()) * direction(w);
    return map_.locate(Point_2(u.x(), u.y()), hint);
  }

  const Map& map() const { return map_; }

private:
  Eigen::Vector2d direction(const Eigen::Vector2d& w) const {
    return Eigen::Vector2d(std::cos(w.x()), sign_ * std::sin(w.x()));
  }
  Eigen::Vector2d coordinates(const Point_2& uv) const {
    const Eigen::Vector2d d = Eigen::Vector2d(uv.x(), uv.y()) - center_;
    return Eigen::Vector2d(sign_ * std::atan2(d.y(), d.x()), -sign_ * std::log(d.norm()));
  }

  // Whether each loop turns around the middle once, X growing along loop 0 and falling along loop 1.
  bool is_inside_of_loops() const {
    for (std::size_t l = 0; l < 2; ++l) {
      double turned = 0;
      const std::vector<int>& loop = map_.patch().loops[l];
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const double d = coordinates(map_.uv(loop[(i + 1) % loop.size()])).x() - coordinates(map_.uv(loop[i])).x();
        turned += d - period * std::round(d / period);
      }
      if (!(std::abs(turned - (l == 0 ? period : -period)) < 1))
        return false;
    }
    return true;
  }

  Eigen::Vector2d centroid(std::size_t l) const {
    const std::vector<int>& loop = map_.patch().loops[l];
    const Eigen::Vector2d first(map_.uv(loop[0]).x(), map_.uv(loop[0]).y());
    Eigen::Vector2d moment(0, 0);
    double area = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Point_2 p = map_.uv(loop[i]), q = map_.uv(loop[i + 1]);
      const Eigen::Vector2d a = Eigen::Vector2d(p.x(), p.y()) - first, b = Eigen::Vector2d(q.x(), q.y()) - first;
      const double c = a.x() * b.y() - a.y() * b.x();
      area += c;
      moment += c / 3 * (a + b);
    }
    return first + moment / area;
  }

  const Map& map_;
  const double sign_; // of the turn of loop 0 in the plane
  Eigen::Vector2d center_ = Eigen::Vector2d(0, 0);
  bool is_unrolled_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ELLIPTIC_ANNULAR_CHART_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ROUND_END_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ROUND_END_H

#include <CGAL/Tubular_meshing/Openings/internal/Lumen_tree.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The end of a vessel, seen from its leaf, which is the centre of the largest ball that touches the tip: how the radius
 * changes on the way into the vessel, and so where the dome begins. All bounds are relative to the radii there. */
class Round_end {
public:
  explicit Round_end(const Lumen_tree::Line& line)
      : points_(line.points)
      , radii_(line.radii)
      , way_(line.way)
      , ends_at_junction_(line.ends_at_junction) {
    base_ = find_base();
  }

  /* The centre of the largest ball that touches the tip. */
  const Point_3& center() const { return points_.front(); }
  double tip_radius() const { return radii_.front(); }
  /* The place at which the dome begins, and the radius there. */
  const Point_3& base() const { return points_[base_]; }
  double radius() const { return radii_[base_]; }
  double length() const { return way_.back(); }
  bool ends_at_junction() const { return ends_at_junction_; }

  /* Out of the vessel, at the dome's base: the direction of the last radius of the line, or of what the vessel has of
   * its own if that is less. */
  Vector_3 direction() const {
    const std::size_t behind = at(way_[base_] + (std::max)(0.4 * radius(), (std::min)(radius(), level_length())));
    Vector_3 d = points_[0] - points_[behind];
    return d / std::sqrt(d.squared_length());
  }

  /* Where the line is at a distance behind the base. */
  Point_3 behind_base(double distance) const { return points_[at(way_[base_] + distance)]; }

  /* Where the line is between the base and the leaf, at a fraction of the way. */
  Point_3 before_base(double fraction) const { return points_[at((1 - fraction) * way_[base_])]; }

  /* How far behind the base the radius stays that of the vessel: it neither narrows as behind a bulb, nor widens as where
   * the line gets into a larger vessel. */
  double level_length() const {
    for (std::size_t i = base_; i < way_.size(); ++i)
      if (radii_[i] * narrower < radius() || radii_[i] > wider * radius() || way_[i] > way_to_junction())
        return way_[i] - way_[base_];
    return way_.back() - way_[base_];
  }

  /* How far the last ball gets out of those of larger vessels, its own line's and the given ones: in radii, as a share of
   * how far a vessel gets out of such a ball at least. Infinite where there are none. */
  double height_over(const std::vector<Lumen_tree::Ball>& others) const {
    double height = (std::numeric_limits<double>::infinity)();
    const auto compare = [&](const Point_3& p, double r) {
      height = (std::min)(height, (point_distance(points_[0], p) + radii_[0] - r) / (least_height_over(r) * radius()));
    };
    for (std::size_t i = base_; i < points_.size(); ++i)
      if (radii_[i] > wider * radius())
        compare(points_[i], radii_[i]);
    for (const auto& ball : others)
      compare(ball.center, ball.radius);
    return height;
  }

  static constexpr double narrower = 1.15, wider = 1.25;

private:
  // A vessel gets out of the one that it leaves by more than a half ball does; one that is thin against it by more. What
  // counts is the vessel that it leaves: on the far side of that there may be a sac.
  static constexpr double min_height = 1.2, thin = 0.15, min_height_if_thin = 3;

  double least_height_over(double r) const { return radius() < thin * r ? min_height_if_thin : min_height; }

  // The first point at least so far from the leaf, or the last one.
  std::size_t at(double way) const {
    const auto i = std::lower_bound(way_.begin(), way_.end(), way);
    return i == way_.end() ? way_.size() - 1 : std::size_t(i - way_.begin());
  }

  // Where the line leaves the vessel that this one comes from: there its radius is that of another vessel.
  double way_to_junction() const {
    return ends_at_junction_ ? (std::max)(0., way_.back() - radii_.back()) : way_.back();
  }

  // Where the radius grows no more than that of a vessel that tapers; within the next half of a radius, where it hardly
  // grows.
  std::size_t find_base() const {
    const std::size_t first = first_with(0.92, 0.75, 0, (std::numeric_limits<double>::infinity)());
    const std::size_t level = first_with(0.985, 0.4, first, way_[first] + 0.6 * radii_[first]);
    return level < points_.size() ? level : first;
  }

  // The first point from one on, and not beyond a length, of which the radius is such a share of that some radii
  // further in. Of the first search the last point if there is none.
  std::size_t first_with(double share, double ahead, std::size_t from, double most) const {
    for (std::size_t i = from; i + 1 < points_.size() && way_[i] <= most; ++i) {
      const double further = way_[i] + ahead * radii_[i];
      const std::size_t j = (std::max)(at(further), (std::min)(i + 3, points_.size() - 1)); // samples may be far apart
      if (further > way_to_junction() || radii_[i] > share * radii_[j])
        return i;
    }
    return most < (std::numeric_limits<double>::infinity)() ? points_.size() : points_.size() - 1;
  }

  std::vector<Point_3> points_; ///< from the leaf to where the vessel begins
  std::vector<double> radii_, way_;
  bool ends_at_junction_ = false;
  std::size_t base_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ROUND_END_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ROUND_END_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ROUND_END_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

enum class Blind_end_kind { vessel, sac, bump };

/* The end of a branch, seen from its leaf, which is the centre of the largest ball that touches the tip: how the radius
 * changes on the way into the vessel, and so where the dome begins. All bounds are relative to the radii there. */
class Round_end {
public:
  Round_end(const Centerline_graph& graph, std::size_t leaf)
      : center_(graph.points()[graph.nodes()[leaf].point]) {
    const auto& branch = graph.branches()[graph.nodes()[leaf].branches.front()];
    const bool is_last = branch.target == leaf;
    for (std::size_t i = 0; i < branch.points.size(); ++i)
      add(graph, branch.points[is_last ? branch.points.size() - 1 - i : i]);
    const std::size_t other = is_last ? branch.source : branch.target;
    ends_at_junction_ = !graph.nodes()[other].is_end();
    base_ = find_base();
  }

  /* The centre of the largest ball that touches the tip. */
  const Point_3& center() const { return center_; }
  /* The place at which the dome begins, and the radius there. */
  const Point_3& base() const { return points_[base_]; }
  double radius() const { return radii_[base_]; }
  double length() const { return way_.back(); }

  Blind_end_kind kind() const {
    if (is_sac())
      return Blind_end_kind::sac;
    return is_bump() ? Blind_end_kind::bump : Blind_end_kind::vessel;
  }

  /* Out of the vessel, at the dome's base: the direction of the last radius of the line. */
  Vector_3 direction() const {
    const std::size_t behind = at(way_[base_] + radius());
    Vector_3 d = points_[0] - points_[behind];
    return d / std::sqrt(d.squared_length());
  }

  /* Where the line is at a distance behind the base. */
  Point_3 behind_base(double distance) const { return points_[at(way_[base_] + distance)]; }

private:
  void add(const Centerline_graph& graph, std::size_t point) {
    const Point_3& p = graph.points()[point];
    way_.push_back(points_.empty() ? 0 : way_.back() + point_distance(points_.back(), p));
    points_.push_back(p);
    radii_.push_back(graph.radii()[point]);
  }

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

  // Wider than its neck, and not much longer than wide: what goes on behind a stenosis is a vessel.
  bool is_sac() const {
    if (!ends_at_junction_)
      return false;
    double widest = 0, widest_before_neck = 0;
    std::size_t neck = base_;
    for (std::size_t i = base_; i < radii_.size(); ++i) {
      widest = (std::max)(widest, radii_[i]);
      if (radii_[i] < radii_[neck]) {
        neck = i;
        widest_before_neck = widest;
      }
    }
    return widest_before_neck > 1.15 * radii_[neck] && way_[neck] + radii_[0] < 4 * widest_before_neck;
  }

  // Hardly out of the vessel that it sits on.
  bool is_bump() const { return length() < (ends_at_junction_ ? radii_.back() + 0.3 * radius() : radius()); }

  Point_3 center_;
  std::vector<Point_3> points_; ///< from the leaf to where the branch begins
  std::vector<double> radii_, way_;
  bool ends_at_junction_ = false;
  std::size_t base_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ROUND_END_H

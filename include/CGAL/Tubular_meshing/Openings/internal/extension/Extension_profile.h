// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_PROFILE_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_PROFILE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A point of an extension unrolled into the plane: the angle along the circumference, and the height along the axis,
 * in radii, so that the plane is nearly isometric to the tube. */
struct Unrolled_point {
  double angle = 0, height = 0;
};

/* The shape of one extension: the surface that leads from a rim to a circle around the axis, as a function of angle and
 * height. Angles are lengths along the rim's projection across the axis, so that they increase around any rim, be it
 * noisy or not convex; at the circle they are polar angles. Heights are counted from the centre of the projection. */
class Extension_profile {

public:
  static constexpr double transition = 2;  // in radii: the height over the rim in which the profile becomes a circle
  static constexpr int least_corners = 12; // of the circle

  Extension_profile() {}
  /* `rim` turns left about `direction`, the unit vector of the axis. */
  Extension_profile(const std::vector<Point_3>& rim, const Vector_3& direction) {
    Rim_shape across;
    rim_weights(rim, across.perimeter);
    const Point_3& farthest = *std::max_element(rim.begin(), rim.end(), [&](const Point_3& p, const Point_3& q) {
      return squared_distance_to_axis(p, rim[0], direction) < squared_distance_to_axis(q, rim[0], direction);
    });
    if (!(squared_distance_to_axis(farthest, rim[0], direction) > 0))
      return;
    across.plane = Rim_plane(rim[0], direction, farthest - rim[0]);
    measure_in_plane(rim, across);
    radius_ = across.radius;
    if (!(radius_ > 0) || !is_simple_across(rim, across.plane)) {
      radius_ = 0;
      return;
    }
    const Vector_3 shift = heights_mean(rim, across) * direction;
    axis_ = Rim_plane(across.center + shift, direction, farthest - rim[0]);
    unroll(rim);
    choose_corners();
    end_ = highest_;
  }

  /* False if the rim seen along the axis crosses itself: no straight tube can begin there. */
  bool is_valid() const { return radius_ > 0; }

  double radius() const { return radius_; } ///< of the disk that has the area of the rim seen along the axis
  const Rim_plane& axis() const { return axis_; }
  std::size_t size() const { return rim_.size(); } ///< of the rim
  const Unrolled_point& rim(std::size_t i) const { return rim_[i % rim_.size()]; }
  double lowest() const { return lowest_; }
  double highest() const { return highest_; } ///< of the rim's vertices
  int corners() const { return corners_; }    ///< of the circle
  double edge_length() const { return 2 * CGAL_PI / corners_; }
  double end() const { return end_; } ///< height of the far end
  void set_end(double height) { end_ = height; }

  /* The length of the edge from rim vertex i to the next, in radii. */
  double rim_edge(std::size_t i) const { return edges_[i % edges_.size()]; }

  /* The edge of the rim below an angle: its first vertex, and how far along it the angle is, from 0 to 1. */
  std::pair<std::size_t, double> rim_at(double angle) const {
    const double turn = 2 * CGAL_PI;
    angle -= turn * std::floor((angle - rim_[0].angle) / turn);
    const auto after = std::upper_bound(rim_.begin(), rim_.end(), angle,
                                        [](double a, const Unrolled_point& p) { return a < p.angle; });
    const std::size_t i = after == rim_.begin() ? 0 : std::size_t(after - rim_.begin()) - 1;
    const double from = rim_[i].angle, to = i + 1 < rim_.size() ? rim_[i + 1].angle : rim_[0].angle + turn;
    return {i, to > from ? (std::min)(1., (std::max)(0., (angle - from) / (to - from))) : 0};
  }

  Point_3 point(const Unrolled_point& p) const {
    const auto [i, s] = rim_at(p.angle);
    const std::size_t j = (i + 1) % rim_.size();
    const double base = (1 - s) * rim_[i].height + s * rim_[j].height;
    const double t = (std::min)(1., (std::max)(0., (p.height - base) / (std::min)(transition, end_ - base)));
    const double circle = t * t * (3 - 2 * t);
    std::array<double, 2> q;
    for (int k : {0, 1})
      q[k] = (1 - circle) * ((1 - s) * section_[i][k] + s * section_[j][k]) +
             circle * circle_radius_ * (k == 0 ? std::cos(p.angle) : std::sin(p.angle));
    return axis_.in_space({radius_ * q[0], radius_ * q[1]}) + radius_ * p.height * axis_.normal();
  }

  Point_3 axis_point(double height) const { return axis_.origin() + radius_ * height * axis_.normal(); }

private:
  static double squared_distance_to_axis(const Point_3& p, const Point_3& origin, const Vector_3& direction) {
    return CGAL::cross_product(p - origin, direction).squared_length();
  }

  static bool is_simple_across(const std::vector<Point_3>& rim, const Rim_plane& plane) {
    std::vector<Kernel::Point_2> polygon;
    for (const Point_3& p : rim) {
      const auto q = plane.in_plane(p);
      polygon.emplace_back(q[0], q[1]);
    }
    return CGAL::is_simple_2(polygon.begin(), polygon.end(), Kernel());
  }

  // Over the plane, weighted by the lengths of edges: of the rim's own centre.
  static double heights_mean(const std::vector<Point_3>& rim, const Rim_shape& across) {
    double perimeter = 0, sum = 0;
    const std::vector<double> weights = rim_weights(rim, perimeter);
    for (std::size_t i = 0; i < rim.size(); ++i)
      sum += weights[i] / perimeter * across.plane.height(rim[i]);
    return sum;
  }

  void unroll(const std::vector<Point_3>& rim) {
    double length = 0;
    std::vector<double> lengths;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const auto q = axis_.in_plane(rim[i]), next = axis_.in_plane(rim[(i + 1) % rim.size()]);
      section_.push_back({q[0] / radius_, q[1] / radius_});
      lengths.push_back(length);
      length += std::hypot(next[0] - q[0], next[1] - q[1]);
      edges_.push_back(point_distance(rim[i], rim[(i + 1) % rim.size()]) / radius_);
    }
    // the circle is turned so that on average its points stand over those of the rim
    double x = 0, y = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const double offset = std::atan2(section_[i][1], section_[i][0]) - 2 * CGAL_PI * lengths[i] / length;
      const double weight = edges_[i] + edges_[(i + rim.size() - 1) % rim.size()];
      x += weight * std::cos(offset);
      y += weight * std::sin(offset);
    }
    const double phase = std::atan2(y, x);
    for (std::size_t i = 0; i < rim.size(); ++i)
      rim_.push_back({phase + 2 * CGAL_PI * lengths[i] / length, axis_.height(rim[i]) / radius_});
    const auto by_height = [](const Unrolled_point& p, const Unrolled_point& q) { return p.height < q.height; };
    lowest_ = std::min_element(rim_.begin(), rim_.end(), by_height)->height;
    highest_ = std::max_element(rim_.begin(), rim_.end(), by_height)->height;
  }

  // As many that edges are as long as the rim's, whose mean is weighted by length: tiny edges count little.
  void choose_corners() {
    double sum = 0, squares = 0;
    for (double e : edges_) {
      sum += e;
      squares += e * e;
    }
    corners_ = (std::max)(least_corners, int(std::lround(2 * CGAL_PI * sum / squares)));
    circle_radius_ = std::sqrt(2 * CGAL_PI / (corners_ * std::sin(2 * CGAL_PI / corners_)));
  }

  Rim_plane axis_; // the plane across
  double radius_ = 0;
  std::vector<Unrolled_point> rim_;
  std::vector<std::array<double, 2>> section_; // of the rim across the axis, in radii
  std::vector<double> edges_;                  // of the rim, in radii
  double lowest_ = 0, highest_ = 0, end_ = 0;
  int corners_ = least_corners;
  double circle_radius_ = 1; // in radii: the polygon of the corners has the area of the disk
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_PROFILE_H

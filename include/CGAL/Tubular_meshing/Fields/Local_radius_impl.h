// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_LOCAL_RADIUS_IMPL_H
#define CGAL_TUBULAR_MESHING_FIELDS_LOCAL_RADIUS_IMPL_H

#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/base/Point_boxes.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

// From 0 to 1, smoothly, as x goes from a to b.
inline double smooth_step(double a, double b, double x) {
  const double t = (std::min)(1., (std::max)(0., (x - a) / (b - a)));
  return t * t * (3 - 2 * t);
}

} // namespace internal

class Local_radius::Impl {
public:
  Impl(const Centerline_field& centerlines, const Wall_distance& wall, Shape_radius_options options)
      : centerlines_(centerlines)
      , bbox_(wall.bbox())
      , shape_(wall, turned(options, centerlines, wall)) {
    collect_places_of_balls(options.number_of_threads);
  }

  Radii at(const Point_3& x, double reach) const {
    const Shape_radius::Ball ball = shape_.ball(x);
    Radii r = beside_wall(ball);
    if (is_outside(x, ball, r.of_centerline.point))
      r.distance_outside = std::sqrt(squared_distance(x, ball.on_wall));
    if (r.distance_outside <= reach)
      find_shares(ball, r);
    return r;
  }

  CGAL::Bbox_3 bbox() const { return bbox_; }

  double largest_width(const Point_3& x, double width_per_radius, double bound) const {
    const double worth_it = 0.9; // leaves are halved: a width that is a little less changes nothing
    const internal::Vector_3d p(x);
    double width = bound;
    places_.search(
        p,
        [&](const internal::Point_boxes::Box& box) {
          return (std::max)(2 * box.distance_of_cubes(p), width_per_radius * box.smallest_value) < worth_it * width;
        },
        [&](const internal::Vector_3d& q, double radius) {
          const internal::Vector_3d d = q - p;
          const double apart = (std::max)({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
          width = (std::min)(width, (std::max)(2 * apart, width_per_radius * radius));
        });
    return width;
  }

private:
  /* A point inside is seen from the wall in the ball's direction, but beyond the wall's ends, so are half of those
   * outside. Beyond the wall as the centerline sees it are those, but also points inside a wide vessel, next to a narrow one
   * at whose mouth the wall is nearest. */
  static bool is_outside(const Point_3& x, const Shape_radius::Ball& ball, const Point_3& on_centerline) {
    const internal::Vector_3d wall(ball.on_wall);
    const bool is_seen = !ball.is_at_rim && ball.radius > 0 &&
                         dot(internal::Vector_3d(x) - wall, internal::Vector_3d(ball.center) - wall) > 0;
    return !is_seen && squared_distance(x, on_centerline) > squared_distance(ball.on_wall, on_centerline);
  }

  Radii beside_wall(const Shape_radius::Ball& ball) const {
    Radii r;
    r.on_wall = ball.on_wall;
    r.of_centerline = centerlines_.descriptors(ball.on_wall);
    r.of_ball = ball.radius;
    r.distance_outside = r.share_of_ball = r.outside = 0;
    return r;
  }

  void find_shares(const Shape_radius::Ball& ball, Radii& r) const {
    if (!(ball.radius > 0))
      return;
    const Centerline_field::Descriptors of_center = centerlines_.descriptors(ball.center);
    r.share_of_ball = internal::smooth_step(0.4, 0.75, of_center.distance / ball.radius);
    r.outside = (std::max)(internal::smooth_step(1.25, 1.7, r.of_centerline.distance / r.of_centerline.radius),
                           internal::smooth_step(0.85, 1.05, of_center.distance / of_center.radius));
  }

  // A surface may be turned inward: then the centerlines lie in front of most of its triangles.
  static Shape_radius_options turned(Shape_radius_options options, const Centerline_field& centerlines,
                                     const Wall_distance& wall) {
    const std::size_t n = wall.number_of_triangles(), step = n / 1000 + 1;
    int in_front = 0;
    for (std::size_t i = 0; i < n; i += step) {
      const auto t = wall.triangle(i);
      const internal::Vector_3d a(t[0]), b(t[1]), c(t[2]);
      const internal::Vector_3d middle = (1. / 3) * (a + b + c);
      const internal::Vector_3d axis(centerlines.descriptors(Point_3(middle.x, middle.y, middle.z)).point);
      in_front += dot(axis - middle, cross(b - a, c - a)) > 0 ? 1 : -1;
    }
    options.turned_inward = in_front > 0;
    return options;
  }

  void collect_places_of_balls(int threads) {
    const std::vector<Shape_radius::Ball> balls = shape_.balls();
    std::vector<double> radius(balls.size(), 0);
    internal::for_each_range(balls.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        Radii r = beside_wall(balls[i]);
        find_shares(balls[i], r);
        const double of_centerline = (std::max)(r.of_centerline.radius, r.of_centerline.distance);
        if (r.share_against(of_centerline) > 0)
          radius[i] = r.combined(of_centerline);
      }
    });
    std::vector<internal::Vector_3d> points;
    std::vector<double> radii;
    for (std::size_t i = 0; i < balls.size(); ++i)
      if (radius[i] > 0) {
        points.emplace_back(balls[i].on_wall);
        radii.push_back(radius[i]);
      }
    places_ = internal::Point_boxes(points, radii);
  }

  Centerline_field centerlines_;
  CGAL::Bbox_3 bbox_;
  Shape_radius shape_;
  internal::Point_boxes places_; // where the ball counts, with the radius there
};

CGAL_TUBULAR_MESHING_INLINE Local_radius::Local_radius(const Centerline_field& centerlines, const Wall_distance& wall,
                                                       const Shape_radius_options& options)
    : impl_(std::make_shared<const Impl>(centerlines, wall, options)) {}

CGAL_TUBULAR_MESHING_INLINE double Local_radius::operator()(const Point_3& x) const {
  const Radii r = radii(x);
  return r.combined(r.of_centerline.radius);
}

CGAL_TUBULAR_MESHING_INLINE double Local_radius::Radii::combined(double radius_of_centerline) const {
  const double share = share_against(radius_of_centerline);
  return share == 0 ? radius_of_centerline : std::pow(radius_of_centerline, 1 - share) * std::pow(of_ball, share);
}

CGAL_TUBULAR_MESHING_INLINE double Local_radius::Radii::share_against(double radius_of_centerline) const {
  if (!(of_ball > 0))
    return 0;
  using internal::smooth_step;
  const double ratio = std::log(of_ball / radius_of_centerline);
  const double share = (std::max)({share_of_ball, smooth_step(std::log(1.25), std::log(1.6), ratio),
                                   smooth_step(std::log(1.5), std::log(2.), -ratio)});
  return share * outside;
}

CGAL_TUBULAR_MESHING_INLINE Local_radius::Radii Local_radius::radii(const Point_3& x, double reach) const {
  return impl_->at(x, reach);
}

CGAL_TUBULAR_MESHING_INLINE double Local_radius::largest_width(const Point_3& x, double width_per_radius,
                                                               double bound) const {
  return impl_->largest_width(x, width_per_radius, bound);
}

CGAL_TUBULAR_MESHING_INLINE CGAL::Bbox_3 Local_radius::bbox() const {
  return impl_->bbox();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_FIELDS_LOCAL_RADIUS_IMPL_H

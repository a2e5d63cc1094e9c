// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_SHAPE_RADIUS_IMPL_H
#define CGAL_TUBULAR_MESHING_FIELDS_SHAPE_RADIUS_IMPL_H

#include <CGAL/Tubular_meshing/Fields/Shape_radius.h>
#include <CGAL/Tubular_meshing/Fields/curvature.h>
#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/Fields/internal/Wall_balls.h>
#include <CGAL/Tubular_meshing/base/Growing_numbering.h>
#include <CGAL/Tubular_meshing/base/Triangle_soup.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/place_on_curve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

class Shape_radius::Impl {
public:
  Impl(const Wall_distance& wall, const Shape_radius_options& options)
      : wall_(wall)
      , faces_(welded(wall)) {
    const internal::Indexed_wall indexed(faces_);
    const internal::Wall_balls balls(indexed, options.turned_inward ? -1 : 1, options.number_of_threads);
    radii_ = balls.radii();
    directions_ = balls.directions();
  }

  Ball at(const Point_3& x) const {
    const Wall_distance::Place place = wall_.closest_place(x);
    const auto& t = faces_.triangles[place.triangle];
    const std::array<double, 3> weights = coordinates(internal::Vector_3d(place.point), t);
    double log_radius = 0, sum = 0;
    internal::Vector_3d center;
    for (int k = 0; k < 3; ++k)
      if (radii_[t[k]] > 0) {
        log_radius += weights[k] * std::log(radii_[t[k]]);
        center += weights[k] * this->center(t[k]);
        sum += weights[k];
      }
    if (!(sum > 0))
      return Ball{place.point, place.point, 0};
    center = (1 / sum) * center;
    return Ball{place.point, Point_3(center.x, center.y, center.z), std::exp(log_radius / sum)};
  }

  std::vector<Ball> all() const {
    std::vector<Ball> result;
    for (std::uint32_t v = 0; v < faces_.points.size(); ++v) {
      const internal::Vector_3d c = center(v);
      result.push_back(Ball{faces_.points[v], Point_3(c.x, c.y, c.z), radii_[v]});
    }
    return result;
  }

private:
  typedef std::array<std::uint32_t, 3> Triangle;
  typedef internal::Growing_numbering<internal::Coordinates, internal::Hash_of_coordinates> Places;

  // The triangles with their corners numbered by places, so that they know their neighbours.
  static internal::Indexed_triangles welded(const Wall_distance& wall) {
    internal::Indexed_triangles result;
    Places places;
    result.triangles.resize(wall.number_of_triangles());
    for (std::size_t i = 0; i < wall.number_of_triangles(); ++i) {
      const std::array<Point_3, 3> corners = wall.triangle(i);
      for (std::size_t k = 0; k < 3; ++k)
        result.triangles[i][k] = places.number_of({corners[k].x(), corners[k].y(), corners[k].z()});
    }
    std::vector<std::uint32_t> renumbered(places.size());
    for (std::uint32_t c : along_curve(places, wall.bbox())) {
      renumbered[c] = std::uint32_t(result.points.size());
      result.points.emplace_back(places[c][0], places[c][1], places[c][2]);
    }
    for (Triangle& t : result.triangles)
      for (std::uint32_t& c : t)
        c = renumbered[c];
    return result;
  }

  // Places that are near each other are near each other in this order, which depends on nothing but the places.
  static std::vector<std::uint32_t> along_curve(const Places& places, const CGAL::Bbox_3& box) {
    const double extent = (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(places.size());
    for (std::uint32_t c = 0; c < places.size(); ++c) {
      const auto& p = places[c];
      order.emplace_back(internal::place_on_curve({(p[0] - box.xmin()) / extent, (p[1] - box.ymin()) / extent,
                                                   (p[2] - box.zmin()) / extent}),
                         c);
    }
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : places[a.second] < places[b.second];
    });
    std::vector<std::uint32_t> result;
    result.reserve(order.size());
    for (const auto& o : order)
      result.push_back(o.second);
    return result;
  }

  internal::Vector_3d center(std::uint32_t v) const {
    return internal::Vector_3d(faces_.points[v]) + radii_[v] * directions_[v];
  }

  std::array<double, 3> coordinates(const internal::Vector_3d& p, const Triangle& t) const {
    const internal::Vector_3d a(faces_.points[t[0]]), b(faces_.points[t[1]]), c(faces_.points[t[2]]);
    const internal::Vector_3d n = cross(b - a, c - a);
    const double area = squared_norm(n);
    const double u = (std::max)(0., dot(cross(c - b, p - b), n) / area);
    const double v = (std::max)(0., dot(cross(a - c, p - c), n) / area);
    const double w = (std::max)(0., 1 - u - v);
    return {u / (u + v + w), v / (u + v + w), w / (u + v + w)};
  }

  Wall_distance wall_;
  internal::Indexed_triangles faces_;
  std::vector<double> radii_;
  std::vector<internal::Vector_3d> directions_;
};

CGAL_TUBULAR_MESHING_INLINE Shape_radius::Shape_radius(const Wall_distance& wall, const Shape_radius_options& options)
    : impl_(std::make_shared<const Impl>(wall, options)) {}

CGAL_TUBULAR_MESHING_INLINE Shape_radius::Ball Shape_radius::ball(const Point_3& x) const {
  return impl_->at(x);
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Shape_radius::Ball> Shape_radius::balls() const {
  return impl_->all();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_FIELDS_SHAPE_RADIUS_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_SHAPE_RADIUS_IMPL_H
#define CGAL_TUBULAR_MESHING_FIELDS_SHAPE_RADIUS_IMPL_H

#include <CGAL/Tubular_meshing/Fields/Shape_radius.h>
#include <CGAL/Tubular_meshing/Fields/curvature.h>
#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/Fields/internal/Wall_balls.h>
#include <CGAL/Tubular_meshing/Fields/internal/Wall_refiner.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

class Shape_radius::Impl {
public:
  Impl(const Wall_distance& wall, const Shape_radius_options& options)
      : wall_(wall)
      , faces_(welded(wall)) {
    const internal::Indexed_wall whole(faces_);
    const double orientation = options.turned_inward ? -1 : 1;
    const internal::Wall_refiner refiner(whole, orientation, options.number_of_threads);
    if (refiner.has_divided()) {
      divide_faces(refiner);
      measure(internal::Indexed_wall(faces_), refiner.resolved(), orientation, options.number_of_threads);
    } else
      measure(whole, whole.shortest_edges(), orientation, options.number_of_threads);
  }

  Ball at(const Point_3& x) const {
    const Wall_distance::Place place = wall_.closest_place(x);
    const internal::Vector_3d p(place.point);
    const Triangle& t = faces_.triangles[part_at(p, place.triangle)];
    const std::array<double, 3> weights = inside(coordinates(p, t));
    const double rounding = 1e-9;
    double log_radius = 0, sum = 0;
    bool is_at_rim = true;
    internal::Vector_3d center;
    for (int k = 0; k < 3; ++k) {
      is_at_rim = is_at_rim && (weights[k] < rounding || is_on_rim_[t[k]]);
      if (radii_[t[k]] > 0) {
        log_radius += weights[k] * std::log(radii_[t[k]]);
        center += weights[k] * this->center(t[k]);
        sum += weights[k];
      }
    }
    if (!(sum > 0))
      return Ball{place.point, place.point, 0, is_at_rim};
    center = (1 / sum) * center;
    return Ball{place.point, Point_3(center.x, center.y, center.z), std::exp(log_radius / sum), is_at_rim};
  }

  std::vector<Ball> all() const {
    std::vector<Ball> result;
    for (std::uint32_t v = 0; v < faces_.points.size(); ++v) {
      const internal::Vector_3d c = center(v);
      result.push_back(Ball{faces_.points[v], Point_3(c.x, c.y, c.z), radii_[v], is_on_rim_[v] != 0});
    }
    return result;
  }

private:
  typedef std::array<std::uint32_t, 3> Triangle;

  /* The triangles with their corners numbered as a front meets them that starts at the first triangle and passes over the
   * wall: by the surface alone, wherever it lies in space, and neighbours are near each other in memory. O(n). */
  static internal::Indexed_triangles welded(const Wall_distance& wall) {
    const std::size_t n = wall.number_of_triangles();
    std::vector<Triangle> triangles(n);
    std::vector<std::size_t> first(wall.number_of_corners() + 1, 0); // of the triangles at each corner
    for (std::size_t i = 0; i < n; ++i)
      for (std::uint32_t c : triangles[i] = wall.corners(i))
        ++first[c + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> around(3 * n);
    for (std::size_t i = n; i-- > 0;)
      for (std::uint32_t c : triangles[i])
        around[--first[c + 1]] = std::uint32_t(i); // first[c + 1] goes down to where those of c begin
    internal::Indexed_triangles result;
    result.points.reserve(wall.number_of_corners());
    const std::uint32_t none = std::uint32_t(-1);
    std::vector<std::uint32_t> number(wall.number_of_corners(), none), front;
    const auto meet = [&](std::size_t i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t c = triangles[i][k];
        if (number[c] != none)
          continue;
        number[c] = std::uint32_t(front.size());
        front.push_back(c);
        result.points.push_back(wall.triangle(i)[k]);
      }
    };
    for (std::size_t i = 0, next = 0; i < n; ++i)
      for (meet(i); next < front.size(); ++next) {
        const std::uint32_t c = front[next];
        const std::size_t end = c + 2 < first.size() ? first[c + 2] : around.size();
        for (std::size_t k = first[c + 1]; k < end; ++k)
          meet(around[k]);
      }
    for (Triangle& t : triangles)
      for (std::uint32_t& c : t)
        c = number[c];
    result.triangles = std::move(triangles);
    return result;
  }

  void measure(const internal::Indexed_wall& wall, const std::vector<double>& resolved, double orientation,
               int threads) {
    const internal::Wall_balls balls(wall, resolved, orientation, threads);
    radii_ = balls.radii();
    directions_ = balls.directions();
    is_on_rim_.reserve(faces_.points.size());
    for (std::uint32_t v = 0; v < faces_.points.size(); ++v)
      is_on_rim_.push_back(wall.is_on_rim(v));
  }

  // faces_ becomes the parts of each triangle, one triangle after the other.
  void divide_faces(const internal::Wall_refiner& refiner) {
    const std::vector<std::uint32_t>& parents = refiner.parents();
    first_part_.assign(faces_.triangles.size() + 1, 0);
    for (std::uint32_t parent : parents)
      ++first_part_[parent + 1];
    std::partial_sum(first_part_.begin(), first_part_.end(), first_part_.begin());
    std::vector<std::size_t> next(first_part_.begin(), first_part_.end());
    faces_.triangles.resize(parents.size());
    for (std::size_t i = 0; i < parents.size(); ++i)
      faces_.triangles[next[parents[i]]++] = refiner.triangles()[i];
    for (std::size_t v = faces_.points.size(); v < refiner.points().size(); ++v)
      faces_.points.push_back(internal::as<Point_3>(refiner.points()[v]));
  }

  // The part of a triangle that a point on it is in, or least outside of.
  std::size_t part_at(const internal::Vector_3d& p, std::size_t triangle) const {
    if (first_part_.empty())
      return triangle;
    std::size_t best = first_part_[triangle];
    double inside = -(std::numeric_limits<double>::infinity)();
    for (std::size_t i = best; inside < 0 && i < first_part_[triangle + 1]; ++i) {
      const std::array<double, 3> c = coordinates(p, faces_.triangles[i]);
      const double least = (std::min)({c[0], c[1], c[2]});
      if (least > inside) {
        inside = least;
        best = i;
      }
    }
    return best;
  }

  internal::Vector_3d center(std::uint32_t v) const {
    return internal::Vector_3d(faces_.points[v]) + radii_[v] * directions_[v];
  }

  std::array<double, 3> coordinates(const internal::Vector_3d& p, const Triangle& t) const {
    const internal::Vector_3d a(faces_.points[t[0]]), b(faces_.points[t[1]]), c(faces_.points[t[2]]);
    const internal::Vector_3d n = cross(b - a, c - a);
    const double area = squared_norm(n);
    const double u = dot(cross(c - b, p - b), n) / area, v = dot(cross(a - c, p - c), n) / area;
    return {u, v, 1 - u - v};
  }

  static std::array<double, 3> inside(const std::array<double, 3>& coordinates) {
    const double u = (std::max)(0., coordinates[0]), v = (std::max)(0., coordinates[1]),
                 w = (std::max)(0., coordinates[2]);
    return {u / (u + v + w), v / (u + v + w), w / (u + v + w)};
  }

  Wall_distance wall_;
  internal::Indexed_triangles faces_;   // the wall's triangles, or parts of them
  std::vector<std::size_t> first_part_; // of each of the wall's triangles, and the end; empty where all are whole
  std::vector<double> radii_;
  std::vector<internal::Vector_3d> directions_;
  std::vector<char> is_on_rim_;
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

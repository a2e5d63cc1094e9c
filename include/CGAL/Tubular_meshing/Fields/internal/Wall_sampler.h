// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_SAMPLER_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_SAMPLER_H

#include <CGAL/Tubular_meshing/Fields/Wall_samples.h>
#include <CGAL/Tubular_meshing/base/Point_boxes.h>
#include <CGAL/Tubular_meshing/base/opposite_ball.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Chooses wall_samples(), and measures the balls at them. */
class Wall_sampler {
public:
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Face_index Face;

  Wall_sampler(const Surface& surface, const Face_patch_map& patch, int threads)
      : surface_(surface)
      , patch_(patch)
      , threads_(threads)
      , normals_(surface.number_of_vertices())
      , is_wall_(surface.number_of_vertices(), 0) {
    add_normals();
    for (int ring = 0; ring < rings; ++ring)
      average_normals();
    std::vector<Vector_3d> points;
    for (Vertex v : surface.vertices())
      if (is_wall_[v])
        points.emplace_back(surface.point(v));
    extent_ = extent_of(points);
    add_middles(points);
    obstacles_ = Point_boxes(points, std::vector<double>(points.size(), 0.));
  }

  std::vector<Wall_sample> samples(std::size_t most) const {
    std::vector<Wall_sample> result;
    const std::size_t n = (std::min)(most, std::size_t(surface_.number_of_faces()));
    double walked = 0;
    for (Face f : surface_.faces()) {
      if (get(patch_, f) != labels::wall)
        continue;
      walked += norm(doubled_area(f)) / 2;
      for (; (double(result.size()) + 0.5) / double(n) * area_ < walked && result.size() < n;) {
        const Vector_3d middle = middle_of(f);
        result.push_back(
            {Point_3(middle.x, middle.y, middle.z), surface_.target(surface_.halfedge(f)), area_ / double(n), 0});
      }
    }
    std::vector<double> radii(result.size());
    for_each_range(result.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        radii[i] = radius(result[i].vertex);
    });
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < result.size(); ++i)
      if (radii[i] > 0)
        balls.push_back(
            {Vector_3d(surface_.point(result[i].vertex)) + radii[i] * normals_[result[i].vertex], radii[i]});
    const Point_boxes axis = middles_of_vessels(balls);
    for_each_range(result.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        if (radii[i] > 0)
          result[i].radius = radius_about(axis, Vector_3d(result[i].point));
    });
    return result;
  }

private:
  static constexpr int rings = 3;

  struct Ball {
    Vector_3d center;
    double radius;
  };

  Vector_3d doubled_area(Face f) const {
    const auto h = surface_.halfedge(f);
    const Vector_3d a(surface_.point(surface_.source(h))), b(surface_.point(surface_.target(h))),
        c(surface_.point(surface_.target(surface_.next(h))));
    return cross(b - a, c - a);
  }

  Vector_3d middle_of(Face f) const {
    Vector_3d sum;
    for (Vertex v : surface_.vertices_around_face(surface_.halfedge(f)))
      sum += Vector_3d(surface_.point(v));
    return (1. / 3) * sum;
  }

  /* Those of facets from which the wall turns away at a corner: in a vessel of few facets round it, they are nearer to its
   * middle than corners are, and a ball would stick out. */
  void add_middles(std::vector<Vector_3d>& points) const {
    const double most_turned = 0.99; // the cosine of 8 degrees, of which a facet is a hundredth nearer
    for (Face f : surface_.faces()) {
      if (get(patch_, f) != labels::wall)
        continue;
      const Vector_3d n = doubled_area(f);
      for (Vertex v : surface_.vertices_around_face(surface_.halfedge(f)))
        if (-dot(n, normals_[v]) < most_turned * norm(n)) {
          points.push_back(middle_of(f));
          break;
        }
    }
  }

  // Inward, of unit length.
  void add_normals() {
    for (Face f : surface_.faces()) {
      if (get(patch_, f) != labels::wall)
        continue;
      const Vector_3d n = doubled_area(f);
      area_ += norm(n) / 2;
      for (Vertex v : surface_.vertices_around_face(surface_.halfedge(f))) {
        normals_[v] += (-1.) * n;
        is_wall_[v] = 1;
      }
    }
    for (Vector_3d& n : normals_)
      n = normalized(n);
  }

  // Where facets are large against the vessel, neighbours' normals lead round it, and are of no use.
  void average_normals() {
    const double most_turned = 0.85;
    std::vector<Vector_3d> averaged(normals_.size());
    for_each_range(normals_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Vertex v{Surface::size_type(i)};
        if (!is_wall_[i])
          continue;
        Vector_3d sum = normals_[i];
        for (Vertex w : surface_.vertices_around_target(surface_.halfedge(v)))
          if (is_wall_[w] && dot(normals_[w], normals_[v]) > most_turned)
            sum += normals_[w];
        averaged[i] = squared_norm(sum) > 0 ? normalized(sum) : normals_[i];
      }
    });
    normals_ = std::move(averaged);
  }

  /* In a cross section that is not round, balls are the smaller the nearer they are to where it is narrow: the slope of
   * their radius is a / (a + b) in an ellipse with half axes a and b, and next to nothing along a vessel, whatever it
   * tapers. Those are left that no other nearby rises above by more than between these. */
  Point_boxes middles_of_vessels(const std::vector<Ball>& balls) const {
    const double reach = 0.8, least = 0.05, slope = 0.2; // the first two in radii
    const Point_boxes all = boxes_of(balls);
    std::vector<char> is_middle(balls.size(), 1);
    for_each_range(balls.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Ball& ball = balls[i];
        all.search(
            ball.center,
            [&](const Point_boxes::Box& box) {
              return is_middle[i] && box.squared_distance(ball.center) < reach * reach * ball.radius * ball.radius;
            },
            [&](const Vector_3d& other, double radius) {
              const double d = norm(other - ball.center);
              if (d < reach * ball.radius && d > least * ball.radius && radius > ball.radius + slope * d)
                is_middle[i] = 0;
            });
      }
    });
    std::vector<Ball> middles;
    for (std::size_t i = 0; i < balls.size(); ++i)
      if (is_middle[i])
        middles.push_back(balls[i]);
    return boxes_of(middles);
  }

  static Point_boxes boxes_of(const std::vector<Ball>& balls) {
    std::vector<Vector_3d> centers;
    std::vector<double> radii;
    for (const Ball& ball : balls) {
      centers.push_back(ball.center);
      radii.push_back(ball.radius);
    }
    return Point_boxes(centers, radii);
  }

  // As for the mesh size on the wall: that of the middle which is nearest, or the distance to it.
  static double radius_about(const Point_boxes& axis, const Vector_3d& x) {
    double nearest = (std::numeric_limits<double>::infinity)(), radius = 0;
    axis.search(
        x, [&](const Point_boxes::Box& box) { return box.squared_distance(x) < nearest; },
        [&](const Vector_3d& middle, double of_middle) {
          const double squared = squared_norm(middle - x);
          if (squared < nearest) {
            nearest = squared;
            radius = of_middle;
          }
        });
    return (std::max)(radius, std::sqrt(nearest));
  }

  // The median of that at the vertex and at its neighbours.
  double radius(Vertex v) const {
    std::vector<double> radii{ball(v)};
    for (Vertex w : surface_.vertices_around_target(surface_.halfedge(v)))
      if (is_wall_[w])
        radii.push_back(ball(w));
    radii.erase(std::remove(radii.begin(), radii.end(), 0.), radii.end());
    if (radii.empty())
      return 0;
    const auto middle = radii.begin() + std::ptrdiff_t(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    return *middle;
  }

  double ball(Vertex v) const {
    const Vector_3d p(surface_.point(v));
    double edge = 0;
    for (Vertex w : surface_.vertices_around_target(surface_.halfedge(v)))
      edge = (std::max)(edge, norm(Vector_3d(surface_.point(w)) - p));
    return opposite_ball(obstacles_, p, normals_[v], 8 * edge, extent_);
  }

  const Surface& surface_;
  const Face_patch_map& patch_;
  int threads_;
  std::vector<Vector_3d> normals_;
  std::vector<char> is_wall_;
  double extent_ = 0;
  double area_ = 0; // of the wall
  Point_boxes obstacles_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_SAMPLER_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a map answers: locations, points on loops, and metrics.

#include "patch_shapes.h"

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace {

using namespace patch_shapes;

// --- locations ---

TEST(Parameterization, Locations_and_points) {
  const Map map = tubular::parameterize_patch(junction(2, 40, 45, 6));
  std::mt19937 random(3);
  int hint = -1;
  for (int i = 0; i < 20000; ++i) {
    const int t = int(random() % map.number_of_triangles());
    double a = random() / 4294967296., b = random() / 4294967296.;
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    tubular::Patch_location at;
    at.triangle = t;
    at.barycentric = {{1 - a - b, a, b}};
    const tubular::Patch_location found = map.locate(map.uv(at), hint);
    const double size = std::sqrt(CGAL::area(map.uv(map.patch().triangles[std::size_t(t)][0]),
                                             map.uv(map.patch().triangles[std::size_t(t)][1]),
                                             map.uv(map.patch().triangles[std::size_t(t)][2])));
    ASSERT_LT(std::sqrt(found.squared_distance), 1e-9 * size);
    ASSERT_LT(std::sqrt(CGAL::squared_distance(map.point(found), map.point(at))), 1e-9);
    if (i % 2)
      hint = found.triangle; // otherwise far away, as often as not
  }
}

TEST(Parameterization, Points_outside_get_the_nearest_point) {
  const Map map = tubular::parameterize_patch(tube(cylinder(3), 12, 6));
  std::mt19937 random(4);
  for (int i = 0; i < 300; ++i) {
    const double a = 2 * pi * random() / 4294967296., r = i % 2 ? 1 + 0.1 * (i % 5) : 0.01;
    const Point_2 p(r * std::cos(a), r * std::sin(a));
    double nearest = 1e300;
    for (const auto& loop : map.patch().loops)
      for (std::size_t k = 0; k < loop.size(); ++k)
        nearest = std::min(nearest, CGAL::squared_distance(
                                        p, Kernel::Segment_2(map.uv(loop[k]), map.uv(loop[(k + 1) % loop.size()]))));
    for (int hint : {-1, 0, 70}) {
      const tubular::Patch_location at = map.locate(p, hint);
      ASSERT_NEAR(at.squared_distance, nearest, 1e-12);
      ASSERT_NEAR(CGAL::squared_distance(map.uv(at), p), nearest, 1e-12);
    }
  }
}

/* By the given loops, whose edges may have been halved. */
void expect_loops_by_arc_length(const Patch& patch) {
  const Map map = tubular::parameterize_patch(patch);
  for (std::size_t l = 0; l < map.number_of_loops(); ++l) {
    const auto& loop = patch.loops[l];
    const double total = map.loop_length(l);
    double s = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point &p = patch.points[std::size_t(loop[k])], &q = patch.points[std::size_t(loop[(k + 1) % loop.size()])];
      const double length = std::sqrt(CGAL::squared_distance(p, q));
      for (double t : {0., 0.25, 0.9}) {
        const Point expected = p + t * (q - p);
        EXPECT_LT(CGAL::squared_distance(map.point(map.on_loop(l, s + t * length)), expected), 1e-20 * total * total);
        EXPECT_LT(CGAL::squared_distance(map.point(map.on_loop(l, s + t * length - total)), expected),
                  1e-20 * total * total);
        const tubular::Patch_location at = map.on_loop_edge(l, k, t);
        EXPECT_LT(CGAL::squared_distance(map.point(at), expected), 1e-28 * total * total);
        // on a chord of the polygon in the plane
        const auto& parts = map.patch().loops[l];
        double nearest = 1e300;
        for (std::size_t i = 0; i < parts.size(); ++i)
          nearest = std::min(
              nearest, CGAL::squared_distance(
                           map.uv(at), Kernel::Segment_2(map.uv(parts[i]), map.uv(parts[(i + 1) % parts.size()]))));
        EXPECT_LT(nearest, 1e-30);
      }
      s += length;
    }
    EXPECT_NEAR(s, total, 1e-12 * total);
  }
}

TEST(Parameterization, Loops_by_arc_length) {
  for (const Patch& patch : {junction(1, 40, 30, 4), tube(cylinder(5), 5, 3)})
    expect_loops_by_arc_length(patch);
}

// --- metrics ---

TEST(Parameterization, The_induced_metric_is_that_of_finite_differences) {
  const Map map = tubular::parameterize_patch(junction(1, 40, 30, 4));
  Eigen::Matrix3d metric;
  metric << 4, 1, 0, 1, 9, 2, 0, 2, 3;
  std::mt19937 random(5);
  for (int t = 0; t < int(map.number_of_triangles()); ++t) {
    tubular::Patch_location a, b;
    a.triangle = b.triangle = t;
    a.barycentric = {{0.2, 0.3, 0.5}};
    const double d = 0.1 * (random() / 4294967296.), e = 0.1 * (random() / 4294967296.);
    b.barycentric = {{0.2 + d, 0.3 + e, 0.5 - d - e}};
    const Point x = map.point(a), y = map.point(b);
    const Eigen::Vector3d dx(y.x() - x.x(), y.y() - x.y(), y.z() - x.z());
    const double du = map.uv(b).x() - map.uv(a).x(), dv = map.uv(b).y() - map.uv(a).y();
    const double expected = dx.dot(metric * dx);
    ASSERT_NEAR(map.induced_metric(t, metric).squared_length(du, dv), expected, 1e-8 * expected);
    const auto derivatives = map.derivatives(t);
    ASSERT_LT((derivatives * Eigen::Vector2d(du, dv) - dx).norm(), 1e-9 * dx.norm() + 1e-14);
  }
}

TEST(Parameterization, The_metric_between_vertices_is_continuous_and_has_the_shapes_scale) {
  const double size = 0.1;
  const Map map = tubular::parameterize_patch(tube(cylinder(6), 48, 46));
  for (int h = 0; h < int(3 * map.number_of_triangles()); ++h) {
    const int t = h / 3, i = h % 3;
    tubular::Patch_location at;
    at.triangle = t;
    at.barycentric = {{0, 0, 0}};
    at.barycentric[std::size_t(i)] = at.barycentric[std::size_t((i + 1) % 3)] = 0.5;
    // just across the edge
    const Point_2 p = map.uv(at);
    const auto& c = map.patch().triangles[std::size_t(t)];
    const Point_2 q = map.uv(c[std::size_t((i + 2) % 3)]);
    const Point_2 beyond = p + 1e-9 * (p - q), before = p - 1e-9 * (p - q);
    const auto m = map.induced_metric(map.locate(beyond, t), size), n = map.induced_metric(map.locate(before, t), size);
    ASSERT_NEAR(m.xx, n.xx, 1e-6 * m.xx);
    ASSERT_NEAR(m.yy, n.yy, 1e-6 * m.yy);
    // x,u = 1 / rho on the ring of a cylinder of radius 1; vertices of a loop have triangles on one side only
    const double rho = norm(p), step = 2 * pi / 48;
    const bool is_near_loop = rho > std::exp(-1.5 * step) || rho < std::exp(-6 + 1.5 * step);
    ASSERT_NEAR(std::sqrt(m.determinant()) * size * size * rho * rho, 1, is_near_loop ? step : 0.02);
  }
  // a field of metrics: isotropic, of a size that depends on the place
  const auto logs = map.log_vertex_metrics(
      [](const Point& p) { return Eigen::Matrix3d(Eigen::Matrix3d::Identity() * (1 + p.z() * p.z())); });
  tubular::Patch_location at;
  at.triangle = 200;
  at.barycentric = {{0.2, 0.3, 0.5}};
  const double z = map.point(at).z();
  EXPECT_NEAR(map.interpolate(logs, at).xx, (1 + z * z) * map.induced_metric(at, 1.).xx,
              0.02 * map.interpolate(logs, at).xx);
}

} // namespace

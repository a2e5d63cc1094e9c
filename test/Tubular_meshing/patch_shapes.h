// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Patches to be mapped onto the plane, and what tests ask of their maps.

#ifndef TUBULAR_MESHING_TEST_PATCH_SHAPES_H
#define TUBULAR_MESHING_TEST_PATCH_SHAPES_H

#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace patch_shapes {

namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Point_2 Point_2;
typedef tubular::Indexed_patch Patch;
typedef tubular::Patch_parameterization Map;
typedef tubular::Parameterization_method Method;

const double pi = 3.14159265358979323846;

// --- patches ---

typedef std::function<Point(double, double)> Shape; // of the angle, and of the height in [0, 1]

/* A tube of `sides` x `rings` quads, each of two triangles; its outside is where the shape's is, if the shape turns
 * counterclockwise as seen from its top. */
inline Patch tube(const Shape& shape, int sides, int rings) {
  Patch patch;
  for (int k = 0; k <= rings; ++k)
    for (int i = 0; i < sides; ++i)
      patch.points.push_back(shape(2 * pi * i / sides, double(k) / rings));
  for (int k = 0; k < rings; ++k)
    for (int i = 0; i < sides; ++i) {
      const int j = (i + 1) % sides, a = k * sides + i, b = k * sides + j;
      patch.triangles.push_back({{a, b, b + sides}});
      patch.triangles.push_back({{a, b + sides, a + sides}});
    }
  patch.loops = tubular::border_loops(patch);
  return patch;
}

inline Shape cylinder(double length, double radius = 1) {
  return [=](double a, double t) { return Point(radius * std::cos(a), radius * std::sin(a), length * t); };
}

/* The upper half of the unit sphere. */
inline Patch half_sphere(int sides, int rings) {
  Patch patch = tube(
      [&](double a, double t) {
        const double b = pi / 2 * t * rings / (rings + 1);
        return Point(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
      },
      sides, rings);
  const int top = int(patch.points.size());
  patch.points.push_back(Point(0, 0, 1));
  for (int i = 0; i < sides; ++i)
    patch.triangles.push_back({{rings * sides + i, rings * sides + (i + 1) % sides, top}});
  patch.loops = tubular::border_loops(patch);
  return patch;
}

/* Of some triangles of a patch, the one piece that has the first of them, so that its loops are new. */
inline Patch part_of(const Patch& patch, const std::function<bool(std::size_t)>& is_kept) {
  Patch part;
  std::vector<int> image(patch.points.size(), -1);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    if (!is_kept(t))
      continue;
    part.triangles.push_back(patch.triangles[t]);
    for (int& v : part.triangles.back()) {
      int& w = image[std::size_t(v)];
      if (w < 0) {
        w = int(part.points.size());
        part.points.push_back(patch.points[std::size_t(v)]);
      }
      v = w;
    }
  }
  part.loops = tubular::border_loops(part);
  return part;
}

/* A tube with a round hole in its side for each branch: a junction of 2 + n loops, whose branches are drawn out of the
 * holes along their normals. */
inline Patch junction(int branches, int sides, int rings, double length) {
  Patch whole = tube(cylinder(length), sides, rings);
  const auto place = [&](std::size_t t, double& a, double& z) {
    const auto& c = whole.triangles[t / 2 * 2];
    a = std::atan2(whole.points[std::size_t(c[0])].y(), whole.points[std::size_t(c[0])].x());
    z = whole.points[std::size_t(c[0])].z() / length;
  };
  Patch patch = part_of(whole, [&](std::size_t t) {
    double a, z;
    place(t, a, z);
    for (int b = 0; b < branches; ++b) {
      const double at = (b + 0.5) / branches, side = b % 2 ? 0.3 : 2.1;
      if (std::hypot(a - side, (z - at) * length) < 0.4)
        return false;
    }
    return true;
  });
  // a collar of two rings around each hole but the tube's ends
  for (std::size_t l = 0; l < patch.loops.size(); ++l) {
    std::vector<int> loop = patch.loops[l];
    bool is_end = true;
    for (int v : loop)
      is_end = is_end && (patch.points[std::size_t(v)].z() < 1e-9 * length ||
                          patch.points[std::size_t(v)].z() > (1 - 1e-9) * length);
    for (int ring = 0; !is_end && ring < 2; ++ring) {
      const int first = int(patch.points.size()), n = int(loop.size());
      for (int v : loop) {
        const Point p = patch.points[std::size_t(v)];
        patch.points.push_back(Point(1.3 * p.x(), 1.3 * p.y(), p.z()));
      }
      for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        patch.triangles.push_back({{loop[std::size_t(j)], loop[std::size_t(i)], first + i}});
        patch.triangles.push_back({{loop[std::size_t(j)], first + i, first + j}});
      }
      for (int i = 0; i < n; ++i)
        loop[std::size_t(i)] = first + i;
    }
  }
  patch.loops = tubular::border_loops(patch);
  return patch;
}

/* Each vertex moved by a part of its shortest edge, each edge flipped with some probability. */
inline Patch perturbed(Patch patch, double amplitude, double flips, std::mt19937& random) {
  const auto in_0_1 = [&] { return random() / 4294967296.; };
  std::map<std::pair<int, int>, std::size_t> triangle_of;
  const auto edges_of = [&](std::size_t t, bool add) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair<int, int> e(patch.triangles[t][i], patch.triangles[t][(i + 1) % 3]);
      if (add)
        triangle_of[e] = t;
      else
        triangle_of.erase(e);
    }
  };
  std::vector<double> shortest(patch.points.size(), 1e300);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    edges_of(t, true);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = std::size_t(patch.triangles[t][i]), b = std::size_t(patch.triangles[t][(i + 1) % 3]);
      const double l = std::sqrt(CGAL::squared_distance(patch.points[a], patch.points[b]));
      shortest[a] = std::min(shortest[a], l);
      shortest[b] = std::min(shortest[b], l);
    }
  }
  const std::size_t tries = std::size_t(flips * 3 * double(patch.triangles.size()) / 2);
  for (std::size_t k = 0; k < tries; ++k) {
    const std::size_t t = random() % patch.triangles.size(), i = random() % 3;
    const int a = patch.triangles[t][i], b = patch.triangles[t][(i + 1) % 3], c = patch.triangles[t][(i + 2) % 3];
    const auto other = triangle_of.find({b, a});
    if (other == triangle_of.end())
      continue;
    const std::size_t s = other->second;
    int d = -1;
    for (int v : patch.triangles[s])
      d = v != a && v != b ? v : d;
    if (triangle_of.count({c, d}) || triangle_of.count({d, c}))
      continue;
    edges_of(t, false);
    edges_of(s, false);
    patch.triangles[t] = {{a, d, c}};
    patch.triangles[s] = {{d, b, c}};
    edges_of(t, true);
    edges_of(s, true);
  }
  for (std::size_t v = 0; v < patch.points.size(); ++v) {
    const double r = amplitude * shortest[v];
    patch.points[v] =
        patch.points[v] + Kernel::Vector_3(r * (2 * in_0_1() - 1), r * (2 * in_0_1() - 1), r * (2 * in_0_1() - 1));
  }
  return patch;
}

// --- measures ---

inline double norm(const Point_2& p) {
  return std::hypot(p.x(), p.y());
}

/* Checks by other means than the map's own: the triangles' areas add up to what the loops enclose, none is negative, no
 * loop meets itself, all is in the unit circle, and the loops turn as they should. */
inline void expect_bijective(const Map& map, const std::string& what = "") {
  double sum = 0, enclosed = 0;
  std::size_t flipped = 0;
  for (const auto& t : map.patch().triangles) {
    flipped += CGAL::orientation(map.uv(t[0]), map.uv(t[1]), map.uv(t[2])) != CGAL::LEFT_TURN;
    sum += CGAL::area(map.uv(t[0]), map.uv(t[1]), map.uv(t[2]));
  }
  EXPECT_EQ(flipped, 0u) << what;
  for (std::size_t l = 0; l < map.number_of_loops(); ++l) {
    std::vector<Point_2> polygon;
    for (int v : map.patch().loops[l])
      polygon.push_back(map.uv(v));
    ASSERT_TRUE(CGAL::is_simple_2(polygon.begin(), polygon.end())) << what;
    EXPECT_EQ(CGAL::orientation_2(polygon.begin(), polygon.end()),
              l == map.outer_loop() ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE)
        << what;
    double area;
    CGAL::area_2(polygon.begin(), polygon.end(), area, Kernel());
    enclosed += area;
  }
  EXPECT_NEAR(sum, enclosed, 1e-9) << what;
  for (int v = 0; v < int(map.number_of_vertices()); ++v)
    ASSERT_LE(norm(map.uv(v)), 1 + 1e-12) << what;
}

/* The largest relative error of uv against a conformal map whose modulus is known, up to a rotation. */
inline double error_of_ring(const Map& map, const std::function<double(const Point&)>& radius) {
  double worst = 0;
  const Point& p0 = map.patch().points[0];
  const double turn = std::atan2(map.uv(0).y(), map.uv(0).x()) - std::atan2(p0.y(), p0.x());
  const bool same_way = [&] { // whether the outer loop goes round the axis as its image does
    const auto& loop = map.patch().loops[map.outer_loop()];
    const Point &a = map.patch().points[std::size_t(loop[0])], &b = map.patch().points[std::size_t(loop[1])];
    return a.x() * b.y() - a.y() * b.x() > 0;
  }();
  for (int v = 0; v < int(map.number_of_vertices()); ++v) {
    const Point& p = map.patch().points[std::size_t(v)];
    const double a = std::atan2(p.y(), p.x());
    const double a0 = std::atan2(p0.y(), p0.x());
    const double angle = a0 + turn + (same_way ? 1 : -1) * (a - a0), r = radius(p);
    worst = std::max(worst, std::hypot(map.uv(v).x() - r * std::cos(angle), map.uv(v).y() - r * std::sin(angle)) / r);
  }
  return worst;
}

/* The largest deviation of the continuous metric's stretches from equality, at inner vertices. */
inline double anisotropy_at_vertices(const Map& map) {
  std::vector<char> is_border(map.number_of_vertices(), 0);
  for (const auto& loop : map.patch().loops)
    for (int v : loop)
      is_border[std::size_t(v)] = 1;
  double worst = 0;
  for (int t = 0; t < int(map.number_of_triangles()); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_border[std::size_t(map.patch().triangles[std::size_t(t)][i])])
        continue;
      tubular::Patch_location at;
      at.triangle = t;
      at.barycentric = {{0, 0, 0}};
      at.barycentric[i] = 1;
      const tubular::Metric_tensor_2 m = map.induced_metric(at, 1.);
      const double mean = (m.xx + m.yy) / 2, radius = std::hypot((m.xx - m.yy) / 2, m.xy);
      worst = std::max(worst, std::sqrt((mean + radius) / (mean - radius)) - 1);
    }
  return worst;
}

} // namespace patch_shapes

#endif // TUBULAR_MESHING_TEST_PATCH_SHAPES_H

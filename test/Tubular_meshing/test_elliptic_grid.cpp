// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Grids of quads on tubes: where the best grid is known, and where points on the ends, cross sections or maps make it
// hard.

#include <CGAL/Tubular_meshing/Quads/elliptic_grid.h>
#include <CGAL/Tubular_meshing/Quads/internal/elliptic/Winslow_smoother.h>
#include <CGAL/Tubular_meshing/Quality/shape_measures.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef tubular::Patch_parameterization Map;
typedef tubular::Elliptic_grid Grid;
typedef std::array<std::vector<tubular::Patch_location>, 2> Loop_points;

const double pi = 3.14159265358979323846;

// --- tubes ---

typedef std::function<Point(double, double)> Shape; // of the angle, and of the height in [0, 1]

Map tube(const Shape& shape, int sides, int rings,
         tubular::Parameterization_method method = tubular::Parameterization_method::conformal) {
  tubular::Indexed_patch patch;
  for (int k = 0; k <= rings; ++k)
    for (int i = 0; i < sides; ++i)
      patch.points.push_back(shape(2 * pi * i / sides, double(k) / rings));
  for (int k = 0; k < rings; ++k)
    for (int i = 0; i < sides; ++i) {
      const int j = (i + 1) % sides, a = k * sides + i, b = k * sides + j;
      const bool other = (i + k) % 2 == 0;
      patch.triangles.push_back({{a, b, other ? a + sides : b + sides}});
      patch.triangles.push_back({{other ? b : a, b + sides, a + sides}});
    }
  patch.loops = tubular::border_loops(patch);
  return tubular::parameterize_patch(patch, method);
}

Shape cylinder(double length, double radius = 1) {
  return [=](double a, double t) { return Point(radius * std::cos(a), radius * std::sin(a), length * t); };
}
Shape cone(double length, double top) {
  return [=](double a, double t) {
    const double r = 1 + (top - 1) * t;
    return Point(r * std::cos(a), r * std::sin(a), length * t);
  };
}
// A part of a torus of the given radius.
Shape bend(double radius, double angle) {
  return [=](double a, double t) {
    const double r = radius + std::cos(a);
    return Point(r * std::cos(angle * t), std::sin(a), r * std::sin(angle * t));
  };
}
// A cylinder cut obliquely at both ends.
Shape oblique(double length, double slope) {
  return [=](double a, double t) {
    return Point(std::cos(a), std::sin(a), length * t + slope * std::cos(a) * (1 - 2 * t));
  };
}

// Points on the loops, at equal distances, loop 1 from a part of a distance on; or at the given parts of the length.
Loop_points even_points(const Map& map, std::size_t n, double start = 0) {
  Loop_points points;
  for (std::size_t l = 0; l < 2; ++l)
    for (std::size_t i = 0; i < n; ++i)
      points[l].push_back(map.on_loop(l, map.loop_length(l) * (double(i) + (l == 1 ? start : 0)) / double(n)));
  return points;
}

auto constant(double h) {
  return [h](const Point&) { return h; };
}

// --- what there is ---

struct Quality {
  double least = 1, mean = 0;
};

// Every quad turns the same way as the surface, whose outside `outward` tells; a folded one has quality 0.
template <class Outward> Quality quality(const Grid& grid, const Outward& outward) {
  Quality q;
  const auto quads = grid.quads();
  for (const auto& c : quads) {
    std::array<Point, 4> p;
    for (std::size_t i = 0; i < 4; ++i)
      p[i] = grid.points[c[i]];
    double eta = tubular::quad_eta(p);
    for (std::size_t i = 0; i < 4; ++i)
      if (!(CGAL::cross_product(p[(i + 1) % 4] - p[i], p[(i + 3) % 4] - p[i]) * outward(p[i]) > 0))
        eta = 0;
    q.least = (std::min)(q.least, eta);
    q.mean += eta / double(quads.size());
  }
  return q;
}
Vector from_axis(const Point& p) {
  return Vector(p.x(), p.y(), 0);
}

void expect_ends(const Grid& grid, const Map& map, const Loop_points& points) {
  const std::size_t n = points[0].size();
  ASSERT_EQ(grid.columns, n);
  ASSERT_EQ(grid.points.size(), n * (grid.rows + 1));
  std::vector<bool> met(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(grid.points[i], map.point(points[0][i]));
    EXPECT_EQ(grid.points[grid.rows * n + i], map.point(points[1][grid.ends[i]]));
    met[grid.ends[i]] = true;
  }
  EXPECT_EQ(std::count(met.begin(), met.end(), true), std::ptrdiff_t(n));
}

// --- closed forms ---

TEST(Elliptic_grid, Of_a_prism_is_made_of_its_rectangles) {
  const Map map = tube(cylinder(4), 16, 10);
  const Loop_points points = even_points(map, 16);
  const double side = 2 * std::sin(pi / 16);
  const Grid grid = tubular::elliptic_grid(map, points, constant(side));
  expect_ends(grid, map, points);
  EXPECT_EQ(grid.rows, std::size_t(std::lround(4 / side)));
  for (std::size_t j = 0; j <= grid.rows; ++j)
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const Point &p = grid.points[j * grid.columns + i], &bottom = grid.points[i];
      EXPECT_NEAR(p.x(), bottom.x(), 1e-6);
      EXPECT_NEAR(p.y(), bottom.y(), 1e-6);
      EXPECT_NEAR(std::abs(p.z() - bottom.z()), 4. * double(j) / double(grid.rows),
                  4. / 256 / 2); // 256 steps are measured
    }
  EXPECT_GT(quality(grid, from_axis).least, 0.99999);
}

TEST(Elliptic_grid, Gets_the_rows_that_the_size_wants) {
  const Map map = tube(cylinder(4), 32, 20);
  // On 0 <= z <= 4, the length in a size of 0.1 + 0.1 z is 10 ln 5.
  const auto size = [](const Point& p) { return 0.1 + 0.1 * p.z(); };
  const Grid grid = tubular::elliptic_grid(map, even_points(map, 32), size);
  EXPECT_EQ(grid.rows, 16u);
  const bool up = grid.points[0].z() < 2;
  for (std::size_t j = 0; j <= grid.rows; ++j) {
    const double t = double(up ? j : grid.rows - j) / double(grid.rows);
    EXPECT_NEAR(grid.points[j * grid.columns].z(), std::pow(5., t) - 1, 0.02);
  }
}

TEST(Elliptic_grid, Has_as_many_rows_as_told) {
  const Map map = tube(cylinder(2), 16, 8);
  const auto points = even_points(map, 12);
  for (std::size_t rows : {1u, 2u, 7u})
    EXPECT_EQ(tubular::elliptic_grid(map, points, constant(0.3), tubular::parameters::number_of_rows(rows)).rows, rows);
}

TEST(Elliptic_grid, Turns_by_less_than_half_a_column) {
  const Map map = tube(cylinder(3), 40, 20);
  for (double start : {0., 3.25, 7.5, 11.9}) {
    const Loop_points points = even_points(map, 20, start);
    const Grid grid = tubular::elliptic_grid(map, points, constant(0.3));
    expect_ends(grid, map, points);
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const Point &p = grid.points[i], &q = grid.points[grid.rows * grid.columns + i];
      EXPECT_LT(std::abs(std::atan2(p.x() * q.y() - p.y() * q.x(), p.x() * q.x() + p.y() * q.y())), 1.01 * pi / 20);
    }
    // A helix that rises by 3 while it turns by half a column or less.
    EXPECT_GT(quality(grid, from_axis).least, 1 - 2 / pi * std::atan(pi / 20 / 3) - 0.005) << start;
  }
}

// --- shapes ---

TEST(Elliptic_grid, Is_orthogonal_on_tapered_tubes) {
  for (double top : {0.5, 0.2}) {
    const Map map = tube(cone(4, top), 48, 80);
    const auto size = [&](const Point& p) { return 2 * pi / 24 * std::hypot(p.x(), p.y()); };
    const Quality q = quality(tubular::elliptic_grid(map, even_points(map, 24), size), from_axis);
    // Trapezia: each of their sides leans by half the angle that a column takes of the unrolled cone.
    const double slope = (1 - top) / std::hypot(4, 1 - top), best = 1 - 2 / pi * (pi / 24 * slope);
    EXPECT_GT(q.least, best - 0.005) << top;
    EXPECT_GT(q.mean, best - 0.005) << top;
    EXPECT_LT(q.mean, best + 0.001) << top;
  }
}

TEST(Elliptic_grid, Is_orthogonal_on_bent_tubes) {
  for (double radius : {4., 1.5}) {
    const Map map = tube(bend(radius, pi / 2), 32, 40);
    const auto outward = [&](const Point& p) {
      const double s = radius / std::hypot(p.x(), p.z());
      return Vector(p.x() * (1 - s), p.y(), p.z() * (1 - s));
    };
    const Quality q = quality(tubular::elliptic_grid(map, even_points(map, 24), constant(0.26)), outward);
    EXPECT_GT(q.least, 0.92) << radius;
    EXPECT_GT(q.mean, 0.95) << radius;
  }
}

TEST(Elliptic_grid, Follows_oblique_ends) {
  const Map map = tube(oblique(4, 0.8), 48, 40);
  const Quality q = quality(tubular::elliptic_grid(map, even_points(map, 24), constant(0.26)), from_axis);
  EXPECT_GT(q.least, 0.85);
  EXPECT_GT(q.mean, 0.95);
}

TEST(Elliptic_grid, Takes_points_at_very_different_distances) {
  const Map map = tube(cylinder(3), 48, 24);
  Loop_points points;
  for (std::size_t l = 0; l < 2; ++l)
    for (std::size_t i = 0; i < 24; ++i) {
      const double t = double(i) / 24;
      points[l].push_back(map.on_loop(l, map.loop_length(l) * (t + (l == 0 ? 0.1 : -0.1) * std::sin(2 * pi * t))));
    }
  const Grid grid = tubular::elliptic_grid(map, points, constant(0.26));
  const Quality q = quality(grid, from_axis);
  EXPECT_GT(q.least, 0.72);
  EXPECT_GT(q.mean, 0.85);
}

TEST(Elliptic_grid, Does_not_need_a_conformal_map) {
  for (auto method : {tubular::Parameterization_method::mean_value, tubular::Parameterization_method::uniform}) {
    const Map map = tube(bend(2.5, pi / 2), 32, 30, method);
    ASSERT_EQ(map.method(), method);
    const auto outward = [&](const Point& p) {
      const double s = 2.5 / std::hypot(p.x(), p.z());
      return Vector(p.x() * (1 - s), p.y(), p.z() * (1 - s));
    };
    const Quality q = quality(tubular::elliptic_grid(map, even_points(map, 24), constant(0.26)), outward);
    EXPECT_GT(q.least, 0.93);
    EXPECT_GT(q.mean, 0.96);
  }
}

TEST(Elliptic_grid, Does_not_depend_on_units) {
  const Map map = tube(cone(3, 0.6), 16, 12);
  const double scale = 1. / 1024;
  const Map small =
      tube([&](double a, double t) { return Point(0, 0, 0) + scale * (cone(3, 0.6)(a, t) - Point(0, 0, 0)); }, 16, 12);
  const Grid grid = tubular::elliptic_grid(map, even_points(map, 16), constant(0.4));
  const Grid other = tubular::elliptic_grid(small, even_points(small, 16), constant(0.4 * scale));
  ASSERT_EQ(grid.points.size(), other.points.size());
  for (std::size_t i = 0; i < grid.points.size(); ++i)
    EXPECT_LT(CGAL::squared_distance(grid.points[i], Point(0, 0, 0) + (other.points[i] - Point(0, 0, 0)) / scale),
              1e-12);
}

// --- the smoother by itself ---

tubular::internal::Ring_nodes square_nodes(std::size_t columns, std::size_t rows) {
  tubular::internal::Ring_nodes nodes;
  nodes.columns = columns;
  nodes.rows = rows;
  nodes.period = double(columns);
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      nodes.places.emplace_back(double(i), double(j));
  return nodes;
}

TEST(Winslow_smoother, Unfolds_cells) {
  tubular::internal::Ring_nodes nodes = square_nodes(8, 6), squares = nodes;
  for (std::size_t n = 8; n < 48; ++n)
    nodes.places[n] += 1.5 * Eigen::Vector2d(std::sin(12.9 * double(n)), std::cos(78.2 * double(n)));
  tubular::internal::Winslow_smoother smoother(nodes);
  ASSERT_LT(smoother.least_corner(), 0);
  for (int k = 0; k < 200; ++k)
    smoother.sweep(1);
  EXPECT_GT(smoother.least_corner(), 0.99);
  for (std::size_t n = 0; n < nodes.places.size(); ++n)
    EXPECT_LT((nodes.places[n] - squares.places[n]).norm(), 1e-3);
}

TEST(Winslow_smoother, Makes_cells_as_high_as_wanted) {
  tubular::internal::Ring_nodes nodes = square_nodes(6, 2);
  tubular::internal::Winslow_smoother smoother(nodes);
  for (std::size_t i = 0; i < 6; ++i) {
    smoother.cell(i, 0).beta = 0.5;
    smoother.cell(i, 1).beta = 1.5;
  }
  for (int k = 0; k < 200; ++k)
    smoother.sweep(1);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(nodes(i, 1).y(), 0.5, 1e-6);
}

// --- refusals ---

template <class Function> std::string sentence_of(const Function& f) {
  try {
    f();
  } catch (const tubular::Input_error& e) {
    return e.what();
  }
  return "";
}

TEST(Elliptic_grid, Refuses_points_that_do_not_fit) {
  const Map map = tube(cylinder(2), 16, 8);
  Loop_points points = even_points(map, 12);
  const auto sentence = [&] { return sentence_of([&] { tubular::elliptic_grid(map, points, constant(0.3)); }); };
  EXPECT_EQ(sentence(), "");
  std::swap(points[1][3], points[1][4]);
  EXPECT_NE(sentence().find("of loop 1"), std::string::npos);
  std::swap(points[1][3], points[1][4]);
  points[0].pop_back();
  EXPECT_NE(sentence().find("11 and 12 points"), std::string::npos);
}

} // namespace

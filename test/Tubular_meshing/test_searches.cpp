// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Searches among many triangles and segments find what looking at each of them finds.

#include <CGAL/Tubular_meshing/Repair/internal/is_oriented_surface.h>
#include <CGAL/Tubular_meshing/base/Corner_tree.h>
#include <CGAL/Tubular_meshing/base/Crossing_suspects.h>
#include <CGAL/Tubular_meshing/base/crossing_pairs.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <vector>

namespace {

namespace internal = CGAL::Tubular_meshing::internal;
using CGAL::Tubular_meshing::Point_3;
using CGAL::Tubular_meshing::Surface;
typedef internal::Double_kernel::Point_3 Point;
typedef internal::Double_kernel::Segment_3 Segment;
typedef internal::Double_kernel::Triangle_3 Triangle;

class Random {
public:
  explicit Random(unsigned seed)
      : generator_(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  Point point(double extent) {
    return Point((*this)(-extent, extent), (*this)(-extent, extent), (*this)(-extent, extent));
  }

private:
  std::mt19937 generator_;
};

// --- the nearest shape ---

// A tube along x with n points round it, as triangles of which the edges along it are `stretch` times as long.
std::vector<Triangle> tube(int n, int rings, double stretch, double noise, Random& random) {
  std::vector<std::vector<Point>> points;
  const double step = 2 * CGAL_PI / n;
  for (int i = 0; i <= rings; ++i) {
    points.emplace_back();
    for (int k = 0; k < n; ++k)
      points.back().emplace_back(i * step * stretch + random(-noise, noise),
                                 std::cos((k + 0.5 * i) * step) + random(-noise, noise),
                                 std::sin((k + 0.5 * i) * step) + random(-noise, noise));
  }
  std::vector<Triangle> result;
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < n; ++k) {
      const Point &a = points[i][k], &b = points[i][(k + 1) % n], &c = points[i + 1][k],
                  &d = points[i + 1][(k + 1) % n];
      result.emplace_back(a, b, c);
      result.emplace_back(b, d, c);
    }
  return result;
}

template <class Shape> double nearest_of_all(const std::vector<Shape>& shapes, const Point& q) {
  double result = (std::numeric_limits<double>::infinity)();
  for (const Shape& s : shapes)
    result = (std::min)(result, CGAL::squared_distance(internal::projection(s, q), q));
  return result;
}

template <class Shape> void expect_nearest(const std::vector<Shape>& shapes, double extent, unsigned seed) {
  const internal::Corner_tree<Shape> tree(shapes);
  ASSERT_EQ(tree.size(), shapes.size());
  const double infinity = (std::numeric_limits<double>::infinity)();
  Random random(seed);
  for (int i = 0; i < 400; ++i) {
    Point q = random.point(extent);
    if (i % 4 == 0) // on a shape, at its corners, or all but
      q = CGAL::midpoint(shapes[std::size_t(i) % shapes.size()].vertex(0),
                         shapes[std::size_t(i) % shapes.size()].vertex(i % 8 == 0 ? 0 : 1));
    const double least = nearest_of_all(shapes, q), rounding = 1e-9 * (least + 1e-9);
    const auto found = tree.nearest(q);
    ASSERT_LT(found.index, shapes.size());
    ASSERT_NEAR(found.squared_distance, least, rounding);
    ASSERT_NEAR(CGAL::squared_distance(internal::projection(shapes[found.index], q), q), least, rounding);
    // wherever the search begins, and however little more is allowed
    for (std::size_t hint : {std::size_t(0), shapes.size() / 2, shapes.size() - 1}) {
      const auto again = tree.nearest_from(hint, q, infinity);
      ASSERT_EQ(again.index, found.index);
      ASSERT_EQ(again.point, found.point);
    }
    ASSERT_EQ(tree.nearest(q, found.squared_distance * 1.001 + 1e-30).index, found.index);
    ASSERT_EQ(tree.nearest(q, found.squared_distance).index, shapes.size());
    // and those no further than a bound
    const double bound = least + 0.01 * extent * extent;
    std::vector<std::size_t> near, expected;
    tree.for_each_near(q, bound, [&](std::size_t s, const Shape&, double d2) {
      ASSERT_NEAR(d2, CGAL::squared_distance(internal::projection(shapes[s], q), q), 1e-9 * (d2 + 1e-9));
      near.push_back(s);
    });
    for (std::size_t s = 0; s < shapes.size(); ++s)
      if (CGAL::squared_distance(internal::projection(shapes[s], q), q) <= bound)
        expected.push_back(s);
    std::sort(near.begin(), near.end());
    ASSERT_EQ(near, expected);
  }
}

TEST(Corner_tree, finds_the_nearest_triangle_of_a_tube) {
  Random random(1);
  for (double stretch : {0.05, 1., 20.})
    for (double noise : {0., 0.05})
      expect_nearest(tube(12, 30, stretch, noise, random), 2 * (1 + 3 * stretch), 2);
}

// Enough of them for several threads; points in between are no corners.
TEST(Corner_tree, is_the_same_of_corners_by_their_numbers_on_any_number_of_threads) {
  typedef internal::Corner_tree<Triangle> Tree;
  Random random(7);
  const std::vector<Triangle> triangles = tube(200, 100, 1, 0.01, random);
  std::map<Point, Tree::Index> numbers;
  std::vector<Point> points;
  std::vector<Tree::Numbers> shapes;
  for (const Triangle& t : triangles) {
    shapes.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const auto found = numbers.emplace(t[k], Tree::Index(points.size()));
      if (found.second) {
        points.push_back(t[k]);
        points.push_back(random.point(0.1));
      }
      shapes.back()[std::size_t(k)] = found.first->second;
    }
  }
  const Tree by_shapes(triangles), on_one(points, shapes, 1), on_three(points, shapes, 3);
  ASSERT_EQ(on_one.number_of_corners(), numbers.size());
  for (int i = 0; i < 2000; ++i) {
    const Point q = random.point(4);
    const auto found = by_shapes.nearest(q);
    EXPECT_EQ(on_one.nearest(q).index, found.index);
    EXPECT_EQ(on_three.nearest(q).index, found.index);
    EXPECT_EQ(on_three.nearest(q).squared_distance, found.squared_distance);
  }
}

TEST(Corner_tree, finds_the_nearest_of_triangles_that_have_nothing_in_common) {
  Random random(3);
  std::vector<Triangle> triangles; // of all shapes, needles among them
  for (int i = 0; i < 600; ++i) {
    const Point p = random.point(1), q = random.point(1);
    triangles.emplace_back(p, CGAL::barycenter(p, 0.999 - 0.001 * i, q), CGAL::barycenter(p, 0.5, random.point(1)));
  }
  expect_nearest(triangles, 1.5, 4);
}

TEST(Corner_tree, finds_the_nearest_triangle_where_some_have_no_area) {
  Random random(5);
  std::vector<Triangle> triangles = tube(10, 8, 1, 0, random);
  for (std::size_t i = 0; i < 20; ++i) {
    const Triangle t = triangles[7 * i];
    triangles.emplace_back(t[0], CGAL::midpoint(t[0], t[1]), t[1]);
  }
  expect_nearest(triangles, 2, 6);
}

TEST(Corner_tree, finds_the_nearest_segment_of_a_line) {
  Random random(7);
  std::vector<Segment> segments;
  Point last(0, 0, 0);
  for (int i = 0; i < 500; ++i) {
    const Point next = last + (random(0.01, 1)) * (random.point(0.1) - CGAL::ORIGIN);
    segments.emplace_back(last, next);
    last = next;
  }
  expect_nearest(segments, 1, 8);
}

TEST(Corner_tree, finds_nothing_where_there_is_nothing_or_no_place) {
  const internal::Corner_tree<Triangle> none;
  EXPECT_EQ(none.nearest(Point(0, 0, 0)).index, 0u);
  Random random(9);
  const internal::Corner_tree<Triangle> tree(tube(8, 4, 1, 0, random));
  const double nan = std::nan(""), infinity = (std::numeric_limits<double>::infinity)();
  EXPECT_EQ(tree.nearest(Point(nan, 0, 0)).index, tree.size());
  EXPECT_EQ(tree.nearest(Point(infinity, 0, 0)).index, tree.size());
  EXPECT_EQ(tree.nearest(Point(0, 0, 0), 0.25).index, tree.size());
}

// --- crossing triangles ---

// A torus of n × m quads, each two triangles; bent is how far its points are moved.
Surface torus(int n, int m, double thin, double moved, unsigned seed) {
  Random random(seed);
  Surface surface;
  std::vector<Surface::Vertex_index> v;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < m; ++k) {
      const double a = 2 * CGAL_PI * i / n, b = 2 * CGAL_PI * k / m, r = 1 + thin * std::cos(b);
      v.push_back(
          surface.add_vertex(Point_3(r * std::cos(a) + random(-moved, moved), r * std::sin(a) + random(-moved, moved),
                                     thin * std::sin(b) + random(-moved, moved))));
    }
  const auto at = [&](int i, int k) { return v[std::size_t(i % n * m + k % m)]; };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < m; ++k) {
      surface.add_face(at(i, k), at(i + 1, k), at(i + 1, k + 1));
      surface.add_face(at(i, k), at(i + 1, k + 1), at(i, k + 1));
    }
  return surface;
}

internal::Face_pairs by_cgal(const Surface& surface) {
  internal::Face_pairs pairs;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(pairs));
  for (auto& p : pairs)
    if (p.second < p.first)
      std::swap(p.first, p.second);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::size_t number_of_suspects(const Surface& surface) {
  return internal::Crossing_suspects({surface.faces_begin(), surface.faces_end()}, surface).faces().size();
}

TEST(Crossing_pairs, are_those_of_all_pairs) {
  std::size_t crossings = 0;
  for (double moved : {0., 0.01, 0.03, 0.1, 0.5})
    for (unsigned seed : {1u, 2u, 3u}) {
      const Surface surface = torus(40, 20, 0.3, moved, seed);
      const internal::Face_pairs expected = by_cgal(surface);
      EXPECT_EQ(internal::crossing_pairs(surface), expected) << moved;
      crossings += expected.size();
    }
  EXPECT_GT(crossings, 1000u);
}

TEST(Crossing_pairs, of_surfaces_that_only_touch_or_lie_on_each_other) {
  // of two sheets that pass through each other, on each other, and at a distance that is next to nothing
  for (double height : {0., 1e-300, 1e-18, 1e-9, 0.25}) {
    Surface surface;
    std::map<int, Surface::Vertex_index> v;
    for (int sheet = 0; sheet < 2; ++sheet)
      for (int i = 0; i < 6; ++i)
        for (int k = 0; k < 6; ++k)
          v[36 * sheet + 6 * i + k] = surface.add_vertex(Point_3(i, k, sheet * height * (height > 0.1 ? i - 2.5 : 1)));
    for (int sheet = 0; sheet < 2; ++sheet)
      for (int i = 0; i < 5; ++i)
        for (int k = 0; k < 5; ++k) {
          const int a = 36 * sheet + 6 * i + k;
          surface.add_face(v[a], v[a + 6], v[a + 7]);
          surface.add_face(v[a], v[a + 7], v[a + 1]);
        }
    EXPECT_EQ(internal::crossing_pairs(surface), by_cgal(surface)) << height;
  }
}

TEST(Crossing_pairs, of_folds_and_of_triangles_without_area) {
  for (double x : {-1., -1e-17, 0., 1e-17, 0.5, 1.}) {
    Surface surface;
    const auto a = surface.add_vertex(Point_3(0, 0, 0)), b = surface.add_vertex(Point_3(0, 1, 0));
    const auto c = surface.add_vertex(Point_3(1, 0.25, 0)), d = surface.add_vertex(Point_3(x, 0.5, 0));
    const auto e = surface.add_vertex(Point_3(x, 0.75, 1e-3));
    surface.add_face(a, c, b);
    surface.add_face(a, b, d);
    surface.add_face(d, b, e);
    EXPECT_EQ(internal::crossing_pairs(surface), by_cgal(surface)) << x;
  }
}

TEST(Crossing_pairs, need_no_exact_test_on_sound_surfaces) {
  EXPECT_EQ(number_of_suspects(torus(200, 40, 0.3, 0, 1)), 0u);
  EXPECT_EQ(number_of_suspects(torus(200, 40, 0.3, 0.002, 1)), 0u);
}

TEST(Crossing_pairs, of_some_faces) {
  const Surface surface = torus(30, 16, 0.3, 0.1, 4);
  std::vector<Surface::Face_index> some;
  for (auto f : surface.faces())
    if (std::size_t(f) % 3 != 0)
      some.push_back(f);
  internal::Face_pairs expected;
  for (const auto& p : by_cgal(surface))
    if (std::size_t(p.first) % 3 != 0 && std::size_t(p.second) % 3 != 0)
      expected.push_back(p);
  EXPECT_GT(expected.size(), 10u);
  EXPECT_EQ(internal::crossing_pairs(some, surface), expected);
  EXPECT_TRUE(internal::crossing_pairs(std::vector<Surface::Face_index>(), surface).empty());
}

// --- triangles that make a surface ---

TEST(Oriented_surface, is_told_as_cgal_tells_it) {
  std::mt19937 random(1);
  int surfaces = 0, others = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<internal::Index_triangle> triangles; // a torus of 4 × 4 quads, of which some are changed
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t a = 4 * i + k, b = 4 * ((i + 1) % 4) + k;
        const std::size_t c = 4 * ((i + 1) % 4) + (k + 1) % 4, d = 4 * i + (k + 1) % 4;
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      }
    const std::size_t removed = random() % 20;
    for (std::size_t i = 0; i < removed; ++i)
      triangles.erase(triangles.begin() + std::ptrdiff_t(random() % triangles.size()));
    if (random() % 3 == 0)
      std::swap(triangles[random() % triangles.size()][0], triangles[random() % triangles.size()][1]);
    if (random() % 3 == 0) {
      internal::Index_triangle& t = triangles[random() % triangles.size()];
      std::swap(t[0], t[1]);
    }
    if (random() % 4 == 0)
      triangles.push_back({random() % 16, random() % 16, random() % 16});
    const bool expected = CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(triangles);
    ASSERT_EQ(internal::is_oriented_surface(triangles, 16), expected) << round;
    ++(expected ? surfaces : others);
  }
  EXPECT_GT(surfaces, 100);
  EXPECT_GT(others, 100);
}

} // namespace

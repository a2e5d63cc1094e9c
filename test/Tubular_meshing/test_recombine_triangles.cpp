// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangles to quads: against all matchings there are on small meshes, on grids whose squares are known, and on borders
// whose corners leave triangles over.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef std::array<std::size_t, 3> Triangle;
typedef std::array<std::size_t, 4> Quad;
typedef std::pair<std::size_t, std::size_t> Edge;

class Recombine_triangles : public ::testing::Test {
protected:
  void SetUp() override {
    if (!tubular::has_lemon())
      GTEST_SKIP() << "built without LEMON";
  }
};

struct Triangles {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

// Of n x m squares, each with a diagonal; vertices inside moved at random by a part of a side.
Triangles grid(std::size_t n, std::size_t m, double noise, unsigned seed = 1, bool random_diagonals = false) {
  Triangles mesh;
  std::mt19937 random(seed);
  const auto shift = [&] { return noise * (double(random()) / double(std::mt19937::max()) - 0.5); };
  for (std::size_t j = 0; j <= m; ++j)
    for (std::size_t i = 0; i <= n; ++i) {
      const bool inside = i > 0 && i < n && j > 0 && j < m;
      const double dx = shift(), dy = shift();
      mesh.points.emplace_back(double(i) + (inside ? dx : 0), double(j) + (inside ? dy : 0), 0);
    }
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (random_diagonals && random() % 2 == 0) {
        mesh.triangles.push_back({{a, b, d}});
        mesh.triangles.push_back({{b, c, d}});
      } else {
        mesh.triangles.push_back({{a, b, c}});
        mesh.triangles.push_back({{a, c, d}});
      }
    }
  return mesh;
}

// Equilateral triangles in n rows: one large equilateral triangle of n² of them.
Triangles large_triangle(std::size_t n) {
  Triangles mesh;
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t j = 0; j <= n; ++j) {
    rows.emplace_back();
    for (std::size_t i = 0; i + j <= n; ++i) {
      rows.back().push_back(mesh.points.size());
      mesh.points.emplace_back(double(i) + 0.5 * double(j), std::sqrt(0.75) * double(j), 0);
    }
  }
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i + j < n; ++i) {
      mesh.triangles.push_back({{rows[j][i], rows[j][i + 1], rows[j + 1][i]}});
      if (i + j + 1 < n)
        mesh.triangles.push_back({{rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]}});
    }
  return mesh;
}

// (14) of a polygon of the plane, with angles up to 2π.
double plane_eta(const std::array<Point, 4>& p) {
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point &a = p[(i + 3) % 4], &b = p[i], &c = p[(i + 1) % 4];
    const double ux = c.x() - b.x(), uy = c.y() - b.y(), vx = a.x() - b.x(), vy = a.y() - b.y();
    double angle = std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
    if (angle < 0)
      angle += 2 * CGAL_PI;
    worst = (std::max)(worst, std::abs(CGAL_PI / 2 - angle));
  }
  return (std::max)(0., 1 - 2 / CGAL_PI * worst);
}

double eta(const std::vector<Point>& points, const Quad& q) {
  return plane_eta({{points[q[0]], points[q[1]], points[q[2]], points[q[3]]}});
}

double cost(const tubular::Recombined_triangles& mesh) {
  double sum = 0;
  for (const Quad& q : mesh.quads)
    sum += 1 - eta(mesh.points, q);
  return sum;
}

std::map<Edge, std::vector<std::size_t>> triangles_at_edges(const Triangles& mesh) {
  std::map<Edge, std::vector<std::size_t>> at;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      at[std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3])].push_back(t);
  return at;
}

/* All perfect matchings of neighbours, one after another: the smallest cost, infinite if there is none. */
class All_matchings {
public:
  explicit All_matchings(const Triangles& mesh)
      : partners_(mesh.triangles.size()) {
    for (const auto& e : triangles_at_edges(mesh)) {
      if (e.second.size() != 2)
        continue;
      const Triangle &s = mesh.triangles[e.second[0]], &t = mesh.triangles[e.second[1]];
      const std::size_t i = corner_opposite(s, e.first), j = corner_opposite(t, e.first);
      const double quality = eta(mesh.points, {{s[i], s[(i + 1) % 3], t[j], s[(i + 2) % 3]}});
      partners_[e.second[0]].emplace_back(e.second[1], quality);
      partners_[e.second[1]].emplace_back(e.second[0], quality);
    }
  }
  double smallest_cost() {
    taken_.assign(partners_.size(), false);
    return best_from(0);
  }

private:
  static std::size_t corner_opposite(const Triangle& t, const Edge& e) {
    std::size_t i = 0;
    while (t[i] == e.first || t[i] == e.second)
      ++i;
    return i;
  }
  double best_from(std::size_t t) {
    while (t < taken_.size() && taken_[t])
      ++t;
    if (t == taken_.size())
      return 0;
    double best = std::numeric_limits<double>::infinity();
    taken_[t] = true;
    for (const auto& p : partners_[t]) {
      if (taken_[p.first] || p.second <= 0)
        continue;
      taken_[p.first] = true;
      best = (std::min)(best, 1 - p.second + best_from(t + 1));
      taken_[p.first] = false;
    }
    taken_[t] = false;
    return best;
  }

  std::vector<std::vector<std::pair<std::size_t, double>>> partners_;
  std::vector<bool> taken_;
};

template <class Polygons> void count_sides(const Polygons& polygons, std::map<Edge, int>& sides) {
  for (const auto& p : polygons)
    for (std::size_t i = 0; i < p.size(); ++i)
      ++sides[{p[i], p[(i + 1) % p.size()]}];
}

// The halfedges without another one on the other side. Each halfedge may be there once only.
template <class Mesh> std::set<Edge> border(const Mesh& mesh) {
  std::map<Edge, int> sides;
  count_sides(mesh.triangles, sides);
  if constexpr (std::is_same<Mesh, tubular::Recombined_triangles>::value)
    count_sides(mesh.quads, sides);
  std::set<Edge> result;
  for (const auto& s : sides) {
    EXPECT_EQ(s.second, 1);
    if (sides.count({s.first.second, s.first.first}) == 0)
      result.insert(s.first);
  }
  return result;
}

double area(const std::vector<Point>& points, const Quad& q) {
  double twice = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point &a = points[q[i]], &b = points[q[(i + 1) % 4]];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

// All quads, valid, of the same area and border as the triangles.
void expect_all_quads(const Triangles& mesh, const tubular::Recombined_triangles& result, double whole) {
  EXPECT_TRUE(result.triangles.empty());
  EXPECT_EQ(result.quads.size(), mesh.triangles.size() / 2 + result.report.split_vertices);
  EXPECT_EQ(result.points.size(), mesh.points.size() + result.report.split_vertices);
  EXPECT_EQ(border(result), border(mesh));
  double sum = 0;
  for (const Quad& q : result.quads) {
    EXPECT_GT(eta(result.points, q), 0);
    sum += area(result.points, q);
  }
  EXPECT_NEAR(sum, whole, 1e-12 * whole);
}

TEST_F(Recombine_triangles, Costs_what_the_best_of_all_matchings_costs) {
  int possible = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Triangles mesh = grid(4, 2 + seed % 3, 0.9, seed, true);
    const double best = All_matchings(mesh).smallest_cost();
    if (std::isinf(best))
      continue; // some angle is too large
    ++possible;
    const auto result = tubular::recombine_triangles(mesh.points, mesh.triangles);
    EXPECT_EQ(result.report.split_vertices, 0u);
    EXPECT_NEAR(cost(result), best, 1e-5 * double(mesh.triangles.size())) << seed;
    expect_all_quads(mesh, result, 4. * (2 + seed % 3));
  }
  EXPECT_GT(possible, 30);
}

TEST_F(Recombine_triangles, Finds_the_squares_of_a_grid) {
  const Triangles mesh = grid(30, 20, 0, 1, true);
  const auto result = tubular::recombine_triangles(mesh.points, mesh.triangles);
  ASSERT_EQ(result.quads.size(), 600u);
  expect_all_quads(mesh, result, 600);
  for (const Quad& q : result.quads)
    EXPECT_NEAR(eta(result.points, q), 1, 1e-12);
}

// Each triangle of one colour has neighbours of the other colour only, of which there are n fewer.
TEST_F(Recombine_triangles, Leaves_no_triangle_where_neighbours_cannot_all_be_paired) {
  for (std::size_t n : {4u, 6u, 10u}) {
    const Triangles mesh = large_triangle(n);
    const auto result = tubular::recombine_triangles(mesh.points, mesh.triangles);
    EXPECT_EQ(result.report.split_vertices, n / 2);
    EXPECT_EQ(result.report.invalid_quads, 0u);
    expect_all_quads(mesh, result, std::sqrt(0.75) / 2 * double(n * n));
  }
}

TEST_F(Recombine_triangles, Reports_the_one_triangle_of_an_odd_number) {
  Triangles mesh = grid(5, 4, 0.3);
  mesh.triangles.erase(mesh.triangles.begin());
  const auto result = tubular::recombine_triangles(mesh.points, mesh.triangles);
  EXPECT_EQ(result.report.triangles, 1u);
  EXPECT_EQ(result.triangles.size(), 1u);
  EXPECT_EQ(result.quads.size(), result.report.quads);
  EXPECT_EQ(border(result), border(mesh));
}

TEST_F(Recombine_triangles, Counts_each_component_by_itself) {
  Triangles mesh = large_triangle(1);
  const Triangles other = large_triangle(3);
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({{t[0] + 3, t[1] + 3, t[2] + 3}});
  for (const Point& p : other.points)
    mesh.points.emplace_back(p.x() + 10, p.y(), p.z());
  const auto result = tubular::recombine_triangles(mesh.points, mesh.triangles);
  EXPECT_EQ(result.report.triangles, 2u); // 1 + 9 is even, but neither is alone
  EXPECT_EQ(border(result), border(mesh));
}

TEST_F(Recombine_triangles, Keeps_the_border_between_patches) {
  Triangles mesh = grid(6, 6, 0.2);
  std::vector<int> patches;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    patches.push_back((t % 12 ^ 1) < 5 ? 7 : 8); // of two squares and a half in each row, three triangles of one colour
  const auto result = tubular::recombine_triangles(mesh.points, mesh.triangles, patches);
  ASSERT_EQ(result.quad_patches.size(), result.quads.size());
  EXPECT_TRUE(result.triangles.empty());
  EXPECT_EQ(result.report.split_vertices, 6u); // half of six on either side
  double in_seven = 0;
  for (std::size_t i = 0; i < result.quads.size(); ++i)
    in_seven += result.quad_patches[i] == 7 ? area(result.points, result.quads[i]) : 0;
  double expected = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    expected += patches[t] == 7 ? area(mesh.points, {{c[0], c[1], c[2], c[2]}}) : 0;
  }
  EXPECT_NEAR(in_seven, expected, 1e-12 * expected);
  EXPECT_EQ(border(result), border(mesh));
}

TEST_F(Recombine_triangles, Does_not_depend_on_units) {
  const Triangles mesh = grid(5, 6, 0.8, 3, true);
  std::vector<Point> small;
  for (const Point& p : mesh.points)
    small.emplace_back(p.x() / 1024 / 1024, p.y() / 1024 / 1024, 0);
  EXPECT_EQ(tubular::recombine_triangles(mesh.points, mesh.triangles).quads,
            tubular::recombine_triangles(small, mesh.triangles).quads);
}

Surface surface_of(const Triangles& mesh) {
  Surface surface;
  for (const Point& p : mesh.points)
    surface.add_vertex(p);
  for (const Triangle& t : mesh.triangles)
    surface.add_face(Surface::Vertex_index(unsigned(t[0])), Surface::Vertex_index(unsigned(t[1])),
                     Surface::Vertex_index(unsigned(t[2])));
  return surface;
}

template <class Polygon> std::set<Point> corners_of(const std::vector<Point>& points, const Polygon& polygon) {
  std::set<Point> corners;
  for (std::size_t v : polygon)
    corners.insert(points[v]);
  return corners;
}

TEST_F(Recombine_triangles, Changes_a_surface_mesh_as_it_does_arrays) {
  for (const Triangles& mesh : {large_triangle(6), grid(4, 5, 0.5, 2, true), large_triangle(5)}) {
    const auto expected = tubular::recombine_triangles(mesh.points, mesh.triangles);
    Surface surface = surface_of(mesh);
    const auto report = tubular::recombine_triangles(surface);
    EXPECT_TRUE(surface.is_valid());
    EXPECT_EQ(report.split_vertices, expected.report.split_vertices);
    EXPECT_EQ(report.triangles, expected.report.triangles);
    EXPECT_EQ(surface.number_of_faces(), expected.quads.size() + expected.triangles.size());
    EXPECT_EQ(surface.number_of_vertices(), expected.points.size());
    std::multiset<std::set<Point>> faces, expected_faces;
    for (auto f : surface.faces()) {
      std::set<Point> corners;
      for (auto v : surface.vertices_around_face(surface.halfedge(f)))
        corners.insert(surface.point(v));
      faces.insert(corners);
    }
    for (const Quad& q : expected.quads)
      expected_faces.insert(corners_of(expected.points, q));
    for (const Triangle& t : expected.triangles)
      expected_faces.insert(corners_of(expected.points, t));
    EXPECT_EQ(faces, expected_faces);
  }
}

TEST_F(Recombine_triangles, Joins_no_faces_of_different_patches_of_a_surface_mesh) {
  Surface surface = surface_of(grid(4, 4, 0));
  auto patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
  for (auto f : surface.faces())
    patch[f] = int(std::size_t(f)) % 2;
  const auto report = tubular::recombine_triangles(surface, tubular::parameters::face_patch_map(patch));
  EXPECT_EQ(report.triangles, 32u); // each beside the three of the other patch
  EXPECT_EQ(report.quads, 0u);
}

template <class Function> std::string sentence_of(const Function& f) {
  try {
    f();
  } catch (const tubular::Input_error& e) {
    return e.what();
  }
  return "";
}

TEST_F(Recombine_triangles, Refuses_what_is_no_mesh) {
  const std::vector<Point> points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)};
  const auto sentence = [&](const std::vector<Triangle>& triangles, const std::vector<int>& patches) {
    return sentence_of([&] { tubular::recombine_triangles(points, triangles, patches); });
  };
  EXPECT_NE(sentence({{{0, 1, 9}}}, {}).find("Triangle 0 refers to point 9"), std::string::npos);
  EXPECT_NE(sentence({{{0, 1, 1}}}, {}).find("point 1 twice"), std::string::npos);
  EXPECT_NE(sentence({{{0, 1, 2}}, {{0, 1, 3}}}, {}).find("turned differently"), std::string::npos);
  EXPECT_NE(sentence({{{0, 1, 2}}}, {1, 2}).find("one patch a triangle"), std::string::npos);
  EXPECT_EQ(sentence({}, {}), "");

  Surface quad;
  std::vector<Surface::Vertex_index> v;
  for (const Point& p : points)
    v.push_back(quad.add_vertex(p));
  quad.add_face(v[0], v[1], v[2], v[3]);
  EXPECT_NE(sentence_of([&] { tubular::recombine_triangles(quad); }).find("Face 0"), std::string::npos);
}

TEST(Recombine_triangles_without_lemon, Says_what_is_missing) {
  if (tubular::has_lemon())
    GTEST_SKIP() << "built with LEMON";
  const Triangles mesh = grid(1, 1, 0);
  EXPECT_THROW(tubular::recombine_triangles(mesh.points, mesh.triangles), tubular::Meshing_error);
}

} // namespace

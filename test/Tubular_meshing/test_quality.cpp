// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Shape measures, quality and validity reports against closed forms.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/Quality/Mesh_check.h>
#include <CGAL/Tubular_meshing/Quality/element_quality.h>
#include <CGAL/Tubular_meshing/Quality/mesh_report.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/shape_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Tubular_meshing::Mixed_mesh Mesh;
namespace tubular = CGAL::Tubular_meshing;

const double eps = 1e-12;
const std::array<Point, 4> regular = {Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1)};

TEST(Shape_measures, Triangles) {
  EXPECT_NEAR(tubular::triangle_gamma(Point(0, 0, 0), Point(1, 0, 0), Point(0.5, std::sqrt(0.75), 0)), 1, eps);
  // the 3-4-5 triangle has inradius 1 and circumradius 5/2
  EXPECT_NEAR(tubular::triangle_gamma(Point(0, 0, 7), Point(3, 0, 7), Point(0, 4, 7)), 0.8, eps);
  EXPECT_EQ(tubular::triangle_gamma(Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)), 0);
  EXPECT_EQ(tubular::triangle_gamma(Point(1, 1, 1), Point(1, 1, 1), Point(1, 1, 1)), 0);
}

TEST(Shape_measures, Tetrahedra) {
  EXPECT_NEAR(tubular::tetrahedron_gamma(regular[0], regular[2], regular[1], regular[3]), 1, eps);
  EXPECT_NEAR(tubular::tetrahedron_gamma(regular[0], regular[1], regular[2], regular[3]), -1, eps);
  // the unit corner: V = 1/6, area (3 + √3) / 2, longest edge √2
  const double inradius = 1 / (3 + std::sqrt(3.));
  EXPECT_NEAR(tubular::tetrahedron_gamma(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)),
              2 * std::sqrt(6.) * inradius / std::sqrt(2.), eps);
  EXPECT_NEAR(tubular::tetrahedron_gamma(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0)), 0, eps);
}

TEST(Shape_measures, Do_not_depend_on_units) {
  for (double s : {1e-9, 1e-3, 1e6}) {
    const auto p = [s](double x, double y, double z) { return Point(s * x, s * y, s * z); };
    EXPECT_NEAR(tubular::tetrahedron_gamma(p(0, 0, 0), p(1, 0, 0), p(0, 1, 0), p(0, 0, 1)),
                tubular::tetrahedron_gamma(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)), 1e-9);
    EXPECT_NEAR(tubular::triangle_gamma(p(0, 0, 7), p(3, 0, 7), p(0, 4, 7)), 0.8, 1e-9);
  }
}

TEST(Shape_measures, Quadrilaterals) {
  EXPECT_NEAR(tubular::quad_eta<Point>({Point(0, 0, 0), Point(3, 0, 0), Point(3, 1, 0), Point(0, 1, 0)}), 1, eps);
  // a rhombus of 60 and 120 degrees is 30 degrees off
  const double h = std::sqrt(0.75);
  EXPECT_NEAR(tubular::quad_eta<Point>({Point(0, 0, 0), Point(1, 0, 0), Point(1.5, h, 0), Point(0.5, h, 0)}), 2. / 3,
              eps);
  // three of its vertices in line
  EXPECT_NEAR(tubular::quad_eta<Point>({Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(0, 2, 0)}), 0, eps);
}

TEST(Shape_measures, Hexahedra) {
  const auto brick = [](double shear) {
    std::array<Point, 8> p;
    const double x[4] = {0, 1, 1, 0}, y[4] = {0, 0, 2, 2};
    for (std::size_t i = 0; i < 8; ++i)
      p[i] = Point(x[i % 4] + (i > 3 ? 3 * shear : 0), y[i % 4], i > 3 ? 3 : 0);
    return p;
  };
  EXPECT_NEAR(tubular::hexahedron_zeta(brick(0)), 1, eps);
  // sheared by 45 degrees, angles are 45 and 135
  EXPECT_NEAR(tubular::hexahedron_zeta(brick(1)), 0.5, eps);
}

TEST(Shape_measures, In_a_metric) {
  const std::array<double, 6> metric = {1. / 9, 0, 0, 4, 0, 25}; // sizes 3, 1/2, 1/5 along the axes
  std::array<Point, 4> p = regular;
  for (Point& q : p)
    q = Point(3 * q.x(), q.y() / 2, q.z() / 5);
  EXPECT_NEAR(tubular::tetrahedron_Q<Point>(p, {metric, metric, metric, metric}), 1, eps);
  EXPECT_NEAR(tubular::metric_length(p[0], p[1], metric, metric), std::sqrt(8.), eps);
  // an edge along x whose squared metric goes from 1 to 4: ∫ √(1 + 3t) dt = 14/9
  EXPECT_NEAR(tubular::metric_length(Point(0, 0, 0), Point(1, 0, 0), {1, 0, 0, 1, 0, 1}, {4, 0, 0, 1, 0, 1}), 14. / 9,
              1e-5);
  const std::array<double, 6> identity = {1, 0, 0, 1, 0, 1};
  EXPECT_EQ(tubular::tetrahedron_Q<Point>({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0)},
                                          {identity, identity, identity, identity}),
            (std::numeric_limits<double>::infinity)());
}

TEST(Measure_statistics, Of_known_numbers) {
  const tubular::Measure_statistics s({0.5, 0.1, 0.3, 0.2, 0.4});
  EXPECT_EQ(s.count(), 5u);
  EXPECT_EQ(s.min(), 0.1);
  EXPECT_EQ(s.max(), 0.5);
  EXPECT_NEAR(s.mean(), 0.3, eps);
  EXPECT_NEAR(s.percentile(50), 0.3, eps);
  EXPECT_NEAR(s.percentile(10), 0.14, eps);
  EXPECT_NEAR(s.share_below(0.3), 0.4, eps);
  EXPECT_EQ(s.histogram()[2], 1u);
  EXPECT_EQ(s.histogram()[19], 0u);
  EXPECT_EQ(tubular::Measure_statistics().mean(), 0);
  EXPECT_EQ(tubular::Measure_statistics().percentile(50), 0);
}

// What a sorted copy of the values gives.
void expect_statistics_of(std::vector<double> values) {
  const tubular::Measure_statistics s(values);
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  ASSERT_EQ(s.count(), n);
  EXPECT_EQ(s.min(), values.front());
  EXPECT_EQ(s.max(), values.back());
  for (double percent : {0., 0.1, 5., 50., 66.6, 95., 99.9, 100.}) {
    const double at = percent / 100 * double(n - 1);
    const std::size_t i = std::size_t(at), j = (std::min)(i + 1, n - 1);
    const double wanted =
        values[i] < values[j] && at > double(i) ? values[i] + (at - double(i)) * (values[j] - values[i]) : values[i];
    EXPECT_EQ(s.percentile(percent), wanted) << percent;
  }
  for (double bound : {-1., 0., 0.3, values[n / 3], values.back(), values.back() + 1})
    EXPECT_EQ(s.share_below(bound),
              double(std::lower_bound(values.begin(), values.end(), bound) - values.begin()) / double(n))
        << bound;
}

TEST(Measure_statistics, Are_those_of_sorted_values) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit;
  const double infinite = (std::numeric_limits<double>::infinity)();
  for (std::size_t n : {1u, 2u, 3u, 1000u, 20001u}) {
    std::vector<double> even(n), wide(n), few(n);
    for (std::size_t k = 0; k < n; ++k) {
      even[k] = unit(random);
      wide[k] = (unit(random) < 0.4 ? -1 : 1) * std::pow(10., 600 * unit(random) - 300);
      few[k] = std::floor(3 * unit(random)) - 1;
    }
    expect_statistics_of(even);
    expect_statistics_of(wide);
    expect_statistics_of(few);
    expect_statistics_of(std::vector<double>(n, 0.7));
    even[n / 2] = infinite;
    expect_statistics_of(even);
    even.assign(n, infinite);
    expect_statistics_of(even);
    even.assign(n, 0.);
    even[n / 2] = -0.;
    expect_statistics_of(even);
  }
}

// A measure that is no number spoils its own place alone.
TEST(Measure_statistics, Numbers_beside_one_that_is_none) {
  std::vector<double> values(1000, 0.5);
  values[500] = std::numeric_limits<double>::quiet_NaN();
  const tubular::Measure_statistics s(values);
  EXPECT_EQ(s.min(), 0.5);
  EXPECT_EQ(s.percentile(50), 0.5);
  EXPECT_EQ(s.share_below(0.4), 0);
  EXPECT_TRUE(std::isnan(s.mean()));
}

/* A cube of side 1 as a hexahedron, a pyramid on its top whose apex is 1 above, and a prism at its side x = 1; all
 * boundary faces labelled 1. */
Mesh mixed_cells() {
  Mesh m;
  m.points = {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 0, 1),  Point(1, 0, 1),
              Point(1, 1, 1), Point(0, 1, 1), Point(2, 0, 0), Point(2, 1, 0), Point(.5, .5, 2)};
  m.hexahedra.push_back({0, 1, 2, 3, 4, 5, 6, 7}, 1);
  m.pyramids.push_back({4, 5, 6, 7, 10}, 1);
  m.prisms.push_back({1, 8, 5, 2, 9, 6}, 1);
  for (auto t : {std::array<std::uint32_t, 3>{4, 5, 10}, {5, 6, 10}, {6, 7, 10}, {7, 4, 10}, {1, 8, 5}, {2, 6, 9}})
    m.triangles.push_back(t, 1);
  for (auto q :
       {std::array<std::uint32_t, 4>{0, 3, 2, 1}, {0, 1, 5, 4}, {2, 3, 7, 6}, {3, 0, 4, 7}, {1, 2, 9, 8}, {8, 9, 6, 5}})
    m.quads.push_back(q, 1);
  return m;
}

TEST(Validity_report, Accepts_mixed_cells) {
  Mesh m = mixed_cells();
  const auto r = tubular::validity_report(m);
  // the prism's base must turn counterclockwise seen from its top
  EXPECT_EQ(r.inverted_cells, 1u) << r.defects();
  m.prisms.vertices[0] = {1, 5, 8, 2, 6, 9};
  const auto fixed = tubular::validity_report(m);
  EXPECT_TRUE(fixed.is_valid()) << fixed.defects();
  EXPECT_EQ(fixed.boundary_euler, 2);
  EXPECT_EQ(fixed.cells, 3u);
}

TEST(Validity_report, Names_every_defect) {
  Mesh good = mixed_cells();
  good.prisms.vertices[0] = {1, 5, 8, 2, 6, 9};
  EXPECT_EQ(tubular::validity_report(Mesh()).defects(), "no cells");

  Mesh m = good;
  m.points.push_back(Point(9, 9, 9));
  EXPECT_EQ(tubular::validity_report(m).unused_points, 1u);

  m = good;
  m.triangles.vertices.pop_back();
  m.triangles.label.pop_back();
  EXPECT_EQ(tubular::validity_report(m).unlabelled_faces, 1u);

  m = good;
  m.triangles.push_back({0, 1, 8}, 1);
  EXPECT_EQ(tubular::validity_report(m).misplaced_facets, 1u);

  m = good; // the same cell twice
  m.pyramids.push_back(m.pyramids.vertices[0], 1);
  EXPECT_GT(tubular::validity_report(m).overfull_faces, 0u);

  m = good; // a tetrahedron grown into the pyramid: both lie on one side of their face
  m.points.push_back(Point(.5, .4, 1.2));
  m.tetrahedra.push_back({4, 5, 11, 10}, 1);
  EXPECT_EQ(tubular::validity_report(m).overfull_faces, 1u);

  m = good; // a second piece
  for (double x : {5., 6.})
    m.points.push_back(Point(x, 0, 0));
  m.points.push_back(Point(5, 1, 0));
  m.points.push_back(Point(5, 0, 1));
  m.tetrahedra.push_back({11, 12, 13, 14}, 1);
  EXPECT_EQ(tubular::validity_report(m).connected_components, 2u);
  EXPECT_EQ(tubular::validity_report(m).boundary_euler, 4);

  m = good; // two cells that touch in an edge only
  m.points.push_back(Point(-1, 0, 0));
  m.points.push_back(Point(0, -1, .5));
  m.tetrahedra.push_back({0, 4, 12, 11}, 1);
  EXPECT_EQ(tubular::validity_report(m).inverted_cells + tubular::validity_report(m).nonmanifold_edges, 2u);
}

TEST(Quality_report, Measures_what_is_there) {
  Mesh m = mixed_cells();
  const auto r = tubular::quality_report(m);
  EXPECT_EQ(r.gamma_tau.count(), 0u);
  EXPECT_EQ(r.Q_tau.count(), 0u);
  EXPECT_EQ(r.gamma_T.count(), 6u);
  EXPECT_EQ(r.eta_q.count(), 6u);
  EXPECT_NEAR(r.zeta_H.min(), 1, eps);
}

// --- finite volumes ---

/* n[0] x n[1] x n[2] unit cubes, their vertices moved. */
template <class Move> Mesh moved_cubes(const std::array<int, 3>& n, const Move& move) {
  Mesh m;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i)
        m.points.push_back(move(double(i), double(j), double(k)));
  const auto at = [&](int i, int j, int k) { return std::uint32_t((k * (n[1] + 1) + j) * (n[0] + 1) + i); };
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        m.hexahedra.push_back({at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k), at(i, j, k + 1),
                               at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)},
                              1 + i % 2);
  return m;
}

TEST(Quality_report, Scaled_jacobian_of_hexahedra) {
  const Mesh brick = moved_cubes({1, 1, 1}, [](double x, double y, double z) { return Point(x, 2 * y, 5 * z); });
  EXPECT_NEAR(tubular::quality_report(brick).scaled_jacobian.min(), 1, eps);
  const Mesh sheared = moved_cubes({2, 1, 1}, [](double x, double y, double z) { return Point(x + z, y, z); });
  EXPECT_EQ(tubular::quality_report(sheared).scaled_jacobian.count(), 2u);
  EXPECT_NEAR(tubular::quality_report(sheared).scaled_jacobian.max(), std::sqrt(0.5), eps);
  // one corner pushed in along the diagonal until it is flat, and beyond
  for (double t : {2. / 3, 0.9}) {
    const Mesh m = moved_cubes({1, 1, 1}, [&](double x, double y, double z) {
      return x + y + z == 0 ? Point(t / 2, t / 2, t / 2) : Point(x, y, z);
    });
    const double flatness = tubular::quality_report(m).scaled_jacobian.min();
    EXPECT_NEAR(flatness, (1 - 1.5 * t) / std::pow((1 - t / 2) * (1 - t / 2) + t * t / 2, 1.5), eps);
    EXPECT_EQ(flatness, tubular::hexahedron_jacobian<Point>({m.points[0], m.points[1], m.points[3], m.points[2],
                                                             m.points[4], m.points[5], m.points[7], m.points[6]}));
  }
}

TEST(Quality_report, Finite_volumes_of_bricks) {
  const Mesh m = moved_cubes({2, 1, 1}, [](double x, double y, double z) { return Point(x, 2 * y, 3 * z); });
  const auto r = tubular::quality_report(m);
  EXPECT_EQ(r.aspect.count(), 2u);
  EXPECT_EQ(r.non_orthogonality.count(), 1u);
  EXPECT_EQ(r.skewness.count(), 11u);
  EXPECT_NEAR(r.aspect.min(), 3, eps); // the areas are 12, 6 and 4 along the axes
  EXPECT_NEAR(r.aspect.max(), 3, eps);
  EXPECT_NEAR(r.non_orthogonality.max(), 0, 1e-5); // of the arc cosine
  EXPECT_NEAR(r.skewness.max(), 0, eps);
}

TEST(Quality_report, Finite_volumes_of_sheared_cubes) {
  const Mesh m = moved_cubes({2, 1, 1}, [](double x, double y, double z) { return Point(x + z, y, z); });
  const auto r = tubular::quality_report(m);
  EXPECT_NEAR(r.aspect.min(), 2, eps); // the areas are 2, 2 and 4
  EXPECT_NEAR(r.non_orthogonality.max(), 45, 1e-9);
  // between the cells 0; at the ends 1/2; at the sides 0; below and above the centers are 1/2 off, as the faces' edges
  EXPECT_NEAR(r.skewness.max(), 1, eps);
  EXPECT_NEAR(r.skewness.mean(), (2 * 0.5 + 4 * 1) / 11, eps);
}

TEST(Quality_report, Finite_volumes_where_lines_of_cells_turn) {
  const double t = 0.4;
  const Mesh m =
      moved_cubes({2, 1, 1}, [&](double x, double y, double z) { return Point(x, y + t * std::max(0., x - 1), z); });
  const auto r = tubular::quality_report(m);
  EXPECT_NEAR(r.non_orthogonality.max(), std::atan(t / 2) * 180 / std::acos(-1.), 1e-9);
  // between the cells t/2, at the far end t, on two sides of the second cell t / (1 + t²)
  EXPECT_NEAR(r.skewness.max(), t, eps);
  EXPECT_NEAR(r.skewness.mean(), (t / 2 + t + 2 * t / (1 + t * t)) / 11, eps);
  // far away the distance of the centers is what the face's extent is compared with: 0.2 √(L² + (t L)²)
  const double l = 20;
  const Mesh thin = moved_cubes(
      {2, 1, 1}, [&](double x, double y, double z) { return Point(l * x, y + l * t * std::max(0., x - 1), z); });
  const double d = l * std::sqrt(1 + t * t / 4);
  EXPECT_GT(0.2 * d, 0.5);
  EXPECT_NEAR(tubular::quality_report(thin, 1).skewness.max(), 0, eps);
  const auto skewness = tubular::quality_report(thin).skewness;
  const double between = (l * t / 4) / (0.2 * d), end = (l * t / 2) / (0.4 * l / 2);
  const double side = t / (l * (1 + t * t));
  EXPECT_NEAR(skewness.mean(), (between + end + 2 * side) / 11, eps);
}

TEST(Quality_report, Finite_volumes_of_two_prisms) {
  Mesh m; // a brick of 2 x 1 x 1, cut along the diagonal of its base
  for (double z : {0., 1.})
    for (const auto& p : {Point(0, 0, z), Point(2, 0, z), Point(2, 1, z), Point(0, 1, z)})
      m.points.push_back(p);
  m.prisms.push_back({0, 1, 2, 4, 5, 6}, 1);
  m.prisms.push_back({0, 2, 3, 4, 6, 7}, 1);
  const auto r = tubular::quality_report(m);
  EXPECT_EQ(r.skewness.count(), 9u);
  // the centers are (4, 1)/3 and (2, 2)/3, the normal is (-1, 2)/√5
  EXPECT_NEAR(r.non_orthogonality.max(), std::acos(0.8) * 180 / std::acos(-1.), 1e-9);
  // on the four upright sides the centers are a third of half the edge off
  EXPECT_NEAR(r.skewness.max(), 1. / 3, eps);
  EXPECT_NEAR(r.skewness.mean(), 4. / 3 / 9, eps);
  EXPECT_NEAR(r.aspect.max(), 2, eps); // the areas are 2, 4 and 2
}

TEST(Quality_report, Finite_volumes_of_tetrahedra_and_pyramids) {
  Mesh m; // a regular octahedron of two pyramids, and a regular tetrahedron on a side of it
  m.points = {Point(1, 0, 0), Point(0, 1, 0),  Point(-1, 0, 0), Point(0, -1, 0),
              Point(0, 0, 1), Point(0, 0, -1), Point(1, 1, 1)};
  m.pyramids.push_back({0, 1, 2, 3, 4}, 1);
  m.pyramids.push_back({3, 2, 1, 0, 5}, 1);
  m.tetrahedra.push_back({0, 1, 4, 6}, 1);
  const auto valid = tubular::validity_report(m);
  EXPECT_EQ(valid.inverted_cells, 0u);
  const auto r = tubular::quality_report(m);
  EXPECT_EQ(r.aspect.count(), 3u);
  EXPECT_EQ(r.non_orthogonality.count(), 2u);
  EXPECT_EQ(r.skewness.count(), 2u + 4 + 3 + 3);
  // a pyramid's center is a quarter of its height up, at (0, 0, 1/4); the tetrahedron's is (1, 1, 1)/2
  EXPECT_NEAR(r.non_orthogonality.min(), 0, 1e-5);
  EXPECT_NEAR(r.non_orthogonality.max(),
              std::acos((0.5 + 0.5 + 0.25) / std::sqrt(3 * (0.25 + 0.25 + 0.0625))) * 180 / std::acos(-1.), 1e-9);
  EXPECT_NEAR(r.aspect.min(), 2, eps); // of a pyramid, whose areas are 2, 2 and 4
  // of the tetrahedron, whose areas are 2 along each axis, and whose volume is 1/3
  EXPECT_NEAR(r.aspect.max(), 1 / std::pow(1. / 3, 2. / 3), eps);
}

TEST(Quality_report, Finite_volumes_of_a_region_end_at_its_interfaces) {
  const Mesh m = moved_cubes({3, 1, 1}, [](double x, double y, double z) { return Point(x + z, y, z); });
  const auto ends = tubular::quality_report(m, 1), middle = tubular::quality_report(m, 2);
  EXPECT_EQ(ends.aspect.count(), 2u);
  EXPECT_EQ(ends.non_orthogonality.count(), 0u);
  EXPECT_EQ(ends.skewness.count(), 12u);
  EXPECT_EQ(middle.skewness.count(), 6u);
  EXPECT_EQ(tubular::quality_report(m).skewness.count(), 16u);
  EXPECT_EQ(tubular::quality_report(m).non_orthogonality.count(), 2u);
  EXPECT_EQ(tubular::quality_report(Mesh()).skewness.count(), 0u);
}

TEST(Quality_report, Is_the_same_on_any_number_of_threads) {
  const Mesh m = moved_cubes({20, 20, 20}, [](double x, double y, double z) {
    return Point(x + 0.2 * std::sin(y), y + 0.2 * std::sin(z), z * (1 + 0.01 * x));
  });
  const auto one = tubular::quality_report(m, tubular::parameters::number_of_threads(1));
  EXPECT_EQ(one.scaled_jacobian.count(), 8000u);
  EXPECT_EQ(one.non_orthogonality.count(), 3 * 19u * 400);
  for (int threads : {0, 3}) {
    const auto several = tubular::quality_report(m, tubular::parameters::number_of_threads(threads));
    for (auto measure :
         {&tubular::Quality_report::zeta_H, &tubular::Quality_report::scaled_jacobian, &tubular::Quality_report::aspect,
          &tubular::Quality_report::non_orthogonality, &tubular::Quality_report::skewness}) {
      EXPECT_EQ((several.*measure).count(), (one.*measure).count());
      EXPECT_EQ((several.*measure).mean(), (one.*measure).mean());
      for (double percent : {0., 1., 50., 99., 100.})
        EXPECT_EQ((several.*measure).percentile(percent), (one.*measure).percentile(percent));
    }
  }
  const auto region = tubular::quality_report(m, 2, tubular::parameters::number_of_threads(3));
  EXPECT_EQ(region.aspect.mean(),
            tubular::quality_report(m, 2, tubular::parameters::number_of_threads(1)).aspect.mean());
}

void expect_same(const tubular::Mesh_report& a, const tubular::Mesh_report& b) {
  EXPECT_EQ(a.validity.cells, b.validity.cells);
  EXPECT_EQ(a.validity.inverted_cells, b.validity.inverted_cells);
  EXPECT_EQ(a.validity.defects(), b.validity.defects());
  EXPECT_EQ(a.validity.boundary_euler, b.validity.boundary_euler);
  EXPECT_EQ(a.validity.region_components, b.validity.region_components);
  for (auto measure : {&tubular::Quality_report::gamma_tau, &tubular::Quality_report::scaled_jacobian,
                       &tubular::Quality_report::aspect, &tubular::Quality_report::non_orthogonality,
                       &tubular::Quality_report::skewness}) {
    EXPECT_EQ((a.quality.*measure).count(), (b.quality.*measure).count());
    EXPECT_EQ((a.quality.*measure).mean(), (b.quality.*measure).mean());
    EXPECT_EQ((a.quality.*measure).percentile(99), (b.quality.*measure).percentile(99));
  }
}

TEST(Mesh_check, Is_known_by_elements_and_labels_wherever_points_are) {
  Mesh m = moved_cubes({9, 8, 7}, [](double x, double y, double z) { return Point(x + 0.1 * z, y, z); });
  const tubular::Mesh_check check(m), on_one_thread(m, 1);
  EXPECT_FALSE(tubular::Mesh_check().is_of(m));
  EXPECT_FALSE(tubular::Mesh_check().is_of(Mesh()));
  EXPECT_EQ(tubular::Mesh_check().validity().cells, 0u);
  EXPECT_EQ(check.validity().cells, m.hexahedra.size());
  EXPECT_EQ(check.validity().defects(), tubular::validity_report(m).defects());
  EXPECT_TRUE(on_one_thread.is_of(m));
  Mesh moved = m;
  for (Point& p : moved.points)
    p = Point(2 * p.x() + 1, p.y() * p.y(), p.z());
  EXPECT_TRUE(check.is_of(moved));
  EXPECT_TRUE(check.is_of(moved, 1));

  Mesh other = m;
  other.hexahedra.label[17] = 5;
  EXPECT_FALSE(check.is_of(other));
  other = m;
  std::swap(other.hexahedra.vertices[400], other.hexahedra.vertices[401]);
  EXPECT_FALSE(check.is_of(other));
  other = m;
  other.points.push_back(Point(0, 0, 0));
  EXPECT_FALSE(check.is_of(other));
  other = m;
  other.quads.push_back({0, 1, 11, 10}, 3);
  EXPECT_FALSE(check.is_of(other));
}

TEST(Mesh_check, Makes_no_difference_to_reports) {
  const Mesh m = moved_cubes({9, 8, 7}, [](double x, double y, double z) { return Point(x + 0.1 * z, y, z); });
  const tubular::Mesh_check check(m);
  Mesh moved = m; // some cells are turned over, which the check has not seen
  for (std::size_t i = 0; i < moved.points.size(); i += 5)
    moved.points[i] = Point(-moved.points[i].x(), 3 * moved.points[i].y(), moved.points[i].z());
  Mesh changed = moved; // it is of another mesh
  changed.hexahedra.vertices.pop_back();
  changed.hexahedra.label.pop_back();
  EXPECT_GT(tubular::validity_report(moved).inverted_cells, 0u);
  for (const Mesh* mesh : std::vector<const Mesh*>{&m, &moved, &changed})
    for (int threads : {0, 1}) {
      const auto np = tubular::parameters::number_of_threads(threads);
      expect_same(tubular::mesh_report(*mesh, np.mesh_check(check)), tubular::mesh_report(*mesh, np));
    }
}

TEST(Quality_report, Finite_volumes_without_extent_are_infinitely_bad) {
  const Mesh flat = moved_cubes({1, 1, 1}, [](double x, double y, double) { return Point(x, y, 0); });
  EXPECT_TRUE(std::isinf(tubular::quality_report(flat).aspect.max()));
  const Mesh point = moved_cubes({2, 1, 1}, [](double, double, double) { return Point(1, 2, 3); });
  EXPECT_TRUE(std::isinf(tubular::quality_report(point).aspect.max()));
  EXPECT_FALSE(std::isnan(tubular::quality_report(point).skewness.mean()));
}

TEST(Quality_report, Efficiency_of_a_unit_mesh) {
  Mesh m;
  m.points.assign(regular.begin(), regular.end());
  m.tetrahedra.push_back({0, 1, 2, 3}, 1);
  const double unit = 1. / 8; // edges are √8 long
  m.point_arrays.push_back({"metric", 6, {}});
  for (int i = 0; i < 4; ++i)
    m.point_arrays[0].values.insert(m.point_arrays[0].values.end(), {unit, 0, 0, unit, 0, unit});
  const auto r = tubular::quality_report(m);
  EXPECT_NEAR(r.Q_tau.mean(), 1, eps);
  EXPECT_NEAR(r.efficiency, 1, eps);
  for (double& v : m.point_arrays[0].values)
    v *= 4; // edges of length 2: exp(1/2 - 1)
  EXPECT_NEAR(tubular::quality_report(m).efficiency, std::exp(-0.5), eps);
}

// Cells of different shapes in a row: the values are theirs, in their order.
// Facets on the boundary, between cells and of no cell make no difference to the measures of cells.
TEST(Mesh_report, Tells_what_both_reports_tell) {
  Mesh sound = mixed_cells(), defective;
  sound.prisms.vertices[0] = {1, 5, 8, 2, 6, 9};
  sound.quads.push_back({4, 5, 6, 7}, 2); // between the hexahedron and the pyramid
  defective = sound;
  defective.triangles.push_back({0, 1, 8}, 1);
  defective.quads.vertices.erase(defective.quads.vertices.begin());
  defective.quads.label.erase(defective.quads.label.begin());
  defective.points.push_back(Point(9, 9, 9));
  for (const Mesh* m : {&sound, &defective})
    for (int threads : {1, 3}) {
      const auto np = tubular::parameters::number_of_threads(threads);
      const tubular::Mesh_report both = tubular::mesh_report(*m, np);
      EXPECT_EQ(both.validity.is_valid(), m == &sound);
      EXPECT_EQ(both.validity.defects(), tubular::validity_report(*m, np).defects());
      EXPECT_EQ(both.validity.boundary_euler, tubular::validity_report(*m, np).boundary_euler);
      const tubular::Quality_report quality = tubular::quality_report(*m, np);
      for (auto measure :
           {&tubular::Quality_report::gamma_T, &tubular::Quality_report::eta_q, &tubular::Quality_report::zeta_H,
            &tubular::Quality_report::pyramid_jacobian, &tubular::Quality_report::aspect,
            &tubular::Quality_report::non_orthogonality, &tubular::Quality_report::skewness}) {
        EXPECT_GT((both.quality.*measure).count(), 0u);
        EXPECT_EQ((both.quality.*measure).count(), (quality.*measure).count());
        EXPECT_EQ((both.quality.*measure).mean(), (quality.*measure).mean());
        EXPECT_EQ((both.quality.*measure).max(), (quality.*measure).max());
      }
    }
}

TEST(Element_quality, Is_in_the_order_of_the_elements) {
  const Mesh m = moved_cubes({4, 1, 1}, [](double x, double y, double z) { return Point(x + z * x / 4, y, z); });
  const std::vector<double> values = tubular::element_quality(m, "scaled_jacobian");
  ASSERT_EQ(values.size(), 4u);
  for (std::size_t i = 0; i + 1 < values.size(); ++i)
    EXPECT_GT(values[i], values[i + 1]); // sheared more and more
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::array<Point, 8> p;
    for (std::size_t k = 0; k < 8; ++k)
      p[k] = m.points[m.hexahedra.vertices[i][k]];
    EXPECT_EQ(values[i], tubular::hexahedron_jacobian(p));
  }
}

TEST(Element_quality, Has_the_spread_that_the_report_has) {
  const Mesh mixed = mixed_cells();
  const tubular::Quality_report r = tubular::quality_report(mixed);
  std::size_t measured = 0;
  const auto compare = [&](const char* name, const tubular::Measure_statistics& expected) {
    const tubular::Measure_statistics found(tubular::element_quality(mixed, name));
    EXPECT_EQ(found.count(), expected.count()) << name;
    EXPECT_EQ(found.min(), expected.min()) << name;
    EXPECT_EQ(found.mean(), expected.mean()) << name;
    EXPECT_EQ(found.max(), expected.max()) << name;
    const std::vector<std::string> names = tubular::element_measures(mixed);
    EXPECT_EQ(std::count(names.begin(), names.end(), name) == 1, expected.count() > 0) << name;
    measured += expected.count() > 0;
  };
  compare("gamma_T", r.gamma_T);
  compare("gamma_tau", r.gamma_tau);
  compare("eta_q", r.eta_q);
  compare("zeta_H", r.zeta_H);
  compare("scaled_jacobian", r.scaled_jacobian);
  compare("prism_jacobian", r.prism_jacobian);
  compare("pyramid_jacobian", r.pyramid_jacobian);
  compare("Q_tau", r.Q_tau);
  compare("aspect", r.aspect);
  compare("non_orthogonality", r.non_orthogonality);
  compare("skewness", r.skewness);
  EXPECT_EQ(measured, tubular::element_measures(mixed).size());
  EXPECT_TRUE(tubular::element_measures(Mesh()).empty());
}

TEST(Element_quality, Measures_that_are_none_are_refused) {
  EXPECT_THROW(tubular::element_quality(Mesh(), "beauty"), tubular::Parameter_error);
}

} // namespace

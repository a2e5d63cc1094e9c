// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangles in the plane by a metric, in domains and metrics of which the right answer is known: the number of
// triangles is the metric's area over that of the unit triangle, and all edges have length one.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Tubular_meshing/Quality/shape_measures.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_in_metric.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point;
typedef Kernel::Point_3 Point_3;
typedef tubular::Metric_tensor_2 Metric;
typedef std::vector<Point> Polygon;
typedef std::vector<Polygon> Polygons;
typedef std::function<Metric(const Point&)> Field;
typedef std::function<Point_3(const Point&)> Embedding;
typedef tubular::Plane_triangulation<Point> Mesh;

const double pi = std::acos(-1.);

// ---- boundaries: curves cut into edges of length one

Point between(const Point& p, const Point& q, double t) {
  return {p.x() + t * (q.x() - p.x()), p.y() + t * (q.y() - p.y())};
}

// The curve from t = 0 on, without its end, in edges of equal length in the metric, close to one.
Polygon unit_edges(const std::function<Point(double)>& curve, const Field& field) {
  const int fine = 20000;
  std::vector<double> length(fine + 1, 0);
  for (int i = 0; i < fine; ++i) {
    const Point p = curve(double(i) / fine), q = curve(double(i + 1) / fine);
    length[i + 1] = length[i] + field(between(p, q, 0.5)).length(q.x() - p.x(), q.y() - p.y());
  }
  const int n = (std::max)(1, int(std::lround(length[fine])));
  Polygon result;
  int j = 0;
  for (int k = 0; k < n; ++k) {
    const double wanted = length[fine] * k / n;
    while (length[j + 1] < wanted)
      ++j;
    result.push_back(curve(k == 0 ? 0 : (j + (wanted - length[j]) / (length[j + 1] - length[j])) / fine));
  }
  return result;
}

Polygon circle(double radius, const Field& field) {
  return unit_edges([=](double t) { return Point(radius * std::cos(2 * pi * t), radius * std::sin(2 * pi * t)); },
                    field);
}

Polygon unit_square(const Field& field) {
  const Point corner[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Polygon result;
  for (int i = 0; i < 4; ++i) {
    const Polygon side = unit_edges([&](double t) { return between(corner[i], corner[(i + 1) % 4], t); }, field);
    result.insert(result.end(), side.begin(), side.end());
  }
  return result;
}

Field uniform(double h) {
  return [h](const Point&) { return Metric::isotropic(h); };
}

// ---- what is measured, by other formulas than the mesher's

double edge_length(const Field& field, const Point& p, const Point& q) { // (10) by the midpoint rule on eight pieces
  double sum = 0;
  for (int k = 0; k < 8; ++k)
    sum += field(between(p, q, (k + 0.5) / 8)).length(q.x() - p.x(), q.y() - p.y()) / 8;
  return sum;
}

// (12) of a triangle in the plane, stretched so that the metric becomes the identity (by its Cholesky factor).
double gamma_in_metric(const Metric& m, const Point& p, const Point& q, const Point& r) {
  const double a = std::sqrt(m.xx), b = m.xy / a, c = std::sqrt(m.yy - b * b);
  const auto stretched = [&](const Point& x) { return Point_3(a * x.x() + b * x.y(), c * x.y(), 0); };
  return tubular::triangle_gamma(stretched(p), stretched(q), stretched(r));
}

struct Report {
  double number_ratio = 0; // of triangles to what the metric's area asks for
  double mean_gamma = 0, min_gamma = 1, tau = 0;
  long euler = 0;
};

typedef std::pair<std::size_t, std::size_t> Edge;

Edge sorted(std::size_t a, std::size_t b) {
  return {(std::min)(a, b), (std::max)(a, b)};
}

std::map<Edge, int> edges_of(const Mesh& mesh) {
  std::map<Edge, int> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      ++edges[sorted(t[i], t[(i + 1) % 3])];
  return edges;
}

// Triangles are positive and cover the domain once, and its boundary is that of the polygons, edge for edge.
void expect_valid(const Mesh& mesh, const Polygons& polygons) {
  double area = 0, polygon_area = 0;
  for (const auto& t : mesh.triangles) {
    const Point &p = mesh.points[t[0]], &q = mesh.points[t[1]], &r = mesh.points[t[2]];
    EXPECT_EQ(CGAL::orientation(p, q, r), CGAL::LEFT_TURN);
    area += CGAL::area(p, q, r);
  }
  std::size_t first = 0, boundary_edges = 0;
  const std::map<Edge, int> edges = edges_of(mesh);
  for (const Polygon& polygon : polygons) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t j = (i + 1) % polygon.size();
      EXPECT_EQ(mesh.points[first + i], polygon[i]);
      const auto edge = edges.find(sorted(first + i, first + j));
      ASSERT_TRUE(edge != edges.end()) << "boundary edge " << i << " is missing";
      EXPECT_EQ(edge->second, 1);
      twice += polygon[i].x() * polygon[j].y() - polygon[j].x() * polygon[i].y();
    }
    polygon_area += (first == 0 ? 0.5 : -0.5) * std::abs(twice);
    first += polygon.size();
  }
  for (const auto& edge : edges) {
    EXPECT_LE(edge.second, 2);
    boundary_edges += edge.second == 1;
  }
  EXPECT_EQ(boundary_edges, first);
  EXPECT_NEAR(area, polygon_area, 1e-9 * polygon_area);
  std::vector<bool> used(mesh.points.size(), false);
  for (const auto& t : mesh.triangles)
    for (std::size_t v : t)
      used[v] = true;
  EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
  EXPECT_EQ(long(mesh.points.size()) - long(edges.size()) + long(mesh.triangles.size()), 2 - long(polygons.size()));
}

Report report(const Mesh& mesh, const Field& field, const Embedding& embedding = nullptr) {
  Report r;
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Point &p = mesh.points[t[0]], &q = mesh.points[t[1]], &s = mesh.points[t[2]];
    const Metric mean = 1. / 3 * (field(p) + field(q) + field(s));
    const double gamma =
        embedding ? tubular::triangle_gamma(embedding(p), embedding(q), embedding(s)) : gamma_in_metric(mean, p, q, s);
    r.mean_gamma += gamma / double(mesh.triangles.size());
    r.min_gamma = (std::min)(r.min_gamma, gamma);
    area += CGAL::area(p, q, s) * std::sqrt(field(CGAL::centroid(p, q, s)).determinant());
  }
  r.number_ratio = double(mesh.triangles.size()) / (area / (std::sqrt(3.) / 4));
  const auto edges = edges_of(mesh);
  for (const auto& edge : edges) { // (17)
    const double l = edge_length(field, mesh.points[edge.first.first], mesh.points[edge.first.second]);
    r.tau += ((std::min)(l, 1 / l) - 1) / double(edges.size());
  }
  r.tau = std::exp(r.tau);
  return r;
}

Report checked_mesh(const Polygons& polygons, const Field& field) {
  const Mesh mesh = tubular::triangulate_in_metric(polygons, field);
  expect_valid(mesh, polygons);
  return report(mesh, field);
}

void expect_unit(const Report& r, double min_gamma = 0.65) {
  EXPECT_NEAR(r.number_ratio, 1, 0.1);
  EXPECT_GE(r.mean_gamma, 0.97);
  EXPECT_GE(r.min_gamma, min_gamma);
  EXPECT_GE(r.tau, 0.92);
}

// ---- the tensor

TEST(Metric_tensor_2, Sizes_directions_and_right_angles) {
  const Metric m = Metric::from_sizes(5, 0.1, 0.7);
  EXPECT_NEAR(m.sizes()[0], 0.1, 1e-12);
  EXPECT_NEAR(m.sizes()[1], 5, 1e-9);
  EXPECT_NEAR(m.angle_of_larger_size(), 0.7, 1e-12);
  EXPECT_NEAR(m.length(5 * std::cos(0.7), 5 * std::sin(0.7)), 1, 1e-12);
  const auto turned = m.quarter_turn(3, 4);
  EXPECT_NEAR(m.dot(3, 4, turned[0], turned[1]), 0, 1e-9 * m.squared_length(3, 4));
  EXPECT_NEAR(m.length(turned[0], turned[1]), m.length(3, 4), 1e-9 * m.length(3, 4));
  EXPECT_GT(3 * turned[1] - 4 * turned[0], 0);
  EXPECT_NEAR(m.normalized().determinant(), 1, 1e-9);
}

TEST(Metric_tensor_2, Definiteness) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(Metric(2, 1, 1).is_positive_definite());
  EXPECT_FALSE(Metric(1, 1, 1).is_positive_definite());
  EXPECT_FALSE(Metric(-1, 0, -1).is_positive_definite());
  EXPECT_FALSE(Metric(nan, 0, 1).is_positive_definite());
  EXPECT_FALSE(Metric(1, nan, 1).is_positive_definite());
  EXPECT_FALSE(Metric::isotropic(0).is_positive_definite());
}

TEST(Metric_tensor_2, Interpolation_is_geometric_in_sizes_and_keeps_ends) {
  const Metric a = Metric::from_sizes(8, 1, 0.3), b = Metric::from_sizes(2, 1. / 16, 0.3);
  const Metric middle = Metric::interpolate(a, b, 0.5);
  EXPECT_NEAR(middle.sizes()[0], 0.25, 1e-10);
  EXPECT_NEAR(middle.sizes()[1], 4, 1e-10);
  EXPECT_NEAR(middle.angle_of_larger_size(), 0.3, 1e-12);
  const Metric c = Metric::from_sizes(1, 30, 1.2);
  EXPECT_NEAR(Metric::interpolate(a, c, 0).xy, a.xy, 1e-12);
  EXPECT_NEAR(Metric::interpolate(a, c, 1).xy, c.xy, 1e-12);
  EXPECT_TRUE(Metric::interpolate(a, c, 0.4).is_positive_definite());
}

TEST(Metric_tensor_2, Induced_by_an_embedding) {
  const Metric m = Metric::induced(Kernel::Vector_3(2, 0, 0), Kernel::Vector_3(1, 1, 1), 0.5);
  EXPECT_DOUBLE_EQ(m.xx, 16);
  EXPECT_DOUBLE_EQ(m.xy, 8);
  EXPECT_DOUBLE_EQ(m.yy, 12);
}

// ---- isotropic

TEST(Plane_mesher, Uniform_square_disk_and_ring) {
  for (double h : {0.1, 0.02}) {
    const Field field = uniform(h);
    expect_unit(checked_mesh({unit_square(field)}, field));
    expect_unit(checked_mesh({circle(1, field)}, field));
    expect_unit(checked_mesh({circle(1, field), circle(0.3, field)}, field));
  }
}

TEST(Plane_mesher, Size_field_of_one_to_a_hundred) {
  const Field field = [](const Point& p) { return Metric::isotropic(0.002 * std::pow(100, p.x())); };
  expect_unit(checked_mesh({unit_square(field)}, field));
}

TEST(Plane_mesher, Sizes_that_the_boundary_knows_nothing_of) {
  const Field field = [](const Point& p) {
    return Metric::isotropic((std::min)(0.1, 0.001 + 0.2 * std::hypot(p.x() - 0.5, p.y() - 0.5)));
  };
  expect_unit(checked_mesh({unit_square(field)}, field));
}

TEST(Plane_mesher, Same_mesh_in_any_unit_and_place) {
  const Field field = uniform(0.05);
  const Polygon square = unit_square(field);
  const std::size_t n = tubular::triangulate_in_metric(Polygons{square}, field).triangles.size();
  for (double scale : {std::ldexp(1., -30), std::ldexp(1., 30)}) { // powers of two: exactly the same
    Polygon scaled;
    for (const Point& p : square)
      scaled.emplace_back(scale * p.x(), scale * p.y());
    EXPECT_EQ(tubular::triangulate_in_metric(Polygons{scaled}, uniform(0.05 * scale)).triangles.size(), n);
  }
  Polygon moved;
  for (const Point& p : square)
    moved.emplace_back(p.x() + 1e6, p.y() - 1e6);
  expect_unit(checked_mesh({moved}, field));
}

// ---- anisotropic

TEST(Plane_mesher, Constant_anisotropic_metric) {
  const Field field = [](const Point&) { return Metric::from_sizes(0.2, 0.002, pi / 6); };
  expect_unit(checked_mesh({circle(1, field)}, field), 0.4);       // the tips of the disk are sharp in the metric
  const Report square = checked_mesh({unit_square(field)}, field); // its corners are of 1.3 degrees in the metric
  EXPECT_NEAR(square.number_ratio, 1, 0.1);
  EXPECT_GE(square.tau, 0.92);
  EXPECT_GE(square.mean_gamma, 0.95);
}

TEST(Plane_mesher, Rotating_metric) {
  const Field field = [](const Point& p) {
    return Metric::from_sizes(0.1, 0.01, std::atan2(p.y() + 1.5, p.x() + 1.5) + pi / 2);
  };
  expect_unit(checked_mesh({circle(1, field)}, field), 0.5);
}

TEST(Plane_mesher, Shock_metric) {
  const Field field = [](const Point& p) {
    const double d = std::abs(p.x() + 0.3 * p.y() - 0.6) / std::hypot(1, 0.3);
    return Metric::from_sizes((std::min)(0.05, 0.0005 + 0.25 * d), 0.05, std::atan(0.3));
  };
  expect_unit(checked_mesh({unit_square(field)}, field));
}

// ---- on a surface

TEST(Plane_mesher, Conformal_ring_of_a_cylinder_eight_radii_long) {
  for (int around : {12, 24, 60}) {
    const double h = 2 * pi / around;
    const Field field = [h](const Point& p) { return Metric::isotropic(h * std::hypot(p.x(), p.y())); };
    const auto cylinder = [](const Point& p) {
      const double r = std::hypot(p.x(), p.y());
      return Point_3(p.x() / r, p.y() / r, -std::log(r));
    };
    const Polygons ring = {circle(1, field), circle(std::exp(-8.), field)};
    const Mesh mesh = tubular::triangulate_in_metric(ring, field, tubular::parameters::embedding(cylinder));
    expect_valid(mesh, ring);
    expect_unit(report(mesh, field, cylinder));
  }
}

TEST(Plane_mesher, Stretched_parameterization_of_a_cylinder) {
  const double h = 0.1; // angle and height over a hundred as coordinates
  const Field field = [h](const Point&) { return Metric(1 / (h * h), 0, 1e4 / (h * h)); };
  const auto cylinder = [](const Point& p) { return Point_3(std::cos(p.x()), std::sin(p.x()), 100 * p.y()); };
  Polygon rectangle;
  const Point corner[4] = {{0, 0}, {6, 0}, {6, 0.05}, {0, 0.05}};
  for (int i = 0; i < 4; ++i) {
    const Polygon side = unit_edges([&](double t) { return between(corner[i], corner[(i + 1) % 4], t); }, field);
    rectangle.insert(rectangle.end(), side.begin(), side.end());
  }
  const Mesh mesh =
      tubular::triangulate_in_metric(Polygons{rectangle}, field, tubular::parameters::embedding(cylinder));
  expect_valid(mesh, {rectangle});
  expect_unit(report(mesh, field, cylinder));
}

// ---- boundaries that do not suit the metric

TEST(Plane_mesher, Boundary_finer_or_coarser_than_the_metric) {
  const Field field = uniform(0.05);
  const Report finer = checked_mesh({unit_square(uniform(0.005))}, field);
  EXPECT_GE(finer.min_gamma, 0.4);
  EXPECT_GE(finer.mean_gamma, 0.9);
  const Report coarser = checked_mesh({unit_square(uniform(0.2))}, field);
  EXPECT_GE(coarser.min_gamma, 0.2);
  EXPECT_GE(coarser.mean_gamma, 0.9);
  const Report hole = checked_mesh({circle(1, field), circle(0.02, uniform(0.005))}, field);
  EXPECT_GE(hole.min_gamma, 0.5);
  EXPECT_GE(hole.mean_gamma, 0.97);
}

TEST(Plane_mesher, Smallest_domains) {
  const Field unit = uniform(1);
  EXPECT_EQ(tubular::triangulate_in_metric(Polygons{{{0, 0}, {1, 0}, {0.5, 0.8}}}, unit).triangles.size(), 1u);
  EXPECT_EQ(tubular::triangulate_in_metric(Polygons{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, unit).triangles.size(), 2u);
  checked_mesh({{{0, 0}, {20, 0}, {20, 0.01}}}, unit);
  checked_mesh({{{0, 0}, {0, 9}, {9, 9}, {9, 0}}}, unit); // clockwise, edges nine times too long
  checked_mesh({{{0, 0}, {4, 0}, {8, 0}, {8, 1e-9}}}, unit);
}

TEST(Plane_mesher, Jagged_domains_in_wild_metrics_are_valid) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  for (int trial = 0; trial < 40; ++trial) {
    Polygon star, hole;
    const int n = 5 + trial;
    for (int i = 0; i < n; ++i) {
      const double a = 2 * pi * i / n, r = 0.3 + any(random), s = 0.25 * any(random) + 0.01;
      star.emplace_back(r * std::cos(a), r * std::sin(a));
      hole.emplace_back(s * std::cos(a), s * std::sin(a));
    }
    const double k = std::pow(10, 4 * any(random) - 2);
    const Field field = [k](const Point& p) { // neither smooth nor of bounded growth
      const double turn = 20 * std::sin(k * p.x()) + 7 * p.y();
      const bool coarse = std::sin(9 * p.x() + k * p.y()) > 0;
      return Metric::from_sizes(coarse ? 0.5 : 0.05, coarse ? 0.02 : 0.05, turn);
    };
    checked_mesh({star, hole}, field);
  }
}

TEST(Plane_mesher, Every_thread_and_run_gives_the_same) {
  const Field field = [](const Point& p) { return Metric::from_sizes(0.05, 0.02 + 0.02 * p.x(), p.y()); };
  const Polygons square = {unit_square(field)};
  const Mesh a = tubular::triangulate_in_metric(square, field), b = tubular::triangulate_in_metric(square, field);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(Plane_mesher, Points_of_other_kernels) {
  typedef CGAL::Simple_cartesian<double>::Point_2 Other;
  const std::vector<std::vector<Other>> square = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const auto mesh = tubular::triangulate_in_metric(square, [](const Other&) { return Metric::isotropic(1); });
  EXPECT_EQ(mesh.points, square.front());
}

TEST(Plane_mesher, Optimization_pays) {
  const Field field = [](const Point& p) { return Metric::isotropic(0.03 + 0.05 * p.x()); };
  const Polygons square = {unit_square(field)};
  const Mesh raw = tubular::triangulate_in_metric(square, field, tubular::parameters::optimization_passes(0));
  const Mesh smooth = tubular::triangulate_in_metric(square, field);
  expect_valid(raw, square);
  EXPECT_GT(report(smooth, field).mean_gamma, report(raw, field).mean_gamma);
  EXPECT_GT(report(smooth, field).min_gamma, report(raw, field).min_gamma);
}

TEST(Plane_mesher, Hundred_thousand_triangles_in_time) {
  const Field field = uniform(0.0048);
  const Polygons square = {unit_square(field)};
  const auto start = std::chrono::steady_clock::now();
  const Mesh mesh = tubular::triangulate_in_metric(square, field);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  EXPECT_GT(mesh.triangles.size(), 95000u);
  RecordProperty("seconds", std::to_string(time.count()));
#ifdef NDEBUG
  EXPECT_LT(time.count(), 6.); // of which an idle machine needs a tenth
#endif
}

// ---- bad input

template <class Exception> std::string sentence(const Polygons& polygons, const Field& field) {
  try {
    tubular::triangulate_in_metric(polygons, field);
  } catch (const Exception& e) {
    return e.what();
  }
  return "";
}

TEST(Plane_mesher_input, Bad_polygons_are_refused) {
  const Field unit = uniform(1);
  const Polygon square = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  const auto says = [&](const Polygons& polygons, const std::string& words) {
    const std::string what = sentence<tubular::Input_error>(polygons, unit);
    EXPECT_NE(what.find(words), std::string::npos) << what;
  };
  says({}, "there is none");
  says({{{0, 0}, {1, 0}}}, "has 2");
  says({{{0, 0}, {1, 0}, {2, 0}}}, "line");
  says({{{0, 0}, {1, 0}, {std::nan(""), 1}}}, "vertex 2 of the outer polygon");
  says({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}, "crosses another edge");
  says({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}, "passes through another vertex");
  says({{{0, 0}, {1, 0}, {1, 1}, {0, 0}}}, "same point");
  says({square, {{7, 7}, {12, 7}, {7, 8}}}, "crosses another edge");
  says({square, {{20, 20}, {22, 20}, {20, 22}}}, "is outside");
  says({square, {{1, 1}, {8, 1}, {1, 8}}, {{2, 2}, {3, 2}, {2, 3}}}, "inside another one");
  says({{{2, 2}, {3, 2}, {2, 3}}, square}, "must come first");
  says({square, {{1, 1}, {2, 1}, {1, 2}}, {{1, 1}, {0.5, 1}, {1, 0.5}}}, "same point");
}

TEST(Plane_mesher_input, Bad_metrics_are_refused) {
  const Polygons square = {{{0, 0}, {9, 0}, {9, 9}, {0, 9}}};
  const auto says = [&](const Field& field, const std::string& words) {
    const std::string what = sentence<tubular::Parameter_error>(square, field);
    EXPECT_NE(what.find(words), std::string::npos) << what;
  };
  says([](const Point&) { return Metric(1, 2, 1); }, "not symmetric positive definite");
  says([](const Point&) { return Metric(std::nan(""), 0, 1); }, "not symmetric positive definite");
  says(uniform(0), "not symmetric positive definite");
  says([](const Point& p) { return Metric::isotropic(p.x() > 3 && p.x() < 6 ? std::nan("") : 1); }, "(");
  says(uniform(1e-7), "more than fit into memory");
  EXPECT_THROW(tubular::triangulate_in_metric(square, uniform(1), tubular::parameters::optimization_passes(-1)),
               tubular::Parameter_error);
}

} // namespace

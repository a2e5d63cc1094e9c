// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The anisotropic metric field: on tubes against the equations, elsewhere for what must hold everywhere.

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
using namespace test_surfaces;
typedef tubular::Centerline_metric_field Field;
typedef tubular::Metric_tensor_3 Metric;
typedef tubular::Tubular_model Model;

const double pi = 3.14159265358979323846;

Model model_of(const tubular::Tubular_skeleton& skeleton, double points = 40, double noise = 0) {
  Mesh mesh;
  tubular::generate_tubular_surface(skeleton, mesh, tubular::parameters::points_per_circumference(points).noise(noise));
  return tubular::make_tubular_model(mesh, tubular::centerlines_of(skeleton));
}

template <class NamedParameters> Field field_of(const Model& m, const NamedParameters& np) {
  return Field(m.surface, m.patch, m.centerlines, np);
}
Field field_of(const Model& m) {
  return field_of(m, CGAL::parameters::default_values());
}

const Model& straight() {
  static const Model model = model_of(tubular::straight_tube(12));
  return model;
}
const Model& bent() { // of radius 1, bent with a radius of 5
  static const Model model = model_of(tubular::curved_tube());
  return model;
}
const Model& bifurcation() {
  static const Model model = model_of(tubular::y_bifurcation(), 28, 0.02);
  return model;
}

// The bound that (8) puts on the tangential size, by bisection.
double bound_of_8(double rho, double h_n, double beta) {
  double low = h_n, high = 1e6;
  for (int i = 0; i < 200; ++i) {
    const double h = std::sqrt(low * high);
    const double left = beta * beta / (h * h), right = 1 / (h * h) + (h * h / (h_n * h_n) - 1) / (rho * rho);
    (left > right ? low : high) = h;
  }
  return low;
}

// Half of the difference of logarithms: of sizes, in Frobenius' norm.
double jump(const Metric& a, const Metric& b) {
  const Metric d = a.log() - b.log();
  return std::sqrt(d.xx * d.xx + d.yy * d.yy + d.zz * d.zz + 2 * (d.xy * d.xy + d.xz * d.xz + d.yz * d.yz)) / 2;
}

TEST(Metric_field, Of_a_straight_tube_follows_the_equations) {
  const Field metric = field_of(straight());
  for (double d : {0., 0.01, 0.05, 0.1, 0.2, 0.29})
    for (double angle : {0.3, 1.9, 4.}) {
      const Vector n(std::cos(angle), std::sin(angle), 0), b(-n.y(), n.x(), 0), t(0, 0, 1);
      const Point on_wall = CGAL::ORIGIN + n + 6 * t;
      const Point p = on_wall - (d + metric.distance_to_wall(on_wall)) * n; // its triangles lie within the tube
      const double depth = metric.distance_to_wall(p);
      const Metric m = metric(p);
      const double h_n = 0.3 / 20 + 0.3 * depth;          // (4)
      EXPECT_NEAR(m.size_along(n), h_n, 0.03 * h_n) << d; // directions are interpolated
      const double by_points = 2 * pi / 20 * (1 - depth); // (5), (6)
      const double h_b = (std::min)(by_points, bound_of_8(1, h_n, 1.5));
      EXPECT_NEAR(m.size_along(b), h_b, 0.05 * h_b) << d;
      EXPECT_GT(m.size_along(t), 2 * h_b) << d; // nothing but its anisotropy limits it
      EXPECT_LE(m.anisotropy(), 100 * (1 + 1e-6));
      const auto axes = m.eigen_system().directions;
      EXPECT_GT(std::abs(axes[0].x * n.x() + axes[0].y * n.y()), std::cos(0.03));
      EXPECT_GT(std::abs(axes[2].z), std::cos(0.03));
    }
}

TEST(Metric_field, Is_isotropic_in_the_core) {
  const Field metric = field_of(straight());
  for (double z : {2., 6.3, 9.})
    for (double size : metric(Point(0, 0, z)).sizes())
      EXPECT_NEAR(size, 2 * pi / 20, 0.06 * 2 * pi / 20);
  const Field finer = field_of(straight(), tubular::parameters::points_per_circumference(40));
  for (double size : finer(Point(0, 0, 6)).sizes())
    EXPECT_NEAR(size, 2 * pi / 40, 0.06 * 2 * pi / 40);
}

TEST(Metric_field, Listens_to_its_options) {
  const Point wall(1, 0, 6), inner(0.8, 0, 6);
  const Vector n(1, 0, 0), b(0, 1, 0), t(0, 0, 1);
  using namespace tubular::parameters;
  const auto at = [&](const auto& np, const Point& p) { return field_of(straight(), np)(p); };
  EXPECT_NEAR(at(boundary_layer_thickness(0.2), wall).size_along(n), 0.01, 0.001);
  EXPECT_NEAR(at(first_height(0.002), wall).size_along(n), 0.002, 0.0012); // the wall is a polyhedron
  EXPECT_NEAR(at(growth(1.1), inner).size_along(n), 0.015 + 0.1 * 0.2, 0.001);
  EXPECT_NEAR(at(growth(1.), inner).size_along(n), 0.015, 0.001);
  EXPECT_NEAR(at(curvature_points(80.), inner).size_along(b), 2 * pi / 80 * 0.8, 0.002);
  EXPECT_NEAR(at(smoothing_ratio(1.1), wall).size_along(b), bound_of_8(1, 0.015, 1.1), 0.004);
  EXPECT_NEAR(at(smoothing_ratio(1.), wall).anisotropy(), 1, 1e-3); // no anisotropy is possible
  EXPECT_LE(at(max_anisotropy(5.), wall).anisotropy(), 5 * (1 + 1e-5));
  EXPECT_NEAR(at(max_anisotropy(1.), wall).anisotropy(), 1, 1e-5);
  EXPECT_LE(at(max_size(0.25), inner).sizes()[2], 0.25 * (1 + 1e-5));
  EXPECT_GE(at(min_size(0.1), wall).sizes()[0], 0.1 * (1 - 1e-5));
}

TEST(Metric_field, Of_a_bend_follows_the_curvature_along_it) {
  const Field metric = field_of(bent());
  const double a = 0.7; // away from the ends
  const Vector out(std::cos(a), 0, std::sin(a)), along(-std::sin(a), 0, std::cos(a));
  for (double side : {-1., 1.}) {
    const Point p = CGAL::ORIGIN + (5 + 0.97 * side) * out;
    const double depth = metric.distance_to_wall(p), h_n = 0.015 + 0.3 * depth, rho = 5 + side;
    const double by_points = 2 * pi * rho / 20 * (1 - side * depth / rho);
    const double h_t = (std::min)(by_points, bound_of_8(rho, h_n, 1.5));
    EXPECT_NEAR(metric(p).size_along(along), h_t, 0.06 * h_t) << side;
  }
}

TEST(Metric_field, Is_positive_definite_and_bounded_everywhere) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  for (const Model* model : {&straight(), &bent(), &bifurcation()}) {
    const Field metric = field_of(*model, tubular::parameters::max_anisotropy(30.));
    const auto& points = model->centerlines.points();
    for (int i = 0; i < 20000; ++i) {
      const Point p = points[random() % points.size()] + 1.7 * Vector(u(random), u(random), u(random));
      const Metric m = metric(p);
      ASSERT_TRUE(m.is_valid()) << p;
      ASSERT_LE(m.anisotropy(), 30 * (1 + 1e-4)) << p;
    }
    const double huge = 1e6, nan = std::nan("");
    for (const Point& p : {Point(huge, 0, -huge), Point(nan, 0, 0), Point(nan, nan, nan)})
      EXPECT_TRUE(metric(p).is_valid() || std::isnan(p.x()));
  }
}

TEST(Metric_field, Is_continuous) {
  // in steps of a ten-thousandth of the radius sizes change by less than a hundredth: at the wall h_n, 0.015, grows by
  // 0.3 in the unit of length, which is 0.002; where leaves of the octree change by much, as at the bifurcation, 0.005
  std::mt19937 random(4);
  std::uniform_real_distribution<double> u(-1, 1);
  for (const Model* model : {&bent(), &bifurcation()}) {
    const Field metric = field_of(*model);
    const auto& points = model->centerlines.points();
    for (int i = 0; i < 100000; ++i) {
      const Point p = points[random() % points.size()] + 1.2 * Vector(u(random), u(random), u(random));
      const Vector step = 1e-4 / std::sqrt(3.) * Vector(u(random), u(random), u(random));
      ASSERT_LT(jump(metric(p), metric(p + step)), 0.01) << p;
    }
  }
}

TEST(Metric_field, Does_not_see_caps) {
  // along a line parallel to the axis, through the cap: the distance to the wall and all sizes stay the same
  const Field metric = field_of(straight());
  const Metric inside = metric(Point(0.9, 0, 6));
  for (double z : {11., 11.9, 11.99, 12.})
    for (const Vector& v : {Vector(1, 0, 0), Vector(0, 1, 0)})
      EXPECT_NEAR(metric(Point(0.9, 0, z)).size_along(v), inside.size_along(v), 0.05 * inside.size_along(v)) << z;
  EXPECT_NEAR(metric(Point(0.5, 0, 11.99)).size_along(Vector(1, 0, 0)), 0.165, 0.02);
}

TEST(Metric_field, Layers_a_sac_by_its_own_radius) {
  // a bulge on one side of a straight tube, of which the centerline knows nothing
  Mesh mesh;
  tubular::generate_tubular_surface(tubular::straight_tube(20), mesh);
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    const double bulge = 1 + 2 * std::exp(-(p.z() - 10) * (p.z() - 10) / 4) * (std::max)(0., p.x());
    mesh.point(v) = Point(p.x() * bulge, p.y() * bulge, p.z());
  }
  const Model model = tubular::make_tubular_model(mesh, tubular::centerlines_of(tubular::straight_tube(20)));
  const Field metric = field_of(model);
  const double ball = 1.8; // the largest that touches the bulge's end
  EXPECT_NEAR(metric.radius(Point(2.9, 0, 10)), ball, 0.15 * ball);
  EXPECT_GT(metric(Point(2.98, 0, 10)).size_along(Vector(1, 0, 0)), 0.85 * ball * 0.015);
  EXPECT_LT(metric(Point(-0.99, 0, 10)).size_along(Vector(1, 0, 0)), 0.03);
}

TEST(Metric_field, Does_not_depend_on_units) {
  for (double scale : {1e-3, 1e5}) {
    Model model;
    model.surface += transformed(bent().surface, Transformation(CGAL::SCALING, scale));
    for (auto f : model.surface.faces())
      model.patch[f] = bent().patch[f];
    std::vector<Point> points;
    std::vector<double> radii;
    std::vector<tubular::Centerline_graph::Polyline> branches;
    for (const Point& p : bent().centerlines.points())
      points.push_back(CGAL::ORIGIN + scale * (p - CGAL::ORIGIN));
    for (double r : bent().centerlines.radii())
      radii.push_back(scale * r);
    for (const auto& b : bent().centerlines.branches())
      branches.push_back(b.points);
    model.centerlines = tubular::Centerline_graph(points, radii, branches);
    const Field unit = field_of(bent()), scaled = field_of(model);
    for (double x : {4.02, 4.2, 4.6, 5.1, 5.9})
      EXPECT_LT(jump((scale * scale) * scaled(Point(scale * x, 0, scale * 1.1)), unit(Point(x, 0, 1.1))), 1e-3);
  }
}

TEST(Metric_field, Is_the_same_on_any_number_of_threads) {
  const Field one = field_of(bifurcation(), tubular::parameters::number_of_threads(1));
  const Field two = field_of(bifurcation(), tubular::parameters::number_of_threads(2));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-3, 3);
  for (int i = 0; i < 2000; ++i) {
    const Point p(u(random), u(random), 6 + 2 * u(random));
    ASSERT_EQ(one(p).components(), two(p).components());
  }
}

TEST(Metric_field, Refuses_senseless_options) {
  using namespace tubular::parameters;
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const auto refuses = [](const auto& np) { EXPECT_THROW(field_of(straight(), np), tubular::Parameter_error); };
  for (double bad : {0., -0.3, 1.5, nan, inf}) {
    refuses(boundary_layer_thickness(bad));
    refuses(first_height(bad));
  }
  for (double bad : {0.9, -1., nan, inf}) {
    refuses(growth(bad));
    refuses(smoothing_ratio(bad));
    refuses(max_anisotropy(bad));
    refuses(curvature_points(bad));
  }
  refuses(points_per_circumference(2.));
  refuses(min_size(2.).max_size(1.));
  refuses(min_size(-1.));
  refuses(smoothing_radius(-1.));
  Model no_wall;
  no_wall.surface += straight().surface;
  for (auto f : no_wall.surface.faces())
    no_wall.patch[f] = tubular::labels::inlet;
  EXPECT_THROW(Field(no_wall.surface, no_wall.patch, straight().centerlines), tubular::Input_error);
  EXPECT_THROW(Field(straight().surface, straight().patch, tubular::Centerline_graph()), tubular::Input_error);
}

class Metric_field_of_real_vessels : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Metric_field_of_real_vessels, Is_positive_definite_and_continuous) {
#ifndef TUBULAR_MESHING_SHARED_DATA
  GTEST_SKIP() << "the measurement data are not there";
#else
  const std::string folder = std::string(TUBULAR_MESHING_SHARED_DATA) + "/paper/";
  Mesh mesh;
  tubular::Centerline_polylines lines;
  tubular::IO::read_surface(folder + GetParam().first, mesh);
  tubular::IO::read_centerlines(folder + GetParam().second, lines);
  const Model model = tubular::make_tubular_model(mesh, lines);
  const Field metric = field_of(model);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 50000; ++i) {
    const std::size_t k = random() % model.centerlines.points().size();
    const double r = model.centerlines.radii()[k];
    const Point p = model.centerlines.points()[k] + 1.3 * r * Vector(u(random), u(random), u(random));
    const Metric m = metric(p);
    ASSERT_TRUE(m.is_valid()) << p;
    ASSERT_LE(m.anisotropy(), 100 * (1 + 1e-4)) << p;
    const Vector step = 1e-4 * metric.radius(p) / std::sqrt(3.) * Vector(u(random), u(random), u(random));
    ASSERT_LT(jump(m, metric(p + step)), 0.02) << p;
  }
  // at the wall the first layer has the height that was asked for
  std::size_t good = 0, all = 0;
  for (auto v : model.surface.vertices()) {
    const Point p = model.surface.point(v);
    const double h = metric(p).sizes()[0] / metric.radius(p);
    if (metric.distance_to_wall(p) > 0)
      continue; // within a cap
    ++all;
    good += h > 0.8 * 0.015 && h < 1.2 * 0.015;
  }
  EXPECT_GT(all, 1000u);
  EXPECT_GT(good, 0.98 * all);
#endif
}

INSTANTIATE_TEST_SUITE_P(Paper, Metric_field_of_real_vessels,
                         ::testing::Values(std::make_pair("aorta.stl", "centerlinesAORTA.vtk"),
                                           std::make_pair("carotid.stl", "centerlinesCAROTID.vtk")));

} // namespace

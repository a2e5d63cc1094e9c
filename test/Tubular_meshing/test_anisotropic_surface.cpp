// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces meshed anew by a metric: that triangles are good in it, as many as it asks for, and point where it does.

#include "surface_measures.h"
#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Metric_sizes.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Tangent_planes.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Triangle_piece_mesher.h>
#include <CGAL/Tubular_meshing/Patches/metric_on_surface.h>
#include <CGAL/Tubular_meshing/Patches/metric_surface_report.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace test_surfaces;
namespace tubular = CGAL::Tubular_meshing;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef tubular::Tubular_model Model;
typedef tubular::Remeshed_surface Remeshed;
typedef tubular::Metric_tensor_2 Metric_2;
typedef tubular::Metric_tensor_3 Metric_3;
typedef tubular::internal::Vector_3d V;

const double pi = 3.14159265358979323846;

// --- models and metrics ---

Model model_of(const tubular::Tubular_skeleton& skeleton, double points = 24) {
  Mesh mesh;
  tubular::generate_tubular_surface(skeleton, mesh, tubular::parameters::points_per_circumference(points).noise(0.));
  return tubular::make_tubular_model(mesh, tubular::centerlines_of(skeleton));
}

Model straight_tube(double points = 24) {
  return model_of(tubular::straight_tube(10, 1), points);
}

template <class Size> Remeshed remesh(Model&& model, const Size& size, int threads = 0) {
  const auto cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
  const auto maps = tubular::parameterize_patches(model.surface, cut);
  return tubular::remesh_patches(model.surface, cut, maps, size, tubular::parameters::number_of_threads(threads));
}

/* Of a tube along z: sizes across the wall, in a direction `turn` (by z, radians) off the circumference, and
 * perpendicular to both. */
template <class Across, class Turn>
auto tube_metric(const Across& across, double first, double second, const Turn& turn) {
  return [=](const Point& p) {
    const double r = std::max(std::hypot(p.x(), p.y()), 1e-9), a = turn(p.z());
    const V e(p.x() / r, p.y() / r, 0), t(-p.y() / r, p.x() / r, 0), z(0, 0, 1);
    const std::array<V, 3> axes = {e, std::cos(a) * t + std::sin(a) * z, std::cos(a) * z - std::sin(a) * t};
    return Metric_3::from_sizes({across(r), first, second}, axes);
  };
}

const auto straight = [](double) { return 0.; };
const auto as_around = [](double) { return 0.2; };
const auto thin_at_wall = [](double r) { return std::min(0.2, 0.02 + 0.3 * std::abs(1 - r)); };

// --- an independent look at a surface in its metric ---

std::array<Mesh::Vertex_index, 3> vertices_of(const Mesh& mesh, Mesh::Face_index f) {
  const auto h = mesh.halfedge(f);
  return {{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}};
}

/* Triangles of the wall, or of the caps, in the mean of their corners' metrics, restricted to their own planes. */
struct Judgement {
  std::size_t triangles = 0, edges = 0, unit_edges = 0;
  double wanted = 0; // the number of equilateral triangles of unit edges on the area
  double worst = 1, mean = 0;

  double share_of_unit_edges() const { return double(unit_edges) / double(edges); }
};

double logarithmic_mean(double a, double b) {
  return std::abs(a - b) < 1e-6 * a ? (a + b) / 2 : (a - b) / std::log(a / b);
}

Judgement judge(const Remeshed& r, bool wall) {
  Judgement result;
  for (auto f : r.surface.faces()) {
    if ((r.patch[f] == tubular::labels::wall) != wall)
      continue;
    const auto v = vertices_of(r.surface, f);
    const V p[3] = {V(r.surface.point(v[0])), V(r.surface.point(v[1])), V(r.surface.point(v[2]))};
    const V normal = cross(p[1] - p[0], p[2] - p[0]);
    const V a = normalized(p[1] - p[0]), b = normalized(cross(normal, a));
    Metric_2 m[3], mean(0, 0, 0);
    for (int i = 0; i < 3; ++i) {
      const Metric_3& at = r.metrics[v[i]];
      m[i] = wall ? tubular::metric_shadow(at, a, b) : tubular::metric_section(at, a, b);
      mean = mean + 1. / 3 * m[i];
    }
    double squares = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const double x = dot(p[j] - p[i], a), y = dot(p[j] - p[i], b);
      const double length = logarithmic_mean(m[i].length(x, y), m[j].length(x, y));
      squares += mean.squared_length(x, y);
      ++result.edges;
      result.unit_edges += length >= std::sqrt(0.5) && length <= std::sqrt(2.);
    }
    const double area = norm(normal) / 2 * std::sqrt(mean.determinant());
    const double gamma = 4 * std::sqrt(3.) * area / squares;
    ++result.triangles;
    result.wanted += area / (std::sqrt(3.) / 4);
    result.worst = std::min(result.worst, gamma);
    result.mean += gamma;
  }
  result.mean /= double(result.triangles);
  return result;
}

// What every surface mesh must be, whatever it is of.
void expect_good(const Mesh& old, const Remeshed& r) {
  EXPECT_TRUE(r.surface.is_valid());
  EXPECT_TRUE(CGAL::is_closed(r.surface));
  EXPECT_TRUE(CGAL::is_triangle_mesh(r.surface));
  EXPECT_FALSE(PMP::does_self_intersect(r.surface));
  EXPECT_EQ(euler(r.surface), euler(old));
  EXPECT_GT(PMP::volume(r.surface), 0);
  EXPECT_LE(distance(r.surface, old), 1e-9 * extent(old)) << "all vertices are on the old surface";
  EXPECT_EQ(r.metrics.size(), r.surface.number_of_vertices());
}

void expect_fits(const Judgement& j, double unit_edges, double mean, double worst) {
  EXPECT_NEAR(double(j.triangles), j.wanted, 0.15 * j.wanted);
  EXPECT_GE(j.share_of_unit_edges(), unit_edges);
  EXPECT_GE(j.mean, mean);
  EXPECT_GE(j.worst, worst);
}

// --- metrics in a plane ---

const V some_axis = normalized(V(1, 2, 3)), another_axis = normalized(cross(some_axis, V(1, 0, 0)));

void expect_equal(const Metric_2& a, const Metric_2& b, double tolerance = 1e-9) {
  const double scale = tolerance * (a.xx + a.yy);
  EXPECT_NEAR(a.xx, b.xx, scale);
  EXPECT_NEAR(a.xy, b.xy, scale);
  EXPECT_NEAR(a.yy, b.yy, scale);
}

TEST(Metric_in_a_plane, Is_the_same_either_way_where_the_normal_is_an_axis) {
  const std::array<V, 3> axes = {some_axis, another_axis, cross(some_axis, another_axis)};
  const Metric_3 m = Metric_3::from_sizes({0.01, 0.3, 2}, axes);
  const V a = normalized(axes[1] + 0.7 * axes[2]), b = cross(axes[0], a);
  expect_equal(tubular::metric_section(m, a, b), tubular::metric_shadow(m, a, b), 1e-6);
  const std::array<double, 2> sizes = tubular::metric_shadow(m, a, b).sizes();
  EXPECT_NEAR(sizes[0], 0.3, 1e-9);
  EXPECT_NEAR(sizes[1], 2, 1e-9);
  const Metric_3 i = Metric_3::isotropic(0.4);
  expect_equal(tubular::metric_section(i, a, b), Metric_2::isotropic(0.4));
  expect_equal(tubular::metric_shadow(i, a, b), Metric_2::isotropic(0.4));
}

TEST(Metric_in_a_plane, Has_the_projected_ball_as_shadow) {
  const Metric_3 m(3, 0.5, -0.2, 2, 0.7, 5);
  Eigen::Matrix<double, 3, 2> t;
  for (int i = 0; i < 3; ++i)
    t.row(i) << some_axis[i], another_axis[i];
  const Eigen::Matrix2d shadow = (t.transpose() * m.to_matrix<Eigen::Matrix3d>().inverse() * t).inverse();
  expect_equal(tubular::metric_shadow(m, some_axis, another_axis), {shadow(0, 0), shadow(0, 1), shadow(1, 1)}, 1e-12);
}

TEST(Metric_in_a_plane, Shades_off_as_the_plane_is_tilted) { // whereas the section is thin at once
  const double thin = 0.001;
  const Metric_3 m = Metric_3::from_sizes({thin, 1, 1}, std::array<V, 3>{V(0, 0, 1), V(1, 0, 0), V(0, 1, 0)});
  for (double tilt : {0.01, 0.1, 0.3}) {
    const V a(std::cos(tilt), 0, std::sin(tilt)), b(0, 1, 0);
    EXPECT_NEAR(tubular::metric_shadow(m, a, b).sizes()[0], std::cos(tilt), 1e-5);
    EXPECT_LT(tubular::metric_section(m, a, b).sizes()[0], 1.01 * thin / std::sin(tilt));
  }
}

// --- tangent planes ---

TEST(Plane_axes, Are_the_nearest_to_two_vectors) {
  tubular::internal::Plane_axes axes;
  ASSERT_TRUE(tubular::internal::nearest_axes(3 * some_axis, 0.2 * another_axis, axes));
  EXPECT_NEAR(norm(axes.first - some_axis), 0, 1e-12);
  EXPECT_NEAR(norm(axes.second - another_axis), 0, 1e-12);
  ASSERT_TRUE(tubular::internal::nearest_axes(V(1, 0.2, 0), V(0.2, 1, 0), axes));
  EXPECT_NEAR(norm(axes.first - V(1, 0, 0)), 0, 1e-12) << "symmetric";
  EXPECT_FALSE(tubular::internal::nearest_axes(some_axis, -2 * some_axis, axes));
  EXPECT_FALSE(tubular::internal::nearest_axes(V(), V(), axes));
}

// --- tubes, where the truth is known ---

TEST(Anisotropic_surface, Of_a_tube_has_the_metric) {
  Model model = straight_tube();
  const Mesh old = model.surface;
  const Remeshed r = remesh(std::move(model), tube_metric(as_around, 0.2, 0.8, straight));
  expect_good(old, r);
  const Judgement j = judge(r, true);
  expect_fits(j, 0.95, 0.9, 0.4);
  EXPECT_NEAR(j.wanted, 2 * pi * 10 / (0.2 * 0.8) / (std::sqrt(3.) / 4), 0.02 * j.wanted);
  expect_fits(judge(r, false), 0.95, 0.9, 0.4);
}

TEST(Anisotropic_surface, Is_not_thin_where_the_metric_is_across) { // however coarse the facets
  for (double points : {12., 24.}) {
    const auto isotropic = remesh(straight_tube(points), tube_metric(as_around, 0.2, 0.8, straight));
    const auto thin = remesh(straight_tube(points), tube_metric(thin_at_wall, 0.2, 0.8, straight));
    const Judgement expected = judge(isotropic, true), j = judge(thin, true);
    EXPECT_NEAR(double(j.triangles), double(expected.triangles), 0.05 * double(expected.triangles));
    EXPECT_GE(j.share_of_unit_edges(), 0.9);
    EXPECT_GE(j.mean, 0.9);
    EXPECT_GE(j.worst, 0.4);
  }
}

TEST(Anisotropic_surface, Of_a_round_tube_is_that_of_the_unrolled_one) { // the patch is a ring in the plane
  const Remeshed r = remesh(straight_tube(48), tube_metric(as_around, 0.6, 0.2, straight));
  expect_fits(judge(r, true), 0.95, 0.9, 0.4);
}

TEST(Anisotropic_surface, Turns_with_the_metric) {
  const auto turn = [](double z) { return z * pi / 10; };
  const double h0 = 0.12, h1 = 0.48;
  const Remeshed r = remesh(straight_tube(), tube_metric(as_around, h0, h1, turn));
  const Judgement j = judge(r, true);
  expect_fits(j, 0.95, 0.9, 0.4);
  EXPECT_NEAR(j.wanted, 2 * pi * 10 / (h0 * h1) / (std::sqrt(3.) / 4), 0.02 * j.wanted);
  double cosines = 0; // of long edges with the long direction
  std::size_t number = 0;
  for (auto e : r.surface.edges()) {
    const auto h = r.surface.halfedge(e);
    const V p(r.surface.point(r.surface.source(h))), q(r.surface.point(r.surface.target(h)));
    if (norm(q - p) < 0.7 * h1)
      continue;
    const V middle = 0.5 * (p + q), t = normalized(V(-middle.y, middle.x, 0));
    const double a = turn(middle.z);
    cosines += std::abs(dot(normalized(q - p), std::cos(a) * V(0, 0, 1) - std::sin(a) * t));
    ++number;
  }
  EXPECT_GT(number, 300u);
  EXPECT_GT(cosines / double(number), std::cos(10 * pi / 180));
}

TEST(Anisotropic_surface, Of_an_isotropic_metric_is_that_of_the_size) {
  const auto size = [](const Point& p) { return 0.2 + 0.02 * p.z(); };
  const Remeshed by_size = remesh(straight_tube(), size);
  const Remeshed by_metric = remesh(straight_tube(), [&](const Point& p) { return Metric_3::isotropic(size(p)); });
  ASSERT_EQ(by_size.curves.size(), by_metric.curves.size());
  for (std::size_t c = 0; c < by_size.curves.size(); ++c) {
    ASSERT_EQ(by_size.curves[c].size(), by_metric.curves[c].size());
    for (std::size_t i = 0; i < by_size.curves[c].size(); ++i)
      EXPECT_LT(CGAL::squared_distance(by_size.surface.point(by_size.curves[c][i]),
                                       by_metric.surface.point(by_metric.curves[c][i])),
                1e-20);
  }
  const double n = double(by_size.surface.number_of_faces());
  EXPECT_NEAR(double(by_metric.surface.number_of_faces()), n, 0.03 * n) << "triangles are judged in another way";
  EXPECT_TRUE(by_size.metrics.empty());
}

TEST(Anisotropic_surface, Has_curves_of_unit_edges) {
  const Remeshed r = remesh(straight_tube(), tube_metric(thin_at_wall, 0.25, 1, straight));
  ASSERT_GE(r.curves.size(), 3u);
  for (const auto& curve : r.curves) {
    EXPECT_NEAR(double(curve.size()), 2 * pi / 0.25, 1);
    for (std::size_t i = 0; i < curve.size(); ++i)
      EXPECT_NEAR(
          std::sqrt(CGAL::squared_distance(r.surface.point(curve[i]), r.surface.point(curve[(i + 1) % curve.size()]))),
          0.25, 0.02);
  }
}

TEST(Anisotropic_surface, Is_refined_piece_by_piece) {
  Model model = straight_tube();
  const auto cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
  const auto maps = tubular::parameterize_patches(model.surface, cut);
  const auto metric = tube_metric(thin_at_wall, 0.2, 0.8, straight);
  const tubular::internal::Metric_sizes sizes(model.surface, cut, maps, metric);
  tubular::internal::Triangle_piece_mesher mesher(model.surface, cut, maps, sizes, false, 1);
  mesher.mesh_all();
  const std::size_t before = mesher.pieces()[0].triangles.size();
  mesher.mesh_finer({0});
  EXPECT_NEAR(double(mesher.pieces()[0].triangles.size()) / double(before), 1 / (0.7 * 0.7), 0.25);
}

TEST(Anisotropic_surface, Does_not_depend_on_the_number_of_threads) {
  const auto metric = tube_metric(thin_at_wall, 0.2, 0.8, straight);
  const Remeshed one = remesh(straight_tube(), metric, 1), many = remesh(straight_tube(), metric, 4);
  ASSERT_EQ(one.surface.number_of_vertices(), many.surface.number_of_vertices());
  for (auto v : one.surface.vertices())
    EXPECT_EQ(one.surface.point(v), many.surface.point(v));
}

TEST(Anisotropic_surface, Refuses_what_is_no_metric) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Metric_3 bad[] = {
      {nan, 0, 0, 1, 0, 1}, {1, 0, 0, inf, 0, 1}, {1, 0, 0, 1, 0, -1}, {0, 0, 0, 0, 0, 0}, {1, 2, 0, 1, 0, 1}};
  for (const Metric_3& m : bad)
    for (double from : {-1., 4.9}) // everywhere, or in one place
      try {
        remesh(straight_tube(),
               [&](const Point& p) { return p.z() > from && p.z() < 5.1 ? m : Metric_3::isotropic(0.3); });
        ADD_FAILURE() << "not refused";
      } catch (const tubular::Parameter_error& e) {
        EXPECT_NE(std::string(e.what()).find("positive definite"), std::string::npos) << e.what();
      }
}

// --- trees, by their centerlines ---

std::size_t number_of_labels(const Remeshed& r) {
  std::vector<int> labels;
  for (auto f : r.surface.faces())
    labels.push_back(r.patch[f]);
  std::sort(labels.begin(), labels.end());
  return std::size_t(std::unique(labels.begin(), labels.end()) - labels.begin());
}

TEST(Anisotropic_surface, Of_a_bifurcation_is_long_along_the_vessels) {
  const Model model = model_of(tubular::y_bifurcation());
  const Remeshed r = tubular::make_anisotropic_surface_mesh(model, tubular::parameters::preserve_volume(false));
  expect_good(model.surface, r);
  EXPECT_EQ(number_of_labels(r), 1 + model.openings.size());
  expect_fits(judge(r, true), 0.95, 0.9, 0.4);
  expect_fits(judge(r, false), 0.95, 0.9, 0.4);
  EXPECT_NEAR(PMP::volume(r.surface), PMP::volume(model.surface), 0.02 * PMP::volume(model.surface));

  // Where sizes differ much on the wall, away from the junction, the longest edge of a triangle is along the vessel.
  const tubular::Centerline_field lines(model.centerlines);
  double cosines = 0;
  std::size_t number = 0;
  for (auto f : r.surface.faces()) {
    if (r.patch[f] != tubular::labels::wall)
      continue;
    const auto v = vertices_of(r.surface, f);
    V longest;
    for (int i = 0; i < 3; ++i) {
      const V e = V(r.surface.point(v[(i + 1) % 3])) - V(r.surface.point(v[i]));
      if (norm(e) > norm(longest))
        longest = e;
    }
    const auto sizes = r.metrics[v[0]].sizes();
    if (sizes[2] < 3 * sizes[1])
      continue;
    cosines += std::abs(dot(normalized(longest), V(lines.frame(r.surface.point(v[0])).e_t)));
    ++number;
  }
  EXPECT_GT(number, 300u);
  EXPECT_GT(cosines / double(number), std::cos(15 * pi / 180));
}

TEST(Anisotropic_surface, Has_the_layers_on_its_caps) {
  const Model model = straight_tube();
  const double first = 0.03;
  const Remeshed r =
      tubular::make_anisotropic_surface_mesh(model, tubular::parameters::first_height(first).curvature_points(24.));
  std::vector<double> heights; // of the triangles of caps on their rims
  for (auto f : r.surface.faces()) {
    if (r.patch[f] == tubular::labels::wall)
      continue;
    for (auto h : r.surface.halfedges_around_face(r.surface.halfedge(f))) {
      if (r.patch[r.surface.face(r.surface.opposite(h))] != tubular::labels::wall)
        continue;
      const V a(r.surface.point(r.surface.source(h))), b(r.surface.point(r.surface.target(h)));
      const V c(r.surface.point(r.surface.target(r.surface.next(h))));
      heights.push_back(norm(cross(b - a, c - a)) / norm(b - a));
    }
  }
  ASSERT_GT(heights.size(), 40u);
  std::nth_element(heights.begin(), heights.begin() + std::ptrdiff_t(heights.size() / 2), heights.end());
  const double median = heights[heights.size() / 2];
  EXPECT_GT(median, 0.5 * first);
  EXPECT_LT(median, 2 * first);
}

TEST(Anisotropic_surface, Does_not_depend_on_unit_position_and_direction) {
  const Transformation t =
      rotation(1) * Transformation(CGAL::TRANSLATION, Vector(5, -3, 2)) * Transformation(CGAL::SCALING, 0.001);
  const auto skeleton = tubular::y_bifurcation(); // whose principal axes are distinct
  Mesh mesh;
  tubular::generate_tubular_surface(skeleton, mesh, tubular::parameters::points_per_circumference(16.).noise(0.));
  auto lines = tubular::centerlines_of(skeleton);
  const Remeshed r = tubular::make_anisotropic_surface_mesh(tubular::make_tubular_model(mesh, lines));
  for (Point& p : lines.points)
    p = t(p);
  for (double& radius : lines.radius)
    radius *= 0.001;
  const Remeshed s = tubular::make_anisotropic_surface_mesh(tubular::make_tubular_model(transformed(mesh, t), lines));
  const double n = double(r.surface.number_of_faces());
  EXPECT_NEAR(double(s.surface.number_of_faces()), n, 0.03 * n) << "but for rounding";
  const Judgement a = judge(r, true), b = judge(s, true);
  EXPECT_NEAR(a.wanted, b.wanted, 0.05 * a.wanted) << "the metrics came along, but for how the field is sampled";
  EXPECT_NEAR(a.mean, b.mean, 0.01);
}

TEST(Anisotropic_surface, Refuses_bad_parameters) {
  const Model model = straight_tube();
  EXPECT_THROW(tubular::make_anisotropic_surface_mesh(model, tubular::parameters::growth(0.5)),
               tubular::Parameter_error);
  EXPECT_THROW(tubular::make_anisotropic_surface_mesh(model, tubular::parameters::first_height(-1.)),
               tubular::Parameter_error);
}

TEST(Anisotropic_surface, Is_measured_in_its_metric) {
  const Remeshed r = remesh(straight_tube(), tube_metric(thin_at_wall, 0.2, 0.8, straight));
  const tubular::Metric_surface_report report = tubular::metric_surface_report(r);
  for (bool wall : {false, true}) {
    const Judgement j = judge(r, wall);
    const tubular::Metric_fit& fit = wall ? report.wall : report.caps;
    EXPECT_EQ(fit.shape.count(), j.triangles);
    EXPECT_EQ(fit.edge_length.count(), j.edges);
    EXPECT_NEAR(fit.shape.mean(), j.mean, 1e-9);
    EXPECT_NEAR(fit.shape.min(), j.worst, 1e-9);
    EXPECT_NEAR(fit.share_of_unit_edges(), j.share_of_unit_edges(), 1e-3);
    EXPECT_NEAR(fit.wanted_triangles, j.wanted, 1e-6 * j.wanted);
  }
  EXPECT_EQ(
      tubular::metric_surface_report(remesh(straight_tube(), [](const Point&) { return 0.3; })).wall.shape.count(), 0u);
}

TEST(Anisotropic_surface, Takes_its_metric_to_a_mesh) {
  const Remeshed r = remesh(straight_tube(), tube_metric(as_around, 0.3, 0.9, straight));
  tubular::Mixed_mesh mesh;
  tubular::surface_to_mixed_mesh(r, mesh);
  EXPECT_EQ(mesh.triangles.size(), r.surface.number_of_faces());
  ASSERT_EQ(mesh.point_arrays.size(), 1u);
  const auto& array = mesh.point_arrays[0];
  EXPECT_EQ(array.name, "metric");
  ASSERT_EQ(array.components, 6);
  ASSERT_EQ(array.values.size(), 6 * mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_EQ(array.values[6 * i + k], r.metrics[i].components()[k]);
}

// --- real vessels ---

#ifdef TUBULAR_MESHING_SHARED_DATA
void remesh_real(const std::string& surface, const std::string& centerlines) {
  const std::string folder = std::string(TUBULAR_MESHING_SHARED_DATA) + "/";
  for (const std::string& name : {surface, centerlines})
    if (!std::ifstream(folder + name))
      GTEST_SKIP() << folder + name << " is not there";
  Mesh mesh;
  tubular::IO::read_surface(folder + surface, mesh);
  tubular::repair_surface(mesh);
  tubular::Centerline_polylines lines;
  tubular::IO::read_centerlines(folder + centerlines, lines);
  const Model model = tubular::make_tubular_model(mesh, lines);
  const Remeshed r = tubular::make_anisotropic_surface_mesh(model, tubular::parameters::preserve_volume(false));
  expect_good(model.surface, r);
  expect_fits(judge(r, true), 0.95, 0.9, 0.4);
  EXPECT_GE(judge(r, false).mean, 0.9);
}

TEST(Anisotropic_surface_real, Aorta) {
  remesh_real("paper/aorta.stl", "paper/centerlinesAORTA.vtk");
}
TEST(Anisotropic_surface_real, Carotid) {
  remesh_real("paper/carotid.stl", "paper/centerlinesCAROTID.vtk");
}
TEST(Anisotropic_surface_real, Cerebral) {
  remesh_real("paper/cerebral.stl", "paper/centerlinesCEREBRAL.vtk");
}
#endif

} // namespace

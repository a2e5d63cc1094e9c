// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The optimizer of hexahedra: boxes and cylinders, whose surfaces are known; a vessel.

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Star_energy.h>
#include <CGAL/Tubular_meshing/Hexahedra/optimize_hexahedra.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include "hexahedral_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using namespace hexahedral_shapes;
using tubular::internal::Corner_penalty;
using tubular::internal::Star_energy;
using tubular::internal::Vector_3d;
typedef tubular::Optimize_hexahedra_report Report;
namespace params = tubular::parameters;

const std::array<double, 3> box_lengths = {6, 8, 10};

std::array<Vector_3d, 8> corners(const Mesh& mesh, std::size_t h) {
  std::array<Vector_3d, 8> p;
  for (std::size_t c = 0; c < 8; ++c)
    p[c] = Vector_3d(mesh.points[mesh.hexahedra.vertices[h][c]]);
  return p;
}

struct Quality {
  double min = 1, mean = 0;
  explicit Quality(const Mesh& mesh) {
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
      const double q = tubular::internal::scaled_jacobian(corners(mesh, h));
      min = std::min(min, q);
      mean += q / double(mesh.hexahedra.size());
    }
  }
};

// --- the energy ---

/* The corner of a shaken grid's middle vertex in each hexahedron around it, with targets of different lengths. */
struct Middle_star {
  Mesh mesh = box_grid({2, 2, 2}, {2, 2.5, 1.5});
  std::uint32_t middle = 13;
  tubular::internal::Axis_lengths inverse = {1.3, 0.8, 2.1};

  explicit Middle_star(double shaken) {
    shake(mesh, shaken, [](std::size_t, const Point& p) { return p; });
  }
  Star_energy energy() const {
    Star_energy result;
    result.clear();
    for (std::size_t h = 0; h < 8; ++h) {
      const auto& v = mesh.hexahedra.vertices[h];
      const auto at = std::find(v.begin(), v.end(), middle);
      result.add_hexahedron(corners(mesh, h), int(at - v.begin()), inverse);
    }
    return result;
  }
  // Of all corners, those that do not change included.
  double total(const Vector_3d& d, const Corner_penalty& penalty) const {
    Mesh moved = mesh;
    const Point& p = mesh.points[middle];
    moved.points[middle] = Point(p.x() + d.x, p.y() + d.y, p.z() + d.z);
    double sum = 0;
    for (std::size_t h = 0; h < 8; ++h)
      sum += tubular::internal::hexahedron_energy(corners(moved, h), inverse, penalty).value;
    return sum;
  }
};

Corner_penalty penalty_of(int power, double epsilon) {
  Corner_penalty penalty;
  penalty.power = power;
  penalty.epsilon = epsilon;
  return penalty;
}

TEST(Star_energy, Is_one_at_the_corners_of_a_brick_in_its_proportions) {
  const Mesh mesh = box_grid({1, 1, 1}, {2, 3, 5});
  for (int power : {1, 2, 4, 8})
    for (double size : {1e-3, 1., 1e4}) // only proportions count
      EXPECT_NEAR(
          tubular::internal::hexahedron_energy(corners(mesh, 0), {size / 2, size / 3, size / 5}, penalty_of(power, 0))
              .value,
          8, 1e-12);
}

TEST(Star_energy, Changes_with_a_vertex_as_the_sum_over_all_corners_does) {
  for (double epsilon : {0., 0.3}) {
    const Middle_star star(epsilon > 0 ? 0.6 : 0.15);
    const Star_energy energy = star.energy();
    for (int power : {1, 2, 4, 8}) {
      const Corner_penalty penalty = penalty_of(power, epsilon);
      const Vector_3d zero, d(0.03, -0.05, 0.02);
      const double expected = star.total(d, penalty) - star.total(zero, penalty);
      EXPECT_NEAR(energy.value(d, penalty) - energy.value(zero, penalty), expected, 1e-11 * star.total(zero, penalty));
    }
  }
}

TEST(Star_energy, Has_the_gradient_of_finite_differences) {
  for (double epsilon : {0., 0.3}) {
    const Middle_star star(epsilon > 0 ? 0.6 : 0.15);
    const Star_energy energy = star.energy();
    for (int power : {1, 2, 4, 8}) {
      const Corner_penalty penalty = penalty_of(power, epsilon);
      const Vector_3d at(0.02, 0.01, -0.03);
      const auto exact = energy.derivatives(at, penalty);
      EXPECT_NEAR(exact.value, energy.value(at, penalty), 1e-12 * exact.value);
      const double h = 1e-5, tolerance = 1e-6 * (tubular::internal::norm(exact.gradient) + exact.value);
      for (int axis = 0; axis < 3; ++axis) {
        const Vector_3d e(axis == 0 ? h : 0, axis == 1 ? h : 0, axis == 2 ? h : 0);
        const double difference = (energy.value(at + e, penalty) - energy.value(at - e, penalty)) / (2 * h);
        EXPECT_NEAR(exact.gradient[axis], difference, tolerance) << power << " " << epsilon << " " << axis;
        if (epsilon > 0)
          continue; // the Hessian is without the curvature of χ
        const Vector_3d column = exact.hessian * Vector_3d(axis == 0, axis == 1, axis == 2);
        const Vector_3d change =
            energy.derivatives(at + e, penalty).gradient - energy.derivatives(at - e, penalty).gradient;
        for (int row = 0; row < 3; ++row)
          EXPECT_NEAR(column[row], change[row] / (2 * h),
                      1e-5 * (exact.hessian.xx + exact.hessian.yy + exact.hessian.zz));
      }
    }
  }
}

TEST(Star_energy, Has_no_bound_at_flat_corners_without_epsilon_only) {
  EXPECT_TRUE(std::isinf(penalty_of(1, 0)(3, 0)));
  EXPECT_TRUE(std::isinf(penalty_of(4, 0)(3, -1)));
  EXPECT_TRUE(std::isfinite(penalty_of(1, 0.1)(3, -1)));
  EXPECT_GT(penalty_of(1, 0.1)(3, -1), penalty_of(1, 0.1)(3, -0.5));
  EXPECT_GT(penalty_of(1, 0.1)(3, -0.5), penalty_of(1, 0.1)(3, 0.5));
}

TEST(Star_energy, Takes_the_scaled_jacobian_as_the_quality_report_does) {
  Mesh mesh = box_grid({3, 3, 3}, {3, 3, 3});
  shake(mesh, 0.6, [](std::size_t, const Point& p) { return p; });
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    EXPECT_NEAR(tubular::internal::least_scaled_jacobian(corners(mesh, h)),
                tubular::internal::scaled_jacobian(corners(mesh, h)), 1e-14);
}

// --- boxes ---

/* The box's grid of unit cubes, shaken within the box. */
Mesh shaken_box(double amount) {
  Mesh mesh = box_grid({6, 8, 10}, box_lengths);
  shake_box(mesh, amount, box_lengths);
  return mesh;
}

void expect_on_box(const Mesh& mesh, const std::array<double, 3>& lengths, double tolerance) {
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    const int axis = (mesh.quads.label[i] - 1) / 2, end = (mesh.quads.label[i] - 1) % 2;
    for (std::uint32_t v : mesh.quads.vertices[i]) {
      ASSERT_NEAR(mesh.points[v][axis], end * lengths[std::size_t(axis)], tolerance);
      for (int k = 0; k < 3; ++k) {
        ASSERT_GE(mesh.points[v][k], -tolerance);
        ASSERT_LE(mesh.points[v][k], lengths[std::size_t(k)] + tolerance);
      }
    }
  }
}

TEST(Optimize_hexahedra, Untangles_a_box_and_keeps_its_sides) {
  const auto surface = box_surface(box_lengths);
  struct Case {
    double shaken, least, mean;
  };
  for (const Case& c : {Case{0.3, 0.95, 0.99}, Case{0.6, 0.95, 0.99}, Case{1, 0.95, 0.99}}) {
    const Mesh before = shaken_box(c.shaken);
    Mesh mesh = before;
    const Report report = tubular::optimize_hexahedra(mesh, surface, params::quality_wanted(1));
    const Quality quality(mesh);
    EXPECT_GT(report.inverted_before, 0u);
    EXPECT_EQ(report.inverted, 0u);
    EXPECT_NEAR(report.min_scaled_jacobian, quality.min, 1e-6);
    EXPECT_NEAR(report.mean_scaled_jacobian, quality.mean, 1e-6);
    EXPECT_NEAR(report.min_scaled_jacobian_before, Quality(before).min, 1e-6);
    EXPECT_GT(quality.min, c.least) << c.shaken;
    EXPECT_GT(quality.mean, c.mean) << c.shaken;
    EXPECT_EQ(mesh.hexahedra.vertices, before.hexahedra.vertices);
    EXPECT_EQ(mesh.quads.vertices, before.quads.vertices);
    expect_on_box(mesh, box_lengths, 1e-13);
    const auto valid = tubular::validity_report(mesh);
    EXPECT_TRUE(valid.is_valid()) << valid.defects();
  }
}

TEST(Optimize_hexahedra, Goes_on_until_the_quality_wanted_is_there) {
  const auto surface = box_surface(box_lengths);
  std::size_t sweeps = 0;
  for (double wanted : {0.1, 0.5, 0.8, 0.9}) {
    Mesh mesh = shaken_box(0.6);
    const Report report = tubular::optimize_hexahedra(mesh, surface, params::quality_wanted(wanted));
    EXPECT_GT(report.below_wanted_before, 0u);
    EXPECT_EQ(report.below_wanted, 0u);
    EXPECT_GE(Quality(mesh).min, wanted - 1e-6);
    EXPECT_GE(report.sweeps, sweeps);
    sweeps = report.sweeps;
  }
}

TEST(Optimize_hexahedra, Untangles_a_box_whose_inside_has_collapsed) {
  const std::array<double, 3> lengths = {1, 1, 1};
  Mesh mesh = box_grid({10, 10, 10}, lengths);
  for (Point& p : mesh.points)
    if (std::min({p.x(), p.y(), p.z()}) > 0 && std::max({p.x(), p.y(), p.z()}) < 1)
      p = Point(0.3 + 0.01 * p.x(), 0.4 + 0.01 * p.y(), 0.5 - 0.01 * p.z());
  const Report report = tubular::optimize_hexahedra(mesh, box_surface(lengths));
  EXPECT_GE(report.inverted_before, 800u);
  EXPECT_EQ(report.inverted, 0u);
  EXPECT_GT(Quality(mesh).min, 0.5);
  EXPECT_GT(Quality(mesh).mean, 0.85);
  expect_on_box(mesh, lengths, 1e-13);
}

TEST(Optimize_hexahedra, Leaves_a_good_mesh_alone) {
  const Mesh before = shaken_box(0.05);
  Mesh mesh = before;
  const Report report = tubular::optimize_hexahedra(mesh, box_surface(box_lengths));
  EXPECT_EQ(mesh.points, before.points);
  EXPECT_EQ(report.sweeps, 0u);
  EXPECT_EQ(report.movable_vertices, 0u);
  EXPECT_EQ(report.min_scaled_jacobian, report.min_scaled_jacobian_before);
}

TEST(Optimize_hexahedra, Works_near_bad_hexahedra_only) {
  const std::array<double, 3> lengths = {20, 20, 20};
  const Mesh grid = box_grid({20, 20, 20}, lengths);
  Mesh mesh = grid;
  const std::size_t bad = (10 * 21 + 10) * 21 + 10;
  ASSERT_EQ(grid.points[bad], Point(10, 10, 10));
  mesh.points[bad] = Point(11.5, 10.2, 10.1);
  const Report report = tubular::optimize_hexahedra(mesh, box_surface(lengths));
  EXPECT_GT(report.inverted_before, 0u);
  EXPECT_GT(report.min_scaled_jacobian, 0.9);
  EXPECT_LT(report.movable_vertices, 1000u);
  for (std::size_t v = 0; v < grid.points.size(); ++v) {
    const Point& p = grid.points[v];
    if (std::max({std::abs(p.x() - 10.5), std::abs(p.y() - 10), std::abs(p.z() - 10)}) > 5)
      ASSERT_EQ(mesh.points[v], p);
  }
}

TEST(Optimize_hexahedra, Keeps_fixed_vertices_and_those_of_other_cells) {
  const Mesh before = shaken_box(0.4);
  Mesh mesh = before;
  std::vector<bool> fixed(mesh.points.size());
  for (std::size_t v = 0; v < fixed.size(); v += 9)
    fixed[v] = true;
  const std::array<std::uint32_t, 4> tetrahedron = {100, 101, 108, 163};
  mesh.tetrahedra.push_back(tetrahedron, 1);
  tubular::optimize_hexahedra(mesh, box_surface(box_lengths), params::fixed_vertices(&fixed).quality_wanted(1));
  std::size_t moved = 0;
  for (std::size_t v = 0; v < fixed.size(); ++v)
    if (fixed[v] || std::count(tetrahedron.begin(), tetrahedron.end(), v) != 0)
      ASSERT_EQ(mesh.points[v], before.points[v]);
    else
      moved += mesh.points[v] != before.points[v];
  EXPECT_GT(moved, fixed.size() / 2);
}

TEST(Optimize_hexahedra, Keeps_vertices_of_patches_that_the_surface_does_not_have) {
  Mesh before = shaken_box(0.4);
  for (int& l : before.quads.label)
    l = l == 6 ? 100 : l;
  Mesh mesh = before;
  tubular::optimize_hexahedra(mesh, box_surface(box_lengths), params::quality_wanted(1));
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    for (std::uint32_t v : mesh.quads.vertices[i])
      if (mesh.quads.label[i] == 100)
        ASSERT_EQ(mesh.points[v], before.points[v]);
  EXPECT_NE(mesh.points, before.points);
}

// A vertex outside of the box, and a fixed one inside of it that is further out than the surface.
TEST(Optimize_hexahedra, Leaves_vertices_off_the_surface_where_hexahedra_would_turn_over_there) {
  const std::array<double, 3> lengths = {6, 6, 6};
  Mesh mesh = box_grid({6, 6, 6}, lengths);
  const auto vertex_at = [&](const Point& p) {
    return std::size_t(std::find(mesh.points.begin(), mesh.points.end(), p) - mesh.points.begin());
  };
  const std::size_t outside = vertex_at(Point(3, 3, 0)), inside = vertex_at(Point(3, 3, 1)),
                    beside = vertex_at(Point(4, 3, 1));
  mesh.points[outside] = Point(3, 3, -0.9);
  mesh.points[inside] = Point(3, 3, -0.3);
  mesh.points[beside] = Point(3.6, 3, 1);
  std::vector<bool> fixed(mesh.points.size(), false);
  fixed[inside] = true;
  const Report report =
      tubular::optimize_hexahedra(mesh, box_surface(lengths), params::fixed_vertices(&fixed).quality_wanted(1));
  EXPECT_EQ(report.inverted_before, 0u);
  EXPECT_LT(report.min_scaled_jacobian_before, 0.2);
  EXPECT_EQ(report.inverted, 0u);
  EXPECT_GT(report.min_scaled_jacobian, 0.35);
  EXPECT_EQ(mesh.points[outside], Point(3, 3, -0.9));
}

TEST(Optimize_hexahedra, Is_the_same_on_any_number_of_threads) {
  const std::array<double, 3> lengths = {16, 16, 16};
  Mesh one = box_grid({16, 16, 16}, lengths);
  shake_box(one, 0.6, lengths);
  Mesh two = one;
  const auto surface = box_surface(lengths);
  const Report first = tubular::optimize_hexahedra(one, surface, params::number_of_threads(1));
  const Report second = tubular::optimize_hexahedra(two, surface, params::number_of_threads(2));
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(first.sweeps, second.sweeps);
  EXPECT_EQ(first.inverted, 0u);
}

TEST(Optimize_hexahedra, Works_in_any_unit) {
  const Mesh before = shaken_box(0.6);
  Mesh unit = before;
  tubular::optimize_hexahedra(unit, box_surface(box_lengths));
  for (double s : {1. / 1024, 1e-9, 1e6}) {
    Mesh mesh = before;
    for (Point& p : mesh.points)
      p = Point(s * p.x(), s * p.y(), s * p.z());
    tubular::optimize_hexahedra(mesh, box_surface({6 * s, 8 * s, 10 * s}));
    EXPECT_NEAR(Quality(mesh).min, Quality(unit).min, 1e-6) << s;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      for (int i = 0; i < 3; ++i)
        ASSERT_NEAR(mesh.points[v][i] / s, unit.points[v][i], 1e-6) << s;
  }
}

TEST(Optimize_hexahedra, Gives_hexahedra_the_proportions_wanted) {
  const std::array<double, 3> lengths = {4, 4, 4};
  Mesh mesh = box_grid({4, 4, 4}, lengths);
  std::vector<tubular::Hexahedron_edge_lengths> targets(mesh.hexahedra.size(), {1, 1, 1});
  for (std::size_t h = 0; h < 16; ++h) // the lowest
    targets[h] = {1, 1, 0.25};
  const Report report = tubular::optimize_hexahedra(
      mesh, box_surface(lengths), params::target_lengths(&targets).quality_wanted(1.1).number_of_sweeps(30));
  EXPECT_NEAR(report.min_scaled_jacobian, 1, 1e-3);
  for (std::size_t h = 0; h < 16; ++h) {
    const double height = tubular::internal::mean_edge_lengths(corners(mesh, h))[2];
    EXPECT_GT(height, 0.25);
    EXPECT_LT(height, 0.5);
  }
}

TEST(Optimize_hexahedra, Refuses_options_that_do_not_fit) {
  Mesh mesh = shaken_box(0.3);
  const auto surface = box_surface(box_lengths);
  const std::vector<bool> fixed(3);
  EXPECT_THROW(tubular::optimize_hexahedra(mesh, surface, params::fixed_vertices(&fixed)), tubular::Parameter_error);
  std::vector<tubular::Hexahedron_edge_lengths> targets(3);
  EXPECT_THROW(tubular::optimize_hexahedra(mesh, surface, params::target_lengths(&targets)), tubular::Parameter_error);
  targets.assign(mesh.hexahedra.size(), {1, 1, 0});
  EXPECT_THROW(tubular::optimize_hexahedra(mesh, surface, params::target_lengths(&targets)), tubular::Parameter_error);
  EXPECT_THROW(tubular::optimize_hexahedra(mesh, surface, params::tempering(1.5)), tubular::Parameter_error);
}

TEST(Optimize_hexahedra, Does_nothing_without_hexahedra) {
  Mesh mesh;
  const Report report = tubular::optimize_hexahedra(mesh, box_surface(box_lengths));
  EXPECT_EQ(report.min_scaled_jacobian, 0);
  EXPECT_EQ(report.sweeps, 0u);
}

TEST(Optimize_hexahedra, Takes_a_surface_and_its_labels_apart) {
  Mesh one = shaken_box(0.6), two = one;
  const auto surface = box_surface(box_lengths);
  tubular::optimize_hexahedra(one, surface);
  tubular::optimize_hexahedra(two, surface.surface, surface.patch);
  EXPECT_EQ(one.points, two.points);
}

// --- cylinders ---

constexpr int sides = 96;
constexpr double cylinder_length = 4;

// How far a point is outside of the cylinder's wall, which is a prism.
double outside(const Point& p) {
  double furthest = -1;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * CGAL_PI * (i + 0.5) / sides;
    furthest = std::max(furthest, p.x() * std::cos(a) + p.y() * std::sin(a) - std::cos(CGAL_PI / sides));
  }
  return furthest;
}

void expect_on_cylinder(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    for (std::uint32_t v : mesh.quads.vertices[i]) {
      const Point& p = mesh.points[v];
      if (mesh.quads.label[i] == 1) {
        ASSERT_NEAR(outside(p), 0, 1e-14);
        ASSERT_GE(p.z(), -1e-14);
        ASSERT_LE(p.z(), cylinder_length + 1e-14);
      } else {
        ASSERT_NEAR(p.z(), mesh.quads.label[i] == 2 ? 0 : cylinder_length, 1e-14);
        ASSERT_LE(outside(p), 1e-14);
      }
    }
}

TEST(Optimize_hexahedra, Untangles_a_cylinder_on_its_surface) {
  const auto surface = cylinder_surface(sides, 40, cylinder_length);
  for (double shaken : {0.1, 0.2, 0.3}) {
    Mesh mesh = o_grid(3, 3, 16, cylinder_length);
    shake(mesh, shaken, [](std::size_t, const Point& p) { return p; }); // off the surface, too
    const Report report = tubular::optimize_hexahedra(mesh, surface, params::quality_wanted(1));
    EXPECT_GT(report.inverted_before, 100u);
    EXPECT_EQ(report.inverted, 0u);
    EXPECT_GT(Quality(mesh).min, 0.75) << shaken;
    EXPECT_GT(Quality(mesh).mean, 0.95) << shaken;
    expect_on_cylinder(mesh);
  }
}

TEST(Optimize_hexahedra, Brings_back_vertices_thrown_inside) {
  const auto surface = cylinder_surface(sides, 40, cylinder_length);
  Mesh mesh = o_grid(3, 3, 16, cylinder_length);
  for (std::size_t v = 0; v < mesh.points.size(); v += 23) {
    const Point& p = mesh.points[v];
    mesh.points[v] = Point(0.2 * p.x() + 0.3, 0.2 * p.y(), p.z());
  }
  const Report report = tubular::optimize_hexahedra(mesh, surface);
  EXPECT_GT(report.inverted_before, 100u);
  EXPECT_EQ(report.inverted, 0u);
  EXPECT_GT(Quality(mesh).min, 0.5);
  EXPECT_GT(Quality(mesh).mean, 0.9);
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    for (std::uint32_t v : mesh.quads.vertices[i])
      if (mesh.quads.label[i] != 1)
        ASSERT_NEAR(mesh.points[v].z(), mesh.quads.label[i] == 2 ? 0 : cylinder_length, 1e-14);
}

// --- a vessel ---

TEST(Optimize_hexahedra, Improves_what_tetrahedra_were_split_into) {
  const auto skeleton = tubular::y_bifurcation();
  tubular::Surface wall;
  tubular::generate_tubular_surface(skeleton, wall, params::points_per_circumference(24));
  const auto model = tubular::make_tubular_model(wall, tubular::centerlines_of(skeleton));
  const Mesh before = split_tetrahedra(
      tubular::make_isotropic_mesh(model, params::points_per_circumference(12).preserve_volume(false)));
  Mesh mesh = before;
  const Report report = tubular::optimize_hexahedra(mesh, model, params::quality_wanted(0.6));
  EXPECT_EQ(report.inverted, 0u);
  EXPECT_GE(Quality(mesh).min, 0.12);
  EXPECT_GE(Quality(mesh).min, Quality(before).min + 0.1);
  EXPECT_GE(Quality(mesh).mean, 0.6);
  const auto valid = tubular::validity_report(mesh);
  EXPECT_TRUE(valid.is_valid()) << valid.defects();
  std::vector<tubular::internal::Double_kernel::Triangle_3> triangles;
  for (auto f : model.surface.faces())
    if (model.patch[f] == tubular::labels::wall) {
      const auto h = model.surface.halfedge(f);
      const auto at = [&](tubular::Surface::Halfedge_index g) {
        return tubular::internal::to_double_point(model.surface.point(model.surface.target(g)));
      };
      triangles.emplace_back(at(model.surface.prev(h)), at(h), at(model.surface.next(h)));
    }
  const tubular::internal::Nearest_tree<tubular::internal::Double_kernel::Triangle_3> tree(triangles);
  double furthest = 0;
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    for (std::uint32_t v : mesh.quads.vertices[i])
      if (mesh.quads.label[i] == tubular::labels::wall)
        furthest = std::max(
            furthest, std::sqrt(tree.nearest(tubular::internal::to_double_point(mesh.points[v])).squared_distance));
  EXPECT_LT(furthest, 1e-12);
}

} // namespace

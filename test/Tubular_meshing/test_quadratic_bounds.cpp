// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bounds of the Jacobian of quadratic cells: against dense samples by the textbooks' shape functions, of random cells of
// all kinds; cells that are invalid where no corner shows it.

#include "quadratic_meshes.h"

#include <CGAL/Tubular_meshing/Quadratic/quadratic_quality.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace quadratic_meshes;

constexpr std::array<Element_type, 4> cell_types = {Element_type::tetrahedron, Element_type::pyramid,
                                                    Element_type::prism, Element_type::hexahedron};

// A cell of about unit size, its corners off their places by at most `amplitude`.
Mixed_mesh one_cell(Element_type type, double amplitude, std::mt19937& random) {
  std::uniform_real_distribution<double> off(-amplitude, amplitude);
  const std::vector<std::array<double, 3>> cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<std::array<double, 3>> prism = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  const std::vector<std::array<double, 3>> pyramid = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0.8}};
  const std::vector<std::array<double, 3>> tetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto& places = type == Element_type::tetrahedron ? tetrahedron
                       : type == Element_type::pyramid   ? pyramid
                       : type == Element_type::prism     ? prism
                                                         : cube;
  Mixed_mesh m;
  for (const auto& p : places)
    m.points.push_back(Point_3(p[0] + off(random), p[1] + off(random), p[2] + off(random)));
  switch (type) {
  case Element_type::tetrahedron:
    m.tetrahedra.push_back({0, 1, 2, 3}, 1);
    break;
  case Element_type::pyramid:
    m.pyramids.push_back({0, 1, 2, 3, 4}, 1);
    break;
  case Element_type::prism:
    m.prisms.push_back({0, 1, 2, 3, 4, 5}, 1);
    break;
  default:
    m.hexahedra.push_back({0, 1, 2, 3, 4, 5, 6, 7}, 1);
  }
  return m;
}

Textbook_element element_of(const Quadratic_mesh& mesh, Element_type type) {
  std::uint32_t corners[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  return element(mesh, type, corners, 0);
}

void bend(Quadratic_mesh& mesh, double amplitude, std::mt19937& random) {
  std::uniform_real_distribution<double> off(-amplitude, amplitude);
  for (auto* points : {&mesh.edge_points, &mesh.quad_points, &mesh.inner_points})
    for (Point_3& p : *points)
      p = Point_3(p.x() + off(random), p.y() + off(random), p.z() + off(random));
}

struct Least {
  double determinant = 1e30, scaled = 1e30;
};

// Of the samples at a lattice of points in a cell.
Least least_of_samples(const Textbook_element& cell, Element_type type, int n) {
  Least least;
  const auto product = [](const Vector& a, const Vector& b, const Vector& c) { return norm(a) * norm(b) * norm(c); };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) {
        const double u = double(i) / n, v = double(j) / n, w = double(k) / n;
        std::array<Vector, 3> f;
        double longest = 0, sign = 1;
        if (type == Element_type::hexahedron) {
          f = cell.frame(2 * u - 1, 2 * v - 1, 2 * w - 1);
          longest = product(f[0], f[1], f[2]);
        } else if (type == Element_type::prism) {
          if (i + j > n)
            continue;
          f = cell.frame(u, v, w);
          const Vector d = f[1] - f[0];
          longest = std::max({product(f[0], f[1], f[2]), product(f[0], d, f[2]), product(f[1], d, f[2])});
        } else if (type == Element_type::tetrahedron) {
          if (i + j + k > n)
            continue;
          f = cell.frame(u, v, w);
          const Vector a = f[1] - f[0], b = f[2] - f[0], c = f[2] - f[1];
          longest =
              std::max({product(f[0], f[1], f[2]), product(f[0], a, b), product(f[1], a, c), product(f[2], b, c)});
        } else {
          if (k == n) // the apex, where the shape functions have no value
            continue;
          f = cell.frame((2 * u - 1) * (1 - w), (2 * v - 1) * (1 - w), w);
          // toward the apex, not along the axis
          const Vector up = f[2] + -(2 * u - 1) * f[0] + -(2 * v - 1) * f[1];
          longest = product(f[0], f[1], up);
        }
        const double det = sign * dot(cross(f[0], f[1]), f[2]);
        least.determinant = std::min(least.determinant, det);
        least.scaled = std::min(least.scaled, det / longest);
      }
  return least;
}

TEST(Quadratic_bounds, Enclose_dense_samples_of_random_cells) {
  std::mt19937 random(5);
  std::size_t valid = 0, invalid = 0;
  for (Element_type type : cell_types)
    for (bool complete : {false, true})
      for (double amplitude : {0.02, 0.06, 0.15})
        for (int repetition = 0; repetition < 4; ++repetition) {
          Quadratic_mesh mesh = tubular::straight_quadratic_mesh(one_cell(type, amplitude, random), complete);
          bend(mesh, amplitude, random);
          const Least least = least_of_samples(element_of(mesh, type), type, 12);
          const auto bounds = tubular::scaled_jacobian_bounds(mesh, type, 0, 0.02);
          const auto report = tubular::quality_report(mesh, 1);
          SCOPED_TRACE(int(type) + 10 * complete + 100 * amplitude);
          EXPECT_LE(bounds.lower, bounds.upper);
          EXPECT_LE(bounds.lower, least.scaled + 1e-6);
          if (bounds.lower > 0) {
            ++valid;
            EXPECT_GT(least.determinant, 0);
            EXPECT_GE(bounds.lower, 0.98 * bounds.upper - 1e-12);
            EXPECT_LE(bounds.upper, 1.1 * least.scaled); // some sample is near the least
            EXPECT_TRUE(report.is_valid());
            EXPECT_GT(report.scaled_jacobian.min(), amplitude < 0.05 ? 0.8 * least.scaled : 0); // of so many parts
            EXPECT_LE(report.scaled_jacobian.min(), least.scaled + 1e-6);
          } else if (bounds.upper <= 0) {
            ++invalid;
            const double sampled = // it may be a small part of the cell, as next to an apex
                least.scaled < 0.02 ? least.scaled : least_of_samples(element_of(mesh, type), type, 48).scaled;
            EXPECT_LT(sampled, 0.02);
            EXPECT_EQ(report.invalid, 1u);
            EXPECT_LE(report.scaled_jacobian.min(), 0);
          }
        }
  EXPECT_GT(valid, 40u);
  EXPECT_GT(invalid, 10u);
}

// --- straight cells: what is known of linear ones ---

TEST(Quadratic_bounds, Straight_cells_have_the_measures_of_linear_ones) {
  std::mt19937 random(8);
  for (int repetition = 0; repetition < 5; ++repetition) {
    const auto measured = [&](Element_type type, double amplitude) {
      return tubular::scaled_jacobian_bounds(tubular::straight_quadratic_mesh(one_cell(type, amplitude, random)), type,
                                             0, 1e-3);
    };
    const std::mt19937 before = random;
    const auto tetrahedron = measured(Element_type::tetrahedron, 0.2);
    random = before;
    const Mixed_mesh linear = one_cell(Element_type::tetrahedron, 0.2, random);
    double least = 1;
    for (int k = 0; k < 4; ++k) { // at each corner
      const Vector p(linear.points[std::size_t(k)]);
      std::vector<Vector> e;
      for (int i = 0; i < 4; ++i)
        if (i != k)
          e.push_back(Vector(linear.points[std::size_t(i)]) - p);
      least = std::min(least, std::abs(dot(cross(e[0], e[1]), e[2])) / (norm(e[0]) * norm(e[1]) * norm(e[2])));
    }
    EXPECT_NEAR(tetrahedron.lower, least, 2e-3 * least);
    // no cube of straight edges is better than its worst corner
    const std::mt19937 of_cube = random;
    const auto hexahedron = measured(Element_type::hexahedron, 0.1);
    random = of_cube;
    const Mixed_mesh cube = one_cell(Element_type::hexahedron, 0.1, random);
    std::array<Vector, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
      corners[i] = Vector(cube.points[i]);
    EXPECT_LE(hexahedron.lower, tubular::internal::scaled_jacobian<8>(corners) + 1e-9);
    EXPECT_GT(hexahedron.lower, 0);
  }
  std::mt19937 none(1);
  EXPECT_NEAR(
      tubular::scaled_jacobian_bounds(tubular::straight_quadratic_mesh(one_cell(Element_type::hexahedron, 0, none)),
                                      Element_type::hexahedron, 0)
          .lower,
      1, 1e-9);
}

// --- what corners do not show ---

TEST(Quadratic_bounds, A_cell_that_folds_between_its_nodes_is_found) {
  std::mt19937 random(2);
  for (Element_type type : cell_types) {
    // an edge's node goes toward the far side, by bisection as far as the cell is still valid
    Quadratic_mesh mesh = tubular::straight_quadratic_mesh(one_cell(type, 0, random));
    const std::size_t e = mesh.edge(0, 1);
    const Point_3 straight = mesh.edge_points[e];
    const auto at = [&](double t) {
      mesh.edge_points[e] = Point_3(straight.x(), straight.y() + t, straight.z() + 0.5 * t);
      return tubular::scaled_jacobian_bounds(mesh, type, 0, 0.05);
    };
    EXPECT_GT(at(0).lower, 0);
    EXPECT_LE(at(0.9).upper, 0);
    double good = 0, bad = 0.9;
    for (int i = 0; i < 12; ++i) {
      const double t = (good + bad) / 2;
      (at(t).lower > 0 ? good : bad) = t;
    }
    // just before and behind, as samples see it
    at(good - 0.02);
    EXPECT_GT(least_of_samples(element_of(mesh, type), type, 16).determinant, 0) << int(type);
    EXPECT_TRUE(tubular::quality_report(mesh, 1).is_valid());
    at(bad + 0.02);
    EXPECT_LT(least_of_samples(element_of(mesh, type), type, 24).scaled, 0.02) << int(type);
    EXPECT_EQ(tubular::quality_report(mesh, 1).invalid, 1u) << int(type);
  }
}

TEST(Quadratic_bounds, Do_not_depend_on_place_size_and_numbering_of_cells) {
  std::mt19937 random(11);
  for (Element_type type : cell_types) {
    Quadratic_mesh mesh = tubular::straight_quadratic_mesh(one_cell(type, 0.05, random), true);
    bend(mesh, 0.05, random);
    const auto before = tubular::scaled_jacobian_bounds(mesh, type, 0, 0.01);
    const auto moved = [](const Point_3& p) { // by a turn about z, a factor and a shift
      return Point_3(1e-3 * (0.6 * p.x() - 0.8 * p.y()) + 4, 1e-3 * (0.8 * p.x() + 0.6 * p.y()) - 2, 1e-3 * p.z());
    };
    for (auto* points : {&mesh.linear.points, &mesh.edge_points, &mesh.quad_points, &mesh.inner_points})
      for (Point_3& p : *points)
        p = moved(p);
    const auto after = tubular::scaled_jacobian_bounds(mesh, type, 0, 0.01);
    EXPECT_NEAR(before.lower, after.lower, 1e-6);
    EXPECT_NEAR(before.upper, after.upper, 1e-6);
  }
}

} // namespace

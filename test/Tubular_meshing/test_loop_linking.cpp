// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "looped_surfaces.h"
#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/internal/Loop_linking.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Surface_loops.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace {

using namespace looped_surfaces;
using namespace test_surfaces;
namespace internal = CGAL::Tubular_meshing::internal;
using internal::Loop_linking;
typedef std::vector<Loop_linking::Point> Line;

// A circle of n points round a center, between two directions at right angles.
Line circle(const Vector& center, const Vector& u, const Vector& v, int turns = 1, int n = 60) {
  Line result;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * turns * i / n;
    const Vector x = center + std::cos(angle) * u + std::sin(angle) * v;
    result.emplace_back(x.x(), x.y(), x.z());
  }
  return result;
}

Loop_linking::Numbers numbers(const Loop_linking& linking, const Line& line) {
  Loop_linking::Numbers result(linking.number_of_loops(), 0);
  for (std::size_t i = 0; i < line.size(); ++i)
    linking.add(line[i], line[(i + 1) % line.size()], 1, result);
  return result;
}

// With a fan in each opening.
Mesh closed(Mesh mesh) {
  const std::vector<Mesh::Halfedge_index> all(mesh.halfedges().begin(), mesh.halfedges().end());
  for (auto h : all)
    if (mesh.is_border(h)) {
      Vector sum(0, 0, 0);
      double n = 0;
      for (auto v : mesh.vertices_around_face(h)) {
        sum = sum + (mesh.point(v) - CGAL::ORIGIN);
        n += 1;
      }
      CGAL::Euler::fill_hole(h, mesh);
      mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) = CGAL::ORIGIN + sum / n;
    }
  EXPECT_TRUE(CGAL::is_closed(mesh));
  return mesh;
}

const Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

TEST(Loop_linking, Counts_how_often_circles_go_round_each_other) {
  for (double scale : {1e-6, 1., 1e6}) {
    const Loop_linking linking(
        {circle(Vector(0, 0, 0), scale * x, scale * y), circle(5 * scale * x, scale * x, scale * y)});
    const auto linked = numbers(linking, circle(scale * x, scale * x, scale * z));
    EXPECT_EQ(std::abs(linked[0]), 1);
    EXPECT_EQ(linked[1], 0);
    EXPECT_EQ(numbers(linking, circle(scale * x, scale * x, -scale * z))[0], -linked[0]);
    EXPECT_EQ(numbers(linking, circle(scale * x, scale * x, scale * z, 3))[0], 3 * linked[0]);
    EXPECT_EQ(numbers(linking, circle(scale * z, scale * x, scale * y))[0], 0); // above it
    EXPECT_EQ(numbers(linking, circle(Vector(0, 0, 0), 0.5 * scale * x, 0.5 * scale * z))[0], 0);
  }
}

TEST(Surface_loops, Are_twice_as_many_as_handles) {
  EXPECT_TRUE(internal::Surface_loops(make_sphere(8, 12)).loops().empty());
  for (int rings : {1, 3}) {
    Mesh mesh = closed(chain_of_rings(rings, 0.2));
    EXPECT_EQ(internal::Surface_loops(mesh).loops().size(), std::size_t(2 * rings));
    // pieces count on their own
    mesh += transformed(mesh, Transformation(CGAL::TRANSLATION, Vector(10, 0, 0)));
    EXPECT_EQ(internal::Surface_loops(mesh).loops().size(), std::size_t(4 * rings));
  }
}

TEST(Surface_loops, Are_linked_with_what_goes_round_inside) {
  const Mesh mesh = closed(chain_of_rings(2, 0.2));
  std::vector<Line> loops;
  const internal::Surface_loops found(mesh);
  for (const auto& loop : found.loops()) {
    loops.emplace_back();
    for (auto v : loop) {
      EXPECT_TRUE(mesh.is_valid(v));
      loops.back().push_back(internal::to_double_point(mesh.point(v)));
    }
  }
  const Loop_linking linking(loops);
  internal::Independent_numbers independent;
  for (double center : {-2., 2.})
    EXPECT_TRUE(independent.add(numbers(linking, circle(center * z, 1.3 * x, 1.3 * z))));
  EXPECT_EQ(independent.size(), 2u);
  // round a section, and along a way and back
  const Loop_linking::Numbers none(loops.size(), 0);
  EXPECT_EQ(numbers(linking, circle(3.3 * z, 0.2 * x, 0.2 * y)), none);
  EXPECT_EQ(numbers(linking, circle(0 * z, 0.1 * x, 0.9 * z)), none);
}

TEST(Independent_numbers, Are_no_sums_of_each_other) {
  internal::Independent_numbers numbers;
  EXPECT_FALSE(numbers.add({0, 0, 0}));
  EXPECT_TRUE(numbers.add({1, -2, 0}));
  EXPECT_FALSE(numbers.add({-3, 6, 0}));
  EXPECT_TRUE(numbers.add({1, 0, 5}));
  EXPECT_FALSE(numbers.add({0, 2, 5}));
  EXPECT_TRUE(numbers.add({0, 0, 7}));
  EXPECT_FALSE(numbers.add({1, 1, 1}));
}

} // namespace

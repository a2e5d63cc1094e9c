// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Delaunay triangulations that are made in parts are those that insertion makes.

#include <CGAL/Tubular_meshing/base/Delaunay_in_parts.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/number_type_basic.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>,
                                             CGAL::Delaunay_triangulation_cell_base_3<Kernel>>
    Data_structure;
typedef CGAL::Delaunay_triangulation_3<Kernel, Data_structure> Delaunay;
typedef CGAL::Tubular_meshing::internal::Delaunay_in_parts<Delaunay> In_parts;

// The corners of all cells, in order; that of infinite ones last, as a number that no point has.
std::vector<std::array<std::uint32_t, 4>> cells_of(const Delaunay& delaunay) {
  std::vector<std::array<std::uint32_t, 4>> result;
  for (auto c = delaunay.all_cells_begin(); c != delaunay.all_cells_end(); ++c) {
    result.emplace_back();
    for (int k = 0; k < 4; ++k)
      result.back()[std::size_t(k)] =
          c->vertex(k) == delaunay.infinite_vertex() ? std::uint32_t(-1) : c->vertex(k)->info();
    std::sort(result.back().begin(), result.back().end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_the_same(const std::vector<Kernel::Point_3>& points) {
  In_parts::Samples samples;
  for (std::size_t i = 0; i < points.size(); ++i)
    samples.emplace_back(points[i], std::uint32_t(i));
  Delaunay whole;
  In_parts::Samples copy = samples;
  In_parts::triangulate(copy, 1, 1, whole);
  const auto expected = cells_of(whole);
  for (int parts : {2, 4}) {
    copy = samples;
    Delaunay joined;
    In_parts::triangulate(copy, parts, 0, joined);
    EXPECT_EQ(joined.number_of_vertices(), points.size());
    EXPECT_TRUE(cells_of(joined) == expected) << parts;
    EXPECT_TRUE(joined.tds().is_valid()) << parts;
    // that it can be changed
    const auto v = joined.insert(Kernel::Point_3(0.501, 0.502, 0.503));
    EXPECT_EQ(joined.number_of_vertices(), points.size() + 1);
    joined.remove(v);
    EXPECT_TRUE(cells_of(joined) == expected) << parts;
  }
}

TEST(Delaunay_in_parts, Of_random_points) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Kernel::Point_3> points;
  for (int i = 0; i < 45000; ++i) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    points.emplace_back(x, 2 * y, z);
  }
  expect_the_same(points);
}

// Eight points on each sphere, and many in the plane of the cut.
TEST(Delaunay_in_parts, Of_a_lattice) {
  std::vector<Kernel::Point_3> points;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 34; ++j)
      for (int k = 0; k < 33; ++k)
        points.emplace_back(i, j, k);
  expect_the_same(points);
}

// As of vessels: all cells outside are large.
TEST(Delaunay_in_parts, Of_a_bent_tube) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> turn(0, 2 * CGAL_PI);
  std::vector<Kernel::Point_3> points;
  for (int i = 0; i < 45000; ++i) {
    const double s = turn(random) / 2, t = turn(random), r = 1 + 0.1 * std::cos(t);
    points.emplace_back(r * std::cos(s), r * std::sin(s), 0.1 * std::sin(t));
  }
  expect_the_same(points);
}

// One half has no cells of its own.
TEST(Delaunay_in_parts, Of_a_plane_and_points_beside_it) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Kernel::Point_3> points;
  for (int i = 0; i < 12000; ++i) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    points.emplace_back(0, y, z);
    points.emplace_back(2 + x, y, z);
  }
  expect_the_same(points);
}

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The report on layers at the wall, on a block of flat tetrahedra beside a straight centerline.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Quality/boundary_layer_report.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include "grid_of_tetrahedra.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Tubular_meshing::Mixed_mesh Mesh;
typedef CGAL::Tubular_meshing::Centerline_graph Graph;
typedef CGAL::Tubular_meshing::Metric_tensor_3 Metric;
namespace tubular = CGAL::Tubular_meshing;

const int n = 4;
const double height = 0.05, around = 0.2, along = 0.6;

/* n × n × n boxes of six tetrahedra, long in x and flat in z; the wall is at z = 0. If `lifted`, the last row of
 * points above the wall is nearly at twice its height; all points are turned about z by `angle`. */
Mesh block(bool lifted = false, double angle = 0) {
  return grid_of_tetrahedra(
      {n, n, n},
      [&](int i, int j, int k) {
        const double x = along * i, y = around * j, z = height * (lifted && k == 1 && j == n ? 1.95 : k);
        return Point(std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y, z);
      },
      [](int axis, int end) { return axis == 2 && end == 0 ? tubular::labels::wall : 0; });
}

void set_metric(Mesh& m, double h_x, double h_y, double h_z) {
  tubular::Point_array array{"metric", 6, {}};
  for (std::size_t v = 0; v < m.points.size(); ++v)
    for (double component : Metric(1 / (h_x * h_x), 0, 0, 1 / (h_y * h_y), 0, 1 / (h_z * h_z)).components())
      array.values.push_back(component);
  m.point_arrays.assign(1, array);
}

// Along x, far above the block; with a side branch far away, or over its middle.
Graph line(bool branches_here = false) {
  const double x = branches_here ? 1.2 : 40;
  return Graph({Point(-50, 0.4, 3), Point(x, 0.4, 3), Point(60, 0.4, 3), Point(x, 0.4, 30)}, std::vector<double>(4, 3.),
               {{0, 1}, {1, 2}, {1, 3}});
}

TEST(Boundary_layer_report, First_heights_are_those_of_the_layer) {
  Mesh m = block();
  set_metric(m, along, around, height);
  const auto r = tubular::boundary_layer_report(m, line());
  EXPECT_EQ(r.first_height.count(), std::size_t((n + 1) * (n + 1)));
  EXPECT_NEAR(r.first_height.min(), 1, 1e-12);
  EXPECT_NEAR(r.first_height.max(), 1, 1e-12);
  EXPECT_EQ(r.share_of_first_heights(), 1);
  // asked for is the smallest size
  set_metric(m, along, around, height / 2);
  EXPECT_NEAR(tubular::boundary_layer_report(m, line()).first_height.mean(), 2, 1e-12);
}

TEST(Boundary_layer_report, Tells_where_the_layer_is_too_high) {
  Mesh m = block(true);
  set_metric(m, along, around, height);
  const auto r = tubular::boundary_layer_report(m, line());
  EXPECT_NEAR(r.first_height.min(), 1, 1e-12);
  EXPECT_NEAR(r.first_height.max(), 1.95, 1e-12);
  // the last row, and the one beside it, where facets on either side have tetrahedra of either height
  EXPECT_NEAR(r.share_of_first_heights(), (n - 1.) / (n + 1), 1e-12);
  EXPECT_EQ(r.share_of_first_heights(1), 1);
}

TEST(Boundary_layer_report, Long_edges_are_measured_against_the_centerline) {
  for (double degrees : {0., 10., 30.}) {
    Mesh m = block(false, degrees * std::acos(-1.) / 180);
    set_metric(m, along * 0.99, around, height);
    const auto r = tubular::boundary_layer_report(m, line());
    ASSERT_GT(r.alignment.count(), 0u);
    // edges along the boxes, and their diagonals, which are longer still
    const double diagonal = std::atan(std::hypot(around, height) / along) * 180 / std::acos(-1.);
    EXPECT_NEAR(r.alignment.min(), degrees, 1e-6);
    EXPECT_LE(r.alignment.max(), degrees + diagonal + 1e-6);
  }
}

TEST(Boundary_layer_report, Leaves_out_what_has_no_direction) {
  Mesh m = block();
  set_metric(m, along, along / 1.9, height); // not even twice as long
  EXPECT_EQ(tubular::boundary_layer_report(m, line()).alignment.count(), 0u);
  set_metric(m, along * 0.99, around, height);
  EXPECT_GT(tubular::boundary_layer_report(m, line()).alignment.count(), 0u);
  EXPECT_EQ(tubular::boundary_layer_report(m, line(true)).alignment.count(), 0u);
}

TEST(Boundary_layer_report, Does_not_depend_on_the_number_of_threads) {
  Mesh m = block(true, 0.3);
  set_metric(m, along * 0.99, around, height);
  const auto report = [&](int threads) {
    return tubular::boundary_layer_report(m, line(), tubular::parameters::number_of_threads(threads));
  };
  const auto one = report(1);
  for (int threads : {0, 2, 4}) {
    const auto r = report(threads);
    for (auto measure : {&tubular::Boundary_layer_report::first_height, &tubular::Boundary_layer_report::alignment}) {
      EXPECT_EQ((r.*measure).count(), (one.*measure).count());
      EXPECT_EQ((r.*measure).mean(), (one.*measure).mean());
      for (double percent : {0., 30., 50., 100.})
        EXPECT_EQ((r.*measure).percentile(percent), (one.*measure).percentile(percent));
    }
  }
}

TEST(Boundary_layer_report, Needs_a_metric) {
  const Mesh m = block();
  EXPECT_THROW(tubular::boundary_layer_report(m, line()), tubular::Input_error);
  Mesh with = block();
  set_metric(with, along, around, height);
  EXPECT_THROW(tubular::boundary_layer_report(with, Graph()), tubular::Input_error);
}

} // namespace

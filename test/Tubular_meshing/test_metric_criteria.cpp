// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The metric criteria of Mesh_3, on a triangulation of one cell. Whole meshes are made by the example.

#include <CGAL/Tubular_meshing/Fields/Metric_criteria_3.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

namespace tubular = CGAL::Tubular_meshing;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Polyhedral_mesh_domain_3<CGAL::Surface_mesh<Point>, Kernel> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
typedef Triangulation::Geom_traits::Weighted_point_3 Weighted_point;
typedef CGAL::Mesh_cell_criteria_3<Triangulation> Cell_criteria;
typedef CGAL::Mesh_facet_criteria_3<Triangulation> Facet_criteria;

// Size `h` along x, 1 across.
struct Flat_field {
  typedef Point Point_3;
  double h;
  tubular::Metric_tensor_3 operator()(const Point&) const { return {1 / (h * h), 0, 0, 1, 0, 1}; }
};
typedef tubular::Metric_cell_criteria_3<Triangulation, Flat_field> Metric_cell_criteria;
typedef tubular::Metric_facet_criteria_3<Triangulation, Flat_field> Metric_facet_criteria;

// A corner of the unit cube: edges of 1 along the axes, three of √2, circumradius √3/2.
class Metric_criteria : public ::testing::Test {
protected:
  Triangulation tr;
  Triangulation::Cell_handle cell;

  void SetUp() override {
    for (const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)})
      tr.insert(Weighted_point(p))->set_dimension(2);
    cell = tr.finite_cells_begin();
    for (int i = 0; i < 4; ++i)
      cell->vertex(i)->set_index(Domain::Surface_patch_index(0, 1));
  }

  Triangulation::Facet facet_without(const Point& p) const {
    for (int i = 0; i < 4; ++i)
      if (cell->vertex(i)->point().point() == p)
        return {cell, i};
    return {cell, -1};
  }

  bool is_bad(const Flat_field& field, const tubular::Metric_size_bounds& bounds) const {
    return bool(Metric_cell_criteria(Cell_criteria(0, 0), field, bounds)(tr, cell));
  }
};

TEST_F(Metric_criteria, Cells_are_measured_in_the_metric) {
  const double diagonal = std::sqrt(2.), radius = std::sqrt(3.) / 2;
  const Flat_field unit = {1}, flat = {0.5};
  EXPECT_FALSE(is_bad(unit, {1.001 * diagonal, 0}));
  EXPECT_TRUE(is_bad(unit, {0.999 * diagonal, 0}));
  EXPECT_FALSE(is_bad(unit, {0, 1.001 * radius}));
  EXPECT_TRUE(is_bad(unit, {0, 0.999 * radius}));
  EXPECT_FALSE(is_bad(flat, {1.001 * std::sqrt(5.), 0})); // from (1, 0, 0) to (0, 1, 0)
  EXPECT_TRUE(is_bad(flat, {0.999 * std::sqrt(5.), 0}));
  EXPECT_FALSE(is_bad(flat, {0, 1.001 * std::sqrt(6.) / 2}));
  EXPECT_TRUE(is_bad(flat, {0, 0.999 * std::sqrt(6.) / 2}));
  EXPECT_FALSE(is_bad({1e-6}, {0, 0})); // nothing is asked for
}

TEST_F(Metric_criteria, Larger_cells_come_first) {
  const Flat_field a = {0.5}, b = {0.1};
  const auto of_a = Metric_cell_criteria(Cell_criteria(0, 0), a)(tr, cell);
  const auto of_b = Metric_cell_criteria(Cell_criteria(0, 0), b)(tr, cell);
  ASSERT_TRUE(of_a && of_b);
  EXPECT_LT(*of_b, *of_a);
}

TEST_F(Metric_criteria, Cgals_own_criteria_come_before) {
  const Flat_field field = {0.5};
  const auto by_size = Metric_cell_criteria(Cell_criteria(0, 0.1), field)(tr, cell);
  const auto by_metric = Metric_cell_criteria(Cell_criteria(0, 0), field)(tr, cell);
  ASSERT_TRUE(by_size && by_metric);
  EXPECT_EQ(*by_size, *Cell_criteria(0, 0.1)(tr, cell));
  EXPECT_LT(*by_size, *by_metric);
}

TEST_F(Metric_criteria, Facets_are_measured_in_the_metric) {
  const Flat_field flat = {0.5};
  const auto is_bad_facet = [&](const Point& without, const tubular::Metric_size_bounds& bounds) {
    return bool(Metric_facet_criteria(Facet_criteria(0, 0, 0), flat, bounds)(tr, facet_without(without)));
  };
  const Point x(1, 0, 0), y(0, 1, 0); // x: the facet lies across the x-axis
  EXPECT_FALSE(is_bad_facet(x, {1.001 * std::sqrt(2.), 0}));
  EXPECT_TRUE(is_bad_facet(x, {0.999 * std::sqrt(2.), 0}));
  EXPECT_FALSE(is_bad_facet(y, {1.001 * std::sqrt(5.), 0}));
  EXPECT_TRUE(is_bad_facet(y, {0.999 * std::sqrt(5.), 0}));
  EXPECT_FALSE(is_bad_facet(y, {0, 1.001 * std::sqrt(5.) / 2})); // half of the hypotenuse
  EXPECT_TRUE(is_bad_facet(y, {0, 0.999 * std::sqrt(5.) / 2}));
}

TEST_F(Metric_criteria, Refuses_senseless_bounds) {
  const double inf = std::numeric_limits<double>::infinity();
  for (double bad : {-1., std::nan(""), inf}) {
    EXPECT_THROW(is_bad({1}, {bad, 0}), tubular::Parameter_error);
    EXPECT_THROW(is_bad({1}, {0, bad}), tubular::Parameter_error);
  }
}

} // namespace

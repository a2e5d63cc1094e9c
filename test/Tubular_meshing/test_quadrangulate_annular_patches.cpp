// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Grids on the annular patches of cut trees: the numbers of points on curves, that grids share them, and their quality.

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Quads/quadrangulate_annular_patches.h>
#include <CGAL/Tubular_meshing/Quality/shape_measures.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using namespace test_surfaces;
namespace tubular = CGAL::Tubular_meshing;

const double pi = 3.14159265358979323846;

struct Cut_tree {
  tubular::Tubular_model model;
  tubular::Surface_cut cut;
  std::vector<tubular::Patch_parameterization> maps;

  explicit Cut_tree(const tubular::Tubular_skeleton& skeleton, double points = 24) {
    Mesh mesh;
    tubular::generate_tubular_surface(skeleton, mesh, tubular::parameters::points_per_circumference(points));
    model = tubular::make_tubular_model(mesh, tubular::centerlines_of(skeleton));
    cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
    maps = tubular::parameterize_patches(model.surface, cut);
  }

  template <class Size> tubular::Annular_quads quads(const Size& size, int threads = 0) const {
    return tubular::quadrangulate_annular_patches(model.surface, cut, maps, size,
                                                  tubular::parameters::number_of_threads(threads));
  }
  bool is_tube(std::size_t k) const { return cut.patches[k].loops.size() == 2; }
};

auto constant(double h) {
  return [h](const Point&) { return h; };
}

// The worst and the mean quality.
std::array<double, 2> quality(const tubular::Annular_quads& quads) {
  double least = 1, sum = 0;
  std::size_t n = 0;
  for (const auto& grid : quads.grids)
    for (const auto& q : grid.quads()) {
      const double eta = tubular::quad_eta(
          std::array<Point, 4>{{grid.points[q[0]], grid.points[q[1]], grid.points[q[2]], grid.points[q[3]]}});
      least = (std::min)(least, eta);
      sum += eta;
      ++n;
    }
  return {{least, sum / double(n)}};
}

// Relative to the distance of two points.
double farthest_from_locations(const tubular::Elliptic_grid& grid, const tubular::Patch_parameterization& map) {
  double far = 0;
  for (std::size_t i = 0; i < grid.points.size(); ++i)
    far = (std::max)(far, CGAL::squared_distance(grid.points[i], map.point(grid.locations[i])));
  return grid.points.empty() ? 0 : std::sqrt(far / CGAL::squared_distance(grid.points[0], grid.points[1]));
}

void expect_grids_on_tubes(const Cut_tree& tree, const tubular::Annular_quads& quads) {
  ASSERT_EQ(quads.grids.size(), tree.cut.patches.size());
  ASSERT_EQ(quads.curve_points.size(), tree.cut.curves.size());
  for (const auto& points : quads.curve_points)
    EXPECT_EQ(points.size() % 2, 0u);
  for (std::size_t k = 0; k < quads.grids.size(); ++k) {
    const auto& grid = quads.grids[k];
    EXPECT_LT(farthest_from_locations(grid, tree.maps[k]), 1e-10);
    EXPECT_EQ(grid.rows > 0, tree.is_tube(k));
    if (!tree.is_tube(k))
      continue;
    for (std::size_t l = 0; l < 2; ++l) {
      const auto& curve = quads.curve_points[tree.cut.patches[k].loops[l].curve];
      EXPECT_EQ(curve.size(), grid.columns);
      const std::set<Point> expected(curve.begin(), curve.end());
      const auto first = grid.points.begin() + std::ptrdiff_t(l * grid.rows * grid.columns);
      EXPECT_EQ(std::set<Point>(first, first + std::ptrdiff_t(grid.columns)), expected);
      EXPECT_EQ(expected.size(), grid.columns);
    }
  }
}

TEST(Quadrangulate_annular_patches, Of_a_long_tube_is_one_grid_without_twist) {
  const Cut_tree tree(tubular::straight_tube(20, 1), 60); // a tube nearly round
  ASSERT_GE(tree.cut.patches.size(), 3u);
  const auto quads = tree.quads(constant(2 * pi / 20));
  expect_grids_on_tubes(tree, quads);
  std::size_t rows = 0;
  for (const auto& grid : quads.grids) {
    EXPECT_EQ(grid.columns, 20u);
    rows += grid.rows;
    for (std::size_t i = 0; i < grid.columns; ++i) { // columns run along the tube
      const auto along = grid.points[grid.rows * grid.columns + i] - grid.points[i];
      EXPECT_GT(std::abs(along.z()), 0.998 * std::sqrt(along.squared_length()));
    }
  }
  EXPECT_NEAR(double(rows), 20 / (2 * pi / 20), 2);
  EXPECT_GT(quality(quads)[0], 0.9);
  EXPECT_GT(quality(quads)[1], 0.97);
}

TEST(Quadrangulate_annular_patches, Has_good_quads_on_trees) {
  for (const auto& skeleton : {tubular::y_bifurcation(), tubular::aortic_arch()}) {
    const Cut_tree tree(skeleton);
    const tubular::Centerline_field centerlines(tree.model.centerlines);
    const auto size = [&](const Point& p) { return 2 * pi / 24 * centerlines.descriptors(p).radius; };
    const auto quads = tree.quads(size);
    expect_grids_on_tubes(tree, quads);
    const auto eta = quality(quads);
    EXPECT_GT(eta[0], 0.6);
    EXPECT_GT(eta[1], 0.92);
  }
}

TEST(Quadrangulate_annular_patches, Does_not_depend_on_threads) {
  const Cut_tree tree(tubular::y_bifurcation());
  const auto one = tree.quads(constant(0.2), 1), several = tree.quads(constant(0.2), 4);
  EXPECT_EQ(one.curve_points, several.curve_points);
  for (std::size_t k = 0; k < one.grids.size(); ++k)
    EXPECT_EQ(one.grids[k].points, several.grids[k].points);
}

TEST(Quadrangulate_annular_patches, Refuses_maps_of_something_else) {
  Cut_tree tree(tubular::straight_tube(6, 1));
  tree.maps.pop_back();
  EXPECT_THROW(tree.quads(constant(0.3)), tubular::Input_error);
}

} // namespace

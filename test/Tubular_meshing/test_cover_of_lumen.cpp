// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Hexahedra along vessels that part slowly: they fill the lumen, all of it and once.

#include "hexahedral_shapes.h"

#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Hexahedron_overlaps.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace parameters = tubular::parameters;
using tubular::Mixed_mesh;
using tubular::Point_3;
using tubular::internal::pi;
using tubular::internal::Vector_3d;

std::size_t overlaps(const Mixed_mesh& mesh) {
  std::vector<std::uint32_t> all(mesh.hexahedra.size());
  std::iota(all.begin(), all.end(), 0);
  return tubular::internal::Hexahedron_overlaps(mesh, all).count();
}

std::array<Vector_3d, 8> corners(const Mixed_mesh& mesh, std::size_t h) {
  std::array<Vector_3d, 8> p;
  for (std::size_t k = 0; k < 8; ++k)
    p[k] = Vector_3d(mesh.points[mesh.hexahedra.vertices[h][k]]);
  return p;
}

double least_scaled_jacobian(const Mixed_mesh& mesh) {
  double least = 1;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    least = (std::min)(least, tubular::internal::scaled_jacobian<8>(corners(mesh, h)));
  return least;
}

// --- what is found ---

// A bar bent to an arc: past a full circle its ends are in the same place, though no hexahedron is inverted.
Mixed_mesh bent_bar(double degrees) {
  Mixed_mesh mesh = hexahedral_shapes::box_grid({60, 4, 4}, {1, 1, 1});
  for (Point_3& p : mesh.points) {
    const double angle = p.x() * degrees * pi / 180, r = 3 + p.y();
    p = Point_3(r * std::sin(angle), r * std::cos(angle), p.z());
  }
  return mesh;
}

TEST(Hexahedron_overlaps, Are_found_where_a_bar_meets_itself) {
  for (const double degrees : {200., 300., 359.})
    EXPECT_EQ(overlaps(bent_bar(degrees)), 0u) << degrees;
  for (const double degrees : {400., 450.}) {
    const Mixed_mesh mesh = bent_bar(degrees);
    EXPECT_GT(least_scaled_jacobian(mesh), 0.5);
    // of the 960, those of the part that is there twice
    const double expected = 2 * 960 * (degrees - 360) / degrees;
    EXPECT_NEAR(double(overlaps(mesh)), expected, 0.2 * expected + 40) << degrees;
  }
}

TEST(Hexahedron_overlaps, Are_not_between_neighbors) {
  Mixed_mesh mesh = hexahedral_shapes::box_grid({9, 9, 9}, {9, 9, 9});
  hexahedral_shapes::shake_box(mesh, 0.2, {9, 9, 9});
  EXPECT_GT(least_scaled_jacobian(mesh), 0);
  EXPECT_EQ(overlaps(mesh), 0u);
}

TEST(Inside_of_a_hexahedron, Is_where_its_bilinear_faces_have_it) {
  using tubular::internal::is_inside_of_hexahedron;
  const std::array<Vector_3d, 8> h = {
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 2}, {0, 1, 1}}};
  EXPECT_TRUE(is_inside_of_hexahedron(h, Vector_3d(0.5, 0.5, 1.2))); // its upper face is at 1 + x y
  EXPECT_FALSE(is_inside_of_hexahedron(h, Vector_3d(0.5, 0.5, 1.3)));
  EXPECT_TRUE(is_inside_of_hexahedron(h, Vector_3d(0.9, 0.9, 1.75)));
  EXPECT_FALSE(is_inside_of_hexahedron(h, Vector_3d(0.5, 0.5, -0.01)));
  EXPECT_FALSE(is_inside_of_hexahedron(h, Vector_3d(-20, 3, 7)));
  std::array<Vector_3d, 8> inverted = h;
  std::swap_ranges(inverted.begin(), inverted.begin() + 4, inverted.begin() + 4);
  EXPECT_FALSE(is_inside_of_hexahedron(inverted, Vector_3d(0.5, 0.5, 0.5)));
}

// --- vessels that part slowly ---

struct Parting {
  std::string name;
  int branches;
  double degrees; // between neighbors
  double ratio;   // of the trunk's branches' radii
  int points;     // round the tubes of the surface
  double scale;
  bool is_turned;
  bool lines_are_given;

  /* Branches round the axis of a trunk, turned by some angles and scaled. */
  tubular::Tubular_skeleton skeleton() const {
    const double a = degrees * pi / 360, length = 3 + 2 / std::tan(a);
    std::vector<Vector_3d> directions = {{0, -1, 0}};
    for (int i = 0; i < branches; ++i) {
      const double b = 2 * pi * i / branches, across = std::sin(a) / std::sin(pi / branches);
      directions.emplace_back(across * std::cos(b), std::sqrt(1 - across * across), across * std::sin(b));
    }
    tubular::Tubular_skeleton result;
    result.nodes.push_back(Point_3(0, 0, 0));
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vector_3d end = (i == 0 ? 5. : length) * turned(directions[i]);
      const double radius = scale * (i == 0 ? 1 : i % 2 == 0 ? 0.8 / ratio : 0.8);
      result.nodes.push_back(Point_3(scale * end.x, scale * end.y, scale * end.z));
      result.add_branch(
          0, i + 1, [&](double t) { return Point_3(t * scale * end.x, t * scale * end.y, t * scale * end.z); },
          [&](double) { return radius; });
    }
    result.inlet = 1;
    return result;
  }

  tubular::Tubular_model model() const {
    const auto s = skeleton();
    tubular::Surface surface;
    tubular::generate_tubular_surface(s, surface, parameters::points_per_circumference(points));
    return lines_are_given ? tubular::make_tubular_model(surface, tubular::centerlines_of(s))
                           : tubular::make_tubular_model(surface);
  }

private:
  Vector_3d turned(const Vector_3d& d) const {
    if (!is_turned)
      return d;
    const Vector_3d u = normalized(Vector_3d(1, 2, -0.5)), v = normalized(cross(u, Vector_3d(0.3, 1, 2)));
    return d.x * u + d.y * v + d.z * cross(u, v);
  }
};
std::ostream& operator<<(std::ostream& out, const Parting& p) {
  return out << p.name;
}

class Slow_partings : public ::testing::TestWithParam<Parting> {};

/* The volume of the blocks, before it is corrected, is the lumen's but for what facets cut off: 1.1 % of a tube of 24
 * points. Where two vessels overlapped, it would be more. */
TEST_P(Slow_partings, Have_blocks_that_fill_the_lumen_once) {
  const auto model = GetParam().model();
  tubular::Mesher_options options(parameters::points_per_circumference(24));
  options.preserve_volume = false;
  options.hexahedral_fallback = tubular::Hexahedral_fallback::none;
  tubular::Mesher mesher(model, options);
  const Mixed_mesh mesh = mesher.hexahedral();
  EXPECT_EQ(mesher.report().hexahedral.method, tubular::Hexahedral_method::blocks);
  EXPECT_EQ(tubular::validity_report(mesh).defects(), "");
  EXPECT_GT(least_scaled_jacobian(mesh), 0.15);
  EXPECT_EQ(overlaps(mesh), 0u);
  const double volume = tubular::lumen_measures(mesh, model.openings.size()).volume;
  const double of_surface = CGAL::Polygon_mesh_processing::volume(model.surface);
  EXPECT_LT(volume, 1.001 * of_surface);
  EXPECT_GT(volume, 0.98 * of_surface);
}

INSTANTIATE_TEST_SUITE_P(
    Vessels, Slow_partings,
    ::testing::Values(Parting{"Y_of_10_degrees", 2, 10, 1, 30, 1, false, true},
                      Parting{"Y_of_15_degrees", 2, 15, 1, 30, 1000, true, true},
                      Parting{"Y_of_15_degrees_and_ratio_2_coarse", 2, 15, 2, 12, 1e-3, true, false},
                      Parting{"Y_of_20_degrees_and_ratio_15_tenths_coarse", 2, 20, 1.5, 10, 1, true, true},
                      Parting{"Y_of_25_degrees_and_ratio_3", 2, 25, 3, 30, 1, true, false},
                      Parting{"Four_of_20_degrees_and_given_lines", 4, 20, 1, 30, 1, false, true},
                      Parting{"Four_of_20_degrees", 4, 20, 1, 16, 10, true, false},
                      Parting{"Five_of_30_degrees", 5, 30, 1, 24, 1, true, false}),
    [](const auto& info) { return info.param.name; });

} // namespace

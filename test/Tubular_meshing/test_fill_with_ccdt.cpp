// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Filling by CGAL's constrained triangulation, and its points on the surface that are brought inside.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/ccdt/Steiner_points_inside.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include "test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace {

namespace tubular = CGAL::Tubular_meshing;
using test_surfaces::Point;
using tubular::internal::Steiner_points_inside;
using tubular::internal::Vector_3d;
typedef CGAL::Surface_mesh<Point> Surface;

struct Constant_size {
  double h;
  template <class P, class Index> double operator()(const P&, int, const Index&) const { return h; }
};

double volume(const Steiner_points_inside& a, double& least) {
  double sum = 0;
  least = 1;
  for (const auto& t : a.tetrahedra) {
    const double v = tubular::internal::signed_volume(a.points[t[0]], a.points[t[1]], a.points[t[2]], a.points[t[3]]);
    sum += v;
    least = std::min(least, v);
  }
  return sum;
}

// The facets of the tetrahedron 0123 with the points of `a` from 4 on: those of the surface, turned as they were.
void expect_facets_of_a_tetrahedron(const Steiner_points_inside& a) {
  std::set<std::array<std::uint32_t, 3>> facets;
  for (const auto& f : a.facets) {
    auto v = f.v;
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    facets.insert(v);
  }
  const std::set<std::array<std::uint32_t, 3>> expected = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  EXPECT_EQ(facets, expected);
  EXPECT_EQ(a.facets.size(), 4u);
  double least;
  EXPECT_NEAR(volume(a, least), 1 / 6., 1e-14);
  EXPECT_GT(least, 1e-4);
}

TEST(Steiner_points_inside, Takes_a_point_off_an_edge) {
  Steiner_points_inside a;
  a.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.4, 0, 0}};
  a.tetrahedra = {{0, 4, 2, 3}, {4, 1, 2, 3}};
  a.facets = {{{1, 2, 3}, 0}, {{0, 3, 2}, 1}, {{0, 4, 3}, 2}, {{4, 1, 3}, 2}, {{0, 2, 4}, 3}, {{4, 2, 1}, 3}};
  ASSERT_TRUE(a.run(4));
  EXPECT_EQ(a.tetrahedra.size(), 4u);
  expect_facets_of_a_tetrahedron(a);
}

TEST(Steiner_points_inside, Takes_several_points_off_one_edge) {
  Steiner_points_inside a;
  a.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.3, 0, 0}, {0.6, 0, 0}};
  a.tetrahedra = {{0, 4, 2, 3}, {4, 5, 2, 3}, {5, 1, 2, 3}};
  a.facets = {{{1, 2, 3}, 0}, {{0, 3, 2}, 1}, {{0, 4, 3}, 2}, {{4, 5, 3}, 2},
              {{5, 1, 3}, 2}, {{0, 2, 4}, 3}, {{4, 2, 5}, 3}, {{5, 2, 1}, 3}};
  ASSERT_TRUE(a.run(4));
  expect_facets_of_a_tetrahedron(a);
}

TEST(Steiner_points_inside, Takes_a_point_off_a_face) {
  Steiner_points_inside a;
  a.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.3, 0.3, 0}};
  a.tetrahedra = {{0, 1, 4, 3}, {1, 2, 4, 3}, {2, 0, 4, 3}};
  a.facets = {{{1, 2, 3}, 0}, {{0, 3, 2}, 1}, {{0, 1, 3}, 2}, {{0, 4, 1}, 3}, {{1, 4, 2}, 3}, {{2, 4, 0}, 3}};
  ASSERT_TRUE(a.run(4));
  expect_facets_of_a_tetrahedron(a);
}

TEST(Steiner_points_inside, Leaves_points_inside_alone) {
  Steiner_points_inside a;
  a.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}};
  a.tetrahedra = {{4, 1, 2, 3}, {4, 0, 3, 2}, {4, 0, 1, 3}, {4, 0, 2, 1}};
  a.facets = {{{1, 2, 3}, 0}, {{0, 3, 2}, 1}, {{0, 1, 3}, 2}, {{0, 2, 1}, 3}};
  ASSERT_TRUE(a.run(4));
  EXPECT_EQ(a.points[4].x, 0.2);
  expect_facets_of_a_tetrahedron(a);
}

TEST(Fill_with_ccdt, Keeps_the_surface_bit_for_bit) {
  test_surfaces::Tube shape; // long thin triangles, whose edges are in no Delaunay triangulation
  shape.sides = 12;
  shape.rings = 5;
  shape.bottom = shape.top = test_surfaces::End::fine;
  shape.tilt = 0.3;
  Surface surface = test_surfaces::make_tube(shape);
  auto patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 5).first;
  tubular::Mixed_mesh mesh;
  const auto by_ccdt = tubular::parameters::volume_mesher(tubular::Volume_mesher::ccdt);
  if (!tubular::has_ccdt()) {
    try {
      tubular::fill_keeping_boundary(surface, patch, Constant_size{0.5}, mesh, by_ccdt);
      FAIL() << "there is nothing to fill it with";
    } catch (const tubular::Meshing_error& e) {
      EXPECT_NE(std::string(e.what()).find("before 6.1"), std::string::npos) << e.what();
    }
    return;
  }
  tubular::fill_keeping_boundary(surface, patch, Constant_size{0.5}, mesh, by_ccdt);
  const auto report = tubular::validity_report(mesh);
  EXPECT_TRUE(report.is_valid()) << report.defects();
  ASSERT_EQ(mesh.triangles.size(), surface.number_of_faces());
  EXPECT_GT(mesh.points.size(), surface.number_of_vertices());
  for (auto v : surface.vertices())
    ASSERT_EQ(mesh.points[v.idx()], surface.point(v));
  for (auto f : surface.faces()) {
    int k = 0;
    for (auto v : vertices_around_face(surface.halfedge(f), surface))
      ASSERT_EQ(mesh.triangles.vertices[f.idx()][k++], v.idx());
    ASSERT_EQ(mesh.triangles.label[f.idx()], 5);
  }
}

} // namespace

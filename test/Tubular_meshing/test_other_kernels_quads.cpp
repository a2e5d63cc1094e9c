// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Quads for callers with other kernels, other surfaces, and other function objects than the core's.

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Quads/quadrangulate_annular_patches.h>
#include <CGAL/Tubular_meshing/Quads/quadrangulate_patches.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include "other_graphs.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
typedef CGAL::Exact_predicates_exact_constructions_kernel Epeck;
typedef CGAL::Simple_cartesian<float> Floats;

// n² squares, each with a diagonal, in coordinates that floats have exactly.
template <class Point> std::vector<Point> points_of_grid(int n) {
  std::vector<Point> points;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      points.emplace_back(i, j, (i * j) % 3);
  return points;
}
std::vector<std::array<std::size_t, 3>> triangles_of_grid(std::size_t n) {
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = j * (n + 1) + i, c = a + n + 2;
      triangles.push_back({{a, a + 1, c}});
      triangles.push_back({{a, c, c - 1}});
    }
  return triangles;
}

template <class Kernel> class Recombined_points_of : public testing::Test {};
typedef testing::Types<Epeck, Floats, CGAL::Simple_cartesian<double>> Kernels;
TYPED_TEST_SUITE(Recombined_points_of, Kernels);

TYPED_TEST(Recombined_points_of, Any_kernel_gives_the_same_quads) {
  if (!tubular::has_lemon())
    GTEST_SKIP() << "built without LEMON";
  const auto expected = tubular::recombine_triangles(points_of_grid<tubular::Point_3>(4), triangles_of_grid(4));
  const auto found = tubular::recombine_triangles(points_of_grid<typename TypeParam::Point_3>(4), triangles_of_grid(4));
  EXPECT_EQ(found.quads, expected.quads);
  EXPECT_EQ(found.points, expected.points);
}

template <class FaceGraph> class Quads_on : public testing::Test {};
typedef testing::Types<tubular::Surface, CGAL::Surface_mesh<Epeck::Point_3>, CGAL::Surface_mesh<Floats::Point_3>,
                       CGAL::Polyhedron_3<tubular::Kernel>>
    Surfaces;
TYPED_TEST_SUITE(Quads_on, Surfaces);

// Two patches: their squares become quads in each.
TYPED_TEST(Quads_on, Any_surface_is_recombined_in_place) {
  typedef typename boost::graph_traits<TypeParam>::face_descriptor Face;
  if (!tubular::has_lemon())
    GTEST_SKIP() << "built without LEMON";
  const std::size_t n = 4;
  tubular::Surface grid;
  for (const auto& p : points_of_grid<tubular::Point_3>(int(n)))
    grid.add_vertex(p);
  typedef tubular::Surface::Vertex_index V;
  for (const auto& t : triangles_of_grid(n))
    grid.add_face(V(t[0]), V(t[1]), V(t[2]));
  TypeParam surface, unlabelled;
  const auto copies = other_graphs::copy_in_order(grid, surface);
  other_graphs::copy_in_order(grid, unlabelled);
  std::map<Face, int> labels;
  for (const auto& f : copies)
    labels[f.second] = std::size_t(f.first) < n * n ? 7 : 8;
  const auto patch = boost::make_assoc_property_map(labels);

  const auto report = tubular::recombine_triangles(surface, tubular::parameters::face_patch_map(patch));
  EXPECT_EQ(report.quads, n * n);
  std::map<int, int> faces_with;
  for (Face f : faces(surface)) {
    EXPECT_EQ(CGAL::halfedges_around_face(halfedge(f, surface), surface).size(), 4u);
    ++faces_with[get(patch, f)];
  }
  EXPECT_EQ(faces_with, (std::map<int, int>{{7, 8}, {8, 8}}));
  EXPECT_EQ(tubular::recombine_triangles(unlabelled).quads, n * n);
}

// A plain function is a size too.
double half(const tubular::Point_3&) {
  return 0.5;
}

TEST(Quads_of_functions, Any_size_and_surface_give_the_same_quads) {
  if (!tubular::has_lemon())
    GTEST_SKIP() << "built without LEMON";
  const auto skeleton = tubular::straight_tube(6, 1);
  tubular::Surface generated;
  tubular::generate_tubular_surface(skeleton, generated, tubular::parameters::points_per_circumference(16));
  auto model = tubular::make_tubular_model(generated, tubular::centerlines_of(skeleton));
  static_cast<tubular::Labelled_surface&>(model) = other_graphs::in_order(model);
  typedef CGAL::Surface_mesh<Epeck::Point_3> Exact_surface;
  Exact_surface exact;
  const auto copies = other_graphs::copy_in_order(model.surface, exact);
  auto labels = exact.add_property_map<Exact_surface::Face_index, int>("f:label", 0).first;
  for (const auto& f : copies)
    labels[f.second] = model.patch[f.first];

  const auto np = tubular::parameters::points_per_circumference(12);
  const auto found = tubular::quadrangulate_patches(exact, labels, model.centerlines, np);
  const auto expected = tubular::quadrangulate_patches(model.surface, model.patch, model.centerlines, np);
  EXPECT_GT(expected.quads.wall_quads(), 50u);
  EXPECT_EQ(found.quads.wall_quads(), expected.quads.wall_quads());
  EXPECT_EQ(exact.number_of_faces(), model.surface.number_of_faces()) << "cut alike";
  ASSERT_EQ(found.surface.number_of_vertices(), expected.surface.number_of_vertices());
  for (auto v : found.surface.vertices())
    EXPECT_EQ(found.surface.point(v), expected.surface.point(v));

  const auto cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
  const auto maps = tubular::parameterize_patches(model.surface, cut);
  const auto by_function = tubular::quadrangulate_annular_patches(model.surface, cut, maps, half);
  const auto by_object =
      tubular::quadrangulate_annular_patches(model.surface, cut, maps, [](const auto&) { return 0.5; });
  EXPECT_EQ(by_function.curve_points, by_object.curve_points);
  ASSERT_FALSE(by_function.grids.empty());
  EXPECT_EQ(by_function.grids[0].points, by_object.grids[0].points);
}

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of other kernels and other data structures give the meshes that the core's own surface gives.

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Linear_cell_complex_traits.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include "other_graphs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace parameters = tubular::parameters;

const tubular::Surface& surface() {
  static const tubular::Surface s = [] {
    tubular::Surface result;
    tubular::generate_tubular_surface(tubular::y_bifurcation(), result, parameters::points_per_circumference(14));
    return other_graphs::in_order(result);
  }();
  return s;
}

template <class Mesh> Mesh copy() {
  Mesh mesh;
  other_graphs::copy_in_order(surface(), mesh);
  return mesh;
}

const auto np = parameters::points_per_circumference(8).number_of_threads(1);

template <class Mesh> void expect_same_mesh(bool rounded = false) {
  const tubular::Mixed_mesh expected = tubular::make_isotropic_mesh(surface(), np);
  const tubular::Mixed_mesh mesh = tubular::make_isotropic_mesh(copy<Mesh>(), np);
  if (rounded) { // rounded coordinates give another mesh, of the same fineness
    EXPECT_NEAR(double(mesh.tetrahedra.size()), double(expected.tetrahedra.size()), 0.05 * expected.tetrahedra.size());
    EXPECT_EQ(mesh.patch_names, expected.patch_names);
    return;
  }
  EXPECT_EQ(mesh.points, expected.points);
  EXPECT_EQ(mesh.tetrahedra.vertices, expected.tetrahedra.vertices);
  EXPECT_EQ(mesh.triangles.label, expected.triangles.label);
}

TEST(Other_kernels, Exact_constructions) {
  expect_same_mesh<CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>>();
}

TEST(Other_kernels, Single_precision) {
  expect_same_mesh<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>>(true);
}

TEST(Other_kernels, Polyhedron) {
  expect_same_mesh<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>();
}

TEST(Other_kernels, Linear_cell_complex) {
  typedef CGAL::Linear_cell_complex_traits<3, CGAL::Simple_cartesian<double>> Traits;
  typedef CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Traits>::type Mesh;
  expect_same_mesh<Mesh>();
}

TEST(Other_kernels, A_vertex_point_map_of_the_caller) {
  tubular::Surface doubled = surface();
  auto half = doubled.add_property_map<tubular::Surface::Vertex_index, tubular::Point_3>("v:half").first;
  for (auto v : doubled.vertices()) {
    const tubular::Point_3 p = doubled.point(v);
    half[v] = p;
    doubled.point(v) = tubular::Point_3(2 * p.x(), 2 * p.y(), 2 * p.z());
  }
  const auto with_map = CGAL::parameters::vertex_point_map(half);
  const auto expected = tubular::make_tubular_model(surface());
  const auto model = tubular::make_tubular_model(doubled, with_map);
  ASSERT_EQ(model.openings.size(), expected.openings.size());
  for (std::size_t i = 0; i < model.openings.size(); ++i)
    EXPECT_EQ(model.openings[i].center, expected.openings[i].center);
}

} // namespace

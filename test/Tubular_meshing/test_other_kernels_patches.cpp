// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Plane and Patches for callers with other kernels, other surfaces, and other function objects than the core's.

#include "other_graphs.h"
#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Patches/remesh_patches.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_in_metric.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
typedef CGAL::Exact_predicates_exact_constructions_kernel Epeck;
typedef CGAL::Simple_cartesian<float> Floats;

// --- points of the plane ---

template <class Kernel> class Plane_of : public testing::Test {};
typedef testing::Types<Epeck, Floats, CGAL::Simple_cartesian<double>> Kernels;
TYPED_TEST_SUITE(Plane_of, Kernels);

// A square of 16 unit edges, in coordinates that floats have exactly.
template <class Point_2> std::vector<std::vector<Point_2>> square() {
  std::vector<std::vector<Point_2>> polygons(1);
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 4; ++i)
      polygons[0].push_back(side == 0   ? Point_2(i, 0)
                            : side == 1 ? Point_2(4, i)
                            : side == 2 ? Point_2(4 - i, 4)
                                        : Point_2(0, 4 - i));
  return polygons;
}

TYPED_TEST(Plane_of, Any_kernel_gives_the_same_triangles) {
  typedef typename TypeParam::Point_2 Point_2;
  typedef typename TypeParam::Point_3 Point_3;
  const auto unit = [](const auto&) { return tubular::Metric_tensor_2::isotropic(1); };
  const auto expected = tubular::triangulate_in_metric(square<tubular::Kernel::Point_2>(), unit);
  const auto found = tubular::triangulate_in_metric(square<Point_2>(), unit);
  EXPECT_EQ(found.triangles, expected.triangles);
  ASSERT_EQ(found.points.size(), expected.points.size());
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    EXPECT_NEAR(CGAL::to_double(found.points[i].x()), expected.points[i].x(), 1e-6);
    EXPECT_NEAR(CGAL::to_double(found.points[i].y()), expected.points[i].y(), 1e-6);
  }
  const auto flat = [](const Point_2& p) { return Point_3(p.x(), p.y(), 0); };
  const std::vector<Point_2> given(1, Point_2(1, 2));
  const auto embedded = tubular::triangulate_in_metric(square<Point_2>(), unit,
                                                       tubular::parameters::embedding(flat).interior_points(given));
  EXPECT_GT(embedded.triangles.size(), 20u);
}

// --- surfaces ---

tubular::Tubular_model tube() {
  tubular::Surface surface;
  tubular::generate_tubular_surface(tubular::straight_tube(10, 1), surface,
                                    tubular::parameters::points_per_circumference(16));
  return tubular::make_tubular_model(surface, tubular::centerlines_of(tubular::straight_tube(10, 1)));
}

template <class Mesh> void expect_same_mesh() {
  const tubular::Tubular_model model = tube();
  tubular::Mixed_mesh expected, found;
  tubular::surface_to_mixed_mesh(model.surface, model.patch, expected);
  Mesh mesh;
  std::map<typename boost::graph_traits<Mesh>::face_descriptor, int> labels;
  other_graphs::copy_in_order(model.surface, mesh);
  auto f = model.surface.faces().begin();
  for (auto g : faces(mesh))
    labels[g] = model.patch[*f++];
  tubular::surface_to_mixed_mesh(mesh, boost::make_assoc_property_map(labels), found);
  ASSERT_EQ(found.points.size(), expected.points.size());
  for (std::size_t i = 0; i < found.points.size(); ++i)
    EXPECT_LT(CGAL::squared_distance(found.points[i], expected.points[i]), 1e-10);
  ASSERT_EQ(found.triangles.size(), expected.triangles.size());
  EXPECT_EQ(found.triangles.label, expected.triangles.label);
}

TEST(Surfaces, Any_face_graph_becomes_a_mixed_mesh) {
  expect_same_mesh<CGAL::Surface_mesh<Epeck::Point_3>>();
  expect_same_mesh<CGAL::Surface_mesh<Floats::Point_3>>();
  expect_same_mesh<CGAL::Polyhedron_3<Epeck>>();
  expect_same_mesh<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>();
}

// --- function objects ---

TEST(Remeshing, Takes_any_function_of_a_point) {
  tubular::Tubular_model model = tube();
  const auto cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
  const auto maps = tubular::parameterize_patches(model.surface, cut);
  const std::function<double(const tubular::Point_3&)> size = [](const tubular::Point_3&) { return 0.5; };
  const auto faces_of = [&](const auto& field) {
    const auto result = tubular::remesh_patches(model.surface, cut, maps, field);
    EXPECT_TRUE(CGAL::is_closed(result.surface));
    return result.surface.number_of_faces();
  };
  const std::size_t n = faces_of(size);
  EXPECT_EQ(faces_of([](const auto& p) { return float(0 * p.x() + 0.5); }), n);
  EXPECT_EQ(faces_of(tubular::internal::Length_function(size)), n);
  const auto metric = [](const tubular::Point_3&) { return tubular::Metric_tensor_3::isotropic(0.5); };
  EXPECT_NEAR(double(faces_of(metric)), double(n), 0.1 * double(n));
}

} // namespace

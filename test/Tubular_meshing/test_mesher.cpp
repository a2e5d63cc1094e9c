// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Mesher: one object for all meshes of a model, the fallback to Mesh_3, what its errors carry.

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace parameters = tubular::parameters;
using tubular::Mesher;
using tubular::Mixed_mesh;
using tubular::Point_3;

bool keeps_boundary() {
  return tubular::default_volume_mesher() != tubular::Volume_mesher::mesh_3;
}

/* A Y, moved far from where the mesher works. */
tubular::Tubular_model bifurcation(const tubular::Vector_3& shift = {0, 0, 0}) {
  const auto skeleton = tubular::y_bifurcation();
  tubular::Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(16));
  tubular::Centerline_polylines lines = tubular::centerlines_of(skeleton);
  for (auto v : surface.vertices())
    surface.point(v) = surface.point(v) + shift;
  for (Point_3& p : lines.points)
    p = p + shift;
  return tubular::make_tubular_model(surface, lines);
}

void expect_same(const Mixed_mesh& a, const Mixed_mesh& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tetrahedra.vertices, b.tetrahedra.vertices);
  EXPECT_EQ(a.triangles.vertices, b.triangles.vertices);
  EXPECT_EQ(a.quads.vertices, b.quads.vertices);
}

TEST(Mesher, Makes_the_same_meshes_in_any_order) {
  if (!keeps_boundary() || !tubular::has_lemon())
    GTEST_SKIP() << "built without LEMON, or with neither TetGen nor CGAL 6.1";
  const auto model = bifurcation();
  const auto np = parameters::points_per_circumference(10).number_of_threads(1);
  Mesher first(model, np), second(model, np);
  const Mixed_mesh isotropic = first.isotropic(), mixed = first.mixed(), anisotropic = first.anisotropic();
  expect_same(anisotropic, second.anisotropic());
  expect_same(mixed, second.mixed());
  expect_same(isotropic, second.isotropic());
  expect_same(isotropic, tubular::make_isotropic_mesh(model, np));
}

TEST(Mesher, Has_checked_each_mesh_as_it_is) {
  if (!keeps_boundary() || !tubular::has_lemon())
    GTEST_SKIP() << "built without LEMON, or with neither TetGen nor CGAL 6.1";
  Mesher mesher(bifurcation({500, -20, 7}), parameters::points_per_circumference(10));
  const auto expect_checked = [&](const Mixed_mesh& mesh) {
    EXPECT_TRUE(mesher.report().check.is_of(mesh));
    EXPECT_EQ(mesher.report().check.validity().cells, mesh.number_of_cells());
  };
  expect_checked(mesher.isotropic());
  expect_checked(mesher.anisotropic());
  expect_checked(mesher.mixed());
  expect_checked(mesher.hexahedral());
  Mesher by_mesh_3(bifurcation(),
                   parameters::points_per_circumference(10).volume_mesher(tubular::Volume_mesher::mesh_3));
  const Mixed_mesh mesh = by_mesh_3.isotropic();
  EXPECT_TRUE(by_mesh_3.report().check.is_of(mesh));
  by_mesh_3.surface(tubular::Surface_elements::triangles);
  EXPECT_FALSE(by_mesh_3.report().check.is_of(mesh));
}

TEST(Mesher, What_N_was_before_does_not_matter) {
  const auto model = bifurcation();
  const auto np = parameters::points_per_circumference(12).curvature_points(9).number_of_threads(1);
  Mesher first(model, np), second(model, np);
  for (double points : {4., 2., 12.}) // few enough for curvature to have the least of points, or none
    second.set_points_per_circumference(points);
  const auto a = first.surface(tubular::Surface_elements::anisotropic_triangles),
             b = second.surface(tubular::Surface_elements::anisotropic_triangles);
  ASSERT_EQ(a.surface.number_of_vertices(), b.surface.number_of_vertices());
  for (auto v : a.surface.vertices())
    EXPECT_EQ(a.surface.point(v), b.surface.point(v));
}

TEST(Mesher, Makes_cut_and_maps_once) {
  if (!keeps_boundary())
    GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1";
  const auto model = bifurcation();
  std::vector<std::string> stages;
  Mesher mesher(model, parameters::points_per_circumference(10).observer([&](const char* s) { stages.push_back(s); }));
  mesher.isotropic();
  EXPECT_EQ(stages, (std::vector<std::string>{"size field", "cut", "parameterization", "surface mesh", "volume",
                                              "tetrahedra", "optimization", "check"}));
  stages.clear();
  mesher.isotropic();
  EXPECT_EQ(stages, (std::vector<std::string>{"surface mesh", "volume", "tetrahedra", "optimization", "check"}));
}

// Which is measured in a frame of the mesher's own.
TEST(Mesher, Tells_the_local_radius) {
  for (const tubular::Vector_3& shift : {tubular::Vector_3(0, 0, 0), tubular::Vector_3(500, -20, 7)}) {
    const auto model = bifurcation(shift);
    const tubular::Local_radius radius(tubular::Centerline_field(model.centerlines),
                                       tubular::Wall_distance(model.surface, model.patch, tubular::labels::wall));
    Mesher mesher(model, tubular::parameters::points_per_circumference(12));
    for (const Point_3& p : model.surface.points())
      EXPECT_NEAR(mesher.local_radius(p), radius(p), 1e-4 * radius(p)) << p;
  }
}

TEST(Mesher, Keeps_the_surface_that_it_meshed_by_patches) {
  if (!keeps_boundary())
    GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1";
  Mesher mesher(bifurcation(), parameters::points_per_circumference(10));
  const Mixed_mesh mesh = mesher.isotropic();
  EXPECT_TRUE(mesher.report().fallbacks.empty());
  const tubular::Remeshed_surface surface = mesher.kept_surface();
  ASSERT_EQ(surface.surface.number_of_faces(), mesh.triangles.size());
  for (auto v : surface.surface.vertices())
    EXPECT_EQ(surface.surface.point(v), mesh.points[std::size_t(v)]);
  EXPECT_EQ(mesher.kept_surface().surface.number_of_faces(), 0u);
}

TEST(Mesher, Falls_back_to_Mesh_3_and_says_so) {
  if (tubular::has_tetgen() && tubular::has_ccdt())
    GTEST_SKIP() << "built with all fillers: none fails for want of a library";
  const auto missing = tubular::has_tetgen() ? tubular::Volume_mesher::ccdt : tubular::Volume_mesher::tetgen;
  const tubular::Mesher_options options(
      parameters::points_per_circumference(8).number_of_threads(1).volume_mesher(missing));
  Mesher mesher(bifurcation(), options);
  const Mixed_mesh mesh = mesher.isotropic();
  EXPECT_TRUE(tubular::validity_report(mesh).is_valid());
  ASSERT_EQ(mesher.report().fallbacks.size(), 1u);
  EXPECT_NE(mesher.report().fallbacks[0].find("Mesh_3"), std::string::npos);
  EXPECT_NE(mesher.report().fallbacks[0].find("tetrahedra"), std::string::npos) << mesher.report().fallbacks[0];
  EXPECT_EQ(mesher.kept_surface().surface.number_of_faces(), 0u);
  const auto by_mesh_3 =
      parameters::points_per_circumference(8).number_of_threads(1).surface_mesher(tubular::Surface_mesher::mesh_3);
  expect_same(mesh, tubular::make_isotropic_mesh(mesher.model(), by_mesh_3));
}

TEST(Mesher, Names_places_of_the_model_that_was_given) {
  if (!keeps_boundary())
    GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1";
  const tubular::Vector_3 shift(1000, -2000, 3000);
  const auto model = bifurcation(shift);
  Mesher mesher(model, parameters::points_per_circumference(10).boundary_layer_prisms(3).first_height(1e-17));
  try {
    mesher.isotropic();
    FAIL() << "layers of no height were made";
  } catch (const tubular::Error& e) {
    ASSERT_FALSE(e.places().empty()) << e.what();
    for (const tubular::Place& p : e.places()) {
      const CGAL::Bbox_3 box = CGAL::bbox_3(model.surface.points().begin(), model.surface.points().end());
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(p[k], box.min(k) - 0.01) << e.what();
        EXPECT_LE(p[k], box.max(k) + 0.01) << e.what();
      }
    }
    EXPECT_EQ(e.stage(), "boundary layer");
  }
}

/* The largest angle, in degrees, between the normal of a triangle on the wall of a tube along z and the way out. */
double largest_turn(const Mixed_mesh& mesh) {
  using tubular::internal::Vector_3d;
  double least = 1;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles.vertices[i];
    if (mesh.triangles.label[i] != tubular::labels::wall)
      continue;
    const Vector_3d a(mesh.points[t[0]]), b(mesh.points[t[1]]), c(mesh.points[t[2]]), middle = a + b + c;
    least = (std::min)(least, dot(normalized(cross(b - a, c - a)), normalized(Vector_3d(middle.x, middle.y, 0))));
  }
  return std::acos(least) * 180 / CGAL_PI;
}

// They are long along the edges of a coarse surface, and thin: each of them may slide over such an edge and turn over.
TEST(Mesher, Triangles_of_an_anisotropic_wall_do_not_turn_over) {
  if (!keeps_boundary())
    GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1";
  const auto skeleton = tubular::straight_tube(6, 1);
  tubular::Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(16));
  Mesher mesher(tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton)),
                parameters::preserve_volume(false));
  for (double points : {12, 13, 14, 16, 20, 22}) {
    mesher.set_points_per_circumference(points);
    const Mixed_mesh mesh = mesher.anisotropic();
    EXPECT_LT(largest_turn(mesh), 50) << points;
    EXPECT_GT(tubular::quality_report(mesh).efficiency, 0.86) << points;
  }
}

TEST(Mesher, Refuses_layers_of_prisms_in_anisotropic_meshes) {
  Mesher mesher(bifurcation(), parameters::boundary_layer_prisms(3));
  EXPECT_THROW(mesher.anisotropic(), tubular::Parameter_error);
}

} // namespace

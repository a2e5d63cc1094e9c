// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The whole road to mixed meshes: with and without a wall and layers inside, on a bifurcation of known shape; and on
// real vessels, where they are present.

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace {

using test_surfaces::Mesh;
using test_surfaces::Point;
namespace tubular = CGAL::Tubular_meshing;
namespace parameters = tubular::parameters;
typedef tubular::Tubular_model Model;
typedef tubular::Mixed_mesh Mixed;

class Mixed_mesh_test : public ::testing::Test {
protected:
  void SetUp() override {
    if (!tubular::has_lemon() || (!tubular::has_tetgen() && !tubular::has_ccdt()))
      GTEST_SKIP() << "built without LEMON, or with neither TetGen nor CGAL 6.1";
  }
};

Model bifurcation() {
  const auto skeleton = tubular::y_bifurcation();
  Mesh mesh;
  tubular::generate_tubular_surface(skeleton, mesh, parameters::points_per_circumference(24));
  return tubular::make_tubular_model(mesh, tubular::centerlines_of(skeleton));
}

std::size_t count(const std::vector<int>& labels, int label) {
  return std::size_t(std::count(labels.begin(), labels.end(), label));
}

void expect_valid(const Mixed& mesh, double least_gamma) {
  const auto report = tubular::validity_report(mesh);
  EXPECT_TRUE(report.is_valid()) << report.defects();
  const auto quality = tubular::quality_report(mesh);
  EXPECT_GT(quality.gamma_tau.min(), least_gamma);
  EXPECT_GT(quality.gamma_tau.mean(), 0.7);
  EXPECT_GT(quality.pyramid_jacobian.min(), 0.1);
  EXPECT_EQ(mesh.region_names.at(tubular::labels::lumen), "lumen");
  EXPECT_EQ(mesh.patch_names.at(tubular::labels::wall), "wall");
  EXPECT_EQ(mesh.patch_names.at(tubular::labels::inlet), "inlet");
}

TEST_F(Mixed_mesh_test, Has_a_pyramid_on_each_quad_of_the_lumen) {
  const Mixed mesh = tubular::make_mixed_mesh(bifurcation(), parameters::points_per_circumference(16));
  expect_valid(mesh, 0.1);
  EXPECT_EQ(mesh.pyramids.size(), mesh.quads.size());
  EXPECT_EQ(count(mesh.quads.label, tubular::labels::wall), mesh.quads.size());
  EXPECT_EQ(count(mesh.triangles.label, tubular::labels::wall), 0u);
  EXPECT_TRUE(mesh.hexahedra.empty());
  EXPECT_EQ(mesh.patch_names.at(4), "outlet_2");
  EXPECT_EQ(tubular::validity_report(mesh).boundary_euler, 2);
}

TEST_F(Mixed_mesh_test, Has_hexahedra_on_the_same_quads_in_the_wall) {
  const Mixed mesh = tubular::make_mixed_mesh(
      bifurcation(), parameters::points_per_circumference(16).wall_thickness(0.2).wall_layers(3));
  expect_valid(mesh, 0.1);
  EXPECT_EQ(mesh.hexahedra.size(), 3 * mesh.pyramids.size());
  EXPECT_EQ(count(mesh.hexahedra.label, tubular::labels::wall_region), mesh.hexahedra.size());
  EXPECT_EQ(count(mesh.quads.label, tubular::labels::wall), mesh.pyramids.size());
  EXPECT_EQ(count(mesh.quads.label, tubular::labels::outer_wall), mesh.pyramids.size());
  EXPECT_GT(count(mesh.quads.label, tubular::labels::inlet_ring), 0u);
  EXPECT_EQ(mesh.region_names.at(tubular::labels::wall_region), "wall");
  EXPECT_GT(tubular::quality_report(mesh).zeta_H.min(), 0.33);
}

TEST_F(Mixed_mesh_test, Has_layers_inside_on_which_the_pyramids_stand) {
  const Mixed mesh = tubular::make_mixed_mesh(
      bifurcation(), parameters::points_per_circumference(16).boundary_layer_prisms(3).first_height(0.04).growth(1.2));
  expect_valid(mesh, 0.1);
  EXPECT_EQ(mesh.hexahedra.size(), 3 * mesh.pyramids.size());
  EXPECT_EQ(count(mesh.hexahedra.label, tubular::labels::lumen), mesh.hexahedra.size());
  EXPECT_EQ(count(mesh.quads.label, tubular::labels::wall), mesh.pyramids.size());
}

TEST_F(Mixed_mesh_test, Refuses_parameters_out_of_range) {
  const Model model = bifurcation();
  EXPECT_THROW(tubular::make_mixed_mesh(model, parameters::wall_thickness(-1)), tubular::Parameter_error);
  EXPECT_THROW(tubular::make_mixed_mesh(model, parameters::points_per_circumference(1)), tubular::Parameter_error);
}

#ifdef TUBULAR_MESHING_SHARED_DATA
// Table II has hexahedra of 0.28 at least, and 0.83 on average, on the aorta, 0.33 and 0.86 on the carotid.
void mesh_of_real(const std::string& name, double least_gamma, double least_zeta, double mean_zeta) {
  const std::string file = std::string(TUBULAR_MESHING_SHARED_DATA) + "/" + name;
  if (!std::ifstream(file))
    GTEST_SKIP() << file << " is not there";
  Mesh surface;
  tubular::IO::read_surface(file, surface);
  tubular::repair_surface(surface);
  const Mixed mesh =
      tubular::make_mixed_mesh(surface, parameters::points_per_circumference(20).wall_thickness(0.2).wall_layers(4));
  expect_valid(mesh, least_gamma);
  const auto quality = tubular::quality_report(mesh);
  EXPECT_GT(quality.zeta_H.min(), least_zeta);
  EXPECT_GT(quality.zeta_H.mean(), mean_zeta);
  std::printf("%s: %zu hexahedra %.2f, %.3f; %zu pyramids; %zu tetrahedra %.2f, %.3f\n", name.c_str(),
              mesh.hexahedra.size(), quality.zeta_H.min(), quality.zeta_H.mean(), mesh.pyramids.size(),
              mesh.tetrahedra.size(), quality.gamma_tau.min(), quality.gamma_tau.mean());
}

TEST_F(Mixed_mesh_test, Aorta) {
  mesh_of_real("paper/aorta.stl", 0.02, 0.28, 0.83);
}
TEST_F(Mixed_mesh_test, Carotid) {
  mesh_of_real("paper/carotid.stl", 0.1, 0.33, 0.86);
}
TEST_F(Mixed_mesh_test, Sofa_carotids) {
  mesh_of_real("trees/sofa_carotids.stl", 0.1, 0.28, 0.8);
}
#else
TEST(Mixed_mesh_real, All_surfaces) {
  GTEST_SKIP() << "the measurement data are not there";
}
#endif

} // namespace

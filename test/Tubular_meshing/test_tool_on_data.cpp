// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool on the sample that is shipped, and on real vessels.

#include "test_tool_helpers.h"
#include "test_tool_report.h"

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <string>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

TEST_F(Tool, Meshes_the_sample_that_is_shipped) {
  for (const Arguments& mesher : {Arguments(), by_mesh_3}) {
    succeed(Arguments{arch(), "-c", arch_centerlines(), "-o", out("mesh.msh"), "--report", out("r.json")} + mesher);
    const Json report = json_in(out("r.json"));
    expect_report_of(report, mesh_in(out("mesh.msh")));
    EXPECT_EQ(report["openings"].size(), 5u);
    EXPECT_EQ(report["branches"].size(), 7u);
    EXPECT_EQ(report["boundary_euler"], 2);
    mesher.empty() ? expect_by_patches(report) : expect_by_mesh_3(report);
    EXPECT_GE(report["quality"]["gamma_tau"]["min"].get<double>(), 0.21);
  }
}

// --- the paper's own geometries, by Mesh_3 ---

struct Real_model {
  const char *name, *surface, *centerlines;
  double points;
  std::size_t openings, branches;
  int euler;
  double least_gamma_tau, mean_gamma_tau, mean_gamma_T, distance;
};

std::ostream& operator<<(std::ostream& out, const Real_model& m) {
  return out << m.name;
}

class Real : public Tool, public ::testing::WithParamInterface<Real_model> {};

// How far the input's vertices are from the mesh, at most, over the diagonal: caps may cut off a little at the ends.
double distance_to_mesh(const std::string& surface_file, const Mesh& mesh) {
  Surface surface, boundary;
  tubular::IO::read_surface(surface_file, surface);
  for (const Point& p : mesh.points)
    boundary.add_vertex(p);
  typedef Surface::Vertex_index Vertex;
  for (const auto& t : mesh.triangles.vertices)
    boundary.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  const tubular::Wall_distance distance(boundary);
  double largest = 0;
  for (auto v : surface.vertices())
    largest = (std::max)(largest, distance(surface.point(v)));
  return largest / diagonal_of(mesh);
}

TEST_P(Real, Is_meshed_well) {
  const Real_model& model = GetParam();
  const std::string surface = shared_file(model.surface), centerlines = shared_file(model.centerlines);
  NEEDS(surface, fs::exists(surface) && fs::exists(centerlines));
  std::ostringstream n;
  n << model.points;
  succeed(Arguments{surface, "-c", centerlines, "-n", n.str(), "-o", out("mesh.vtu"), "--report", out("r.json")} +
          by_mesh_3 + reproducibly); // what passes once passes always
  const Json report = json_in(out("r.json"));
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  expect_report_of(report, mesh);
  expect_by_mesh_3(report);
  EXPECT_EQ(report["boundary_euler"], model.euler);
  EXPECT_EQ(report["openings"].size(), model.openings);

  EXPECT_EQ(report["branches"].size(), model.branches);
  EXPECT_GE(report["quality"]["gamma_tau"]["min"].get<double>(), model.least_gamma_tau);
  EXPECT_GE(report["quality"]["gamma_tau"]["mean"].get<double>(), model.mean_gamma_tau);
  EXPECT_GE(report["quality"]["gamma_T"]["mean"].get<double>(), model.mean_gamma_T);
  EXPECT_LE(distance_to_mesh(surface, mesh), model.distance);
  for (const Json& branch : report["branches"])
    if (branch["points_per_circumference"] > 0) {
      EXPECT_GE(branch["points_per_circumference"].get<double>(), 0.9 * model.points);
      EXPECT_LE(branch["points_per_circumference"].get<double>(), model.points + 6);
    }
}

const Real_model real_models[] = {
    {"Aorta", "paper/aorta.stl", "paper/centerlinesAORTA.vtk", 20, 5, 7, 2, 0.21, 0.72, 0.90, 0.004},
    {"Carotid", "paper/carotid.stl", "paper/centerlinesCAROTID.vtk", 20, 3, 3, 2, 0.18, 0.72, 0.90, 0.004},
    {"Carotid_16", "paper/carotid.stl", "paper/centerlinesCAROTID.vtk", 16, 3, 3, 2, 0.18, 0.72, 0.90, 0.004},
    {"Bypass", "paper/bypass.stl", "paper/centerlinesBYPASS.msh", 20, 2, 4, 0, 0.18, 0.72, 0.90, 0.004},
    {"Bypass_25", "paper/bypass.stl", "paper/centerlinesBYPASS.msh", 25, 2, 4, 0, 0.18, 0.72, 0.90, 0.004},
    {"Cerebral_10", "paper/cerebral.stl", "paper/centerlinesCEREBRAL.vtk", 10, 9, 15, 2, 0.15, 0.66, 0.85,
     0.008}, // chords of ten a round
};
INSTANTIATE_TEST_SUITE_P(Paper, Real, ::testing::ValuesIn(real_models),
                         [](const ::testing::TestParamInfo<Real_model>& info) { return std::string(info.param.name); });

// --- a surface alone ---

struct Real_surface {
  const char *name, *file;
  double points;
  std::size_t openings;
  int euler;
};

std::ostream& operator<<(std::ostream& out, const Real_surface& s) {
  return out << s.name;
}

class Real_alone : public Tool, public ::testing::WithParamInterface<Real_surface> {};

TEST_P(Real_alone, Is_meshed) {
  const std::string file = shared_file(GetParam().file);
  NEEDS(file, fs::exists(file));
  std::ostringstream n;
  n << GetParam().points;
  succeed(Arguments{file, "-n", n.str(), "-o", out("mesh.vtu"), "--report", out("r.json")} + reproducibly);
  const Json report = json_in(out("r.json"));
  expect_report_of(report, mesh_in(out("mesh.vtu")));
  EXPECT_EQ(report["boundary_euler"], GetParam().euler);
  EXPECT_EQ(report["openings"].size(), GetParam().openings);
  for (const Json& opening : report["openings"])
    EXPECT_FALSE(opening["branch"].is_null()) << opening["name"];
  expect_by_patches(report);
  EXPECT_GE(report["quality"]["gamma_tau"]["min"].get<double>(), 0.15); // by Mesh_3, too
}

const Real_surface real_surfaces[] = {{"Aorta", "paper/aorta.stl", 20, 5, 2},
                                      {"Carotid", "paper/carotid.stl", 16, 3, 2},
                                      {"Bypass", "paper/bypass.stl", 12, 2, 0},
                                      {"Cerebral", "paper/cerebral.stl", 10, 9, 2},
                                      {"Cylemi", "paper/cylemi.stl", 20, 2, 2},
                                      {"Coronaries", "trees/sofa_LCA.stl", 12, 7, 2},
                                      {"Noisy_carotids", "trees/sofa_carotids.stl", 16, 3, 2},
                                      {"Network", "trees/sofa_phantom_network.obj", 12, 8, 0}};
INSTANTIATE_TEST_SUITE_P(Shared, Real_alone, ::testing::ValuesIn(real_surfaces),
                         [](const ::testing::TestParamInfo<Real_surface>& info) {
                           return std::string(info.param.name);
                         });

} // namespace

#endif // TUBULAR_MESH_TOOL

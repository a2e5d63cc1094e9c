// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// tubular_mesh with its parametric surface mesher, the default: surfaces alone, and meshes that keep them.

#include "test_tool_helpers.h"
#include "test_tool_report.h"

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;
namespace PMP = CGAL::Polygon_mesh_processing;

Surface surface_in(const std::string& file) {
  Surface surface;
  tubular::IO::read_surface(file, surface);
  return surface;
}

TEST_F(Tool, Makes_a_surface_alone_in_each_format) {
  const std::string input = make("y.off", bifurcation().surface);
  std::map<std::string, std::size_t> triangles;
  for (const char* format : {"stl", "vtp", "msh", "ply", "off", "obj", "vtk"}) {
    const std::string file = out(std::string("s.") + format);
    succeed({input, "-t", "surface", "-n", "12", "-o", file, "--report", out("r.json")});
    const Surface s = surface_in(file);
    triangles[format] = s.number_of_faces();
    EXPECT_TRUE(CGAL::is_closed(s)) << format;
    EXPECT_FALSE(PMP::does_self_intersect(s)) << format;
    EXPECT_EQ(json_in(out("r.json"))["facets"]["triangles"], s.number_of_faces()) << format;
  }
  for (const auto& t : triangles)
    EXPECT_EQ(t.second, triangles["off"]) << t.first;
}

TEST_F(Tool, Reports_the_surface_that_it_makes) {
  const std::string input = make("y.off", bifurcation().surface);
  const Outcome outcome = succeed({input, "-t", "surface", "-n", "16", "-o", out("s.vtp"), "--report", out("r.json")});
  const Json r = json_in(out("r.json"));
  EXPECT_EQ(r["valid"], true);
  EXPECT_EQ(r["boundary_euler"], 2);
  EXPECT_EQ(r["cells"]["tetrahedra"], 0);
  EXPECT_GE(r["quality"]["gamma_T"]["min"].get<double>(), 0.5);
  EXPECT_GE(r["quality"]["gamma_T"]["mean"].get<double>(), 0.95);
  const Json& p = r["patches"];
  EXPECT_EQ(p["junctions"], 1);
  EXPECT_EQ(p["annular"].get<int>() + p["junctions"].get<int>() + p["disks"].get<int>(), p["count"]);
  EXPECT_LE(p["largest_aspect_ratio"].get<double>(), 4 * (1 + 1e-9));
  EXPECT_TRUE(p["problems"].empty());
  EXPECT_NE(outcome.out.find("patches"), std::string::npos);
  EXPECT_EQ(outcome.out.find("tetrahedra, gamma_tau"), std::string::npos);
}

// The boundary of the mesh, as sorted triangles of points.
typedef std::array<Point, 3> Corners;
Corners turned(Corners c) { // from the least point on: the same for the same triangle, however it is begun
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  return c;
}
std::multiset<Corners> triangles_of(const Mesh& mesh) {
  std::multiset<Corners> all;
  for (const auto& t : mesh.triangles.vertices)
    all.insert(turned({{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}}));
  return all;
}
std::multiset<Corners> triangles_of(const Surface& s) {
  std::multiset<Corners> all;
  for (auto f : s.faces()) {
    const auto h = s.halfedge(f);
    all.insert(turned({{s.point(s.source(h)), s.point(s.target(h)), s.point(s.target(s.next(h)))}}));
  }
  return all;
}

TEST_F(Tool, Keeps_the_surface_triangle_for_triangle) {
  NEEDS_FILLING();
  const std::string input = make("y.off", bifurcation().surface);
  succeed({input, "-n", "14", "-o", out("mesh.vtu"), "--write-surface", out("s.vtp"), "--report", out("r.json")});
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  EXPECT_EQ(triangles_of(mesh), triangles_of(surface_in(out("s.vtp"))));
  const auto validity = tubular::validity_report(mesh);
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
  const Json r = json_in(out("r.json"));
  EXPECT_EQ(r["valid"], true);
  expect_by_patches(r);
  EXPECT_GE(r["quality"]["gamma_tau"]["mean"].get<double>(), 0.73);
  EXPECT_EQ(r["patches"]["junctions"], 1);
}

TEST_F(Tool, Fills_the_parametric_surface_by_Mesh_3_too) {
  const std::string input = make("y.off", bifurcation().surface);
  succeed({input, "-n", "12", "-o", out("mesh.vtu"), "--surface-mesher", "parametric", "--volume-mesher", "mesh_3",
           "--report", out("r.json")});
  const auto validity = tubular::validity_report(mesh_in(out("mesh.vtu")));
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
  EXPECT_EQ(json_in(out("r.json"))["fallbacks"], Json::array());
}

TEST_F(Tool, Makes_by_default_what_can_be_asked_for_by_name) {
  NEEDS("TetGen", tubular::has_tetgen());
  const std::string input = make("tube.off", tube().surface);
  const Arguments parametric = {"--surface-mesher", "parametric"}, tetgen = {"--volume-mesher", "tetgen"};
  std::string file;
  for (const Arguments& options : {Arguments(), parametric, tetgen, parametric + tetgen, Arguments{"--threads", "3"}}) {
    succeed(Arguments{input, "-n", "12", "-o", out("mesh.vtu")} + options);
    const std::string again = bytes_of(out("mesh.vtu"));
    EXPECT_TRUE(file.empty() || again == file) << ::testing::PrintToString(options);
    file = again;
  }
}

// --- anisotropic meshes ---

TEST_F(Tool, Makes_an_anisotropic_mesh) {
  const std::string input = make("tube.off", tube().surface);
  const Outcome outcome = succeed({input, "-t", "anisotropic", "-n", "12", "--curvature-points", "12", "--first-height",
                                   "0.05", "-o", out("mesh.vtu"), "--report", out("r.json")});
  EXPECT_NE(outcome.out.find("in the metric"), std::string::npos);
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  const auto validity = tubular::validity_report(mesh);
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
  ASSERT_EQ(mesh.point_arrays.size(), 1u);
  EXPECT_EQ(mesh.point_arrays[0].name, "metric");
  EXPECT_EQ(mesh.point_arrays[0].values.size(), 6 * mesh.points.size());
  const Json q = json_in(out("r.json"))["quality"];
  EXPECT_LE(q["Q_tau"]["mean"].get<double>(), 1.4);
  EXPECT_LE(q["Q_tau"]["max"].get<double>(), 8);
  EXPECT_GE(q["Q_tau"]["share_below_3"].get<double>(), 0.985);
  EXPECT_GE(q["efficiency"].get<double>(), 0.86);
}

// By the paper's parameters, on a smooth wall.
TEST_F(Tool, Lays_the_first_layer_along_the_wall) {
  const auto skeleton = tubular::y_bifurcation();
  Sample s;
  tubular::generate_tubular_surface(skeleton, s.surface, tubular::parameters::points_per_circumference(32));
  const Outcome outcome =
      succeed({make("y.off", s.surface), "-t", "anisotropic", "-o", out("mesh.vtu"), "--report", out("r.json")});
  EXPECT_NE(outcome.out.find("first layer"), std::string::npos);
  const Json q = json_in(out("r.json"))["quality"];
  EXPECT_GE(q["first_height"]["share_within_30_percent"].get<double>(), 0.95);
  EXPECT_GT(q["alignment"]["count"].get<int>(), 1000);
  EXPECT_GE(q["alignment"]["share_below_15_degrees"].get<double>(), 0.9);
}

// The metric is that of the mesh's own space: rotated and scaled with it.
TEST_F(Tool, Measures_in_the_metric_of_space) {
  const Sample s = tube();
  const double k = 1e-3, c = std::cos(0.7), t = std::sin(0.7);
  const CGAL::Aff_transformation_3<Kernel> move(k * c, 0, k * t, 5, 0, k, 0, -3, -k * t, 0, k * c, 1);
  std::array<double, 2> efficiency;
  std::array<std::size_t, 2> cells;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string input =
        make("tube" + std::to_string(i) + ".off", i == 0 ? s.surface : transformed(s, move).surface);
    succeed({input, "-t", "anisotropic", "-n", "10", "--curvature-points", "10", "--first-height", "0.08", "-o",
             out("mesh.vtu"), "--report", out("r.json")});
    const Json r = json_in(out("r.json"));
    efficiency[i] = r["quality"]["efficiency"];
    cells[i] = r["cells"]["tetrahedra"];
  }
  EXPECT_NEAR(efficiency[0], efficiency[1], 0.01);
  EXPECT_NEAR(double(cells[0]), double(cells[1]), 0.05 * double(cells[0])); // a tube has symmetries
}

// --- real vessels ---

struct Real_vessel {
  const char *name, *file;
  const char *points, *loops;
  int euler;
};
std::ostream& operator<<(std::ostream& out, const Real_vessel& v) {
  return out << v.name;
}
class Real_parametric : public Tool, public ::testing::WithParamInterface<Real_vessel> {};

TEST_P(Real_parametric, Is_meshed_well) {
  NEEDS_FILLING();
  const std::string file = shared_file(GetParam().file);
  NEEDS(file, fs::exists(file));
  Arguments arguments = {file, "-n", GetParam().points, "-o", out("mesh.vtu"), "--report", out("r.json")};
  if (*GetParam().loops != 0)
    arguments.push_back(GetParam().loops);
  succeed(arguments);
  const Json r = json_in(out("r.json"));
  const auto validity = tubular::validity_report(mesh_in(out("mesh.vtu")));
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
  EXPECT_EQ(r["boundary_euler"], GetParam().euler);
  expect_by_patches(r);
  EXPECT_TRUE(r["patches"]["problems"].empty());
  EXPECT_LE(r["patches"]["largest_aspect_ratio"].get<double>(), 4 * (1 + 1e-9));
  EXPECT_GE(r["quality"]["gamma_T"]["mean"].get<double>(), 0.95);
  EXPECT_GE(r["quality"]["gamma_tau"]["mean"].get<double>(), 0.72);
}

// Its wall has dimples that flips on the surface might close, by facets on top of each other.
TEST_F(Tool, Meshes_the_bypass_anisotropically) {
  const std::string surface = shared_file("paper/bypass.stl"), lines = shared_file("paper/centerlinesBYPASS.msh");
  NEEDS(surface, fs::exists(surface) && fs::exists(lines));
  succeed({surface, "-c", lines, "-t", "anisotropic", "-o", out("mesh.vtu"), "--report", out("r.json")});
  const auto validity = tubular::validity_report(mesh_in(out("mesh.vtu")));
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
  const Json q = json_in(out("r.json"))["quality"];
  EXPECT_LE(q["Q_tau"]["mean"].get<double>(), 1.4);
  EXPECT_LE(q["Q_tau"]["max"].get<double>(), 8);
  EXPECT_GE(q["Q_tau"]["share_below_3"].get<double>(), 0.985);
  EXPECT_GE(q["efficiency"].get<double>(), 0.86);
}

INSTANTIATE_TEST_SUITE_P(Shared, Real_parametric,
                         ::testing::Values(Real_vessel{"Aorta", "paper/aorta.stl", "20", "", 2},
                                           Real_vessel{"Carotid", "paper/carotid.stl", "12", "", 2},
                                           Real_vessel{"Bypass", "paper/bypass.stl", "16", "--loops", 0},
                                           Real_vessel{"Cylemi", "paper/cylemi.stl", "20", "", 2},
                                           Real_vessel{"Cerebral", "paper/cerebral.stl", "12", "", 2}),
                         [](const ::testing::TestParamInfo<Real_vessel>& info) {
                           return std::string(info.param.name);
                         });

} // namespace

#endif // TUBULAR_MESH_TOOL

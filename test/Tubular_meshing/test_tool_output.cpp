// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the command-line tool writes: meshes, the report, nothing else; all of it, or none.

#include "test_surfaces.h"
#include "test_tool_helpers.h"
#include "test_tool_report.h"

#include <CGAL/Tubular_meshing/Quads/blossom_recombination.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

// --- what fails on the way ---

class Full_disk : public Tool {
protected:
  // The output directory holds an older mesh, which must survive.
  void expect_nothing_written(const Arguments& arguments, const Limits& limits, const std::string& culprit) {
    std::ofstream(out("mesh.vtu")) << "the mesh of yesterday";
    const std::set<std::string> before = listing(output_directory());
    const Outcome outcome = run(arguments, limits);
    EXPECT_EQ(outcome.status, meshing) << outcome.killed_by << outcome.err;
    EXPECT_EQ(outcome.out, "");
    expect_one_sentence(outcome, {culprit, "cannot be written"});
    EXPECT_EQ(listing(output_directory()), before);
    EXPECT_EQ(bytes_of(out("mesh.vtu")), "the mesh of yesterday");
  }
  bool link_to_full_device(const std::string& name) const {
    if (!fs::exists("/dev/full"))
      return false;
    fs::create_symlink("/dev/full", out(name));
    return true;
  }
};

TEST_F(Full_disk, While_the_mesh_is_written) {
  Limits limits;
  limits.file_size = 20000;
  for (const char* format : {".vtu", ".msh", ".mesh"})
    expect_nothing_written(run_to(*this, out(std::string("mesh") + format)), limits, std::string("mesh") + format);
}

TEST_F(Full_disk, While_what_comes_after_the_mesh_is_written) {
  if (!link_to_full_device("full.json") || !link_to_full_device("full.vtp") || !link_to_full_device("full.vtu"))
    GTEST_SKIP() << "needs /dev/full";
  expect_nothing_written(tube_run(*this) + Arguments{"--report", out("full.json")}, Limits(), "full.json");
  expect_nothing_written(tube_run(*this) + Arguments{"--write-surface", out("full.vtp")}, Limits(), "full.vtp");
  expect_nothing_written(tube_run(*this) + Arguments{"--write-centerlines", out("full.vtp")}, Limits(), "full.vtp");
  expect_nothing_written(run_to(*this, out("full.vtu")) + Arguments{"--report", out("r.json")}, Limits(), "full.vtu");
}

// --- the mesh and its report ---

TEST_F(Tool, Reports_the_mesh_that_it_writes) {
  const Sample s = bifurcation();
  const std::string surface = make("y.vtp", s.surface), lines = make("lines.vtp", s.lines);
  const Outcome outcome = succeed({surface, "-c", lines, "-o", out("mesh.vtu"), "--report", out("r.json")});
  EXPECT_EQ(listing(output_directory()).size(), 2u);
  const Json report = json_in(out("r.json"));
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  expect_report_of(report, mesh);
  expect_by_patches(report);
  EXPECT_EQ(report["program"].get<std::string>() + "\n", run({"--version"}).out);
  EXPECT_EQ(report["input"], surface);
  EXPECT_EQ(report["centerlines"], lines);
  EXPECT_EQ(report["output"], out("mesh.vtu"));
  EXPECT_EQ(report["boundary_euler"], 2);
  EXPECT_EQ(report["openings"].size(), 3u);
  EXPECT_EQ(report["branches"].size(), 3u);

  // What it prints is the same.
  for (const char* number : {"points", "cells", "facets"}) {
    const Json& n = report[number];
    EXPECT_NE(outcome.out.find((n.is_object() ? n.front() : n).dump()), std::string::npos) << number;
  }
  double sum = 0;
  const std::vector<std::string> stages = stages_of(outcome);
  for (const auto& time : report["times"].items()) {
    EXPECT_GT(std::count(stages.begin(), stages.end(), time.key()), 0) << time.key();
    EXPECT_NE(outcome.out.find(time.key()), std::string::npos) << time.key();
    sum += time.value().get<double>();
  }
  EXPECT_LE(sum, report["total_time"].get<double>() + 0.01);
  EXPECT_GE(sum, 0.9 * report["total_time"].get<double>() - 0.01);
  EXPECT_GT(report["peak_memory_bytes"].get<double>(), 1e6);
}

TEST_F(Tool, Makes_the_same_files_from_the_same_input) {
  const Sample s = bifurcation();
  const Arguments arguments = {make("y.off", s.surface), "-c", make("lines.vtk", s.lines)};
  for (const Arguments& mesher : {Arguments(), by_mesh_3}) {
    for (const char* run : {"a", "b"})
      succeed(arguments + mesher + reproducibly +
              Arguments{"-o", out(run + std::string(".vtu")), "--write-surface", out(run + std::string(".vtp")),
                        "--write-centerlines", out(run + std::string(".vtk"))});
    for (const char* format : {".vtu", ".vtp", ".vtk"}) {
      EXPECT_TRUE(bytes_of(out(std::string("a") + format)) == bytes_of(out(std::string("b") + format))) << format;
      EXPECT_GT(bytes_of(out(std::string("a") + format)).size(), 1000u);
    }
  }
}

TEST_F(Tool, Makes_the_same_file_on_any_number_of_threads) {
  NEEDS_FILLING();
  for (const char* threads : {"1", "2"})
    succeed(
        {arch(), "-n", "8", "-o", out(std::string(threads) + ".vtu"), "--report", out("r.json"), "--threads", threads});
  expect_by_patches(json_in(out("r.json")));
  EXPECT_GT(bytes_of(out("1.vtu")).size(), 1000u);
  EXPECT_TRUE(bytes_of(out("1.vtu")) == bytes_of(out("2.vtu")));
}

TEST_F(Tool, Says_by_what_a_mesh_was_made) {
  const Arguments arguments = tube_run(*this) + Arguments{"-n", "12", "--report", out("r.json")};
  EXPECT_EQ(succeed(arguments).out.find("note: "), std::string::npos);
  expect_by_patches(json_in(out("r.json")));
  for (const Arguments& mesher : {by_mesh_3, Arguments{"--volume-mesher", "mesh_3"}}) {
    const Outcome outcome = succeed(arguments + mesher);
    EXPECT_EQ(outcome.out.find("note: "), std::string::npos);
    expect_report_of(json_in(out("r.json")), mesh_in(out("mesh.vtu")));
    expect_by_mesh_3(json_in(out("r.json")));
  }
}

// --- where meshing by patches fails ---

// A handle on the wall of a tube, through which a centerline runs or not.
std::string tube_with_a_handle_off() {
  const int around = 16, rows = 16, steps = 8, lower = 4, upper = 10; // the handle's ends are holes in these two rows
  std::vector<Point> points;
  std::ostringstream faces;
  int number_of_faces = 0;
  const auto add_quad = [&](int a, int b, int c, int d) {
    faces << "3 " << a << " " << b << " " << c << "\n3 " << a << " " << c << " " << d << "\n";
    number_of_faces += 2;
  };
  const auto at = [&](int i, int j) { return j * around + i % around; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < around; ++i) {
      const double a = 2 * CGAL_PI * i / around;
      points.push_back(Point(std::cos(a), std::sin(a), 6. * j / (rows - 1)));
    }
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i < around; ++i)
      if (i != 0 || (j != lower && j != upper))
        add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));

  // The lower hole's rim is turned about the middle between the holes until it is the upper one's.
  const std::array<int, 4> first = {{at(0, lower), at(1, lower), at(1, lower + 1), at(0, lower + 1)}};
  const std::array<int, 4> last = {{at(0, upper + 1), at(1, upper + 1), at(1, upper), at(0, upper)}};
  const double middle = 6. * (lower + upper + 1) / 2 / (rows - 1);
  const Kernel::Vector_3 outward(std::cos(CGAL_PI / around), std::sin(CGAL_PI / around), 0);
  std::array<int, 4> ring = first;
  for (int k = 1; k <= steps; ++k) {
    std::array<int, 4> next = last;
    const double turn = CGAL_PI * k / steps;
    for (std::size_t m = 0; k < steps && m < 4; ++m) {
      const Point start = points[std::size_t(first[m])];
      const double arm = middle - start.z();
      const Point p = start + arm * std::sin(turn) * outward;
      next[m] = int(points.size());
      points.push_back(Point(p.x(), p.y(), middle - arm * std::cos(turn)));
    }
    for (std::size_t m = 0; m < 4; ++m)
      add_quad(ring[m], ring[(m + 1) % 4], next[(m + 1) % 4], next[m]);
    ring = next;
  }
  std::ostringstream off;
  off.precision(17);
  off << "OFF\n" << points.size() << " " << number_of_faces << " 0\n";
  for (const Point& p : points)
    off << p << "\n";
  return off.str() + faces.str();
}

TEST_F(Tool, Meshes_a_handle_by_patches) {
  NEEDS_FILLING();
  const Arguments arguments = {make("handle.off", tube_with_a_handle_off()), "-n", "16", "--report", out("r.json")};
  for (const Arguments& loops : {Arguments{"--no-loops"}, Arguments{}}) {
    succeed(arguments + loops + Arguments{"-o", out("mesh.vtu")});
    const Json report = json_in(out("r.json"));
    expect_report_of(report, mesh_in(out("mesh.vtu")));
    expect_by_patches(report);
    EXPECT_EQ(report["boundary_euler"], 0);
    if (!loops.empty()) {
      EXPECT_EQ(report["patches"]["handle_cuts"], 1);
    }
    for (const Arguments& type : {Arguments{"-t", "mixed", "--wall", "0.1"}, Arguments{"--boundary-layer-prisms", "2"}})
      succeed(arguments + loops + type + Arguments{"-o", out("other.vtu")});
    succeed(arguments + loops + Arguments{"-t", "surface", "-o", out("surface.vtp")});
  }
}

// A closed surface, and so short that nothing cuts it.
std::string sphere_off() {
  std::ostringstream off;
  off.precision(17);
  off << test_surfaces::make_sphere(20, 40); // Surface_mesh writes OFF
  return off.str();
}

// --- formats and sizes ---

TEST_F(Tool, Writes_the_same_mesh_in_each_format) {
  std::vector<Mesh> meshes;
  for (const char* format : {".vtu", ".msh", ".mesh"}) {
    succeed(run_to(*this, out(std::string("m") + format)) + reproducibly);
    meshes.push_back(mesh_in(out(std::string("m") + format)));
  }
  for (const Mesh& m : meshes) {
    EXPECT_EQ(m.points, meshes[0].points);
    EXPECT_EQ(m.tetrahedra.vertices, meshes[0].tetrahedra.vertices);
    EXPECT_EQ(m.tetrahedra.label, meshes[0].tetrahedra.label);
    EXPECT_EQ(m.triangles.vertices, meshes[0].triangles.vertices);
    EXPECT_EQ(m.triangles.label, meshes[0].triangles.label);
    EXPECT_EQ(m.patch_names, meshes[0].patch_names);
  }
}

TEST_F(Tool, Obeys_the_limits_of_the_mesh_size) {
  for (const Arguments& mesher : {Arguments(), by_mesh_3 + reproducibly}) {
    const Arguments arguments = tube_run(*this) + Arguments{"--report", out("r.json")} + mesher;
    const auto cells = [&](const Arguments& options) {
      succeed(arguments + options);
      return json_in(out("r.json"))["cells"]["tetrahedra"].get<double>();
    };
    const double n_20 = cells({}), n_12 = cells({"-n", "12"}), size_at_20 = 2 * CGAL_PI / 20;
    const std::string size = std::to_string(size_at_20);
    EXPECT_GT(n_20 / n_12, 3); // 4.6, but for the surface's share
    EXPECT_LT(n_20 / n_12, 5);
    EXPECT_NEAR(cells({"-n", "12", "--max-size", size}), n_20, 0.06 * n_20); // the polygonal tube's radius is below 1
    EXPECT_NEAR(cells({"-n", "40", "--min-size", size}), n_20, 0.06 * n_20);
  }
}

// --- nothing else is left in the folder where it runs ---

struct Working_folder_run {
  const char* name;
  Exit_status status;
  std::string command_line;        // see arguments_of(); outputs are named relative to the folder
  std::set<std::string> asked_for; // the files that are there afterwards
  bool needs_filling = false, needs_quads = false;
};

std::ostream& operator<<(std::ostream& out, const Working_folder_run& r) {
  return out << r.name; // ctest's name of the test
}

class Working_folder : public Tool, public ::testing::WithParamInterface<Working_folder_run> {};

TEST_P(Working_folder, Holds_what_was_asked_for) {
  const Working_folder_run& r = GetParam();
  NEEDS("TetGen or CGAL 6.1", !r.needs_filling || tubular::default_volume_mesher() != tubular::Volume_mesher::mesh_3);
  NEEDS("LEMON", !r.needs_quads || tubular::has_lemon());
  const Sample s = tube();
  const fs::path folder = output_directory() / "folder";
  fs::create_directory(folder);
  make("tube.off", s.surface);
  make("lines.vtk", s.lines);
  const Outcome outcome = run_in(folder, arguments_of(r.command_line, *this));
  EXPECT_EQ(outcome.status, r.status) << outcome.killed_by << outcome.err;
  EXPECT_EQ(names_in(folder), r.asked_for);
  EXPECT_EQ(names_in(output_directory()), std::set<std::string>{"folder"});
}

std::string with(const std::string& options) {
  return "IN/tube.off -c IN/lines.vtk " + options;
}

const Working_folder_run working_folder_runs[] = {
    {"Isotropic", done, with("-n 10 -o m.vtu"), {"m.vtu"}},
    {"Isotropic_with_everything",
     done,
     with("-n 10 -o m.msh --report r.json --write-surface s.vtp --write-centerlines c.vtk"),
     {"m.msh", "r.json", "s.vtp", "c.vtk"}},
    {"By_Mesh_3", done, with("-n 10 -o m.mesh --surface-mesher mesh_3"), {"m.mesh"}},
    {"Anisotropic", done, with("-t anisotropic -n 10 --curvature-points 10 --first-height 0.08 -o m.vtu"), {"m.vtu"}},
    {"Mixed", done, with("-t mixed -n 10 --wall 0.2 -o m.inp"), {"m.inp"}, true, true},
    {"Surface", done, with("-t surface -n 10 -o s.stl"), {"s.stl"}},
    {"Layers", done, with("-n 14 --boundary-layer-prisms 2 --first-height 0.02 -o m.vtu"), {"m.vtu"}, true},
    {"Wrong_usage", usage, with("-n 0 -o m.vtu --report r.json"), {}},
    {"Unusable_input", input, "IN/tube.off -c IN/absent.vtk -o m.vtu --report r.json", {}},
    {"Meshing_failed",
     meshing,
     with("--boundary-layer-prisms 3 --first-height 1e-17 -o m.vtu --report r.json"),
     {},
     true},
};
INSTANTIATE_TEST_SUITE_P(After, Working_folder, ::testing::ValuesIn(working_folder_runs),
                         [](const ::testing::TestParamInfo<Working_folder_run>& info) {
                           return std::string(info.param.name);
                         });

} // namespace

#endif // TUBULAR_MESH_TOOL

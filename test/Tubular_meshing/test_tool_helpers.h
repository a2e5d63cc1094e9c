// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_TOOL_HELPERS_H
#define TUBULAR_MESHING_TEST_TOOL_HELPERS_H

// What tests of the command-line tool need: a directory for its input and one for its output, small surfaces with their
// centerlines, and where models are that are not part of this project.

#include "test_tool_process.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace tool_test {

namespace tubular = CGAL::Tubular_meshing;
typedef nlohmann::json Json;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef tubular::Mixed_mesh Mesh;
typedef tubular::Centerline_polylines Centerlines;

// --- what not every build, and not every machine, has ---

#define NEEDS(what, is_there)                                                                                          \
  if (!(is_there))                                                                                                     \
  GTEST_SKIP() << "needs " << (what)

// Fills a surface mesh and keeps its triangles.
#define NEEDS_FILLING() NEEDS("TetGen or CGAL 6.1", tubular::default_volume_mesher() != tubular::Volume_mesher::mesh_3)

#ifdef TUBULAR_MESHING_SHARED_DATA
const char* const shared_data = TUBULAR_MESHING_SHARED_DATA;
#else
const char* const shared_data = "shared/data, which is not here";
#endif

inline std::string shared_file(const std::string& name) {
  return (fs::path(shared_data) / name).string();
}

// The sample that is shipped.
inline std::string arch() {
  return std::string(TUBULAR_MESHING_DATA) + "/aortic_arch.stl";
}
inline std::string arch_centerlines() {
  return std::string(TUBULAR_MESHING_DATA) + "/aortic_arch_centerlines.vtk";
}

// --- a test's files ---

/* Directories of a test's own, for input and for output, which go when it has passed. */
class Tool : public ::testing::Test {
protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(info->test_suite_name()) + "." + info->name();
    std::replace(name.begin(), name.end(), '/', '_');
    directory_ = fs::path(TUBULAR_MESHING_SCRATCH) / "test_tool" / name;
    fs::remove_all(directory_);
    fs::create_directories(directory_ / "in");
    fs::create_directories(directory_ / "out");
  }
  void TearDown() override {
    if (!HasFailure())
      fs::remove_all(directory_);
  }

public:
  std::string in(const std::string& name) const { return (directory_ / "in" / name).string(); }
  std::string out(const std::string& name) const { return (directory_ / "out" / name).string(); }
  fs::path output_directory() const { return directory_ / "out"; }

  std::string make(const std::string& name, const std::string& bytes) const {
    std::ofstream(in(name), std::ios::binary) << bytes;
    return in(name);
  }

  std::string make(const std::string& name, const Surface& surface) const {
    tubular::IO::write_surface(in(name), surface);
    return in(name);
  }

  std::string make(const std::string& name, const Centerlines& lines) const {
    tubular::IO::write_centerlines(in(name), lines);
    return in(name);
  }

  // In the directory for output, so that any file it leaves behind there is seen.
  Outcome run(const Arguments& arguments, const Limits& limits = Limits()) const {
    return run_in(output_directory(), arguments, limits);
  }

  static Outcome run_in(const fs::path& directory, const Arguments& arguments, const Limits& limits = Limits()) {
    return Child_process(TUBULAR_MESH_TOOL, arguments, directory, limits).wait();
  }

  // A run that has to succeed.
  Outcome succeed(const Arguments& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, done) << outcome.killed_by << "\n" << outcome.err;
    EXPECT_TRUE(complaints(outcome).empty()) << outcome.err;
    return outcome;
  }

  static Mesh mesh_in(const std::string& file) {
    Mesh mesh;
    tubular::IO::read_mesh(file, mesh);
    return mesh;
  }

  static Json json_in(const std::string& file) { return Json::parse(bytes_of(file)); }

private:
  fs::path directory_;
};

// --- input ---

struct Sample {
  Surface surface;
  Centerlines lines;
};

inline Sample sample_of(const tubular::Tubular_skeleton& skeleton) {
  Sample s;
  tubular::generate_tubular_surface(skeleton, s.surface, tubular::parameters::points_per_circumference(16));
  s.lines = tubular::centerlines_of(skeleton);
  return s;
}

// The cheapest there is: meshed in a tenth of a second.
inline Sample tube() {
  return sample_of(tubular::straight_tube(6, 1));
}

inline Sample bifurcation() {
  return sample_of(tubular::y_bifurcation());
}

template <class Transformation> Sample transformed(Sample s, const Transformation& move) {
  for (auto v : s.surface.vertices())
    s.surface.point(v) = move(s.surface.point(v));
  for (Point& p : s.lines.points)
    p = move(p);
  s.lines.radius.clear(); // of no use to the tool, and no longer true
  return s;
}

// --- command lines ---

const Arguments by_mesh_3 = {"--surface-mesher", "mesh_3"};
const Arguments reproducibly = {"--threads", "1"}; // what Mesh_3 makes

// Where IN/ and OUT/ stand for the test's directories, and '' for an empty argument.
inline Arguments arguments_of(const std::string& command_line, const Tool& t) {
  Arguments arguments;
  std::istringstream words(command_line);
  for (std::string word; words >> word; arguments.push_back(word))
    if (word == "''")
      word.clear();
    else if (word.compare(0, 3, "IN/") == 0)
      word = t.in(word.substr(3));
    else if (word.compare(0, 4, "OUT/") == 0)
      word = t.out(word.substr(4));
  return arguments;
}

inline Arguments run_to(const Tool& t, const std::string& output_file) {
  const Sample s = tube();
  return {t.make("tube.off", s.surface), "-c", t.make("lines.vtk", s.lines), "-o", output_file};
}

inline Arguments tube_run(const Tool& t) {
  return run_to(t, t.out("mesh.vtu"));
}

inline std::set<std::string> files_below(const std::filesystem::path& folder) {
  std::set<std::string> files;
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder))
    if (!file.is_directory())
      files.insert(file.path().lexically_relative(folder).string());
  return files;
}

// A run that is refused as wrong usage, in one line with these words, and leaves all as it was.
inline void expect_refused(const Tool& t, const Arguments& arguments, const std::set<std::string>& mentioned) {
  const auto before = files_below(t.output_directory());
  const Outcome outcome = t.run(arguments);
  EXPECT_EQ(outcome.status, usage) << outcome.err;
  for (const std::string& word : mentioned)
    EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " is not in: " << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(files_below(t.output_directory()), before);
}

} // namespace tool_test

#endif // TUBULAR_MESHING_TEST_TOOL_HELPERS_H

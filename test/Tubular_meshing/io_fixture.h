// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the tests of files have in common: a directory a test, and things to write.

#ifndef TUBULAR_MESHING_TEST_IO_FIXTURE_H
#define TUBULAR_MESHING_TEST_IO_FIXTURE_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;
namespace TM = CGAL::Tubular_meshing;
typedef TM::Point_3 Point;
typedef TM::Surface Surface;
typedef TM::Mixed_mesh Mesh;
typedef TM::Centerline_polylines Centerlines;
typedef std::vector<std::array<std::size_t, 3>> Triangles;

// A directory of its own for each test, which goes with it.
class IO : public ::testing::Test {
protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("tubular_meshing_test_io_") + info->test_suite_name() + "_" + info->name();
    std::replace(name.begin(), name.end(), '/', '_'); // of tests with a type or a value
    directory = fs::temp_directory_path() / name;
    fs::remove_all(directory);
    fs::create_directories(directory);
  }
  void TearDown() override { fs::remove_all(directory); }

  std::string path(const std::string& name) const { return (directory / name).string(); }

  std::string make(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  static std::string bytes_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
  }

  std::size_t number_of_files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
  }

  fs::path directory;
};

// One element of each kind at least, labels in no order, coordinates that need all their digits.
inline Mesh sample_mesh() {
  Mesh m;
  for (int i = 0; i < 12; ++i)
    m.points.push_back(Point(i / 3. - 1, std::sqrt(i + 0.1) * 1e-7, -0.0 + i * 12345.678901234567));
  m.points[3] = Point(-0.0, 5e-324, 1.7976931348623157e308);
  m.tetrahedra.push_back({0, 1, 2, 3}, 2);
  m.tetrahedra.push_back({1, 2, 3, 4}, 1);
  m.tetrahedra.push_back({4, 5, 6, 7}, 2);
  m.pyramids.push_back({0, 1, 2, 3, 4}, 1);
  m.prisms.push_back({5, 6, 7, 8, 9, 10}, 2);
  m.prisms.push_back({0, 1, 2, 8, 9, 11}, 1);
  m.hexahedra.push_back({0, 1, 2, 3, 4, 5, 6, 7}, 1);
  m.triangles.push_back({0, 1, 2}, 3);
  m.triangles.push_back({2, 1, 4}, 1);
  m.triangles.push_back({9, 10, 11}, 102);
  m.quads.push_back({0, 1, 2, 3}, 2);
  m.region_names = {{1, "lumen"}, {2, "wall"}};
  m.patch_names = {{1, "wall"}, {2, "inlet"}, {3, "outlet_1"}, {102, "ring <&> 'x'"}};
  return m;
}

inline TM::Point_array sample_array(const std::string& name, int components, std::size_t points) {
  TM::Point_array a{name, components, {}};
  for (std::size_t i = 0; i < points * static_cast<std::size_t>(components); ++i)
    a.values.push_back(std::sin(1. + static_cast<double>(i)));
  return a;
}

inline Surface tetrahedron() {
  Surface s;
  const auto a = s.add_vertex(Point(0, 0, 0)), b = s.add_vertex(Point(1. / 3, 0, 0)),
             c = s.add_vertex(Point(0, 0.1, 0)), d = s.add_vertex(Point(0, 0, 1e-9));
  s.add_face(a, c, b);
  s.add_face(a, b, d);
  s.add_face(b, c, d);
  s.add_face(c, a, d);
  return s;
}

#endif // TUBULAR_MESHING_TEST_IO_FIXTURE_H

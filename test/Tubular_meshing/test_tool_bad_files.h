// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_TOOL_BAD_FILES_H
#define TUBULAR_MESHING_TEST_TOOL_BAD_FILES_H

// Files that nobody can mesh, all in the test's directory for input.

#include "test_tool_helpers.h"

#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>

namespace tool_test {

inline std::string first_part(const std::string& bytes, double share) {
  return bytes.substr(0, std::size_t(share * double(bytes.size())));
}

inline std::string replaced(std::string bytes, std::size_t at, const std::string& by) {
  return bytes.replace(at, by.size(), by);
}

inline std::string one_facet(const std::string& x) {
  return "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex " + x +
         " 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n";
}

inline std::string two_points(const std::string& z) {
  return "# vtk DataFile Version 3.0\nc\nASCII\nDATASET POLYDATA\nPOINTS 2 double\n0 0 0 0 0 " + z +
         "\nLINES 1 3\n2 0 1\n";
}

// A closed surface without a flat place.
inline std::string sphere_off() {
  const int rows = 24, columns = 32;
  std::ostringstream points, faces;
  const auto index = [&](int i, int j) { return 1 + (i - 1) * columns + j % columns; };
  points << "0 0 1\n";
  for (int i = 1; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double a = CGAL_PI * i / rows, b = 2 * CGAL_PI * j / columns;
      points << std::sin(a) * std::cos(b) << " " << std::sin(a) * std::sin(b) << " " << std::cos(a) << "\n";
    }
  points << "0 0 -1\n";
  const int last = (rows - 1) * columns + 1;
  for (int j = 0; j < columns; ++j) {
    faces << "3 0 " << index(1, j) << " " << index(1, j + 1) << "\n";
    for (int i = 1; i + 1 < rows; ++i)
      faces << "3 " << index(i, j) << " " << index(i + 1, j) << " " << index(i + 1, j + 1) << "\n3 " << index(i, j)
            << " " << index(i + 1, j + 1) << " " << index(i, j + 1) << "\n";
    faces << "3 " << index(rows - 1, j) << " " << last << " " << index(rows - 1, j + 1) << "\n";
  }
  return "OFF\n" + std::to_string(last + 1) + " " + std::to_string(2 * (rows - 1) * columns) + " 0\n" + points.str() +
         faces.str();
}

// What of a surface lies above z = 0, stretched along z.
inline Surface half_of(const std::string& off, double stretch) {
  Surface surface;
  std::istringstream in(off);
  CGAL::IO::read_OFF(in, surface);
  for (auto f : surface.faces())
    for (auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      if (surface.point(v).z() < -1e-9) {
        CGAL::Euler::remove_face(surface.halfedge(f), surface);
        break;
      }
  surface.collect_garbage();
  for (auto v : surface.vertices())
    surface.point(v) = Point(surface.point(v).x(), surface.point(v).y(), stretch * surface.point(v).z());
  return surface;
}

// A hole in the wall, as large as the vessel.
inline Surface tube_with_a_window() {
  Surface surface = tube().surface;
  for (auto f : surface.faces()) {
    const Point& p = surface.point(surface.target(surface.halfedge(f)));
    if (p.x() > 0.5 && std::abs(p.z() - 3) < 0.9)
      CGAL::Euler::remove_face(surface.halfedge(f), surface);
  }
  surface.collect_garbage();
  return surface;
}

// Two tubes side by side: apart, or each in the other's wall.
inline Sample two_tubes(double distance) {
  Sample s = tube();
  const Kernel::Vector_3 by(distance, 0, 0);
  const Sample other = transformed(s, [&](const Point& p) { return p + by; });
  CGAL::copy_face_graph(other.surface, s.surface);
  for (const auto& line : other.lines.lines) {
    s.lines.lines.emplace_back();
    for (std::size_t i : line) {
      s.lines.lines.back().push_back(s.lines.points.size());
      s.lines.points.push_back(other.lines.points[i]);
    }
  }
  s.lines.radius.clear();
  return s;
}

// A tube with a point of its wall pulled through the wall across.
inline Surface spiked_tube() {
  Surface surface = tube().surface;
  for (auto v : surface.vertices())
    if (std::abs(surface.point(v).z() - 3) < 0.5 && surface.point(v).x() > 0.9) {
      surface.point(v) = Point(-2, 0, 3);
      break;
    }
  return surface;
}

inline void make_bad_surfaces(const Tool& t, const Sample& good) {
  const std::string stl = bytes_of(t.make("good.stl", good.surface)), off = bytes_of(t.in("tube.off"));
  const std::string vtp = bytes_of(t.make("good.vtp", good.surface));
  t.make("empty.stl", "");
  t.make("letter.stl", "Dear reader,\nthis is a letter, not a surface.\n");
  t.make("surface.docx", off);
  t.make("cut.stl", first_part(stl, 0.6));
  t.make("no_triangles.stl", replaced(stl, 80, std::string(4, '\0')).substr(0, 84));
  t.make("half_a_header.stl", stl.substr(0, 40));
  t.make("four_billion.stl", replaced(stl, 80, "\xff\xff\xff\xff"));
  t.make("nan_in_binary.stl", replaced(stl, 84 + 50 * 7 + 12, std::string("\x00\x00\xc0\x7f", 4)));
  t.make("cut_ascii.stl", one_facet("1").substr(0, 70));
  t.make("nan.stl", one_facet("nan"));
  t.make("infinity.stl", one_facet("-inf"));
  t.make("one_triangle.stl", one_facet("1"));
  t.make("cut.off", first_part(off, 0.8));
  t.make("wrong_index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
  t.make("one_point.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n");
  t.make("cut.vtp", first_part(vtp, 0.7));
  t.make("lines.vtp", good.lines);
  t.make("sphere.off", sphere_off());
  t.make("bag.off", half_of(sphere_off(), 4));
  t.make("window.off", tube_with_a_window());
  t.make("seeds.txt", "0 0 0\n0 0 6\n");
  t.make("one_seed.txt", "# the inlet\n0 0 1\n\n");
  t.make("spiked.off", spiked_tube());
  t.make("overlapping.off", two_tubes(1.2).surface);
  t.make("overlapping.vtk", two_tubes(1.2).lines);
  t.make("two.off", two_tubes(4).surface);
  t.make("two.vtk", two_tubes(4).lines);
  fs::create_directory(t.in("folder.stl"));
}

inline void make_bad_centerlines(const Tool& t, const Sample& good) {
  const auto moved = [&](double scale, const Kernel::Vector_3& by) {
    return transformed(good, [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN) + by; }).lines;
  };
  t.make("empty.vtp", "");
  t.make("letter.vtk", "Dear reader,\nthis is a letter.\n");
  t.make("cut.vtk", first_part(bytes_of(t.in("lines.vtk")), 0.5));
  t.make("nan.vtk", two_points("nan"));
  t.make("one_place.vtk", two_points("0"));
  t.make("far_away.vtk", moved(1, {1000, 0, 0}));
  t.make("beside.vtk", moved(1, {4, 0, 0}));
  t.make("larger.vtk", moved(1000, {0, 50, 0}));
  t.make("smaller.vtk", moved(1e-3, {0, 0, -1}));
}

} // namespace tool_test

#endif // TUBULAR_MESHING_TEST_TOOL_BAD_FILES_H

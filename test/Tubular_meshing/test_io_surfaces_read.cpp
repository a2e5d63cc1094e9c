// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of other programs: what they wrote is understood, and what is wrong is named.

#include "io_fixture.h"

#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Kernel/global_functions.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

void expect_input_error(const std::string& file, const std::string& part_of_sentence) {
  Surface s;
  try {
    TM::IO::read_surface(file, s);
    ADD_FAILURE() << file << " was read";
  } catch (const TM::Input_error& e) {
    EXPECT_NE(std::string(e.what()).find(part_of_sentence), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find(fs::path(file).filename().string()), std::string::npos) << e.what();
  }
}

template <class T> void append(std::string& s, T x) {
  s.append(reinterpret_cast<const char*>(&x), sizeof x);
}

std::string binary_stl(const std::string& header, std::uint32_t announced, std::uint32_t real) {
  std::string s = header;
  s.resize(80, '\0');
  append(s, announced);
  for (std::uint32_t i = 0; i < real; ++i) {
    for (float x : {0.f, 0.f, 1.f, float(i), 0.f, 0.f, float(i + 1), 0.f, 0.f, float(i), 1.f, 0.f})
      append(s, x);
    append(s, std::uint16_t(0));
  }
  return s;
}

} // namespace

TEST_F(IO, Binary_stl_may_start_with_solid) {
  Surface s;
  std::vector<Point> points;
  Triangles triangles;
  const std::string file = make("a.stl", binary_stl("solid facet vertex", 3, 3));
  TM::IO::read_triangle_soup(file, points, triangles);
  EXPECT_EQ(points.size(), 7u);
  EXPECT_EQ(triangles.size(), 3u);
  TM::IO::read_surface(file, s);
  EXPECT_EQ(s.number_of_faces(), 3u);
  EXPECT_EQ(s.number_of_vertices(), 9u); // the triangles touch at single points, which no manifold does
}

TEST_F(IO, Ascii_stl_in_odd_dress) {
  Surface s;
  TM::IO::read_surface(make("a.stl", "  SOLID facet vertex\r\n FACET normal nan 0 0 outer loop\r\n"
                                     "vertex +0 0 0 vertex 1e0 0 0 VERTEX 0 1 0 endloop endfacet endsolid\r\n"),
                       s);
  EXPECT_EQ(s.number_of_faces(), 1u);
}

TEST_F(IO, Polygons_are_triangulated_without_folds) {
  // a dart, whose only diagonal that lies inside starts at its reflex corner 2, and an L of six corners
  const std::string dart = "OFF\n4 1 0\n0 0 0\n4 0 0\n1 1 0\n0 4 0\n4 1 2 3 0\n";
  const std::string ell = "OFF\n6 1 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n6 0 1 2 3 4 5\n";
  const std::pair<std::string, double> cases[] = {{dart, 4.}, {ell, 3.}};
  for (const auto& c : cases) {
    std::vector<Point> p;
    Triangles triangles;
    TM::IO::read_triangle_soup(make("a.off", c.first), p, triangles);
    double area = 0;
    for (const auto& t : triangles) {
      const double a = CGAL::cross_product(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]).z() / 2;
      EXPECT_GT(a, 0);
      area += a;
    }
    EXPECT_DOUBLE_EQ(area, c.second);
  }
}

TEST_F(IO, Obj_indices_of_all_sorts) {
  std::vector<Point> p;
  Triangles t;
  TM::IO::read_triangle_soup(
      make("a.obj", "# c\nv 0 0 0\nv 1 0 0 1.0\nvn 0 0 1\nv 1 1 0\nv 0 1 0\ng x\nf 1/1 2/2/2 3//1\nf -4 -2 -1\n"), p,
      t);
  EXPECT_EQ(t, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(IO, Ply_in_both_byte_orders_and_with_other_elements) {
  for (const bool big : {false, true}) {
    std::string s = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                    "_endian 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty uchar red\nproperty float y\n"
                    "property float z\nelement edge 1\nproperty list uchar short e\nelement face 1\n"
                    "property list uchar uint vertex_index\nend_header\n";
    const auto put = [&](auto x) {
      std::string b;
      append(b, x);
      if (big != !TM::IO::internal::host_is_little_endian())
        std::reverse(b.begin(), b.end());
      s += b;
    };
    for (float x : {0.f, 1.f, 2.f}) {
      put(x);
      put(std::uint8_t(7));
      put(x * x);
      put(0.f);
    }
    put(std::uint8_t(2));
    put(std::int16_t(0));
    put(std::int16_t(1));
    put(std::uint8_t(3));
    for (std::uint32_t v : {2u, 0u, 1u})
      put(v);
    std::vector<Point> p;
    Triangles t;
    TM::IO::read_triangle_soup(make("a.ply", s), p, t);
    EXPECT_EQ(p[2], Point(2, 4, 0));
    EXPECT_EQ(t, (Triangles{{2, 0, 1}}));
  }
}

TEST_F(IO, Vtp_ascii_with_strips_and_pieces) {
  const std::string piece =
      "<Piece NumberOfPoints=\"4\" NumberOfStrips=\"1\" NumberOfPolys=\"0\"><Points><DataArray type=\"Float32\" "
      "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 1 1 0</DataArray></Points><Strips><DataArray "
      "type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray><DataArray type=\"Int32\" "
      "Name=\"offsets\" format=\"ascii\">4</DataArray></Strips></Piece>";
  const std::string file = make("a.vtp", "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\"><PolyData>" + piece +
                                             piece + "</PolyData></VTKFile>");
  std::vector<Point> p;
  Triangles t;
  TM::IO::read_triangle_soup(file, p, t);
  EXPECT_EQ(t, (Triangles{{0, 1, 2}, {1, 3, 2}, {4, 5, 6}, {5, 7, 6}}));
  Surface s;
  TM::IO::read_surface(file, s); // the second piece is the first again
  EXPECT_EQ(s.number_of_faces(), 2u);
}

TEST_F(IO, Vtp_inline_base64) {
  // three points and one triangle, UInt32 header, written by hand: 36, 12 and 4 bytes
  const std::string file = make(
      "a.vtp", "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" header_type=\"UInt32\"><PolyData><Piece "
               "NumberOfPoints=\"3\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
               "format=\"binary\">\n JAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAA==\n</DataArray></Points>"
               "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"binary\">DAAAAAAAAAABAAAAAgAAAA=="
               "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"binary\">BAAAAAMAAAA=</DataArray>"
               "</Polys></Piece></PolyData></VTKFile>");
  std::vector<Point> p;
  Triangles t;
  TM::IO::read_triangle_soup(file, p, t);
  EXPECT_EQ(t, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(p[2], Point(0, 1, 0));
}

TEST_F(IO, Soup_becomes_an_oriented_mesh) {
  Surface s;
  // the second triangle is turned over, the third is the first again, the fourth has two equal corners, vertex 5 is
  // unused
  TM::IO::read_surface(make("a.off", "OFF\n6 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n-0 0 0\n9 9 9\n"
                                     "3 0 1 2\n3 4 3 2\n3 2 0 1\n3 0 4 3\n"),
                       s);
  EXPECT_EQ(s.number_of_vertices(), 4u);
  EXPECT_EQ(s.number_of_faces(), 2u);
  EXPECT_EQ(s.number_of_edges(), 5u);
  // three triangles at an edge
  TM::IO::read_surface(make("b.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n"), s);
  EXPECT_EQ(s.number_of_faces(), 3u);
  EXPECT_TRUE(s.is_valid());
}

TEST_F(IO, Bad_surfaces_are_named) {
  expect_input_error(path("missing.stl"), "cannot be opened");
  expect_input_error(make("empty.stl", ""), "is empty");
  expect_input_error(make("text.stl", "Dear all,\nthis is a letter.\n"), "neither ASCII STL");
  expect_input_error(make("text2.stl", "solid ground\nunder our feet\n"), "line 2");
  expect_input_error(make("letter.off", "Dear all"), "keyword OFF");
  expect_input_error(make("letter.obj", "Dear all"), "no triangles");
  expect_input_error(make("letter.ply", "Dear all"), "'ply'");
  expect_input_error(make("letter.vtp", "Dear all"), "VTK XML");
  expect_input_error(make("letter.vtk", "Dear all"), "legacy VTK");
  expect_input_error(make("letter.msh", "Dear all"), "section");
  expect_input_error(make("letter.xyz", "Dear all"), "known format");
  expect_input_error(directory.string(), "cannot be");
  expect_input_error(make("none.stl", "solid\nendsolid\n"), "no triangles");
  expect_input_error(make("zero.stl", binary_stl("", 0, 0)), "no triangles");
  expect_input_error(make("short.stl", binary_stl("", 3, 2)), "truncated");
  expect_input_error(make("huge.stl", binary_stl("", 0xffffffffu, 2)), "truncated");
  expect_input_error(make("nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), "y coordinate of vertex 1");
  expect_input_error(make("inf.obj", "v 0 0 0\nv 1 0 0\nv 0 1 1e999\nf 1 2 3\n"), "z coordinate of vertex 2");
  std::string nan = binary_stl("", 1, 1);
  const float value = std::numeric_limits<float>::quiet_NaN();
  nan.replace(84 + 12, 4, reinterpret_cast<const char*>(&value), 4);
  expect_input_error(make("nan.stl", nan), "x coordinate of vertex 0");
  expect_input_error(make("word.off", "OFF\n3 1 0\n0 0 0\n1 O 0\n0 1 0\n3 0 1 2\n"), "line 4: 'O'");
  expect_input_error(make("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "vertex 3");
  expect_input_error(make("minus.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), "vertex -1");
  expect_input_error(make("lie.off", "OFF\n4000000000 1 0\n0 0 0\n"), "4000000000");
  expect_input_error(
      make("lie.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nend_header\n"),
      "99999999999");
  expect_input_error(make("point.off", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n"), "three different corners");
}

TEST_F(IO, Real_surfaces) {
#ifndef TUBULAR_MESHING_SHARED_DATA
  GTEST_SKIP() << "needs shared/data";
#else
  const fs::path data = TUBULAR_MESHING_SHARED_DATA;
  struct Row {
    const char* file;
    std::size_t points, triangles;
  };
  const Row surfaces[] = {{"paper/aorta.stl", 2211, 4323},
                          {"paper/bypass.stl", 23317, 46522},
                          {"paper/carotid.stl", 5829, 11594},
                          {"paper/cerebral.stl", 40571, 80979},
                          {"paper/cylemi.stl", 523, 990},
                          {"trees/airway_lf_open.vtp", 202093, 400481},
                          {"trees/sofa_LCA.stl", 731, 1406},
                          {"trees/sofa_carotids.stl", 1164, 2289},
                          {"trees/sofa_phantom_network.obj", 3220, 6392}};
  if (!fs::exists(data / surfaces[0].file))
    GTEST_SKIP() << "needs shared/data/" << surfaces[0].file;
  for (const Row& r : surfaces) {
    Surface s;
    TM::IO::read_surface((data / r.file).string(), s);
    EXPECT_EQ(s.number_of_vertices(), r.points) << r.file;
    EXPECT_EQ(s.number_of_faces(), r.triangles) << r.file;
  }
#endif
}

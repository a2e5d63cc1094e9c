// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces: what is written is read back equal.

#include "io_fixture.h"

#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

TEST_F(IO, Surfaces_are_read_back_equal) {
  const Surface s = tetrahedron();
  for (const std::string name : {"s.off", "s.obj", "s.ply", "s.vtp", "s.vtk", "s.msh", "s.stl"}) {
    SCOPED_TRACE(name);
    TM::IO::write_surface(path(name), s);
    Surface back;
    TM::IO::read_surface(path(name), back);
    ASSERT_EQ(back.number_of_vertices(), 4u);
    ASSERT_EQ(back.number_of_faces(), 4u);
    EXPECT_TRUE(CGAL::is_closed(back));
    std::vector<Point> points;
    Triangles triangles;
    TM::IO::read_triangle_soup(path(name), points, triangles);
    for (auto v : s.vertices()) {
      if (name != "s.stl") { // which is in single precision, and in the order of the triangles
        EXPECT_EQ(points[v], s.point(v));
      }
    }
  }
}

TEST_F(IO, Patches_of_a_surface_are_written) {
  Surface s = tetrahedron();
  auto patch = s.add_property_map<Surface::Face_index, int>("f:patch", 1).first;
  patch[Surface::Face_index(2)] = 2;
  const auto np = TM::parameters::face_patch_map(patch);
  TM::IO::write_surface(path("s.msh"), s, np);
  Mesh m;
  TM::IO::read_mesh(path("s.msh"), m);
  EXPECT_EQ(m.triangles.label, (std::vector<int>{1, 1, 2, 1}));
  EXPECT_EQ(m.patch_names, (TM::Label_names{{1, "wall"}, {2, "inlet"}}));
  TM::IO::write_surface(path("s.vtp"), s, np);
  EXPECT_NE(bytes_of(path("s.vtp")).find("Name=\"patch\""), std::string::npos);
  TM::IO::write_surface(path("s.ply"), s, np);
  Surface back;
  TM::IO::read_surface(path("s.ply"), back);
  EXPECT_EQ(back.number_of_faces(), 4u);
}

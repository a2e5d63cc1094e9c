// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Centerlines: what is written is read back equal, and what other programs wrote is understood.

#include "io_fixture.h"

#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <string>
#include <vector>

TEST_F(IO, Centerlines_are_read_back_equal) {
  Centerlines c, back;
  c.points = {Point(0, 0, 0), Point(1. / 3, 0, 0), Point(1, 1e-9, 0), Point(1, -1, 0)};
  c.radius = {0.1, 1. / 7, 0.3, 1e-20};
  c.lines = {{0, 1, 2}, {0, 1, 3}};
  for (const std::string name : {"c.vtp", "c.vtk"}) {
    TM::IO::write_centerlines(path(name), c);
    TM::IO::read_centerlines(path(name), back);
    EXPECT_EQ(c.points, back.points);
    EXPECT_EQ(c.radius, back.radius);
    EXPECT_EQ(c.lines, back.lines);
  }
  TM::IO::write_centerlines(path("g.vtp"), TM::Centerline_graph());
  EXPECT_THROW(TM::IO::read_centerlines(path("g.vtp"), back), TM::Input_error);
}

TEST_F(IO, Centerlines_of_legacy_vtk_in_old_and_new_layouts) {
  Centerlines c;
  TM::IO::read_centerlines(
      make("old.vtk",
           "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0\n2 0 0 3 0 0\n"
           "VERTICES 1 2\n1 0\nLINES 2 6\n2 0 1\n2 2 3\nPOINT_DATA 4\nFIELD FieldData 2\n"
           "Topology 2 4 int\n1 2 3 4 5 6 7 8\nMaximumInscribedSphereRadius 1 4 double\n1 2 3 4\n"),
      c);
  EXPECT_EQ(c.lines, (std::vector<std::vector<std::size_t>>{{0, 1}, {2, 3}}));
  EXPECT_EQ(c.radius, (std::vector<double>{1, 2, 3, 4}));

  TM::IO::read_centerlines(
      make("new.vtk",
           "# vtk DataFile Version 5.1\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n0 0 0 1 0 0 2 0 0\n"
           "METADATA\nINFORMATION 0\n\nLINES 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n"
           "2 1 0\nPOINT_DATA 3\nSCALARS MaximumInscribedSphereRadius float\nLOOKUP_TABLE default\n.5 .25 1\n"),
      c);
  EXPECT_EQ(c.lines, (std::vector<std::vector<std::size_t>>{{2, 1, 0}}));
  EXPECT_EQ(c.radius, (std::vector<double>{.5, .25, 1}));

  TM::IO::read_centerlines(
      make("grid.vtk",
           "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 1 0 0 2 0 0\n"
           "CELLS 3 10\n2 0 1\n3 0 1 2\n2 1 2\nCELL_TYPES 3\n3\n5\n3\n"),
      c);
  EXPECT_EQ(c.lines, (std::vector<std::vector<std::size_t>>{{0, 1}, {1, 2}}));
  EXPECT_TRUE(c.radius.empty());

  EXPECT_THROW(TM::IO::read_centerlines(make("surface.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"), c),
               TM::Input_error);
}

TEST_F(IO, Centerlines_of_gmsh_with_sparse_node_numbers) {
  Centerlines c;
  TM::IO::read_centerlines(
      make("c.msh",
           "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nx\n$EndComments\n$Nodes\n1 3 7 90\n1 1 0 3\n90\n7\n8\n"
           "9 0 0\n7 0 0\n8 0 0\n$EndNodes\n$Elements\n1 2 1 2\n1 1 1 2\n2 8 90\n1 7 8\n$EndElements\n"),
      c);
  EXPECT_EQ(c.points, (std::vector<Point>{Point(7, 0, 0), Point(8, 0, 0), Point(9, 0, 0)}));
  EXPECT_EQ(c.lines, (std::vector<std::vector<std::size_t>>{{0, 1}, {1, 2}}));
}

TEST_F(IO, Real_centerlines) {
#ifndef TUBULAR_MESHING_SHARED_DATA
  GTEST_SKIP() << "needs shared/data";
#else
  const fs::path data = TUBULAR_MESHING_SHARED_DATA;
  struct Row {
    const char* file;
    std::size_t points, lines;
  };
  const Row centerlines[] = {{"paper/centerlinesAORTA.vtk", 862, 858},
                             {"paper/centerlinesBYPASS.msh", 715, 711},
                             {"paper/centerlinesCAROTID.vtk", 368, 2},
                             {"paper/centerlinesCEREBRAL.vtk", 12545, 8}};
  if (!fs::exists(data / centerlines[0].file))
    GTEST_SKIP() << "needs shared/data/" << centerlines[0].file;
  for (const Row& r : centerlines) {
    Centerlines c;
    TM::IO::read_centerlines((data / r.file).string(), c);
    EXPECT_EQ(c.points.size(), r.points) << r.file;
    EXPECT_EQ(c.lines.size(), r.lines) << r.file;
  }
#endif
}

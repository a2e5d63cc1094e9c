// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Damaged files of every format are an Input_error, or harmless.

#include "io_fixture.h"

#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

TEST_F(IO, Damage_is_an_input_error_or_harmless) {
  const char* thorough = std::getenv("TUBULAR_MESHING_THOROUGH_TESTS"); // every byte
  const std::size_t positions = thorough ? std::numeric_limits<std::size_t>::max() : 50;
  const Surface s = tetrahedron();
  Mesh m = sample_mesh();
  m.point_arrays.push_back(sample_array("metric", 6, m.points.size()));
  Centerlines c;
  c.points = {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)};
  c.radius = {1, 1, 1};
  c.lines = {{0, 1, 2}};
  for (const char* name : {"s.stl", "s.off", "s.obj", "s.ply", "s.vtp", "s.vtk", "s.msh"})
    TM::IO::write_surface(path(name), s);
  Surface labelled = s;
  TM::Face_patch_map patch = labelled.add_property_map<Surface::Face_index, int>("f:patch", 1).first;
  patch[*labelled.faces().begin()] = 2;
  for (const char* name : {"sl.stl", "sl.obj", "sl.ply", "sl.vtp", "sl.vtk", "sl.msh"})
    TM::IO::write_surface(path(name), labelled,
                          TM::parameters::face_patch_map(patch).patch_names(TM::Label_names{{1, "wall"}, {2, "in"}}));
  for (const char* name : {"m.vtu", "m.msh", "m.mesh"})
    TM::IO::write_mesh(path(name), m);
  fs::remove(path("m.sol"));
  for (const char* name : {"c.vtp", "c.vtk"})
    TM::IO::write_centerlines(path(name), c);

  const auto survives = [&](const std::string& name, const std::string& bytes) {
    const std::string file = make("x" + name, bytes);
    if (name[0] != 'c')
      try {
        const TM::IO::Surface_data data = TM::IO::read_surface_data(file);
        EXPECT_TRUE(data.labels.empty() || data.labels.label.size() == data.triangles.size());
        for (const auto& a : data.point_arrays)
          EXPECT_EQ(a.second.size(), data.points.size());
      } catch (const TM::Input_error&) {
      }
    try {
      if (name[0] == 's') {
        Surface back;
        TM::IO::read_surface(file, back);
        EXPECT_GT(back.number_of_faces(), 0u);
      } else if (name[0] == 'm') {
        Mesh back;
        TM::IO::read_mesh(file, back);
        EXPECT_GT(back.number_of_cells() + back.number_of_facets(), 0u);
      } else {
        Centerlines back;
        TM::IO::read_centerlines(file, back);
        EXPECT_FALSE(back.lines.empty());
      }
      return true;
    } catch (const TM::Input_error&) {
      return false;
    }
  };
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory))
    names.push_back(entry.path().filename().string());
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const std::string bytes = bytes_of(path(name));
    ASSERT_TRUE(survives(name, bytes));
    EXPECT_FALSE(survives(name, bytes.substr(0, bytes.size() / 2)));
    const std::size_t step = 1 + bytes.size() / positions;
    for (std::size_t i = 0; i < bytes.size(); i += step) {
      survives(name, bytes.substr(0, i));
      for (const int bits : {0x01, 0x88, 0xff}) {
        std::string flipped = bytes;
        flipped[i] = static_cast<char>(flipped[i] ^ bits);
        survives(name, flipped);
      }
    }
  }
}

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of quadratic meshes, read back by other programs: each node is where its place in a list says. What formats
// cannot hold.

#include "installed_programs.h"
#include "quadratic_meshes.h"
#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/IO/write_exodus.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_xdmf.h>
#include <CGAL/Tubular_meshing/Quadratic/quadratic_quality.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace {

using TM::IO::Mesh_format;
namespace parameters = TM::parameters;

std::string why_not_written(const std::string& file, const TM::Quadratic_mesh& mesh) {
  try {
    TM::IO::write_mesh(file, mesh);
    return "";
  } catch (const TM::Output_error& e) {
    return e.what();
  }
}

TEST_F(IO, Nodes_of_quadratic_elements_are_where_other_programs_look_for_them) {
  std::size_t written = 0, refused = 0;
  for (const Named_mesh& m : solver_meshes())
    for (bool complete : {false, true}) {
      const TM::Quadratic_mesh mesh = TM::straight_quadratic_mesh(m.mesh, complete);
      const std::string name = m.name + (complete ? "_complete" : "_serendipity");
      for (const char* end : {".vtu", ".msh", ".inp", ".feb", ".exo", "-mesh-complete"}) {
        if (std::string(end) == ".exo" && !TM::IO::has_exodus())
          continue;
        const std::string why_not = why_not_written(path(name + end), mesh);
        ++(why_not.empty() ? written : refused);
        if (!why_not.empty()) {
          EXPECT_TRUE(why_not.find("--") != why_not.npos || why_not.find("write a .vtu") != why_not.npos) << why_not;
          EXPECT_FALSE(fs::exists(path(name + end)));
        }
      }
      TM::IO::write_mesh(path(name + "_2.msh"), mesh, parameters::format(2.2));
      ++written;
    }
  EXPECT_GE(written, 100u);
  EXPECT_GE(refused, 20u);
  const int status = run_script("check_quadratic_files.py", {directory.string()}, path("log"));
  if (status == lacks_packages)
    GTEST_SKIP() << "needs VTK or meshio in Python";
  EXPECT_EQ(status, 0) << bytes_of(path("log"));
}

TEST_F(IO, Dolfinx_finds_the_volume_of_curved_cells) {
  using namespace quadratic_meshes;
  if (!TM::IO::has_hdf5())
    GTEST_SKIP() << "built without HDF5";
  const Vessel vessel = bend();
  for (const char* type : {"isotropic", "hexahedral"}) {
    Quadratic_mesh mesh;
    curve(vessel, linear_mesh(vessel, type, parameters::points_per_circumference(8).preserve_volume(false)), true,
          mesh);
    TM::IO::write_mesh(path(std::string(type) + ".xdmf"), mesh);
    std::ofstream out(path(std::string(type) + ".volume"));
    out.precision(17);
    out << volumes(mesh)[1];
  }
  const int status = run_script("check_quadratic_files.py", {directory.string()}, path("log"));
  if (status == lacks_packages)
    GTEST_SKIP() << "needs dolfinx in Python";
  EXPECT_EQ(status, 0) << bytes_of(path("log"));
}

// --- what formats cannot hold ---

TEST_F(IO, Formats_without_quadratic_cells_say_what_to_do) {
  const TM::Quadratic_mesh mesh = TM::straight_quadratic_mesh(Layered_box::make(2, "T", "1"));
  for (const char* file : {"a.mesh", "a.su2", "a.cas", "a.cgns", "polyMesh"}) {
    const Mesh_format format = TM::IO::mesh_format_of(file);
    if (!TM::IO::why_not_built_in(format).empty())
      continue;
    const std::string why_not = why_not_written(path(file), mesh);
    EXPECT_EQ(why_not, TM::IO::why_not_quadratic(format)) << file;
    EXPECT_NE(why_not.find("leave --order 2 away"), why_not.npos) << file;
    EXPECT_FALSE(fs::exists(path(file)));
  }
  for (const char* file : {"a.vtu", "a.msh", "a.inp", "a.feb", "a.exo", "a.xdmf", "mesh-complete"})
    EXPECT_EQ(TM::IO::why_not_quadratic(TM::IO::mesh_format_of(file)), "") << file;
}

TEST_F(IO, Elements_that_a_format_lacks_are_refused_with_the_option_that_helps) {
  struct Case {
    const char *layers, *regions, *file;
    bool complete;
    const char* option;
  };
  for (const Case& c : std::vector<Case>{{"P", "1", "a.vtu", true, "--order-2-complete"},
                                         {"P", "1", "a.inp", false, "--type"},
                                         {"H", "1", "a.inp", true, "--order-2-complete"},
                                         {"W", "1", "a.inp", true, "--order-2-complete"},
                                         {"W", "1", "a.feb", true, "--order-2-complete"},
                                         {"P", "1", "a.feb", true, "--order-2-complete"},
                                         {"W", "1", "b-mesh-complete", false, "--wall-elements"},
                                         {"H", "1", "a.xdmf", false, "add --order-2-complete"}}) {
    if (!TM::IO::why_not_built_in(TM::IO::mesh_format_of(c.file)).empty())
      continue;
    const auto mesh = TM::straight_quadratic_mesh(Layered_box::make(2, c.layers, c.regions), c.complete);
    EXPECT_NE(why_not_written(path(c.file), mesh).find(c.option), std::string::npos)
        << c.file << ": " << why_not_written(path(c.file), mesh);
    EXPECT_FALSE(fs::exists(path(c.file)));
  }
}

TEST_F(IO, Quadratic_files_are_refused_by_the_reader_with_the_option_that_helps) {
  std::size_t refused = 0;
  for (const Named_mesh& m : solver_meshes())
    for (bool complete : {false, true}) {
      const TM::Quadratic_mesh mesh = TM::straight_quadratic_mesh(m.mesh, complete);
      for (const char* file : {"a.vtu", "a.msh"})
        for (double version : {4.1, 2.2}) {
          try {
            TM::IO::write_mesh(path(file), mesh, parameters::format(version));
          } catch (const TM::Output_error&) { // pyramids of 14 nodes
            continue;
          }
          TM::Mixed_mesh read = m.mesh;
          try {
            TM::IO::read_mesh(path(file), read);
            ADD_FAILURE() << m.name << ' ' << file;
          } catch (const TM::Input_error& e) {
            EXPECT_NE(std::string(e.what()).find("--order 2"), std::string::npos) << e.what();
            EXPECT_NE(std::string(e.what()).find(path(file)), std::string::npos) << e.what();
            ++refused;
          }
          EXPECT_EQ(read.points.size(), m.mesh.points.size());
        }
    }
  EXPECT_GT(refused, 80u);
}

TEST_F(IO, Point_arrays_go_on_to_the_nodes_between_corners) {
  TM::Mixed_mesh linear = Layered_box::make(1, "H", "1");
  TM::Point_array x{"x", 1, {}};
  for (const Point& p : linear.points)
    x.values.push_back(p.x());
  linear.point_arrays.push_back(x);
  for (bool complete : {false, true}) {
    const TM::Quadratic_mesh mesh = TM::straight_quadratic_mesh(linear, complete);
    TM::IO::write_mesh(path("a.msh"), mesh, parameters::format(2.2));
    std::ifstream in(path("a.msh"));
    std::string line;
    while (std::getline(in, line) && line != "$NodeData")
      ;
    for (int i = 0; i < 8; ++i) // a name, a time, three integers
      std::getline(in, line);
    EXPECT_EQ(line, std::to_string(mesh.number_of_nodes()));
    for (std::size_t i = 0; i < mesh.number_of_nodes(); ++i) {
      std::size_t node = 0;
      double value = 0;
      in >> node >> value;
      EXPECT_EQ(node, i + 1);
      EXPECT_NEAR(value, mesh.node(i).x(), 1e-12);
    }
  }
}

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes for FEniCSx: read back by HDF5, and by dolfinx where that is installed.

#include "installed_programs.h"
#include "resource_limits.h"
#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/IO/hdf5_at_exit.h>
#include <CGAL/Tubular_meshing/IO/write_xdmf.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <pugixml.hpp>

#ifdef CGAL_TUBULAR_MESHING_WITH_HDF5
#include <hdf5.h>
#endif

#include <array>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#ifndef CGAL_TUBULAR_MESHING_WITH_HDF5

TEST_F(IO, XDMF_needs_HDF5) {
  EXPECT_FALSE(TM::IO::has_hdf5());
  try {
    TM::IO::write_xdmf(path("m.xdmf"), Layered_box::make(1, "T", "1"));
    ADD_FAILURE() << "no error";
  } catch (const TM::Output_error& e) {
    EXPECT_NE(std::string(e.what()).find("libhdf5-dev"), std::string::npos) << e.what();
  }
  EXPECT_EQ(number_of_files(), 0u);
}

#else

namespace {

// Before any test: files that cannot be written are among them.
[[maybe_unused]] const bool hdf5_is_left_alone = (CGAL::Tubular_meshing::IO::leave_hdf5_alone_at_exit(), true);

// A table of numbers that a DataItem leads to.
template <class T> std::vector<T> numbers_of(const pugi::xml_node& item, const fs::path& folder) {
  const std::string text = item.text().as_string();
  EXPECT_EQ(item.attribute("Format").as_string(), std::string("HDF"));
  const std::size_t colon = text.find(':');
  const hid_t file = H5Fopen((folder / text.substr(0, colon)).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t set = H5Dopen2(file, text.substr(colon + 1).c_str(), H5P_DEFAULT), space = H5Dget_space(set);
  hsize_t size[2] = {0, 1};
  const int rank = H5Sget_simple_extent_dims(space, size, nullptr);
  std::ostringstream dimensions;
  dimensions << size[0];
  if (rank == 2)
    dimensions << ' ' << size[1];
  EXPECT_EQ(item.attribute("Dimensions").as_string(), dimensions.str());
  std::vector<T> values(size[0] * size[1]);
  EXPECT_GE(
      H5Dread(set, sizeof(T) == 8 ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
      0);
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(file);
  return values;
}

struct Grid {
  std::string kind;
  std::vector<std::vector<std::size_t>> elements;
  std::vector<int> tags;
  std::map<std::string, int> names;
  std::vector<Point> points;

  Grid(const pugi::xml_node& grid, const fs::path& folder) {
    const pugi::xml_node topology = grid.child("Topology");
    kind = topology.attribute("TopologyType").as_string();
    const auto corners = numbers_of<int>(topology.child("DataItem"), folder);
    const std::size_t n = topology.attribute("NodesPerElement").as_ullong();
    EXPECT_EQ(corners.size(), n * topology.attribute("NumberOfElements").as_ullong());
    for (std::size_t i = 0; i < corners.size(); i += n)
      elements.emplace_back(corners.begin() + std::ptrdiff_t(i), corners.begin() + std::ptrdiff_t(i + n));
    const auto xyz = numbers_of<double>(grid.child("Geometry").child("DataItem"), folder);
    for (std::size_t i = 0; i < xyz.size(); i += 3)
      points.push_back(Point(xyz[i], xyz[i + 1], xyz[i + 2]));
    if (grid.child("Attribute")) {
      EXPECT_EQ(grid.child("Attribute").attribute("Center").as_string(), std::string("Cell"));
      tags = numbers_of<int>(grid.child("Attribute").child("DataItem"), folder);
    }
    for (const auto& i : grid.children("Information"))
      names[i.attribute("Name").as_string()] = i.attribute("Value").as_int();
  }
};

std::map<std::string, Grid> read_xdmf(const fs::path& file) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_file(file.c_str()));
  std::map<std::string, Grid> grids;
  for (const auto& g : document.child("Xdmf").child("Domain").children("Grid"))
    grids.emplace(g.attribute("Name").as_string(), Grid(g, file.parent_path()));
  return grids;
}

} // namespace

TEST_F(IO, XDMF_meshes_are_read_back_equal) {
  EXPECT_TRUE(TM::IO::has_hdf5());
  int written = 0;
  for (Named_mesh m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    if (m.name.find_first_of("PXW") != std::string::npos)
      continue;
    ++written;
    m.mesh.patch_names[2] = "Zufluß <&> 'x'";
    m.mesh.points.push_back(Point(9, 9, 9)); // no cell's
    TM::IO::write_xdmf(path("a mesh & so on.xdmf"), m.mesh);
    EXPECT_EQ(number_of_files(), 2u);
    m.mesh.points.pop_back();
    const auto grids = read_xdmf(directory / "a mesh & so on.xdmf");
    ASSERT_EQ(grids.size(), 3u);
    for (const auto& g : grids)
      EXPECT_TRUE(g.second.points == m.mesh.points);
    const Grid &cells = grids.at("cell_tags"), &facets = grids.at("facet_tags");
    EXPECT_EQ(grids.at("mesh").elements, cells.elements);
    EXPECT_EQ(cells.kind, m.mesh.hexahedra.empty() ? "Tetrahedron" : "Hexahedron");
    EXPECT_EQ(facets.kind, m.mesh.hexahedra.empty() ? "Triangle" : "Quadrilateral");
    Cells_of_regions read;
    std::map<int, std::set<Corners>> patches;
    for (std::size_t i = 0; i < cells.elements.size(); ++i)
      read[cells.tags.at(i)].push_back(cells.elements[i]);
    for (std::size_t i = 0; i < facets.elements.size(); ++i)
      EXPECT_TRUE(
          patches[facets.tags.at(i)].insert(Corners(facets.elements[i].begin(), facets.elements[i].end())).second);
    EXPECT_EQ(read, cells_of(m.mesh));
    EXPECT_EQ(patches, facets_of(m.mesh));
    for (const auto& n : m.mesh.patch_names)
      EXPECT_EQ(facets.names.at(n.second), n.first);
    for (const auto& n : m.mesh.region_names)
      EXPECT_EQ(cells.names.at(n.second), n.first);
  }
  EXPECT_EQ(written, 4);
}

TEST_F(IO, XDMF_is_refused_what_FEniCSx_cannot_take) {
  for (const std::string layers : {"HXW", "P", "W", "WT"})
    EXPECT_THROW(TM::IO::write_xdmf(path("m.xdmf"), Layered_box::make(1, layers, "112")), TM::Output_error);
  EXPECT_THROW(TM::IO::write_xdmf(path("a:b.xdmf"), Layered_box::make(1, "T", "1")), TM::Output_error);
  EXPECT_THROW(TM::IO::write_xdmf("/dev/null", Layered_box::make(1, "T", "1")), TM::Output_error);
  Mesh m;
  EXPECT_THROW(TM::IO::write_xdmf(path("m.xdmf"), m), TM::Output_error);
  EXPECT_EQ(number_of_files(), 0u);
}

TEST_F(IO, XDMF_meshes_are_read_by_FEniCSx) {
  if (std::system("/usr/bin/python3 -c 'import dolfinx' > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs dolfinx (python3-dolfinx)";
  for (const char* layers : {"TT", "HH"}) {
    TM::IO::write_xdmf(path("m.xdmf"), Layered_box::make(3, layers, "12"));
    make("read.py", "import sys\n"
                    "from mpi4py import MPI\n"
                    "from petsc4py import PETSc\n"
                    "import dolfinx, ufl\n"
                    "with dolfinx.io.XDMFFile(MPI.COMM_WORLD, 'm.xdmf', 'r') as f:\n"
                    "    mesh = f.read_mesh(name='mesh')\n"
                    "    cells = f.read_meshtags(mesh, name='cell_tags')\n"
                    "    mesh.topology.create_connectivity(2, 3)\n"
                    "    facets = f.read_meshtags(mesh, name='facet_tags')\n"
                    "one = dolfinx.fem.Constant(mesh, PETSc.ScalarType(1))\n"
                    "integral = lambda m: dolfinx.fem.assemble_scalar(dolfinx.fem.form(one * m)).real\n"
                    "dx = ufl.Measure('dx', domain=mesh, subdomain_data=cells)\n"
                    "ds = ufl.Measure('ds', domain=mesh, subdomain_data=facets)\n"
                    "dS = ufl.Measure('dS', domain=mesh, subdomain_data=facets)\n"
                    "print(integral(dx(1)), integral(dx(2)), integral(ds(2)), integral(ds(3)), integral(dS(1)))\n");
    const std::string command =
        "cd '" + directory.string() + "' && XDG_CACHE_HOME=. /usr/bin/python3 read.py > out 2> log";
    ASSERT_EQ(std::system(command.c_str()), 0) << bytes_of(path("log"));
    std::istringstream said(bytes_of(path("out")));
    // a box of 1 x 1, of two layers of the heights that Layered_box gives them
    double volumes[2], areas[3];
    said >> volumes[0] >> volumes[1] >> areas[0] >> areas[1] >> areas[2];
    const double first = 1 / 3. + 1e-3 / 7, second = 2 / 3. + 4e-3 / 7 - first;
    EXPECT_NEAR(volumes[0], first, 1e-6) << said.str();
    EXPECT_NEAR(volumes[1], second, 1e-6);
    for (double a : areas)
      EXPECT_NEAR(a, 1, 1e-6);
  }
}

#ifdef __unix__
TEST_F(IO, A_limit_on_file_size_leaves_no_XDMF) {
  const Mesh large = Layered_box::make(12, "TTT", "112");
  expect_no_file_within_limits<TM::Output_error>([&] { TM::IO::write_xdmf(path("m.xdmf"), large); },
                                                 [&] { EXPECT_EQ(number_of_files(), 0u); });
  TM::IO::write_xdmf(path("m.xdmf"), large);
  EXPECT_EQ(read_xdmf(directory / "m.xdmf").at("mesh").elements.size(), large.tetrahedra.size());
}
#endif

#endif // CGAL_TUBULAR_MESHING_WITH_HDF5

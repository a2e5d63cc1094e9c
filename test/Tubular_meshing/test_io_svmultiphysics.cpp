// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes for svMultiPhysics: each number is what its reader makes of it.

#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_file.h>
#include <CGAL/Tubular_meshing/IO/write_svmultiphysics.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

// A .vtu or .vtp file; the solver takes its arrays of numbers if they are Int32 only.
struct Vtk {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> cells;
  std::vector<int> types;
  std::map<std::string, std::vector<int>> point_data, cell_data;
  std::set<std::string> names;

  Vtk(const fs::path& name, const std::string& dataset) {
    const TM::IO::internal::Input_file file(name.string());
    const TM::IO::internal::Vtk_xml_file vtk(file, dataset.c_str());
    const pugi::xml_node piece = vtk.dataset().child("Piece");
    for (const auto& p : vtk.points(piece))
      points.push_back(Point(p[0], p[1], p[2]));
    const bool is_grid = dataset == "UnstructuredGrid";
    const pugi::xml_node list = piece.child(is_grid ? "Cells" : "Polys");
    const auto corners = vtk.values<std::size_t>(vtk.find(list, "connectivity"));
    std::size_t begin = 0;
    for (std::size_t end : vtk.values<std::size_t>(vtk.find(list, "offsets"))) {
      cells.emplace_back(corners.begin() + std::ptrdiff_t(begin), corners.begin() + std::ptrdiff_t(end));
      begin = end;
    }
    if (is_grid)
      types = vtk.values<int>(vtk.find(list, "types"));
    EXPECT_EQ(piece.attribute("NumberOfPoints").as_ullong(), points.size());
    EXPECT_EQ(piece.attribute(is_grid ? "NumberOfCells" : "NumberOfPolys").as_ullong(), cells.size());
    read(vtk, piece.child("PointData"), point_data, points.size());
    read(vtk, piece.child("CellData"), cell_data, cells.size());
    for (const auto& a : vtk.dataset().child("FieldData").children("DataArray"))
      names.insert(a.attribute("Name").as_string());
  }

private:
  static void read(const TM::IO::internal::Vtk_xml_file& vtk, const pugi::xml_node& data,
                   std::map<std::string, std::vector<int>>& arrays, std::size_t size) {
    for (const auto& a : data.children("DataArray")) {
      EXPECT_EQ(a.attribute("type").as_string(), std::string("Int32"));
      auto& values = arrays[a.attribute("Name").as_string()];
      values = vtk.values<int>(a);
      EXPECT_EQ(values.size(), size);
    }
  }
};

// What load_msh.cpp does with a wedge: one whose corners 0,1,2 turn the other way seen from 3 is changed, wrongly.
void expect_right_wedge(const std::vector<Point>& points, const std::vector<std::size_t>& c) {
  const auto v1 = points[c[1]] - points[c[0]], v2 = points[c[2]] - points[c[1]], v3 = points[c[3]] - points[c[0]];
  EXPECT_GT(v3 * CGAL::cross_product(v1, v2), 0);
}

std::set<Corners> expect_same_region(const Mesh& m, int region, const fs::path& folder, const Mesh& names) {
  const auto expected = cells_of(m).at(region);
  const Point_finder find(m);
  const Vtk mesh(folder / "mesh-complete.mesh.vtu", "UnstructuredGrid");
  std::vector<std::size_t> index; // in the mesh
  for (const Point& p : mesh.points)
    index.push_back(find(p));
  EXPECT_TRUE(std::is_sorted(index.begin(), index.end()));
  const std::map<std::size_t, int> types = {{4, 10}, {6, 13}, {8, 12}};
  EXPECT_EQ(mesh.cells.size(), expected.size());
  Corners used;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    std::vector<std::size_t> corners;
    for (std::size_t v : mesh.cells[c])
      corners.push_back(index.at(v));
    used.insert(mesh.cells[c].begin(), mesh.cells[c].end());
    EXPECT_EQ(corners, expected[c]);
    EXPECT_EQ(mesh.types[c], types.at(corners.size()));
    EXPECT_EQ(mesh.cell_data.at("GlobalElementID")[c], int(c) + 1);
    EXPECT_EQ(mesh.cell_data.at("ModelRegionID")[c], region);
    if (corners.size() == 6)
      expect_right_wedge(mesh.points, mesh.cells[c]);
  }
  EXPECT_EQ(used.size(), mesh.points.size()); // none without a cell
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_EQ(mesh.point_data.at("GlobalNodeID")[v], int(v) + 1);

  // Each facet's element has its corners, under the numbers that its points have; so has the whole of the exterior.
  const Faces_of_cells faces(m);
  const auto check = [&](const fs::path& file, std::map<int, std::set<Corners>>& facets) {
    const Vtk face(file, "PolyData");
    EXPECT_FALSE(face.cells.empty());
    for (std::size_t v = 0; v < face.points.size(); ++v)
      EXPECT_EQ(face.points[v], mesh.points.at(std::size_t(face.point_data.at("GlobalNodeID")[v] - 1)));
    for (std::size_t f = 0; f < face.cells.size(); ++f) {
      const auto& element = mesh.cells.at(std::size_t(face.cell_data.at("GlobalElementID")[f] - 1));
      std::vector<std::size_t> loop;
      for (std::size_t v : face.cells[f]) {
        const auto node = std::size_t(face.point_data.at("GlobalNodeID").at(v) - 1);
        EXPECT_EQ(std::count(element.begin(), element.end(), node), 1);
        loop.push_back(index.at(node));
      }
      expect_outward(faces, region, loop);
      EXPECT_TRUE(facets[face.cell_data.at("ModelFaceID")[f]].insert(Corners(loop.begin(), loop.end())).second);
    }
    return face.names;
  };
  std::map<int, std::set<Corners>> facets, exterior, walls;
  std::set<Corners> all;
  for (const auto& file : fs::directory_iterator(folder / "mesh-surfaces"))
    EXPECT_EQ(check(file.path(), facets), std::set<std::string>{file.path().stem().string()});
  check(folder / "mesh-complete.exterior.vtp", exterior);
  check(folder / "walls_combined.vtp", walls);
  EXPECT_EQ(exterior, facets);
  const auto patches = facets_of(m);
  for (const auto& f : facets) {
    EXPECT_TRUE(fs::exists(folder / "mesh-surfaces" / (names.patch_names.at(f.first) + ".vtp")));
    for (const Corners& c : f.second)
      EXPECT_EQ(patches.at(f.first).count(c), 1u);
    all.insert(f.second.begin(), f.second.end());
    EXPECT_EQ(walls.count(f.first), f.first == 1 || f.first == 100 ? 1u : 0u);
  }
  return all;
}

} // namespace

TEST_F(IO, SvMultiPhysics_meshes_are_read_back_equal) {
  int written = 0;
  for (const Named_mesh& m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    // pyramids; and triangles and quads on one patch
    if (m.name.find_first_of("PX") != std::string::npos || m.name == "WW_12")
      continue;
    ++written;
    TM::IO::write_svmultiphysics(path("mesh-complete"), m.mesh);
    std::set<Corners> all, expected;
    for (const auto& p : facets_of(m.mesh))
      expected.insert(p.second.begin(), p.second.end());
    if (m.name.find('2') == std::string::npos) {
      all = expect_same_region(m.mesh, 1, directory / "mesh-complete", m.mesh);
    } else {
      all = expect_same_region(m.mesh, 1, directory / "mesh-complete" / "fluid", m.mesh);
      const auto solid = expect_same_region(m.mesh, 2, directory / "mesh-complete" / "solid", m.mesh);
      EXPECT_TRUE(std::any_of(solid.begin(), solid.end(), [&](const Corners& c) { return all.count(c) != 0; }));
      all.insert(solid.begin(), solid.end());
    }
    EXPECT_EQ(all, expected);
    EXPECT_EQ(number_of_files(), 1u);
  }
  EXPECT_EQ(written, 6);
}

TEST_F(IO, SvMultiPhysics_gets_the_faces_of_the_input) {
  Mesh m = Layered_box::make(1, "HH", "12");
  m.patch_ids = {"ModelFaceID", {{1, 7}, {2, 3}}};
  m.patch_names = {{1, "vessel wall"}, {2, "Zufluß/1"}, {3, "vessel_wall"}, {100, "outer"}};
  m.region_names = {};
  TM::IO::write_svmultiphysics(path("m"), m);
  std::map<std::string, int> ids;
  for (const char* folder : {"fluid", "solid"})
    for (const auto& file : fs::directory_iterator(directory / "m" / folder / "mesh-surfaces"))
      ids[file.path().filename().string()] = Vtk(file.path(), "PolyData").cell_data.at("ModelFaceID").front();
  // 3 is the inlet's: the outlet, label 3, gets the next number
  EXPECT_EQ(ids, (std::map<std::string, int>{
                     {"vessel_wall.vtp", 7}, {"Zufluß_1.vtp", 3}, {"vessel_wall_2.vtp", 4}, {"outer.vtp", 100}}));
}

TEST_F(IO, SvMultiPhysics_is_refused_what_it_cannot_take) {
  const auto said = [&](const Mesh& m) {
    try {
      TM::IO::write_svmultiphysics(path("m"), m);
    } catch (const TM::Output_error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(said(Layered_box::make(1, "HXW", "111")).find("pyramids"), std::string::npos);
  const std::string of_layers = said(Layered_box::make(1, "WT", "11"));
  EXPECT_NE(of_layers.find("tetrahedra and prisms"), std::string::npos) << of_layers;
  EXPECT_NE(of_layers.find("--type anisotropic"), std::string::npos) << of_layers;
  Mesh m = Layered_box::make(1, "W", "1");
  for (int& l : m.quads.label)
    l = 2;
  EXPECT_NE(said(m).find("triangles and quads"), std::string::npos);
  Mesh inside = Layered_box::make(1, "HH", "12");
  inside.hexahedra.label = {1, 1};
  EXPECT_NE(said(inside).find("inside of a region"), std::string::npos);
  inside.hexahedra = {};
  EXPECT_FALSE(said(inside).empty());
  EXPECT_EQ(number_of_files(), 0u);

  TM::IO::write_svmultiphysics(path("m"), Layered_box::make(1, "HH", "12"));
  TM::IO::write_svmultiphysics(path("m"), Layered_box::make(1, "T", "1"));
  EXPECT_FALSE(fs::exists(path("m/fluid")));
  make("m/svFSI.xml", "mine");
  EXPECT_NE(said(Layered_box::make(1, "T", "1")).find("svFSI.xml"), std::string::npos);
  EXPECT_EQ(bytes_of(path("m/svFSI.xml")), "mine");
  EXPECT_EQ(number_of_files(), 1u);
}

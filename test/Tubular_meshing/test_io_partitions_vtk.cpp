// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts for VTK: read back by the project's reader, and by VTK where Python has it.

#include "installed_programs.h"
#include "partitioned_meshes.h"

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_file.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh.h>
#include <CGAL/Tubular_meshing/Partition/Ghost_cells.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace {

using TM::IO::write_partitioned_mesh;

// The arrays of a .vtu file of a part.
struct Vtu_file {
  std::vector<std::int64_t> point_ids, point_ghosts, cell_ids, cell_ghosts, region, patch;
  std::vector<double> coordinates;
  Mesh mesh;

  explicit Vtu_file(const std::string& file) {
    const TM::IO::internal::Input_file input(file);
    const TM::IO::internal::Vtk_xml_file vtu(input, "UnstructuredGrid");
    const pugi::xml_node piece = vtu.dataset().child("Piece");
    const auto values = [&](const char* data, const char* name) {
      return vtu.values<std::int64_t>(vtu.find(piece.child(data), name));
    };
    EXPECT_STREQ(piece.child("PointData").attribute("GlobalIds").value(), "GlobalPointIds");
    EXPECT_STREQ(piece.child("CellData").attribute("GlobalIds").value(), "GlobalCellIds");
    point_ids = values("PointData", "GlobalPointIds");
    point_ghosts = values("PointData", "vtkGhostType");
    cell_ids = values("CellData", "GlobalCellIds");
    cell_ghosts = values("CellData", "vtkGhostType");
    region = values("CellData", "region");
    patch = values("CellData", "patch");
    TM::IO::read_mesh(file, mesh);
  }
};

const TM::Point_array* find(const Mesh& m, const std::string& name) {
  for (const auto& a : m.point_arrays)
    if (a.name == name)
      return &a;
  return nullptr;
}

void expect_parts_of_vtu(const Mesh& m, const TM::Cell_partition& p,
                         const std::function<std::string(std::size_t)>& file) {
  const Elements elements(m);
  const TM::Ghost_cells ghosts(m, p);
  const auto behind = cells_behind_facets(m);
  std::vector<int> points_there(m.points.size(), 0), elements_there(elements.corners.size(), 0);
  for (std::size_t part = 0; part < p.number_of_parts; ++part) {
    SCOPED_TRACE(part);
    const Vtu_file vtu(file(part));
    const Elements own(vtu.mesh);
    ASSERT_EQ(vtu.cell_ids.size(), own.corners.size());
    ASSERT_EQ(vtu.point_ids.size(), vtu.mesh.points.size());
    EXPECT_EQ(vtu.mesh.region_names, m.region_names);
    EXPECT_EQ(vtu.mesh.patch_names, m.patch_names);
    for (std::size_t i = 0; i < vtu.point_ids.size(); ++i) {
      const auto v = std::size_t(vtu.point_ids[i]);
      EXPECT_EQ(vtu.mesh.points[i], m.points.at(v));
      points_there[v] += vtu.point_ghosts[i] == 0;
      for (const auto& a : m.point_arrays) {
        const auto* found = find(vtu.mesh, a.name);
        ASSERT_NE(found, nullptr);
        ASSERT_EQ(found->components, a.components);
        for (std::size_t k = 0, n = std::size_t(a.components); k < n; ++k)
          EXPECT_EQ(found->values[n * i + k], a.values[n * v + k]);
      }
    }
    std::set<std::int64_t> there;
    std::vector<std::uint32_t> ghosts_there;
    for (std::size_t i = 0; i < own.corners.size(); ++i) {
      const auto e = std::size_t(vtu.cell_ids[i]);
      EXPECT_TRUE(there.insert(vtu.cell_ids[i]).second);
      auto corners = own.corners[i];
      for (auto& v : corners)
        v = vtu.point_ids[std::size_t(v)];
      EXPECT_EQ(corners, elements.corners.at(e));
      EXPECT_EQ(vtu.region[i], elements.region[e]);
      EXPECT_EQ(vtu.patch[i], elements.patch[e]);
      const std::size_t cell = e < m.number_of_cells() ? e : behind[e - m.number_of_cells()][0];
      EXPECT_EQ(vtu.cell_ghosts[i], p.part[cell] == part ? 0 : 1);
      elements_there[e] += vtu.cell_ghosts[i] == 0;
      if (e < m.number_of_cells() && vtu.cell_ghosts[i] != 0)
        ghosts_there.push_back(std::uint32_t(e));
    }
    EXPECT_EQ(ghosts_there, ghosts.of_part(part));
    for (std::size_t f = 0; f < behind.size(); ++f) { // each facet of a cell that is there
      const bool wanted = std::any_of(behind[f].begin(), behind[f].end(),
                                      [&](std::size_t c) { return there.count(std::int64_t(c)) != 0; });
      EXPECT_EQ(there.count(std::int64_t(m.number_of_cells() + f)), wanted ? 1u : 0u);
    }
  }
  EXPECT_EQ(points_there, std::vector<int>(m.points.size(), 1));
  EXPECT_EQ(elements_there, std::vector<int>(elements.corners.size(), 1));
}

TEST_F(IO, Parts_for_VTK_are_the_mesh_with_ghosts_around) {
  for (const Partitioned& s : partitioned_samples())
    for (bool arrays : {false, true}) {
      SCOPED_TRACE(s.name);
      const Mesh m = arrays ? with_arrays(s.mesh) : s.mesh;
      write_partitioned_mesh(path("a mesh.pvtu"), m, s.partition);
      expect_parts_of_vtu(m, s.partition, [&](std::size_t part) {
        return path("a mesh_parts/a mesh_" + std::to_string(part) + ".vtu");
      });
      EXPECT_EQ(number_of_files(), 2u);
      EXPECT_EQ(
          std::size_t(std::distance(fs::directory_iterator(directory / "a mesh_parts"), fs::directory_iterator())),
          s.partition.number_of_parts); // those of more parts before are gone
    }
}

TEST_F(IO, Parts_for_VTK_are_read_by_VTK) {
  std::vector<Partitioned> meshes = partitioned_samples();
  meshes.erase(meshes.begin(), meshes.end() - 6);
  for (const Partitioned& s : meshes) {
    SCOPED_TRACE(s.name);
    const Mesh m = with_arrays(s.mesh);
    write_partitioned_mesh(path("m.pvtu"), m, s.partition);
    TM::IO::write_mesh(path("m.vtu"), m);
    const int status =
        run_script("read_partitions.py", {path("m.pvtu"), path("m.vtu"), std::to_string(s.partition.number_of_parts)},
                   path("log"));
    if (status == lacks_packages)
      GTEST_SKIP() << "needs VTK in Python";
    EXPECT_EQ(status, 0) << bytes_of(path("log"));
    EXPECT_EQ(bytes_of(path("log")), "");
  }
}

TEST_F(IO, A_pvtu_file_without_a_partition_has_one_part) {
  const Mesh m = with_arrays(Layered_box::make(3, "HXWT", "1112"));
  TM::IO::write_mesh(path("m.pvtu"), m);
  expect_parts_of_vtu(m, in_order(m, 1), [&](std::size_t) { return path("m_parts/m_0.vtu"); });
}

} // namespace

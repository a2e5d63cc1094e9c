// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts for OpenFOAM: read back by a reader of the tests, and by OpenFOAM where it is installed.

#include "openfoam_case.h"
#include "openfoam_parts.h"
#include "partitioned_meshes.h"

#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_openfoam.h>
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using TM::Cell_partition;
using TM::IO::Mesh_format;
using TM::IO::write_partitioned_mesh;

TEST_F(IO, Parts_for_OpenFOAM_are_the_mesh) {
  for (const Partitioned& s : partitioned_samples())
    for (bool binary : {false, true}) {
      SCOPED_TRACE(s.name + (binary ? " binary" : ""));
      const Mesh m = with_arrays(s.mesh);
      write_partitioned_mesh(path("case"), m, s.partition,
                             binary ? Mesh_format::openfoam_binary : Mesh_format::openfoam);
      expect_openfoam_parts(directory / "case", s.partition);
      TM::IO::write_openfoam(path("whole"), m, binary);
      for (const char* file : {"points", "faces", "owner", "neighbour", "boundary"})
        EXPECT_EQ(bytes_of(path("case/constant/polyMesh/" + std::string(file))),
                  bytes_of(path("whole/constant/polyMesh/" + std::string(file))));
      fs::remove_all(directory / "case");
    }
}

TEST_F(IO, Faces_without_a_patch_are_in_all_parts) {
  Mesh m = Layered_box::make(3, "HXWT", "1112");
  m.triangles = {};
  write_partitioned_mesh(path("case"), m, in_order(m, 3), Mesh_format::openfoam);
  expect_openfoam_parts(directory / "case", in_order(m, 3));
  const Poly_mesh part(directory / "case" / "processor0" / "constant" / "polyMesh");
  EXPECT_EQ(part.patches.count("defaultFaces"), 1u);
}

const std::string mpirun = "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -np ";

void write_decompose_dictionary(const fs::path& openfoam_case, std::size_t parts) {
  std::ofstream(openfoam_case / "system" / "decomposeParDict")
      << "FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }\nnumberOfSubdomains "
      << parts << ";\nmethod manual;\nmanualCoeffs { dataFile \"parts\"; }\n";
}

// What decomposePar makes of the same mesh and the same parts.
TEST_F(IO, Parts_are_those_of_decomposePar) {
  if (!has_program("decomposePar"))
    GTEST_SKIP() << "needs decomposePar of OpenFOAM";
  for (const Partitioned& s : partitioned_samples()) {
    if (s.partition.number_of_parts == 1)
      continue;
    SCOPED_TRACE(s.name);
    const fs::path ours = directory / "ours", theirs = directory / "theirs";
    make_openfoam_case(theirs);
    fs::remove_all(theirs / "0");
    write_partitioned_mesh(ours.string(), s.mesh, s.partition, Mesh_format::openfoam);
    TM::IO::write_openfoam(theirs.string(), s.mesh);
    write_decompose_dictionary(theirs, s.partition.number_of_parts);
    std::ofstream parts(theirs / "constant" / "parts");
    parts << "FoamFile { version 2.0; format ascii; class labelList; location \"constant\"; object parts; }\n"
          << s.partition.part.size() << "\n(\n";
    for (std::uint32_t p : s.partition.part)
      parts << p << '\n';
    parts << ")\n";
    parts.close();
    ASSERT_TRUE(run_openfoam("decomposePar", theirs, path("log"))) << bytes_of(path("log"));
    for (std::size_t i = 0; i < s.partition.number_of_parts; ++i) {
      const fs::path mesh = fs::path("processor" + std::to_string(i)) / "constant" / "polyMesh";
      const Poly_mesh a(ours / mesh), b(theirs / mesh);
      EXPECT_EQ(a.addressing.at("cell"), b.addressing.at("cell"));
      EXPECT_EQ(a.addressing.at("face"), b.addressing.at("face"));
      EXPECT_EQ(a.addressing.at("boundary"), b.addressing.at("boundary"));
      const auto sorted = [](std::vector<std::int64_t> labels) {
        std::sort(labels.begin(), labels.end());
        return labels;
      };
      EXPECT_EQ(sorted(a.addressing.at("point")), sorted(b.addressing.at("point")));
      EXPECT_EQ(a.owner, b.owner);
      EXPECT_EQ(a.neighbour, b.neighbour);
      EXPECT_EQ(a.order_of_patches, b.order_of_patches);
      for (const auto& patch : a.patches) {
        const auto& other = b.patches.at(patch.first);
        EXPECT_EQ(patch.second.type, other.type);
        EXPECT_EQ(patch.second.faces, other.faces);
        EXPECT_EQ(patch.second.other_part, other.other_part);
      }
      for (std::size_t f = 0; f < a.faces.size(); ++f)
        EXPECT_EQ(loop_of(a, f), loop_of(b, f));
      ASSERT_EQ(a.cell_zones.size(), b.cell_zones.size());
      for (const auto& z : a.cell_zones)
        EXPECT_EQ(z.second.members, b.cell_zones.at(z.first).members);
      ASSERT_EQ(a.face_zones.size(), b.face_zones.size());
      for (const auto& z : a.face_zones) {
        EXPECT_EQ(z.second.members, b.face_zones.at(z.first).members);
        EXPECT_EQ(z.second.flips, b.face_zones.at(z.first).flips);
      }
    }
    fs::remove_all(ours);
    fs::remove_all(theirs);
  }
}

TEST_F(IO, OpenFOAM_checks_the_parts_and_puts_them_together) {
  if (!has_program("checkMesh") || !has_program("mpirun") || !has_program("reconstructParMesh"))
    GTEST_SKIP() << "needs checkMesh and reconstructParMesh of OpenFOAM, and mpirun";
  for (const char* layers : {"HXWT", "TTTT"})
    for (bool binary : {false, true}) {
      SCOPED_TRACE(std::string(layers) + (binary ? " binary" : ""));
      const Mesh m = Layered_box::make(4, layers, "1112");
      const Cell_partition p = in_order(m, 3);
      const fs::path folder = directory / "case";
      make_openfoam_case(folder);
      fs::remove_all(folder / "0");
      write_decompose_dictionary(folder, 3);
      write_partitioned_mesh(folder.string(), m, p, binary ? Mesh_format::openfoam_binary : Mesh_format::openfoam);
      const std::string log = path("log");
      EXPECT_TRUE(run_openfoam(mpirun + "3 checkMesh -parallel -allTopology", folder, log)) << bytes_of(log);
      const std::string said = bytes_of(log);
      EXPECT_NE(said.find("\nMesh OK.\n"), std::string::npos) << said;
      EXPECT_NE(said.find("cells:            " + std::to_string(m.number_of_cells()) + "\n"), std::string::npos)
          << said;
      EXPECT_TRUE(run_openfoam("reconstructParMesh -constant", folder, log)) << bytes_of(log);
      EXPECT_TRUE(run_openfoam("checkMesh -allTopology -constant", folder, log)) << bytes_of(log);
      EXPECT_NE(bytes_of(log).find("\nMesh OK.\n"), std::string::npos) << bytes_of(log);
      const Poly_mesh whole(folder / "constant" / "polyMesh");
      EXPECT_EQ(whole.points.size(), m.points.size());
      const Faces_of_cells cells(m);
      std::size_t sides = 0;
      for (const auto& faces : cells.faces)
        sides += faces.size();
      EXPECT_EQ(whole.faces.size() + whole.neighbour.size(), sides);
      fs::remove_all(folder);
    }
}

// Fields divided after the mesh, a flow on three processors, put together again: that on the whole mesh.
TEST_F(IO, OpenFOAM_computes_the_same_flow_on_parts) {
  for (const char* program : {"icoFoam", "mpirun", "decomposePar", "reconstructPar"})
    if (!has_program(program))
      GTEST_SKIP() << "needs " << program;
  const Mesh m = Layered_box::make(4, "HHXW", "1111");
  const fs::path whole = directory / "whole", parts = directory / "parts";
  make_openfoam_case(whole);
  TM::IO::write_openfoam(whole.string(), m);
  make_openfoam_case(parts);
  write_decompose_dictionary(parts, 3);
  write_partitioned_mesh(parts.string(), m, scattered(m, 3), Mesh_format::openfoam_binary);
  const std::string log = path("log");
  ASSERT_TRUE(run_openfoam("icoFoam", whole, log)) << bytes_of(log);
  ASSERT_TRUE(run_openfoam("decomposePar -fields", parts, log)) << bytes_of(log);
  ASSERT_TRUE(run_openfoam(mpirun + "3 icoFoam -parallel", parts, log)) << bytes_of(log);
  ASSERT_TRUE(run_openfoam("reconstructPar", parts, log)) << bytes_of(log);
  const auto pressures = [&](const fs::path& folder) {
    std::istringstream in(bytes_of((folder / "0.01" / "p").string()));
    for (std::string word; in >> word && word != "List<scalar>";)
      ;
    std::size_t n = 0;
    char bracket = 0;
    in >> n >> bracket;
    std::vector<double> values(n);
    for (double& value : values)
      in >> value;
    return values;
  };
  const std::vector<double> a = pressures(whole), b = pressures(parts);
  ASSERT_EQ(a.size(), m.number_of_cells());
  ASSERT_EQ(b.size(), m.number_of_cells());
  const double largest = *std::max_element(a.begin(), a.end());
  EXPECT_GT(largest, 0);
  for (std::size_t c = 0; c < a.size(); ++c)
    EXPECT_NEAR(a[c], b[c], 1e-5 * largest);
}

} // namespace

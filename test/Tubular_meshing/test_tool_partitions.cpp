// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool and meshes in parts: what is written, what is said of it, and what is refused.

#include "test_tool_helpers.h"

#include <CGAL/Tubular_meshing/Partition/partition_cells.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <vector>

using namespace tool_test;

namespace {

#define NEEDS_METIS() NEEDS("METIS", tubular::has_metis())

} // namespace

TEST_F(Tool, Meshes_are_written_in_parts) {
  NEEDS_METIS();
  const Arguments options = {"-n", "10", "--wall", "0.2", "--partitions", "3", "--report", out("r.json")};
  succeed(run_to(*this, out("whole.vtu")) + Arguments{"-n", "10", "--wall", "0.2"});
  const Mesh whole = mesh_in(out("whole.vtu"));
  EXPECT_GT(whole.prisms.size(), 0u);
  fs::remove(out("whole.vtu"));

  const Outcome outcome = succeed(run_to(*this, out("m.pvtu")) + options);
  EXPECT_EQ(files_below(output_directory()),
            (std::set<std::string>{"m.pvtu", "m_parts/m_0.vtu", "m_parts/m_1.vtu", "m_parts/m_2.vtu", "r.json"}));
  const Json report = json_in(out("r.json"))["partitions"];
  EXPECT_EQ(report["count"], 3);
  const auto cells = report["cells"].get<std::vector<std::size_t>>();
  const auto ghosts = report["ghost_cells"].get<std::vector<std::size_t>>();
  ASSERT_EQ(cells.size(), 3u);
  ASSERT_EQ(ghosts.size(), 3u);
  EXPECT_EQ(std::accumulate(cells.begin(), cells.end(), std::size_t(0)), whole.number_of_cells());
  const double most = double(*std::max_element(cells.begin(), cells.end()));
  EXPECT_NEAR(report["imbalance"].get<double>(), 3 * most / double(whole.number_of_cells()) - 1, 1e-9);
  EXPECT_LE(report["imbalance"].get<double>(), 0.03);
  EXPECT_EQ(report["pieces"], (std::vector<int>{1, 1, 1}));
  EXPECT_GT(report["cut_faces"], 0);
  for (std::size_t part = 0; part < 3; ++part) {
    const Mesh mesh = mesh_in(out("m_parts/m_" + std::to_string(part) + ".vtu"));
    EXPECT_EQ(mesh.number_of_cells(), cells[part] + ghosts[part]);
    EXPECT_EQ(mesh.patch_names, whole.patch_names);
    EXPECT_EQ(mesh.region_names, whole.region_names);
  }
  EXPECT_NE(outcome.out.find("3 parts of "), std::string::npos) << outcome.out;
  EXPECT_NE(
      outcome.out.find(std::to_string(std::accumulate(ghosts.begin(), ghosts.end(), std::size_t(0))) + " ghost cells"),
      std::string::npos)
      << outcome.out;

  succeed(run_to(*this, out("m.msh")) + options);
  const Mesh msh = mesh_in(out("m.msh"));
  EXPECT_EQ(msh.points, whole.points);
  EXPECT_EQ(msh.tetrahedra.vertices, whole.tetrahedra.vertices);
  EXPECT_EQ(msh.prisms.label, whole.prisms.label);
  EXPECT_EQ(msh.triangles.label, whole.triangles.label);

  for (const char* format : {"openfoam", "openfoam-binary"}) {
    succeed(run_to(*this, out("case")) + options + Arguments{"--format", format});
    for (const char* folder : {"case", "case/processor0", "case/processor1", "case/processor2"})
      EXPECT_TRUE(fs::exists(out(std::string(folder) + "/constant/polyMesh/faceZones"))) << folder;
    EXPECT_FALSE(fs::exists(out("case/processor3")));
    EXPECT_TRUE(fs::exists(out("case/processor2/constant/polyMesh/cellProcAddressing")));
  }
}

TEST_F(Tool, Parts_do_not_depend_on_threads) {
  NEEDS_METIS();
  for (const char* threads : {"1", "2", "3"})
    succeed(run_to(*this, out(std::string(threads) + ".msh")) +
            Arguments{"-n", "10", "--partitions", "4", "--threads", threads});
  EXPECT_EQ(bytes_of(out("2.msh")), bytes_of(out("1.msh")));
  EXPECT_EQ(bytes_of(out("3.msh")), bytes_of(out("1.msh")));
}

TEST_F(Tool, One_part_is_the_whole_mesh) {
  succeed(run_to(*this, out("a.msh")) + Arguments{"-n", "8"});
  const Outcome outcome = succeed(run_to(*this, out("b.msh")) + Arguments{"-n", "8", "--partitions", "1"});
  EXPECT_EQ(bytes_of(out("a.msh")), bytes_of(out("b.msh")));
  EXPECT_NE(outcome.out.find("1 part, of "), std::string::npos) << outcome.out;
  succeed(run_to(*this, out("c.pvtu")) + Arguments{"-n", "8"});
  EXPECT_EQ(mesh_in(out("c_parts/c_0.vtu")).points, mesh_in(out("a.msh")).points);
}

TEST_F(Tool, Parts_that_cannot_be_are_refused) {
  const Arguments pvtu = run_to(*this, out("m.pvtu")) + Arguments{"-n", "8"};
  for (const char* number : {"0", "-1", "x", "1.5", "", "1000001", "99999999999999999999"})
    expect_refused(*this, pvtu + Arguments{"--partitions", number}, {"--partitions"});
  for (const char* file : {"m.vtu", "m.su2", "mesh-complete", "m.mesh"})
    expect_refused(*this, run_to(*this, out(file)) + Arguments{"--partitions", "2"}, {file, ".pvtu", "openfoam"});
  expect_refused(*this, run_to(*this, out("m.msh")) + Arguments{"--format", "fluent", "--partitions", "2"},
                 {"m.msh", ".pvtu"});
  expect_refused(*this, run_to(*this, out("s.vtp")) + Arguments{"-t", "surface", "--partitions", "2"},
                 {"surface", "--partitions"});
  if (!tubular::has_metis()) {
    expect_refused(*this, pvtu + Arguments{"--partitions", "2"}, {"METIS", "libmetis-dev"});
    return;
  }
  expect_refused(*this, run_to(*this, out("polyMesh")) + Arguments{"--partitions", "2"}, {"polyMesh", "constant"});
  expect_refused(*this, pvtu + Arguments{"--partitions", "100000", "--quiet"}, {"cells", "100000"});
  fs::create_directories(output_directory() / "m_parts");
  std::ofstream(out("m_parts/mine.txt")) << "mine";
  expect_refused(*this, pvtu + Arguments{"--partitions", "2"}, {"mine.txt"});
  fs::create_directories(output_directory() / "case" / "processor7");
  expect_refused(*this, run_to(*this, out("case")) + Arguments{"--format", "openfoam", "--partitions", "2"},
                 {"processor7"});
}

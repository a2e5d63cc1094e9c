// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool and the files of solvers: what is made, and what is refused before any work is done.

#include "test_tool_helpers.h"

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>

#include <map>
#include <set>
#include <string>

using namespace tool_test;

namespace {

const std::set<std::string> poly_mesh = {"points", "faces", "owner", "neighbour", "boundary"};

std::set<std::string> below(const std::string& folder, const std::set<std::string>& files) {
  std::set<std::string> result;
  for (const std::string& f : files)
    result.insert(folder + "/" + f);
  return result;
}

} // namespace

TEST_F(Tool, Solvers_files_are_made_by_name_and_by_format) {
  const auto make_files = [&](const std::string& name, const Arguments& options) {
    fs::remove_all(output_directory());
    fs::create_directories(output_directory());
    succeed(run_to(*this, out(name)) + Arguments{"-n", "8"} + options);
    return files_below(output_directory());
  };
  typedef std::set<std::string> Files;
  EXPECT_EQ(make_files("polyMesh", {}), below("polyMesh", poly_mesh));
  EXPECT_EQ(make_files("case", {"--format", "openfoam-binary"}), below("case/constant/polyMesh", poly_mesh));
  EXPECT_EQ(
      make_files("tube-mesh-complete", {}),
      below("tube-mesh-complete", {"mesh-complete.mesh.vtu", "mesh-complete.exterior.vtp", "walls_combined.vtp",
                                   "mesh-surfaces/wall.vtp", "mesh-surfaces/inlet.vtp", "mesh-surfaces/outlet_1.vtp"}));
  std::map<std::string, std::string> words = {{"m.su2", "MARKER_TAG= outlet_1"},
                                              {"m.feb", "<Surface name=\"outlet_1\">"},
                                              {"m.cas", " pressure-outlet outlet_1)"}};
  for (const auto& w : words) {
    EXPECT_EQ(make_files(w.first, {}), Files{w.first});
    EXPECT_NE(bytes_of(out(w.first)).find(w.second), std::string::npos) << w.first;
  }
  EXPECT_EQ(make_files("m.msh", {"--format", "fluent"}), Files{"m.msh"});
  EXPECT_EQ(bytes_of(out("m.msh")).compare(0, 4, "(0 \""), 0);
  if (tubular::IO::why_not_built_in(tubular::IO::Mesh_format::xdmf).empty())
    EXPECT_EQ(make_files("m.xdmf", {}), (Files{"m.h5", "m.xdmf"}));
  for (const auto& f : std::map<std::string, tubular::IO::Mesh_format>{{"m.cgns", tubular::IO::Mesh_format::cgns},
                                                                       {"m.exo", tubular::IO::Mesh_format::exodus}})
    if (tubular::IO::why_not_built_in(f.second).empty())
      EXPECT_EQ(make_files(f.first, {}), Files{f.first});
}

TEST_F(Tool, Names_that_a_format_spells_otherwise_are_told) {
  const Arguments renamed = {"-n", "8", "--rename", "outlet_1=right one", "--report", out("r.json")};
  const Outcome outcome = succeed(run_to(*this, out("m.su2")) + renamed);
  EXPECT_NE(outcome.out.find("\"right one\" is right_one"), std::string::npos) << outcome.out;
  EXPECT_NE(bytes_of(out("r.json")).find("right_one"), std::string::npos);
  EXPECT_NE(bytes_of(out("m.su2")).find("MARKER_TAG= right_one\n"), std::string::npos);
  EXPECT_EQ(succeed(run_to(*this, out("m.feb")) + renamed).out.find("right_one"), std::string::npos);
}

TEST_F(Tool, Solvers_of_walls_get_a_folder_a_region) {
  NEEDS_FILLING();
  succeed(run_to(*this, out("m-mesh-complete")) +
          Arguments{"-n", "8", "--wall", "0.2", "--wall-layers", "1", "--wall-elements", "tetrahedra"});
  const auto files = files_below(output_directory());
  for (const char* file :
       {"fluid/mesh-complete.mesh.vtu", "solid/mesh-complete.mesh.vtu", "fluid/mesh-surfaces/wall.vtp",
        "solid/mesh-surfaces/wall.vtp", "solid/mesh-surfaces/outer_wall.vtp", "solid/mesh-surfaces/inlet_ring.vtp"})
    EXPECT_EQ(files.count(std::string("m-mesh-complete/") + file), 1u) << file;
}

TEST_F(Tool, OpenFOAM_gets_a_folder_a_region_on_request) {
  NEEDS_FILLING();
  succeed(run_to(*this, out("case")) +
          Arguments{"-n", "8", "--wall", "0.2", "--wall-layers", "1", "--format", "openfoam-regions"});
  std::set<std::string> files = below("case/constant/fluid/polyMesh", poly_mesh);
  files.merge(below("case/constant/solid/polyMesh", poly_mesh));
  files.insert("case/constant/regionProperties");
  EXPECT_EQ(files_below(output_directory()), files);
  expect_refused(*this, run_to(*this, out("c")) + Arguments{"--format", "openfoam-regions", "--order", "2"},
                 {"OpenFOAM has no quadratic cells"});
  expect_refused(*this, run_to(*this, out("c")) + Arguments{"--format", "openfoam-regions", "--partitions", "2"},
                 {"in parts", "--format openfoam"});
}

TEST_F(Tool, What_solvers_cannot_take_is_refused_at_once) {
  const Arguments mesh = run_to(*this, out("mesh-complete"));
  expect_refused(*this, mesh + Arguments{"-t", "mixed"}, {"svMultiPhysics", "pyramids", "--type isotropic"});
  expect_refused(*this, mesh + Arguments{"--boundary-layer-prisms", "3"}, {"svMultiPhysics", "--type anisotropic"});
  if (tubular::IO::why_not_built_in(tubular::IO::Mesh_format::xdmf).empty()) {
    expect_refused(*this, run_to(*this, out("m.xdmf")) + Arguments{"-t", "mixed"}, {"FEniCSx", "pyramids"});
    expect_refused(*this, run_to(*this, out("m.xdmf")) + Arguments{"--wall", "0.2"},
                   {"FEniCSx", "--wall-elements tetrahedra"});
  } else {
    expect_refused(*this, run_to(*this, out("m.xdmf")), {"libhdf5-dev"});
  }
  expect_refused(*this, run_to(*this, out("m.unknown")), {"m.unknown", "--format"});
  expect_refused(*this, run_to(*this, out("m.vtu")) + Arguments{"--format", "nastran"}, {"nastran", "openfoam"});
  expect_refused(*this, run_to(*this, out("s.vtp")) + Arguments{"-t", "surface", "--format", "vtu"}, {"--format"});
}

TEST_F(Tool, Folders_with_other_files_are_left_as_they_are) {
  fs::create_directories(output_directory() / "polyMesh");
  std::ofstream(out("polyMesh/mine.txt")) << "mine";
  std::ofstream(out("case")) << "a file";
  expect_refused(*this, run_to(*this, out("polyMesh")), {"mine.txt"});
  expect_refused(*this, run_to(*this, out("case")) + Arguments{"--format", "openfoam"}, {"case"});
  EXPECT_EQ(bytes_of(out("polyMesh/mine.txt")), "mine");
}

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes for OpenFOAM: read back face by face, and by its own checkMesh where that is installed.

#include "openfoam_case.h"
#include "poly_mesh.h"
#include "resource_limits.h"
#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/IO/write_openfoam.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

Corners corners(const std::vector<std::size_t>& loop) {
  return Corners(loop.begin(), loop.end());
}

void expect_same(const Mesh& m, const Poly_mesh& p) {
  ASSERT_EQ(p.points.size(), m.points.size());
  for (std::size_t i = 0; i < m.points.size(); ++i)
    EXPECT_EQ(p.points[i], m.points[i]);

  // the faces of each cell, and its volume by the way that they turn
  const Faces_of_cells cells(m);
  std::vector<std::set<Corners>> faces(cells.faces.size());
  std::vector<double> volume(cells.faces.size(), 0);
  ASSERT_EQ(p.owner.size(), p.faces.size());
  for (std::size_t f = 0; f < p.faces.size(); ++f) {
    std::vector<Point> loop;
    for (std::size_t v : p.faces[f])
      loop.push_back(p.points.at(v));
    EXPECT_TRUE(faces.at(p.owner[f]).insert(corners(p.faces[f])).second);
    volume[p.owner[f]] += volume_under(loop);
    if (f < p.neighbour.size()) {
      EXPECT_TRUE(faces.at(p.neighbour[f]).insert(corners(p.faces[f])).second);
      volume[p.neighbour[f]] -= volume_under(loop);
    }
  }
  for (std::size_t c = 0; c < faces.size(); ++c) {
    EXPECT_EQ(faces[c], cells.corners(c));
    double expected = 0;
    for (const auto& face : cells.faces[c]) {
      std::vector<Point> loop;
      for (std::size_t v : face)
        loop.push_back(m.points[v]);
      expected += volume_under(loop);
    }
    EXPECT_GT(volume[c], 0);
    EXPECT_NEAR(volume[c], expected, 1e-9);
  }

  // upper triangular order
  for (std::size_t f = 0; f < p.neighbour.size(); ++f) {
    EXPECT_LT(p.owner[f], p.neighbour[f]);
    if (f > 0) {
      EXPECT_LT(std::make_pair(p.owner[f - 1], p.neighbour[f - 1]), std::make_pair(p.owner[f], p.neighbour[f]));
    }
  }

  // patches and zones are the facets of the mesh
  std::map<std::string, std::set<Corners>> found;
  std::size_t next = p.neighbour.size();
  for (const std::string& name : p.order_of_patches) {
    const auto& patch = p.patches.at(name);
    EXPECT_EQ(patch.first, next);
    next += patch.faces;
    for (std::size_t f = patch.first; f < next; ++f)
      found[name].insert(corners(p.faces.at(f)));
    EXPECT_EQ(patch.type, name == "wall" || name == "outer_wall" ? "wall" : "patch") << name;
  }
  EXPECT_EQ(next, p.faces.size());
  for (const auto& zone : p.face_zones) {
    ASSERT_EQ(zone.second.flips.size(), zone.second.members.size());
    for (std::size_t i = 0; i < zone.second.members.size(); ++i) {
      const std::size_t f = zone.second.members[i];
      ASSERT_LT(f, p.neighbour.size());
      found[zone.first].insert(corners(p.faces[f]));
      EXPECT_EQ(zone.second.flips[i] != 0, cells.region[p.owner[f]] > cells.region[p.neighbour[f]]);
    }
  }
  std::map<std::string, std::set<Corners>> expected;
  for (const auto& patch : facets_of(m))
    expected[m.patch_names.at(patch.first)] = patch.second;
  EXPECT_EQ(found, expected);

  std::map<std::string, std::vector<std::size_t>> zones;
  for (std::size_t c = 0; c < cells.region.size(); ++c)
    zones[m.region_names.count(cells.region[c]) != 0 ? m.region_names.at(cells.region[c])
                                                     : "region_" + std::to_string(cells.region[c])]
        .push_back(c);
  if (zones.size() > 1) {
    ASSERT_EQ(p.cell_zones.size(), zones.size());
    for (const auto& z : zones)
      EXPECT_EQ(p.cell_zones.at(z.first).members, z.second);
  } else {
    EXPECT_TRUE(p.cell_zones.empty());
  }
}

} // namespace

TEST_F(IO, OpenFOAM_meshes_are_read_back_equal) {
  for (const Named_mesh& m : solver_meshes())
    for (bool binary : {false, true}) {
      SCOPED_TRACE(m.name + (binary ? " binary" : ""));
      TM::IO::write_openfoam(path("case"), m.mesh, binary);
      const fs::path folder = directory / "case" / "constant" / "polyMesh";
      expect_same(m.mesh, Poly_mesh(folder));
      EXPECT_EQ(fs::exists(folder / "faceZones"),
                m.name.find("12") != std::string::npos || m.name.find("21") != std::string::npos);
      EXPECT_EQ(number_of_files(), 1u);
    }
}

TEST_F(IO, OpenFOAM_says_that_meshes_are_OK) {
  if (!has_program("checkMesh"))
    GTEST_SKIP() << "needs checkMesh of OpenFOAM";
  for (const Named_mesh& m : solver_meshes())
    for (bool binary : {false, true}) {
      SCOPED_TRACE(m.name + (binary ? " binary" : ""));
      const fs::path folder = directory / "case";
      make_openfoam_case(folder);
      TM::IO::write_openfoam(folder.string(), m.mesh, binary);
      const std::string log = path("log");
      EXPECT_TRUE(run_openfoam("checkMesh -allTopology", folder, log));
      const std::string said = bytes_of(log);
      EXPECT_NE(said.find("\nMesh OK.\n"), std::string::npos) << said;
      EXPECT_NE(said.find("tetrahedra:    " + std::to_string(m.mesh.tetrahedra.size()) + "\n"), std::string::npos)
          << said;
      EXPECT_NE(said.find("prisms:        " + std::to_string(m.mesh.prisms.size()) + "\n"), std::string::npos);
      EXPECT_NE(said.find("pyramids:      " + std::to_string(m.mesh.pyramids.size()) + "\n"), std::string::npos);
      EXPECT_NE(said.find("hexahedra:     " + std::to_string(m.mesh.hexahedra.size()) + "\n"), std::string::npos);
      fs::remove_all(folder);
    }
}

TEST_F(IO, OpenFOAM_computes_a_flow) {
  if (!has_program("icoFoam"))
    GTEST_SKIP() << "needs icoFoam of OpenFOAM";
  for (const char* layers : {"TTTT", "HHXW"})
    for (bool binary : {false, true}) {
      const fs::path folder = directory / "case";
      make_openfoam_case(folder);
      TM::IO::write_openfoam(folder.string(), Layered_box::make(4, layers, "1111"), binary);
      EXPECT_TRUE(run_openfoam("icoFoam", folder, path("log"))) << bytes_of(path("log"));
      const std::string said = bytes_of(path("log"));
      EXPECT_NE(said.find("\nTime = 0.01\n"), std::string::npos) << said;
      EXPECT_NE(said.find("\nEnd\n"), std::string::npos) << said;
      EXPECT_TRUE(fs::exists(folder / "0.01" / "U"));
      fs::remove_all(folder);
    }
}

TEST_F(IO, OpenFOAM_takes_names_as_words) {
  Mesh m = Layered_box::make(1, "HH", "12");
  m.patch_names = {{1, "arterial wall"}, {2, "Einströmung"}, {3, "2nd outlet; {a}"}, {100, "arterial_wall"}};
  m.region_names = {{1, "same"}, {2, "same"}};
  TM::IO::write_openfoam(path("polyMesh"), m);
  const Poly_mesh p(directory / "polyMesh");
  std::set<std::string> names, zones;
  for (const auto& patch : p.patches)
    names.insert(patch.first);
  for (const auto& zone : p.cell_zones)
    zones.insert(zone.first);
  EXPECT_EQ(names, (std::set<std::string>{"arterial_wall", "Einströmung", "_2nd_outlet___a_", "arterial_wall_2"}));
  EXPECT_EQ(zones, (std::set<std::string>{"same", "same_2"}));
  EXPECT_EQ(p.patches.at("arterial_wall_2").type, "wall");
  m.patch_names[2] = "an \"inlet\"";
  EXPECT_THROW(TM::IO::write_openfoam(path("other"), m), TM::Output_error);
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(IO, OpenFOAM_gets_no_points_that_no_cell_has_and_every_face_a_patch) {
  Mesh m = Layered_box::make(1, "H", "1");
  m.points.insert(m.points.begin(), Point(9, 9, 9));
  for (auto& h : m.hexahedra.vertices)
    for (auto& v : h)
      ++v;
  for (auto& q : m.quads.vertices)
    for (auto& v : q)
      ++v;
  m.quads.vertices.pop_back();
  m.quads.label.pop_back();
  TM::IO::write_openfoam(path("case"), m);
  const Poly_mesh p(directory / "case" / "constant" / "polyMesh");
  EXPECT_EQ(p.points.size(), 8u);
  EXPECT_EQ(p.points[0], m.points[1]);
  ASSERT_EQ(p.patches.count("defaultFaces"), 1u);
  EXPECT_EQ(p.patches.at("defaultFaces").faces, 1u);
  EXPECT_EQ(p.faces.size(), 6u);
  EXPECT_NE(p.note.find("\"nPoints:8  nCells:1  nFaces:6  nInternalFaces:0\""), std::string::npos) << p.note;
}

namespace {

const std::map<int, std::string> region_folders_of_samples = {{1, "fluid"}, {2, "solid"}, {3, "region_3"}};

Corners in_mesh(const Poly_mesh& p, std::size_t face, const Point_finder& find) {
  Corners result;
  for (std::size_t v : p.faces.at(face))
    result.insert(find(p.points.at(v)));
  return result;
}

// The faces of the cells of a region, its patches, and the interfaces, whose two sides have the same faces.
void expect_regions(const Mesh& m, const fs::path& openfoam_case) {
  const Faces_of_cells cells(m);
  const Point_finder find(m);
  std::map<int, Poly_mesh> regions;
  for (int region : cells.region)
    if (regions.count(region) == 0)
      regions.emplace(region,
                      Poly_mesh(openfoam_case / "constant" / region_folders_of_samples.at(region) / "polyMesh"));
  std::map<Corners, std::vector<std::size_t>> sides;
  for (std::size_t c = 0; c < cells.faces.size(); ++c)
    for (const Corners& f : cells.corners(c))
      sides[f].push_back(c);
  for (const auto& r : regions) {
    const Poly_mesh& p = r.second;
    std::vector<std::set<Corners>> faces;
    for (std::size_t f = 0; f < p.faces.size(); ++f) {
      faces.resize(std::max({faces.size(), p.owner[f] + 1, f < p.neighbour.size() ? p.neighbour[f] + 1 : 0}));
      const Corners face = in_mesh(p, f, find);
      EXPECT_TRUE(faces[p.owner[f]].insert(face).second);
      if (f < p.neighbour.size()) {
        EXPECT_TRUE(faces[p.neighbour[f]].insert(face).second);
        EXPECT_LT(p.owner[f], p.neighbour[f]);
      }
    }
    std::vector<std::set<Corners>> expected;
    for (std::size_t c = 0; c < cells.faces.size(); ++c)
      if (cells.region[c] == r.first)
        expected.push_back(cells.corners(c));
    EXPECT_EQ(faces, expected);
    EXPECT_TRUE(p.cell_zones.empty());
    std::map<std::string, std::set<Corners>> patches, facets;
    for (const auto& patch : p.patches)
      for (std::size_t k = 0; k < patch.second.faces; ++k)
        patches[patch.first].insert(in_mesh(p, patch.second.first + k, find));
    for (const auto& patch : facets_of(m))
      for (const Corners& f : patch.second)
        if (sides.at(f).size() == 1 && cells.region[sides.at(f)[0]] == r.first)
          facets[m.patch_names.at(patch.first)].insert(f);
    for (const auto& s : sides)
      if (s.second.size() == 2)
        for (std::size_t k = 0; k < 2; ++k)
          if (cells.region[s.second[k]] == r.first && cells.region[s.second[1 - k]] != r.first)
            facets[region_folders_of_samples.at(r.first) + "_to_" +
                   region_folders_of_samples.at(cells.region[s.second[1 - k]])]
                .insert(s.first);
    EXPECT_EQ(patches, facets);
    for (const auto& other : regions) {
      const std::string mine = region_folders_of_samples.at(r.first),
                        theirs = region_folders_of_samples.at(other.first);
      const auto side = p.patches.find(mine + "_to_" + theirs);
      if (side == p.patches.end())
        continue;
      EXPECT_EQ(side->second.type, "mappedWall");
      const auto& back = other.second.patches.at(theirs + "_to_" + mine);
      ASSERT_EQ(side->second.faces, back.faces);
      for (std::size_t k = 0; k < back.faces; ++k) { // the same order, the same first point, turned round
        std::vector<Point> loop, opposite;
        for (std::size_t v : p.faces[side->second.first + k])
          loop.push_back(p.points[v]);
        for (std::size_t v : other.second.faces[back.first + k])
          opposite.push_back(other.second.points[v]);
        std::reverse(opposite.begin() + 1, opposite.end());
        EXPECT_EQ(loop, opposite);
      }
    }
  }
}

} // namespace

TEST_F(IO, OpenFOAM_gets_a_folder_a_region_whose_interfaces_match) {
  for (const Named_mesh& m : solver_meshes())
    for (bool binary : {false, true}) {
      SCOPED_TRACE(m.name + (binary ? " binary" : ""));
      TM::IO::write_openfoam_regions(path("case"), m.mesh, binary);
      expect_regions(m.mesh, directory / "case");
      EXPECT_TRUE(fs::exists(directory / "case" / "constant" / "regionProperties"));
      EXPECT_FALSE(fs::exists(directory / "case" / "constant" / "polyMesh"));
      EXPECT_EQ(number_of_files(), 1u);
      fs::remove_all(directory / "case");
    }
}

TEST_F(IO, OpenFOAM_says_that_regions_are_OK) {
  if (!has_program("checkMesh"))
    GTEST_SKIP() << "needs checkMesh of OpenFOAM";
  for (const char* layers : {"TT", "WW", "HH", "TW", "HXWT"}) {
    SCOPED_TRACE(layers);
    const std::size_t n = std::string(layers).size();
    const fs::path folder = directory / "case";
    make_openfoam_case(folder);
    fs::remove_all(folder / "0");
    TM::IO::write_openfoam_regions(folder.string(), Layered_box::make(3, layers, std::string(n - 1, '1') + "2"));
    for (const char* region : {"fluid", "solid"}) {
      fs::create_directories(folder / "system" / region);
      for (const char* file : {"fvSchemes", "fvSolution"})
        fs::copy_file(folder / "system" / file, folder / "system" / region / file);
      EXPECT_TRUE(run_openfoam(std::string("checkMesh -allTopology -region ") + region, folder, path("log")));
      EXPECT_NE(bytes_of(path("log")).find("\nMesh OK.\n"), std::string::npos) << bytes_of(path("log"));
    }
    fs::remove_all(folder);
  }
}

TEST_F(IO, Regions_for_OpenFOAM_are_written_all_or_none) {
  Mesh m = Layered_box::make(1, "HH", "12");
  m.patch_names[2] = "fluid_to_solid"; // as the interface would be called
  TM::IO::write_openfoam_regions(path("case"), m);
  const fs::path constant = directory / "case" / "constant";
  EXPECT_EQ(Poly_mesh(constant / "fluid" / "polyMesh").patches.at("fluid_to_solid_2").type, "mappedWall");
  EXPECT_NE(bytes_of((constant / "fluid" / "polyMesh" / "boundary").string()).find("samplePatch     solid_to_fluid;"),
            std::string::npos);
  EXPECT_NE(bytes_of((constant / "solid" / "polyMesh" / "boundary").string()).find("samplePatch     fluid_to_solid_2;"),
            std::string::npos);
  // what the user has made of the list of regions stays
  std::ofstream(constant / "regionProperties") << "mine";
  TM::IO::write_openfoam_regions(path("case"), Layered_box::make(1, "WW", "12"));
  EXPECT_EQ(bytes_of((constant / "regionProperties").string()), "mine");
  EXPECT_EQ(Poly_mesh(constant / "solid" / "polyMesh").faces.size(), 9u);
  // a file of the user's in the second region: the first one is as it was
  std::ofstream(constant / "solid" / "polyMesh" / "mine.txt") << "mine";
  const auto all_files = [&] {
    return std::distance(fs::recursive_directory_iterator(directory), fs::recursive_directory_iterator());
  };
  const auto before = all_files();
  EXPECT_THROW(TM::IO::write_openfoam_regions(path("case"), Layered_box::make(2, "HH", "12")), TM::Output_error);
  EXPECT_EQ(Poly_mesh(constant / "fluid" / "polyMesh").faces.size(), 9u);
  EXPECT_EQ(all_files(), before);
  EXPECT_THROW(TM::IO::write_openfoam_regions(path("other"), Mesh()), TM::Output_error);
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(IO, OpenFOAM_refuses_what_is_no_mesh_of_cells) {
  Mesh m = Layered_box::make(1, "H", "1");
  Mesh surface = m;
  surface.hexahedra = {};
  EXPECT_THROW(TM::IO::write_openfoam(path("case"), surface), TM::Output_error);
  Mesh loose = m;
  loose.triangles.push_back({0, 3, 5}, 1);
  EXPECT_THROW(TM::IO::write_openfoam(path("case"), loose), TM::Output_error);
  Mesh twice = m;
  twice.quads.push_back(twice.quads.vertices[0], 3);
  EXPECT_THROW(TM::IO::write_openfoam(path("case"), twice), TM::Output_error);
  Mesh three = m;
  three.hexahedra.push_back(three.hexahedra.vertices[0], 1);
  three.hexahedra.push_back(three.hexahedra.vertices[0], 1);
  EXPECT_THROW(TM::IO::write_openfoam(path("case"), three), TM::Output_error);
  EXPECT_EQ(number_of_files(), 0u);
}

TEST_F(IO, Folders_are_written_whole_or_not_at_all) {
  const Mesh m = Layered_box::make(1, "H", "1"), other = Layered_box::make(1, "T", "1");
  fs::create_directories(directory / "case" / "system");
  TM::IO::write_openfoam(path("case"), m);
  const std::string before = bytes_of(path("case/constant/polyMesh/faces"));
  {
    TM::IO::Output_folder out = TM::IO::openfoam_folder(path("case"));
    TM::IO::write_openfoam(out, other);
    out.finish();
    EXPECT_EQ(bytes_of(path("case/constant/polyMesh/faces")), before);
  }
  EXPECT_EQ(bytes_of(path("case/constant/polyMesh/faces")), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(directory / "case" / "constant"), fs::directory_iterator()), 1);
  TM::IO::write_openfoam(path("case"), other);
  EXPECT_NE(bytes_of(path("case/constant/polyMesh/faces")), before);
  EXPECT_TRUE(fs::exists(directory / "case" / "system"));

  // what a killed process left behind is not in the way, and stays
  fs::create_directories(directory / "case" / "constant" / ".tubular_meshing_0.partial");
  make("case/constant/.tubular_meshing_1.partial", "a file");
  TM::IO::write_openfoam(path("case"), m);
  EXPECT_EQ(bytes_of(path("case/constant/polyMesh/faces")), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(directory / "case" / "constant"), fs::directory_iterator()), 3);

  // folders above it that were made go with it
  {
    TM::IO::Output_folder out = TM::IO::openfoam_folder(path("new/case"));
    TM::IO::write_openfoam(out, m);
  }
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(IO, Folders_with_other_files_are_not_replaced) {
  const Mesh m = Layered_box::make(1, "H", "1");
  TM::IO::write_openfoam(path("polyMesh"), m);
  make("polyMesh/blockMeshDict", "mine");
  try {
    TM::IO::write_openfoam(path("polyMesh"), m);
    ADD_FAILURE() << "no error";
  } catch (const TM::Output_error& e) {
    EXPECT_NE(std::string(e.what()).find("blockMeshDict"), std::string::npos) << e.what();
  }
  EXPECT_EQ(bytes_of(path("polyMesh/blockMeshDict")), "mine");
  fs::create_directories(directory / "b");
  make("b/polyMesh", "a file");
  EXPECT_THROW(TM::IO::write_openfoam(path("b/polyMesh"), m), TM::Output_error);
  make("c", "a file");
  EXPECT_THROW(TM::IO::write_openfoam(path("c"), m), TM::Output_error);
  EXPECT_THROW(TM::IO::write_openfoam("/dev/null/polyMesh", m), TM::Output_error);
  EXPECT_EQ(bytes_of(path("c")), "a file");
  EXPECT_EQ(number_of_files(), 3u);
}

#ifdef __unix__
TEST_F(IO, Folders_stay_links) {
  fs::create_directories(directory / "there" / "polyMesh");
  fs::create_directory_symlink(directory / "there" / "polyMesh", directory / "polyMesh");
  TM::IO::write_openfoam(path("polyMesh"), Layered_box::make(1, "H", "1"));
  EXPECT_TRUE(fs::is_symlink(path("polyMesh")));
  EXPECT_TRUE(fs::is_regular_file(path("there/polyMesh/points")));
}

TEST_F(IO, A_limit_on_file_size_leaves_the_folder_as_it_was) {
  const Mesh m = Layered_box::make(1, "H", "1"), large = Layered_box::make(8, "TTT", "112");
  TM::IO::write_openfoam(path("case"), m);
  const std::string before = bytes_of(path("case/constant/polyMesh/faces"));
  std::string said;
  try {
    const Resource_limit limit(RLIMIT_FSIZE, 20000);
    TM::IO::write_openfoam(path("case"), large);
  } catch (const TM::Output_error& e) {
    said = e.what();
  }
  EXPECT_NE(said.find(path("case/constant/polyMesh/")), std::string::npos) << said;
  EXPECT_EQ(bytes_of(path("case/constant/polyMesh/faces")), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(directory / "case" / "constant"), fs::directory_iterator()), 1);
}
#endif

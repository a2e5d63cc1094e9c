// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes for Ansys Fluent: read back face by face, and by OpenFOAM's converter where that is installed.

#include "openfoam_case.h"
#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/IO/write_fluent.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

// A Fluent mesh, by a reader of its own: nested lists, numbers of indices in hexadecimals.
struct Fluent_mesh {
  struct Face {
    std::vector<std::size_t> corners; // from 0
    std::size_t right, left;          // cells from 1, 0 for none
  };
  struct Zone {
    std::size_t first, last;
    int condition, type;
    std::string name, kind;
    std::vector<Face> faces;
    std::vector<int> types; // of mixed cells
  };
  std::vector<Point> points;
  std::map<std::size_t, Zone> zones; // of cells and faces
  std::map<int, std::size_t> declared;

  explicit Fluent_mesh(const std::string& text) {
    std::istringstream in(text);
    char c;
    while (in >> c) {
      EXPECT_EQ(c, '(');
      int section;
      in >> section;
      if (section == 0) {
        std::getline(in, rest_, ')');
      } else if (section == 2) {
        EXPECT_EQ(number(in), 3u);
        expect(in, ")");
      } else if (section == 45) {
        expect(in, "(");
        std::size_t id;
        in >> std::dec >> id;
        in >> zones.at(id).kind;
        std::getline(in, zones.at(id).name, ')');
        zones.at(id).name.erase(0, 1);
        expect(in, "())");
      } else {
        read_section(section, in);
      }
    }
  }

private:
  std::string rest_;

  static std::size_t number(std::istream& in) {
    std::size_t n = 0;
    in >> std::hex >> n >> std::dec;
    return n;
  }
  static void expect(std::istream& in, const std::string& signs) {
    for (char s : signs) {
      char c = 0;
      in >> c;
      EXPECT_EQ(c, s);
    }
  }

  void read_section(int section, std::istream& in) {
    expect(in, "(");
    const std::size_t id = number(in), first = number(in), last = number(in);
    const int condition = int(number(in)), type = int(number(in));
    expect(in, ")");
    if (id == 0) {
      EXPECT_EQ(first, 1u);
      declared[section] = last;
      expect(in, ")");
      return;
    }
    if (section != 10) {
      EXPECT_EQ(zones.count(id), 0u);
      zones[id] = {first, last, condition, type, "", "", {}, {}};
    }
    if (section == 12 && type != 0) {
      expect(in, ")");
      return;
    }
    expect(in, "(");
    for (std::size_t i = first; i <= last; ++i)
      if (section == 10) {
        std::string x, y, z;
        in >> x >> y >> z;
        points.push_back(
            Point(std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr), std::strtod(z.c_str(), nullptr)));
      } else if (section == 12) {
        zones[id].types.push_back(int(number(in)));
      } else {
        Face f;
        f.corners.resize(number(in));
        for (std::size_t& v : f.corners)
          v = number(in) - 1;
        f.right = number(in);
        f.left = number(in);
        zones[id].faces.push_back(f);
      }
    expect(in, "))");
  }
};

void expect_same(const Mesh& m, const Fluent_mesh& f) {
  EXPECT_TRUE(f.points == m.points);
  EXPECT_EQ(f.declared.at(10), m.points.size());
  EXPECT_EQ(f.declared.at(12), m.number_of_cells());

  // the cells of the mesh in the order of the file
  const Cells_of_regions regions = cells_of(m);
  const Faces_of_cells cells(m);
  std::vector<std::size_t> order;
  std::vector<std::string> region; // of each cell of the file
  std::vector<int> type;
  std::size_t next = 1;
  for (const auto& r : regions) {
    for (std::size_t c = 0; c < cells.region.size(); ++c)
      if (cells.region[c] == r.first)
        order.push_back(c);
    const std::string name =
        m.region_names.count(r.first) != 0 ? m.region_names.at(r.first) : "region_" + std::to_string(r.first);
    bool found = false;
    for (const auto& z : f.zones)
      if ((z.second.kind == "fluid" || z.second.kind == "solid") && z.second.first == next) {
        found = true;
        EXPECT_EQ(z.second.name, name == "wall" ? "wall-cells" : name);
        EXPECT_EQ(z.second.condition, r.first == 1 ? 1 : 0x11);
        EXPECT_EQ(z.second.last, next + r.second.size() - 1);
        for (std::size_t i = z.second.first; i <= z.second.last; ++i)
          type.push_back(z.second.type != 0 ? z.second.type : z.second.types.at(i - z.second.first));
      }
    EXPECT_TRUE(found) << name;
    next += r.second.size();
  }

  const std::map<int, std::size_t> faces_of_type = {{2, 4}, {4, 6}, {5, 5}, {6, 5}};
  std::vector<std::set<Corners>> faces(order.size());
  std::vector<double> volume(order.size(), 0);
  std::map<std::string, std::set<Corners>> patches;
  std::size_t number = 1;
  for (const auto& z : f.zones) {
    if (z.second.kind == "fluid" || z.second.kind == "solid")
      continue;
    EXPECT_EQ(z.second.first, number);
    number = z.second.last + 1;
    for (const auto& face : z.second.faces) {
      std::vector<Point> loop;
      for (std::size_t v : face.corners)
        loop.push_back(f.points.at(v));
      const Corners key(face.corners.begin(), face.corners.end());
      ASSERT_GT(face.right, 0u);
      EXPECT_TRUE(faces.at(face.right - 1).insert(key).second);
      volume[face.right - 1] -= volume_under(loop);
      if (face.left > 0) {
        EXPECT_TRUE(faces.at(face.left - 1).insert(key).second);
        volume[face.left - 1] += volume_under(loop);
      }
      if (z.second.name.compare(0, 8, "interior") != 0) {
        patches[z.second.name].insert(key);
        EXPECT_EQ(z.second.condition == 3, z.second.kind == "wall");
      } else {
        EXPECT_EQ(z.second.condition, 2);
        EXPECT_GT(face.left, 0u);
      }
    }
  }
  EXPECT_EQ(f.declared.at(13), number - 1);
  const std::map<std::size_t, int> type_of_corners = {{4, 2}, {5, 5}, {6, 6}, {8, 4}};
  std::size_t i = 0;
  for (const auto& r : regions)
    for (const auto& c : r.second) {
      EXPECT_EQ(faces[i], cells.corners(order[i]));
      EXPECT_EQ(faces[i].size(), faces_of_type.at(type[i]));
      EXPECT_EQ(type[i], type_of_corners.at(c.size()));
      EXPECT_GT(volume[i], 0);
      ++i;
    }
  std::map<std::string, std::set<Corners>> expected;
  for (const auto& p : facets_of(m))
    expected[m.patch_names.at(p.first)] = p.second;
  EXPECT_EQ(patches, expected);
}

} // namespace

TEST_F(IO, Fluent_meshes_are_read_back_equal) {
  for (const Named_mesh& m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    TM::IO::write_fluent(path("m.msh"), m.mesh);
    expect_same(m.mesh, Fluent_mesh(bytes_of(path("m.msh"))));
    EXPECT_EQ(number_of_files(), 1u);
  }
}

TEST_F(IO, Fluent_gets_names_and_conditions) {
  Mesh m = Layered_box::make(1, "HHH", "121");
  m.patch_names = {{1, "Arterial Wall"}, {2, "Zufluß"}, {3, "arterial-wall"}, {100, "2nd"}};
  const auto outer = std::find(m.quads.label.begin(), m.quads.label.end(), 100) - m.quads.label.begin();
  m.quads.vertices.erase(m.quads.vertices.begin() + outer);
  m.quads.label.erase(m.quads.label.begin() + outer);
  TM::IO::write_fluent(path("m.msh"), m);
  const Fluent_mesh f(bytes_of(path("m.msh")));
  std::map<std::string, std::string> kinds;
  for (const auto& z : f.zones)
    EXPECT_TRUE(kinds.emplace(z.second.name, z.second.kind).second);
  EXPECT_EQ(kinds, (std::map<std::string, std::string>{{"lumen", "fluid"},
                                                       {"wall", "solid"},
                                                       {"arterial-wall", "wall"},
                                                       {"zuflu--", "velocity-inlet"},
                                                       {"arterial-wall_2", "pressure-outlet"},
                                                       {"z-2nd", "wall"},
                                                       {"default-faces", "wall"}}));
  m.hexahedra = {};
  EXPECT_THROW(TM::IO::write_fluent(path("n.msh"), m), TM::Output_error);
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(IO, Fluent_meshes_are_read_by_OpenFOAM) {
  if (!has_program("fluent3DMeshToFoam") || !has_program("checkMesh"))
    GTEST_SKIP() << "needs fluent3DMeshToFoam and checkMesh of OpenFOAM";
  int read = 0;
  for (const Named_mesh& m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    if (cells_of(m.mesh).size() > 1)
      continue; // the converter takes a wall with cells on both sides for a boundary, and loses one of the sides
    ++read;
    const fs::path folder = directory / "case";
    make_openfoam_case(folder);
    TM::IO::write_fluent(path("m.msh"), m.mesh);
    EXPECT_TRUE(run_openfoam("fluent3DMeshToFoam ../m.msh", folder, path("log"))) << bytes_of(path("log"));
    EXPECT_TRUE(run_openfoam("checkMesh -allTopology", folder, path("log")));
    const std::string said = bytes_of(path("log"));
    EXPECT_NE(said.find("\nMesh OK.\n"), std::string::npos) << said;
    EXPECT_EQ(said.find("rror"), std::string::npos) << said;
    EXPECT_NE(said.find("tetrahedra:    " + std::to_string(m.mesh.tetrahedra.size()) + "\n"), std::string::npos)
        << said;
    EXPECT_NE(said.find("prisms:        " + std::to_string(m.mesh.prisms.size()) + "\n"), std::string::npos) << said;
    for (const char* name : {"inlet", "outlet_1"})
      EXPECT_NE(said.find(name), std::string::npos) << said;
    fs::remove_all(folder);
  }
  EXPECT_EQ(read, 5);
}

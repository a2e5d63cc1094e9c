// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes in parts: read back by readers of this test, and by VTK, Gmsh and OpenFOAM where these are installed.

#include "openfoam_case.h"
#include "poly_mesh.h"
#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_file.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_openfoam.h>
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh.h>
#include <CGAL/Tubular_meshing/Partition/Ghost_cells.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <utility>
#include <vector>

#ifdef __unix__
#include <csignal>
#include <sys/resource.h>
#endif

namespace {

using TM::Cell_partition;
using TM::IO::Mesh_format;
using TM::IO::write_partitioned_mesh;

// --- what is written ---

struct Partitioned {
  std::string name;
  Mesh mesh;
  Cell_partition partition;
};

// In the order of the mesh, and as mixed as can be.
Cell_partition in_order(const Mesh& m, std::size_t parts) {
  Cell_partition p{parts, {}};
  for (std::size_t c = 0; c < m.number_of_cells(); ++c)
    p.part.push_back(std::uint32_t(c * parts / m.number_of_cells()));
  return p;
}
Cell_partition scattered(const Mesh& m, std::size_t parts) {
  Cell_partition p{parts, {}};
  for (std::size_t c = 0; c < m.number_of_cells(); ++c)
    p.part.push_back(std::uint32_t((c * 7) % parts));
  return p;
}

// With point arrays, and two points that no cell has.
Mesh with_arrays(Mesh m) {
  m.points.push_back(Point(-1, -2, -3));
  m.points.insert(m.points.begin(), Point(7, 8, 9));
  const auto shift = [](auto& block) {
    for (auto& vertices : block.vertices)
      for (auto& v : vertices)
        ++v;
  };
  shift(m.tetrahedra);
  shift(m.pyramids);
  shift(m.prisms);
  shift(m.hexahedra);
  shift(m.triangles);
  shift(m.quads);
  TM::Point_array number{"number", 1, {}}, metric{"metric", 6, {}};
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    number.values.push_back(double(i) / 3);
    for (std::size_t k = 0; k < 6; ++k)
      metric.values.push_back(double(i * 6 + k) / 7);
  }
  m.point_arrays = {number, metric};
  return m;
}

std::vector<Partitioned> samples() {
  std::vector<Partitioned> result;
  for (const Named_mesh& m : solver_meshes()) {
    result.push_back({m.name + "_3", m.mesh, in_order(m.mesh, 3)});
    result.push_back({m.name + "_scattered", m.mesh, scattered(m.mesh, 4)});
  }
  const Mesh larger = Layered_box::make(5, "HXWWTT", "111222");
  result.push_back({"larger_8", larger, in_order(larger, 8)});
  result.push_back({"larger_1", larger, in_order(larger, 1)});
  return result;
}

// Cells, then facets, by their kinds: corners and label.
struct Elements {
  std::vector<std::vector<std::int64_t>> corners;
  std::vector<int> region, patch;

  explicit Elements(const Mesh& m) {
    add(m.tetrahedra, true);
    add(m.pyramids, true);
    add(m.prisms, true);
    add(m.hexahedra, true);
    add(m.triangles, false);
    add(m.quads, false);
  }

private:
  template <class Block> void add(const Block& block, bool are_cells) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      corners.emplace_back(block.vertices[i].begin(), block.vertices[i].end());
      region.push_back(are_cells ? block.label[i] : 0);
      patch.push_back(are_cells ? 0 : block.label[i]);
    }
  }
};

// For each facet the cells whose face it is, those of the lower region first.
std::vector<std::vector<std::size_t>> cells_behind_facets(const Mesh& m) {
  const Faces_of_cells cells(m);
  std::map<Corners, std::vector<std::size_t>> sides;
  for (std::size_t c = 0; c < cells.faces.size(); ++c)
    for (const Corners& f : cells.corners(c))
      sides[f].push_back(c);
  const Elements elements(m);
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t f = m.number_of_cells(); f < elements.corners.size(); ++f) {
    result.push_back(sides.at(Corners(elements.corners[f].begin(), elements.corners[f].end())));
    std::stable_sort(result.back().begin(), result.back().end(),
                     [&](std::size_t a, std::size_t b) { return cells.region[a] < cells.region[b]; });
  }
  return result;
}

// --- VTK ---

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

void expect_parts_of_vtu(const Mesh& m, const Cell_partition& p, const std::function<std::string(std::size_t)>& file) {
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
  for (const Partitioned& s : samples())
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
  const std::string script =
      (fs::path(TUBULAR_MESHING_DATA).parent_path() / "test/Tubular_meshing/read_partitions.py").string();
  if (!fs::exists(script) || !fs::exists("/usr/bin/python3"))
    GTEST_SKIP() << "needs /usr/bin/python3 and " << script;
  std::vector<Partitioned> meshes = samples();
  meshes.erase(meshes.begin(), meshes.end() - 6);
  for (const Partitioned& s : meshes) {
    SCOPED_TRACE(s.name);
    const Mesh m = with_arrays(s.mesh);
    write_partitioned_mesh(path("m.pvtu"), m, s.partition);
    TM::IO::write_mesh(path("m.vtu"), m);
    const int status =
        std::system(("/usr/bin/python3 '" + script + "' '" + path("m.pvtu") + "' '" + path("m.vtu") + "' " +
                     std::to_string(s.partition.number_of_parts) + " > '" + path("log") + "' 2>&1")
                        .c_str());
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77)
      GTEST_SKIP() << "needs VTK in Python";
    EXPECT_EQ(WEXITSTATUS(status), 0) << bytes_of(path("log"));
    EXPECT_EQ(bytes_of(path("log")), "");
  }
}

TEST_F(IO, A_pvtu_file_without_a_partition_has_one_part) {
  const Mesh m = with_arrays(Layered_box::make(3, "HXWT", "1112"));
  TM::IO::write_mesh(path("m.pvtu"), m);
  expect_parts_of_vtu(m, in_order(m, 1), [&](std::size_t) { return path("m_parts/m_0.vtu"); });
}

// --- Gmsh ---

void expect_same_mesh(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.points, b.points);
  const Elements x(a), y(b);
  EXPECT_EQ(x.corners, y.corners);
  EXPECT_EQ(x.region, y.region);
  EXPECT_EQ(x.patch, y.patch);
  EXPECT_EQ(a.region_names, b.region_names);
  EXPECT_EQ(a.patch_names, b.patch_names);
  ASSERT_EQ(a.point_arrays.size(), b.point_arrays.size());
  for (std::size_t i = 0; i < a.point_arrays.size(); ++i)
    EXPECT_EQ(a.point_arrays[i].values, b.point_arrays[i].values);
}

// The sections of a .msh file in ASCII, a line a string.
std::map<std::string, std::vector<std::string>> sections_of(const std::string& file) {
  std::map<std::string, std::vector<std::string>> sections;
  std::ifstream in(file);
  std::string line, section;
  while (std::getline(in, line)) {
    if (line.compare(0, 4, "$End") == 0)
      section.clear();
    else if (!line.empty() && line[0] == '$')
      section = line.substr(1);
    else if (!section.empty())
      sections[section].push_back(line);
  }
  return sections;
}

std::vector<long> numbers_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<long> numbers;
  for (double x; in >> x;)
    numbers.push_back(long(x));
  return numbers;
}

// What Gmsh's file says of the parts: of each entity of dimension 3 and 2 the part, and the ghosts of each cell.
struct Gmsh_parts {
  std::map<std::pair<long, long>, long> part_of_entity, group_of_entity;
  std::map<long, long> part_of_element, group_of_element;
  std::map<long, std::set<long>> ghosts;

  explicit Gmsh_parts(const std::string& file) {
    auto sections = sections_of(file);
    const auto& entities = sections["PartitionedEntities"];
    std::size_t line = 2 + std::size_t(numbers_of(entities.at(1))[0]);
    const std::vector<long> counts = numbers_of(entities.at(line++));
    line += std::size_t(counts[0] + counts[1]);
    for (long d = 2; d < 4; ++d)
      for (long i = 0; i < counts[std::size_t(d)]; ++i) {
        const std::vector<long> e = numbers_of(entities.at(line++));
        EXPECT_EQ(e[1], d);
        EXPECT_EQ(e[3], 1);
        part_of_entity[{d, e[0]}] = e[4];
        group_of_entity[{d, e[0]}] = e[11] == 0 ? 0 : e[12];
      }
    const auto& elements = sections["Elements"];
    for (std::size_t l = 1; l < elements.size();) {
      const std::vector<long> block = numbers_of(elements[l++]);
      for (long i = 0; i < block[3]; ++i) {
        const long element = numbers_of(elements.at(l++))[0];
        EXPECT_TRUE(part_of_element.emplace(element, part_of_entity.at({block[0], block[1]})).second);
        group_of_element[element] = group_of_entity.at({block[0], block[1]});
      }
    }
    const auto& all_ghosts = sections["GhostElements"];
    for (std::size_t l = 1; l < all_ghosts.size(); ++l) {
      const std::vector<long> g = numbers_of(all_ghosts[l]);
      EXPECT_EQ(g[1], part_of_element.at(g[0]));
      EXPECT_EQ(std::size_t(g[2]) + 3, g.size());
      ghosts[g[0]] = std::set<long>(g.begin() + 3, g.end());
    }
  }
};

TEST_F(IO, Parts_for_Gmsh_are_one_mesh) {
  for (const Partitioned& s : samples()) {
    SCOPED_TRACE(s.name);
    const Mesh m = with_arrays(s.mesh);
    write_partitioned_mesh(path("m.msh"), m, s.partition);
    Mesh back;
    TM::IO::read_mesh(path("m.msh"), back);
    expect_same_mesh(back, m);
    EXPECT_EQ(number_of_files(), 1u);
    if (s.partition.number_of_parts == 1) {
      TM::IO::write_mesh(path("m2.msh"), m);
      EXPECT_EQ(bytes_of(path("m2.msh")), bytes_of(path("m.msh")));
      fs::remove(path("m2.msh"));
    }
  }
}

TEST_F(IO, Gmsh_has_the_parts_and_their_ghosts) {
  if (!has_program("gmsh"))
    GTEST_SKIP() << "needs Gmsh";
  for (const Partitioned& s : samples()) {
    if (s.partition.number_of_parts == 1 || s.name.find("HPX") != std::string::npos)
      continue;
    SCOPED_TRACE(s.name);
    const Mesh& m = s.mesh;
    write_partitioned_mesh(path("m.msh"), m, s.partition);
    const auto run = [&](const std::string& options) {
      return std::system(("gmsh '" + path("m.msh") + "' " + options + " > '" + path("log") + "' 2>&1").c_str());
    };
    EXPECT_EQ(run("-check -parse_and_exit"), 0) << bytes_of(path("log"));
    EXPECT_EQ(run("-save -setnumber Mesh.Binary 0 -format msh41 -o '" + path("ascii.msh") + "'"), 0);
    const std::string said = bytes_of(path("log"));
    EXPECT_EQ(said.find("Error"), std::string::npos) << said;
    EXPECT_EQ(said.find("Warning"), std::string::npos) << said;
    const Gmsh_parts parts(path("ascii.msh"));
    const Elements elements(m);
    const auto behind = cells_behind_facets(m);
    ASSERT_EQ(parts.part_of_element.size(), elements.corners.size());
    for (std::size_t e = 0; e < elements.corners.size(); ++e) {
      const std::size_t cell = e < m.number_of_cells() ? e : behind[e - m.number_of_cells()][0];
      EXPECT_EQ(parts.part_of_element.at(long(e) + 1), long(s.partition.part[cell]) + 1);
      EXPECT_EQ(parts.group_of_element.at(long(e) + 1), elements.region[e] + elements.patch[e]);
    }
    std::map<long, std::set<long>> expected;
    const TM::Ghost_cells ghosts(m, s.partition);
    for (std::size_t part = 0; part < s.partition.number_of_parts; ++part)
      for (std::uint32_t c : ghosts.of_part(part))
        expected[long(c) + 1].insert(long(part) + 1);
    EXPECT_EQ(parts.ghosts, expected);
  }
}

// --- OpenFOAM ---

typedef std::vector<std::size_t> Loop;

// A loop, by the numbers of the whole mesh.
Loop loop_of(const Poly_mesh& part, std::size_t face) {
  Loop loop = part.faces.at(face);
  for (std::size_t& v : loop)
    v = std::size_t(part.addressing.at("point").at(v));
  return loop;
}

Loop reversed(Loop loop) {
  std::reverse(loop.begin() + 1, loop.end());
  return loop;
}

// One part against the whole mesh.
void expect_part(const Poly_mesh& whole, const Poly_mesh& part, std::size_t number, const Cell_partition& p) {
  const auto &cells = part.addressing.at("cell"), &faces = part.addressing.at("face"),
             &points = part.addressing.at("point"), &patches = part.addressing.at("boundary");
  std::vector<std::int64_t> expected_cells;
  for (std::size_t c = 0; c < p.part.size(); ++c)
    if (p.part[c] == number)
      expected_cells.push_back(std::int64_t(c));
  EXPECT_EQ(cells, expected_cells);
  ASSERT_EQ(points.size(), part.points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_EQ(part.points[v], whole.points.at(std::size_t(points[v])));
  ASSERT_EQ(faces.size(), part.faces.size());
  ASSERT_EQ(part.owner.size(), part.faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto g = std::size_t(std::abs(faces[f]) - 1);
    EXPECT_EQ(loop_of(part, f), faces[f] > 0 ? whole.faces.at(g) : reversed(whole.faces.at(g)));
    const std::size_t inside = faces[f] > 0 ? whole.owner[g] : whole.neighbour.at(g);
    EXPECT_EQ(std::size_t(cells.at(part.owner[f])), inside);
    if (f < part.neighbour.size()) {
      EXPECT_GT(faces[f], 0);
      EXPECT_EQ(std::size_t(cells.at(part.neighbour[f])), whole.neighbour.at(g));
      EXPECT_LT(part.owner[f], part.neighbour[f]);
    }
    if (f > 0 && f < part.neighbour.size()) {
      EXPECT_LT(std::make_pair(part.owner[f - 1], part.neighbour[f - 1]),
                std::make_pair(part.owner[f], part.neighbour[f]));
    }
  }
  // all patches of the mesh, in its order, then those between parts
  ASSERT_EQ(patches.size(), part.order_of_patches.size());
  std::size_t next = part.neighbour.size();
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const std::string& name = part.order_of_patches[i];
    const auto& patch = part.patches.at(name);
    EXPECT_EQ(patch.first, next);
    next += patch.faces;
    if (i >= whole.order_of_patches.size()) {
      EXPECT_EQ(patches[i], -1);
      EXPECT_EQ(patch.type, "processor");
      EXPECT_EQ(patch.my_part, number);
      EXPECT_GT(patch.faces, 0u);
      EXPECT_EQ(name, "procBoundary" + std::to_string(number) + "to" + std::to_string(patch.other_part));
      continue;
    }
    EXPECT_EQ(patches[i], std::int64_t(i));
    EXPECT_EQ(name, whole.order_of_patches[i]);
    const auto& in_whole = whole.patches.at(name);
    EXPECT_EQ(patch.type, in_whole.type);
    for (std::size_t f = patch.first; f < next; ++f) {
      const auto g = std::size_t(faces[f] - 1);
      EXPECT_TRUE(g >= in_whole.first && g < in_whole.first + in_whole.faces) << name;
    }
  }
  EXPECT_EQ(next, part.faces.size());
  // zones
  ASSERT_EQ(part.cell_zones.size(), whole.cell_zones.size());
  for (const auto& z : part.cell_zones) {
    const auto& members = whole.cell_zones.at(z.first).members;
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (std::binary_search(members.begin(), members.end(), std::size_t(cells[i])))
        expected.push_back(i);
    EXPECT_EQ(z.second.members, expected);
  }
  ASSERT_EQ(part.face_zones.size(), whole.face_zones.size());
  for (const auto& z : part.face_zones) {
    const auto& in_whole = whole.face_zones.at(z.first);
    std::map<std::size_t, int> flip_of;
    for (std::size_t i = 0; i < in_whole.members.size(); ++i)
      flip_of[in_whole.members[i]] = in_whole.flips[i];
    std::vector<std::size_t> expected;
    std::vector<int> flips;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto found = flip_of.find(std::size_t(std::abs(faces[f]) - 1));
      if (found == flip_of.end())
        continue;
      expected.push_back(f);
      flips.push_back(faces[f] > 0 ? found->second : 1 - found->second);
    }
    EXPECT_EQ(z.second.members, expected);
    EXPECT_EQ(z.second.flips, flips);
  }
}

void expect_openfoam_parts(const fs::path& folder, const Cell_partition& p) {
  const Poly_mesh whole(folder / "constant" / "polyMesh");
  std::vector<Poly_mesh> parts;
  std::vector<int> faces_there(whole.faces.size(), 0);
  for (std::size_t i = 0; i < p.number_of_parts; ++i) {
    SCOPED_TRACE(i);
    parts.emplace_back(folder / ("processor" + std::to_string(i)) / "constant" / "polyMesh");
    expect_part(whole, parts[i], i, p);
    for (std::int64_t f : parts[i].addressing.at("face"))
      ++faces_there[std::size_t(std::abs(f) - 1)];
  }
  for (std::size_t f = 0; f < whole.faces.size(); ++f)
    EXPECT_EQ(faces_there[f],
              f < whole.neighbour.size() && p.part[whole.owner[f]] != p.part[whole.neighbour[f]] ? 2 : 1);
  // a patch between two parts has the same faces in the same order on both sides, turned round
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const auto& patch : parts[i].patches) {
      if (patch.second.type != "processor")
        continue;
      const std::size_t other = patch.second.other_part;
      ASSERT_LT(other, parts.size());
      const auto& back = parts[other].patches.at("procBoundary" + std::to_string(other) + "to" + std::to_string(i));
      ASSERT_EQ(back.faces, patch.second.faces);
      for (std::size_t k = 0; k < back.faces; ++k) {
        const std::size_t f = patch.second.first + k, g = back.first + k;
        EXPECT_EQ(parts[i].addressing.at("face")[f], -parts[other].addressing.at("face")[g]);
        EXPECT_EQ(loop_of(parts[i], f), reversed(loop_of(parts[other], g)));
      }
    }
}

TEST_F(IO, Parts_for_OpenFOAM_are_the_mesh) {
  for (const Partitioned& s : samples())
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
  for (const Partitioned& s : samples()) {
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

// --- whole or not at all ---

std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& file : fs::recursive_directory_iterator(folder))
    files.insert(file.path().lexically_relative(folder).string());
  return files;
}

const std::vector<std::pair<std::string, Mesh_format>>& outputs() {
  static const std::vector<std::pair<std::string, Mesh_format>> list = {{"m.pvtu", Mesh_format::pvtu},
                                                                        {"m.msh", Mesh_format::gmsh},
                                                                        {"case", Mesh_format::openfoam},
                                                                        {"case", Mesh_format::openfoam_binary}};
  return list;
}

TEST_F(IO, Parts_are_written_all_or_none) {
  const Mesh m = Layered_box::make(3, "HXWT", "1112");
  const Cell_partition p = in_order(m, 4);
  for (const auto& o : outputs()) {
    {
      const auto out = TM::IO::open_partitioned_mesh(path(o.first), 4, o.second);
      write_partitioned_mesh(*out, m, p, o.second);
      out->finish();
    }
    EXPECT_EQ(files_below(directory), std::set<std::string>()) << o.first;
  }
}

TEST_F(IO, The_same_parts_make_the_same_files) {
  const Mesh m = with_arrays(Layered_box::make(4, "HXWT", "1112"));
  const auto write_all = [&](const std::string& folder) {
    fs::create_directories(directory / folder);
    for (const auto& o : outputs())
      if (o.second != Mesh_format::openfoam_binary)
        write_partitioned_mesh(path(folder + "/" + o.first), m, in_order(m, 5), o.second);
    return files_below(directory / folder);
  };
  const auto files = write_all("a");
  ASSERT_EQ(write_all("b"), files);
  for (const std::string& f : files)
    if (fs::is_regular_file(path("a/" + f))) {
      EXPECT_EQ(bytes_of(path("a/" + f)), bytes_of(path("b/" + f))) << f;
    }
}

void expect_error(const std::function<void()>& f, const std::string& said) {
  try {
    f();
    ADD_FAILURE() << "no error: " << said;
  } catch (const TM::Error& e) {
    EXPECT_NE(std::string(e.what()).find(said), std::string::npos) << e.what();
  }
}

TEST_F(IO, What_cannot_be_written_in_parts_is_refused) {
  const Mesh m = Layered_box::make(2, "HH", "11");
  const Cell_partition p = in_order(m, 2);
  const auto write = [&](const std::string& file, const Mesh& mesh, const Cell_partition& partition,
                         Mesh_format format = Mesh_format::by_name) {
    return [=] { write_partitioned_mesh(path(file), mesh, partition, format); };
  };
  expect_error(write("m.vtu", m, p), ".pvtu or .msh");
  expect_error(write("m.unknown", m, p), ".pvtu or .msh");
  expect_error(write("m.su2", m, p, Mesh_format::su2), ".pvtu or .msh");
  expect_error(write("polyMesh", m, p), "constant of a case");
  for (const auto& o : outputs()) {
    expect_error(write(o.first, m, {2, {0, 1, 0}}, o.second), "not one of the mesh");
    expect_error(write(o.first, m, {1, p.part}, o.second), "not one of the mesh");
    expect_error(write(o.first, Mesh(), {1, {}}, o.second), "without cells");
    expect_error(write(o.first, m, {0, p.part}, o.second), "not one of the mesh");
    Mesh loose = m;
    loose.quads.push_back({0, 1, 2, 8}, 2);
    expect_error(write(o.first, loose, p, o.second), "bounds no cell");
  }
  const auto out = TM::IO::open_partitioned_mesh(path("case"), 3, Mesh_format::openfoam);
  expect_error([&] { write_partitioned_mesh(*out, m, p, Mesh_format::openfoam); }, "not opened");
  expect_error([&] { write_partitioned_mesh(*out, m, p, Mesh_format::gmsh); }, "not opened");
  const auto file = TM::IO::open_mesh(path("m.vtu"));
  expect_error([&] { write_partitioned_mesh(*file, m, p, Mesh_format::pvtu); }, "not opened");
}

TEST_F(IO, Other_files_stay_where_parts_would_go) {
  const Mesh m = Layered_box::make(2, "HH", "11");
  fs::create_directories(directory / "m_parts");
  make("m_parts/notes.txt", "mine");
  expect_error([&] { write_partitioned_mesh(path("m.pvtu"), m, in_order(m, 2)); }, "notes.txt");
  fs::create_directories(directory / "case" / "processor1" / "constant" / "polyMesh");
  make("case/processor1/constant/polyMesh/mine", "mine");
  expect_error([&] { write_partitioned_mesh(path("case"), m, in_order(m, 2), Mesh_format::openfoam); }, "mine");
  EXPECT_EQ(
      files_below(directory),
      (std::set<std::string>{"m_parts", "m_parts/notes.txt", "case", "case/processor1", "case/processor1/constant",
                             "case/processor1/constant/polyMesh", "case/processor1/constant/polyMesh/mine"}));
}

TEST_F(IO, Processors_of_another_division_are_not_taken_for_parts) {
  const Mesh m = Layered_box::make(2, "HH", "11");
  write_partitioned_mesh(path("case"), m, in_order(m, 4), Mesh_format::openfoam);
  const auto before = files_below(directory);
  const auto write = [&](std::size_t parts) {
    write_partitioned_mesh(path("case"), m, in_order(m, parts), Mesh_format::openfoam);
  };
  expect_error([&] { write(3); }, "\"processor3\"");
  EXPECT_EQ(files_below(directory), before);
  write(4); // replaced
  EXPECT_EQ(files_below(directory), before);
  write(5);
  expect_openfoam_parts(directory / "case", in_order(m, 5));
  fs::create_directories(directory / "case" / "processors4");
  expect_error([&] { write(5); }, "\"processors4\"");
}

#ifdef __unix__
TEST_F(IO, There_may_be_more_parts_than_open_files) {
  const Mesh m = Layered_box::make(5, "TT", "12");
  rlimit limit;
  getrlimit(RLIMIT_NOFILE, &limit);
  rlimit tight = limit;
  tight.rlim_cur = 40;
  setrlimit(RLIMIT_NOFILE, &tight);
  for (const auto& o : outputs())
    EXPECT_NO_THROW(write_partitioned_mesh(path(o.first), m, in_order(m, 100), o.second)) << o.first;
  setrlimit(RLIMIT_NOFILE, &limit);
  expect_openfoam_parts(directory / "case", in_order(m, 100));
}

TEST_F(IO, A_limit_on_file_size_leaves_no_part_behind) {
  const Mesh m = Layered_box::make(8, "TTT", "112");
  rlimit limit;
  getrlimit(RLIMIT_FSIZE, &limit);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit tight = limit;
  tight.rlim_cur = 6000;
  for (const auto& o : outputs()) {
    setrlimit(RLIMIT_FSIZE, &tight);
    std::string said;
    try {
      write_partitioned_mesh(path(o.first), m, in_order(m, 3), o.second);
    } catch (const TM::Output_error& e) {
      said = e.what();
    }
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_NE(said.find("cannot be written"), std::string::npos) << o.first << said;
    EXPECT_EQ(files_below(directory), std::set<std::string>()) << o.first;
  }
  std::signal(SIGXFSZ, handler);
}
#endif

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts for Gmsh: read back by the project's reader, and by Gmsh where it is installed.

#include "installed_programs.h"
#include "partitioned_meshes.h"

#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh.h>
#include <CGAL/Tubular_meshing/Partition/Ghost_cells.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using TM::IO::write_partitioned_mesh;

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
  for (const Partitioned& s : partitioned_samples()) {
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
  for (const Partitioned& s : partitioned_samples()) {
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

} // namespace

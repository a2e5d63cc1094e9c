// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts of a mesh: their balance, the faces between them against METIS called directly, and the ghost cells around them.

#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/Partition/Ghost_cells.h>
#include <CGAL/Tubular_meshing/Partition/partition_cells.h>
#include <CGAL/Tubular_meshing/Partition/partition_report.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#ifdef CGAL_TUBULAR_MESHING_WITH_METIS
#include <metis.h>
#endif

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

#define NEEDS_METIS()                                                                                                  \
  if (!TM::has_metis())                                                                                                \
  GTEST_SKIP() << "needs METIS"

// Corners of all cells, in the order of a partition.
std::vector<std::vector<std::size_t>> corners_of_cells(const Mesh& m) {
  std::vector<std::vector<std::size_t>> cells;
  const auto add = [&](const auto& block) {
    for (const auto& v : block.vertices)
      cells.emplace_back(v.begin(), v.end());
  };
  add(m.tetrahedra);
  add(m.pyramids);
  add(m.prisms);
  add(m.hexahedra);
  return cells;
}

// The cells on the two sides of each face between cells.
std::vector<std::vector<std::size_t>> faces_between(const Mesh& m) {
  const Faces_of_cells cells(m);
  std::map<Corners, std::vector<std::size_t>> sides;
  for (std::size_t c = 0; c < cells.faces.size(); ++c)
    for (const Corners& f : cells.corners(c))
      sides[f].push_back(c);
  std::vector<std::vector<std::size_t>> result;
  for (const auto& s : sides)
    if (s.second.size() == 2)
      result.push_back(s.second);
  return result;
}

// Pieces of each part that are connected through faces, by merging sets.
std::vector<std::size_t> pieces_of(const Mesh& m, const TM::Cell_partition& p) {
  std::vector<std::size_t> root(p.part.size());
  for (std::size_t c = 0; c < root.size(); ++c)
    root[c] = c;
  const auto find = [&](std::size_t c) {
    while (root[c] != c)
      c = root[c] = root[root[c]];
    return c;
  };
  for (const auto& f : faces_between(m))
    if (p.part[f[0]] == p.part[f[1]])
      root[find(f[0])] = find(f[1]);
  std::vector<std::size_t> pieces(p.number_of_parts, 0);
  for (std::size_t c = 0; c < root.size(); ++c)
    pieces[p.part[c]] += root[c] == c;
  return pieces;
}

// What a partition has to be whatever makes it; and the report, counted another way.
void expect_sound(const Mesh& m, const TM::Cell_partition& p, std::size_t parts) {
  const std::size_t n = m.number_of_cells();
  ASSERT_EQ(p.number_of_parts, parts);
  ASSERT_EQ(p.part.size(), n);
  std::vector<std::size_t> cells(parts, 0);
  for (std::uint32_t part : p.part)
    ++cells.at(part);
  EXPECT_GT(*std::min_element(cells.begin(), cells.end()), 0u);
  const std::size_t most = *std::max_element(cells.begin(), cells.end());
  EXPECT_LE(double(most), (std::max)(1.03 * double(n) / double(parts), double((n + parts - 1) / parts)));

  const TM::Partition_report report = TM::partition_report(m, p);
  EXPECT_EQ(report.number_of_parts(), parts);
  EXPECT_EQ(report.cells, cells);
  EXPECT_NEAR(report.imbalance, double(most * parts) / double(n) - 1, 1e-12);
  EXPECT_EQ(report.pieces, pieces_of(m, p));
  std::size_t cut = 0;
  for (const auto& f : faces_between(m))
    cut += p.part[f[0]] != p.part[f[1]];
  EXPECT_EQ(report.cut_faces, cut);

  const auto corners = corners_of_cells(m);
  std::vector<std::set<std::size_t>> parts_at(m.points.size());
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t v : corners[c])
      parts_at[v].insert(p.part[c]);
  std::vector<std::vector<std::uint32_t>> ghosts(parts);
  for (std::size_t c = 0; c < n; ++c) {
    std::set<std::size_t> others;
    for (std::size_t v : corners[c])
      others.insert(parts_at[v].begin(), parts_at[v].end());
    others.erase(p.part[c]);
    for (std::size_t other : others)
      ghosts[other].push_back(std::uint32_t(c));
  }
  const TM::Ghost_cells found(m, p);
  for (std::size_t part = 0; part < parts; ++part) {
    EXPECT_EQ(found.of_part(part), ghosts[part]);
    EXPECT_EQ(report.ghost_cells[part], ghosts[part].size());
  }
  for (std::size_t v = 0; v < m.points.size(); ++v)
    EXPECT_EQ(found.owner(v), parts_at[v].empty() ? TM::Ghost_cells::no_part : std::uint32_t(*parts_at[v].begin()));
}

std::vector<Named_mesh> large_meshes() {
  std::vector<Named_mesh> result;
  for (const auto& m : std::vector<std::array<std::string, 2>>{
           {"TTTT", "1111"}, {"WWWW", "1122"}, {"HHHHHHHH", "11111111"}, {"PPP", "121"}, {"HHPXWWTT", "11112222"}})
    result.push_back({m[0], Layered_box::make(10, m[0], m[1])});
  return result;
}

#ifdef CGAL_TUBULAR_MESHING_WITH_METIS

// The cut that METIS makes of the dual graph that it makes of the mesh itself, as gpmetis does without options.
std::size_t cut_by_metis(const Mesh& m, std::size_t parts) {
  std::vector<idx_t> first = {0}, corners;
  for (const auto& cell : corners_of_cells(m)) {
    corners.insert(corners.end(), cell.begin(), cell.end());
    first.push_back(idx_t(corners.size()));
  }
  idx_t cells = idx_t(first.size()) - 1, points = idx_t(m.points.size()), common = 3, numbering = 0;
  idx_t *rows = nullptr, *neighbours = nullptr;
  EXPECT_EQ(METIS_MeshToDual(&cells, &points, first.data(), corners.data(), &common, &numbering, &rows, &neighbours),
            METIS_OK);
  EXPECT_EQ(std::size_t(rows[cells]), 2 * faces_between(m).size());
  idx_t constraints = 1, number = idx_t(parts), cut = 0;
  std::vector<idx_t> part(std::size_t(cells), 0);
  EXPECT_EQ(METIS_PartGraphKway(&cells, &constraints, rows, neighbours, nullptr, nullptr, nullptr, &number, nullptr,
                                nullptr, nullptr, &cut, part.data()),
            METIS_OK);
  METIS_Free(rows);
  METIS_Free(neighbours);
  return std::size_t(cut);
}

TEST(Partition, The_cut_is_as_small_as_METIS_makes_it) {
  for (const Named_mesh& m : large_meshes())
    for (std::size_t parts : {2, 3, 4, 7, 8, 16, 24}) {
      SCOPED_TRACE(m.name + " " + std::to_string(parts));
      const std::size_t cut = TM::partition_report(m.mesh, TM::partition_cells(m.mesh, parts)).cut_faces;
      EXPECT_LE(double(cut), 1.1 * double(cut_by_metis(m.mesh, parts)));
    }
}

#endif

TEST(Partition, Parts_of_all_kinds_of_cells_are_balanced_and_connected) {
  NEEDS_METIS();
  for (const Named_mesh& m : large_meshes())
    for (std::size_t parts : {2, 5, 8, 32}) {
      SCOPED_TRACE(m.name + " " + std::to_string(parts));
      const TM::Cell_partition p = TM::partition_cells(m.mesh, parts);
      expect_sound(m.mesh, p, parts);
      if (m.mesh.number_of_cells() > 100 * parts) { // with fewer METIS does not always make them so
        EXPECT_EQ(TM::partition_report(m.mesh, p).pieces, std::vector<std::size_t>(parts, 1));
      }
    }
}

TEST(Partition, Small_meshes_have_any_number_of_parts_up_to_their_cells) {
  NEEDS_METIS();
  for (const Named_mesh& m : solver_meshes()) {
    const std::size_t n = m.mesh.number_of_cells();
    for (std::size_t parts : {std::size_t(2), std::size_t(3), n / 5, n / 3, n / 2, n - 1, n})
      if (parts > 0) {
        SCOPED_TRACE(m.name + " " + std::to_string(parts));
        expect_sound(m.mesh, TM::partition_cells(m.mesh, parts), parts);
      }
  }
}

TEST(Partition, METIS_says_nothing) {
  NEEDS_METIS();
  const Mesh m = Layered_box::make(4, "TTTT", "1111");
  testing::internal::CaptureStdout();
  for (std::size_t parts = 2; parts < m.number_of_cells(); parts += 1 + parts / 5)
    TM::partition_cells(m, parts);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

// Vessels apart from each other: there are parts of several pieces then, or there may be.
TEST(Partition, Meshes_of_several_pieces) {
  NEEDS_METIS();
  Mesh m = Layered_box::make(5, "TT", "11");
  const Mesh other = Layered_box::make(4, "TW", "11");
  const std::size_t shift = m.points.size();
  for (const Point& p : other.points)
    m.points.push_back(Point(p.x() + 10, p.y(), p.z()));
  const auto append = [&](auto& block, const auto& more) {
    for (std::size_t i = 0; i < more.size(); ++i) {
      auto v = more.vertices[i];
      for (auto& w : v)
        w += std::uint32_t(shift);
      block.push_back(v, more.label[i]);
    }
  };
  append(m.tetrahedra, other.tetrahedra);
  append(m.prisms, other.prisms);
  for (std::size_t parts : {2, 3, 4, 6})
    expect_sound(m, TM::partition_cells(m, parts), parts);
}

TEST(Partition, One_part_is_the_mesh) {
  for (const Named_mesh& m : solver_meshes()) {
    const TM::Cell_partition p = TM::partition_cells(m.mesh, 1);
    EXPECT_EQ(p.part, std::vector<std::uint32_t>(m.mesh.number_of_cells(), 0));
    const TM::Partition_report report = TM::partition_report(m.mesh, p);
    EXPECT_EQ(report.cut_faces, 0u);
    EXPECT_EQ(report.imbalance, 0);
    EXPECT_EQ(report.ghost_cells, std::vector<std::size_t>(1, 0));
  }
  EXPECT_TRUE(TM::partition_cells(Mesh(), 1).part.empty());
  EXPECT_EQ(TM::partition_report(Mesh(), TM::partition_cells(Mesh(), 1)).cells, std::vector<std::size_t>(1, 0));
}

TEST(Partition, The_same_mesh_has_the_same_parts) {
  NEEDS_METIS();
  const Mesh m = Layered_box::make(8, "TTTT", "1111");
  const std::vector<std::uint32_t> first = TM::partition_cells(m, 6).part;
  TM::partition_cells(Layered_box::make(3, "HH", "11"), 5); // whatever came before
  EXPECT_EQ(TM::partition_cells(m, 6).part, first);
}

template <class Error> void expect_refused(const Mesh& m, std::size_t parts, const std::string& said) {
  try {
    TM::partition_cells(m, parts);
    ADD_FAILURE() << "no error with " << parts;
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(said), std::string::npos) << e.what();
  }
}

TEST(Partition, Numbers_that_make_no_sense) {
  const Mesh m = Layered_box::make(2, "H", "1");
  expect_refused<TM::Parameter_error>(m, 0, "0 parts");
  expect_refused<TM::Parameter_error>(Mesh(), 0, "0 parts");
  if (!TM::has_metis()) {
    expect_refused<TM::Parameter_error>(m, 2, "libmetis-dev");
    return;
  }
  expect_refused<TM::Parameter_error>(m, 5, "4 cells");
  expect_refused<TM::Parameter_error>(m, std::size_t(-1), "4 cells");
  expect_refused<TM::Parameter_error>(Mesh(), 2, "0 cells");
}

TEST(Partition, Three_cells_at_a_face_are_refused) {
  NEEDS_METIS();
  Mesh m = Layered_box::make(1, "T", "1");
  m.tetrahedra.push_back(m.tetrahedra.vertices[0], 1);
  m.tetrahedra.push_back(m.tetrahedra.vertices[0], 1);
  expect_refused<TM::Input_error>(m, 2, "three of its cells share a face");
}

} // namespace

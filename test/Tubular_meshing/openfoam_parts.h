// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Processor folders of OpenFOAM against the whole mesh.

#ifndef TUBULAR_MESHING_TEST_OPENFOAM_PARTS_H
#define TUBULAR_MESHING_TEST_OPENFOAM_PARTS_H

#include "poly_mesh.h"

#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

typedef std::vector<std::size_t> Loop;

// A loop, by the numbers of the whole mesh.
inline Loop loop_of(const Poly_mesh& part, std::size_t face) {
  Loop loop = part.faces.at(face);
  for (std::size_t& v : loop)
    v = std::size_t(part.addressing.at("point").at(v));
  return loop;
}

inline Loop reversed(Loop loop) {
  std::reverse(loop.begin() + 1, loop.end());
  return loop;
}

inline void expect_cells_and_points_of_part(const Poly_mesh& whole, const Poly_mesh& part, std::size_t number,
                                            const TM::Cell_partition& p) {
  std::vector<std::int64_t> expected_cells;
  for (std::size_t c = 0; c < p.part.size(); ++c)
    if (p.part[c] == number)
      expected_cells.push_back(std::int64_t(c));
  EXPECT_EQ(part.addressing.at("cell"), expected_cells);
  const auto& points = part.addressing.at("point");
  ASSERT_EQ(points.size(), part.points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_EQ(part.points[v], whole.points.at(std::size_t(points[v])));
}

// Those inside in the upper triangular order; an addressing of less than zero is of a face that is turned round.
inline void expect_faces_of_part(const Poly_mesh& whole, const Poly_mesh& part) {
  const auto &cells = part.addressing.at("cell"), &faces = part.addressing.at("face");
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
}

// All patches of the mesh, in its order, then those between parts.
inline void expect_patches_of_part(const Poly_mesh& whole, const Poly_mesh& part, std::size_t number) {
  const auto &faces = part.addressing.at("face"), &patches = part.addressing.at("boundary");
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
}

inline void expect_cell_zones_of_part(const Poly_mesh& whole, const Poly_mesh& part) {
  const auto& cells = part.addressing.at("cell");
  ASSERT_EQ(part.cell_zones.size(), whole.cell_zones.size());
  for (const auto& z : part.cell_zones) {
    const auto& members = whole.cell_zones.at(z.first).members;
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (std::binary_search(members.begin(), members.end(), std::size_t(cells[i])))
        expected.push_back(i);
    EXPECT_EQ(z.second.members, expected);
  }
}

inline void expect_face_zones_of_part(const Poly_mesh& whole, const Poly_mesh& part) {
  const auto& faces = part.addressing.at("face");
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

// One part against the whole mesh.
inline void expect_part(const Poly_mesh& whole, const Poly_mesh& part, std::size_t number,
                        const TM::Cell_partition& p) {
  expect_cells_and_points_of_part(whole, part, number, p);
  expect_faces_of_part(whole, part);
  expect_patches_of_part(whole, part, number);
  expect_cell_zones_of_part(whole, part);
  expect_face_zones_of_part(whole, part);
}

// A patch between two parts has the same faces in the same order on both sides, turned round.
inline void expect_patches_between(const std::vector<Poly_mesh>& parts) {
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

// A case's processor folders hold its mesh: each face once, and twice between parts.
inline void expect_openfoam_parts(const fs::path& folder, const TM::Cell_partition& p) {
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
  expect_patches_between(parts);
}

#endif // TUBULAR_MESHING_TEST_OPENFOAM_PARTS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that are moved without meeting themselves.

#include <CGAL/Tubular_meshing/Patches/pieces/crossing_faces.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Shift_holder.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/hold_shifts_back.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace {

namespace internal = CGAL::Tubular_meshing::internal;
using internal::Face;
using internal::Face_pairs;
using internal::Shift_holder;
using CGAL::Tubular_meshing::Surface;
using internal::Vector_3d;
using internal::Vertex;

// Two sheets of n x n quads at a distance, the second one turned over.
Surface sheets(int n, double distance) {
  Surface mesh;
  for (int sheet = 0; sheet < 2; ++sheet) {
    std::vector<Vertex> v;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        v.push_back(mesh.add_vertex(CGAL::Tubular_meshing::Point_3(i, j, sheet * distance)));
    const auto at = [&](int i, int j) { return v[std::size_t(j * (n + 1) + i)]; };
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        if (sheet == 0)
          mesh.add_face(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
        else
          mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return mesh;
}

std::vector<Vector_3d> points_of(const Surface& mesh) {
  std::vector<Vector_3d> result;
  for (Vertex v : mesh.vertices())
    result.emplace_back(mesh.point(v));
  return result;
}

// Up and down, to beyond the other sheet here and there.
std::vector<Vector_3d> random_shifts(std::size_t n, double most, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-most, most);
  std::vector<Vector_3d> result;
  for (std::size_t i = 0; i < n; ++i)
    result.emplace_back(0, 0, part(random));
  return result;
}

// What move_without_crossings() does, with all faces looked at in each round.
void move_with_all_faces(Surface& mesh, Shift_holder& shifts) {
  internal::keep_shapes(mesh, shifts);
  for (;;) {
    for (Vertex v : mesh.vertices())
      mesh.point(v) = shifts.point(std::size_t(v));
    std::vector<std::size_t> at_fault;
    for (const auto& c : internal::crossing_faces(mesh))
      for (Face f : {c.first, c.second})
        for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
          at_fault.push_back(std::size_t(v));
    if (!internal::hold_back(at_fault, shifts))
      return;
  }
}

class Shifts_without_crossings : public testing::TestWithParam<bool> {
protected:
  Surface start() const {
    Surface mesh = sheets(30, 0.3);
    if (GetParam())
      CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
    return mesh;
  }
};
INSTANTIATE_TEST_SUITE_P(Of_triangles, Shifts_without_crossings, testing::Bool(),
                         [](const auto& p) { return std::string(p.param ? "Triangles" : "Quads"); });

TEST_P(Shifts_without_crossings, End_where_looking_at_all_faces_ends) {
  for (unsigned seed : {1u, 2u, 3u}) {
    Surface mesh = start(), all = mesh;
    const std::vector<Vector_3d> from = points_of(mesh);
    Shift_holder shifts(from, random_shifts(from.size(), 0.4, seed)), of_all = shifts;
    internal::move_without_crossings(mesh, shifts);
    move_with_all_faces(all, of_all);
    EXPECT_TRUE(internal::crossing_faces(mesh).empty());
    EXPECT_GT(shifts.number_held_back(), 20u);
    EXPECT_LT(shifts.number_held_back(), from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
      ASSERT_EQ(internal::norm(shifts[i] - of_all[i]), 0) << i;
  }
}

TEST_P(Shifts_without_crossings, Are_kept_where_nothing_meets) {
  Surface mesh = start();
  const std::vector<Vector_3d> from = points_of(mesh);
  Shift_holder shifts(from, random_shifts(from.size(), 0.14, 4));
  internal::move_without_crossings(mesh, shifts);
  EXPECT_EQ(shifts.number_held_back(), 0u);
}

TEST_P(Shifts_without_crossings, Faces_near_are_those_of_the_other_sheet_too) {
  Surface mesh = start();
  const std::size_t of_quad = GetParam() ? 2 : 1;
  const Vertex middle(15 * 31 + 15);
  // apart, a vertex's box meets the faces of its own sheet alone
  EXPECT_EQ(internal::faces_near(mesh, [&](Vertex v) { return v == middle; }).size(), 16 * of_quad);
  mesh.point(middle) = CGAL::Tubular_meshing::Point_3(15, 15, 0.3);
  EXPECT_EQ(internal::faces_near(mesh, [&](Vertex v) { return v == middle; }).size(), 32 * of_quad);
  EXPECT_TRUE(internal::faces_near(mesh, [](Vertex) { return false; }).empty());
}

} // namespace

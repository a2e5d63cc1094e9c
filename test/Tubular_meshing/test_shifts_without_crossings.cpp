// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that are moved without meeting themselves, and cells that keep their shape.

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Patches/pieces/crossing_faces.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Shift_holder.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/hold_shifts_back.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/metric_quality.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include "grid_of_tetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace {

namespace internal = CGAL::Tubular_meshing::internal;
using CGAL::Tubular_meshing::Surface;
using internal::Face;
using internal::Face_pairs;
using internal::Shift_holder;
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
  internal::keep_shapes(mesh, shifts, 1);
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
    internal::move_without_crossings(mesh, shifts, 2);
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
  internal::move_without_crossings(mesh, shifts, 2);
  EXPECT_EQ(shifts.number_held_back(), 0u);
}

// A roof: its ridge along y, its eaves at x = ± width.
Surface roof(double width, int n) {
  Surface mesh;
  for (int i = 0; i <= n; ++i) {
    mesh.add_vertex(CGAL::Tubular_meshing::Point_3(0, i, 1));
    for (double x : {-width, width})
      mesh.add_vertex(CGAL::Tubular_meshing::Point_3(x, i, 0));
  }
  const auto vertex = [](int i, int k) { return Vertex(Surface::size_type(3 * i + k)); };
  for (int i = 0; i < n; ++i) {
    mesh.add_face(vertex(i, 0), vertex(i, 2), vertex(i + 1, 2), vertex(i + 1, 0));
    mesh.add_face(vertex(i, 1), vertex(i, 0), vertex(i + 1, 0), vertex(i + 1, 1));
  }
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

// The roof's sides do not come to lie on each other, though they do not meet.
TEST(Shifts_of_folds, Are_held_back_where_they_fold_further) {
  const int n = 6;
  for (double width : {0.3, 2.}) // steep, and flat
    for (double shift : {-0.25, 0.25}) {
      Surface mesh = roof(width, n);
      std::vector<Vector_3d> from = points_of(mesh), by;
      for (const Vector_3d& p : from)
        by.emplace_back(p.x > 0 ? shift : p.x < 0 ? -shift : 0, 0, 0);
      Shift_holder shifts(from, by);
      internal::move_without_crossings(mesh, shifts, 1);
      for (std::size_t i = 0; i < from.size(); ++i)
        if (from[i].x != 0 && from[i].y > 0 && from[i].y < n) { // at the ends, not all are of triangles at the ridge
          if (width < 1 && shift < 0)
            EXPECT_GT(std::abs(shifts[i].x), 0.6 * width) << "a sixth of it is where they were to go";
          else
            EXPECT_NEAR(std::abs(shifts[i].x), width + shift, 1e-12);
        }
    }
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

// Flat layers, the upper ones of which are to slide along the others: no volume changes by that, but shapes do.
class Sliding_layers : public testing::Test {
protected:
  const double height = 0.05;
  const CGAL::Tubular_meshing::Metric_tensor_3 metric{1, 0, 0, 1, 0, 1 / (height * height)};
  CGAL::Tubular_meshing::Mixed_mesh mesh = grid_of_tetrahedra(
      {6, 6, 6}, [this](int i, int j, int k) { return CGAL::Tubular_meshing::Point_3(i, j, height * k); },
      [](int, int) { return 0; });

  void carry_metric() {
    CGAL::Tubular_meshing::Point_array array{"metric", 6, {}};
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      for (double component : metric.components())
        array.values.push_back(component);
    mesh.point_arrays.assign(1, array);
  }
  Shift_holder kept(int threads) const {
    std::vector<Vector_3d> from, shift;
    for (const auto& p : mesh.points) {
      from.emplace_back(p);
      shift.emplace_back(from.back().z > 2.5 * height ? 3. : 0., 0., 0.);
    }
    Shift_holder shifts(from, shift);
    internal::keep_cells(mesh, internal::Kept_of_cells(), threads, shifts);
    return shifts;
  }
  double worst(const Shift_holder& shifts) const {
    double result = 1;
    for (const auto& t : mesh.tetrahedra.vertices)
      result = (std::min)(result, internal::metric_shape(shifts[t[1]] - shifts[t[0]], shifts[t[2]] - shifts[t[0]],
                                                         shifts[t[3]] - shifts[t[0]], metric)
                                      .quality());
    return result;
  }
};

TEST_F(Sliding_layers, Keep_their_volumes_without_a_metric) {
  const Shift_holder shifts = kept(1);
  EXPECT_EQ(shifts.number_held_back(), 0u);
  EXPECT_LT(worst(shifts), 0.2);
}

TEST_F(Sliding_layers, Keep_their_shapes_in_the_metric) {
  carry_metric();
  const Shift_holder shifts = kept(1), on_all = kept(0);
  EXPECT_GE(worst(shifts), 0.3);
  EXPECT_GT(shifts.number_held_back(), 0u);
  EXPECT_GT(shifts.largest(), 0);
  for (std::size_t i = 0; i < shifts.size(); ++i)
    ASSERT_EQ(internal::norm(shifts[i] - on_all[i]), 0) << i;
}

} // namespace

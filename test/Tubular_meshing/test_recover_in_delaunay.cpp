// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces whose triangles are facets of the Delaunay triangulation of their points, all of them, most, or few.

#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/boundary_recovery.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/recover_in_delaunay.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/take_inside.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>

#include "schoenhardt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
using tubular::internal::Boundary_arrays;
using tubular::internal::Recovered_boundary;
using tubular::internal::Vector_3d;
typedef std::array<std::uint32_t, 3> Triangle;

/* A closed cylinder of n points round, as long as `rings` squares of its grid, with its axis through (x, 0), and fans
 * on its ends. Its points are off the grid by a little, so that no five lie on a sphere. */
void add_cylinder(unsigned n, unsigned rings, double x, Boundary_arrays& boundary) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> little(-1e-3, 1e-3);
  const double pi = std::acos(-1.), step = 2 * pi / n;
  const std::uint32_t first = std::uint32_t(boundary.points.size());
  for (unsigned j = 0; j <= rings; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const double a = (i + 0.5 * (j % 2)) * step;
      boundary.points.push_back({x + std::cos(a) + little(random), std::sin(a) + little(random), j * step});
    }
  const auto at = [&](unsigned i, unsigned j) { return first + j * n + i % n; };
  for (unsigned j = 0; j < rings; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const unsigned s = j % 2;
      boundary.triangles.push_back({at(i, j), at(i + 1, j), at(i + s, j + 1)});
      boundary.triangles.push_back({at(i + 1 - s, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  for (double z : {0., rings * step}) {
    const std::uint32_t middle = std::uint32_t(boundary.points.size());
    boundary.points.push_back({x, 0, z});
    const unsigned j = z == 0 ? 0 : rings;
    for (unsigned i = 0; i < n; ++i) {
      const std::uint32_t a = at(i, j), b = at(i + 1, j);
      boundary.triangles.push_back(z == 0 ? Triangle{middle, b, a} : Triangle{middle, a, b});
    }
  }
}

// The other diagonal of two triangles of the wall.
void flip(Boundary_arrays& boundary, std::size_t triangle) {
  Triangle &t = boundary.triangles[triangle], &u = boundary.triangles[triangle + 1];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3], d = u[(k + 2) % 3];
      if (u[k] == b && u[(k + 1) % 3] == a) {
        t = {c, a, d};
        u = {d, b, c};
        return;
      }
    }
  FAIL() << "they share no edge";
}

double volume_inside(const Boundary_arrays& boundary) {
  double six = 0;
  for (const Triangle& t : boundary.triangles)
    six += dot(boundary.points[t[0]], cross(boundary.points[t[1]], boundary.points[t[2]]));
  return six / 6;
}

std::vector<Vector_3d> all_points(const Boundary_arrays& boundary, const Recovered_boundary& recovered) {
  std::vector<Vector_3d> points = boundary.points;
  points.insert(points.end(), recovered.inner_points.begin(), recovered.inner_points.end());
  return points;
}

// Whether tetrahedra fill the inside, once, and each triangle is a facet of exactly one.
void expect_filled(const Boundary_arrays& boundary, const Recovered_boundary& recovered) {
  const double volume = volume_inside(boundary);
  EXPECT_NEAR(tubular::internal::volume_of(all_points(boundary, recovered), recovered.tetrahedra), volume,
              1e-9 * volume);
  std::multiset<Triangle> facets;
  for (const auto& t : recovered.tetrahedra)
    for (const auto& f : tubular::internal::Cell_topology<4>::triangles()) {
      Triangle v = {t[std::size_t(f[0])], t[std::size_t(f[1])], t[std::size_t(f[2])]};
      std::sort(v.begin(), v.end());
      facets.insert(v);
    }
  std::set<Triangle> boundary_facets;
  for (Triangle t : boundary.triangles) {
    std::sort(t.begin(), t.end());
    boundary_facets.insert(t);
    EXPECT_EQ(facets.count(t), 1u);
  }
  for (const Triangle& f : facets)
    EXPECT_EQ(facets.count(f), boundary_facets.count(f) > 0 ? 1u : 2u);
}

// Whether a surface could be filled; `recovered` is what is inside then.
template <class Recover>
bool fill(const Boundary_arrays& boundary, int threads, const Recover& recover, Recovered_boundary& recovered) {
  if (!tubular::internal::recover_in_delaunay(boundary, threads, recover, recovered))
    return false;
  tubular::Mixed_mesh mesh;
  for (const Vector_3d& p : all_points(boundary, recovered))
    mesh.points.emplace_back(p.x, p.y, p.z);
  for (const auto& t : recovered.tetrahedra)
    mesh.tetrahedra.push_back(t, 1);
  for (const Triangle& t : boundary.triangles)
    mesh.triangles.push_back(t, 7);
  const auto store = tubular::internal::take_inside(mesh, threads);
  EXPECT_EQ(mesh.triangles.label, std::vector<int>(boundary.triangles.size(), 7));
  if (!store)
    return false;
  recovered.tetrahedra.clear();
  for (std::uint32_t t : store->tetrahedra()) {
    recovered.tetrahedra.push_back((*store)[t].v);
    for (std::uint32_t i = 0; i < 4; ++i)
      EXPECT_EQ((*store)[t].label[i], (*store)[t].neighbor[i] == store->none ? 7 : 0);
  }
  return true;
}

const auto no_recovery = [](const Boundary_arrays&, Recovered_boundary&) {
  ADD_FAILURE() << "nothing is missing";
  return false;
};

class Recover_in_delaunay_by_tetgen : public ::testing::Test {
protected:
  void SetUp() override {
    if (!tubular::has_tetgen())
      GTEST_SKIP() << "built without TetGen";
  }
};

// With the sizes of what it was called for.
struct Tetgen {
  std::vector<std::size_t>* triangles;
  bool operator()(const Boundary_arrays& cavities, Recovered_boundary& filling) const {
    triangles->push_back(cavities.triangles.size());
    return tubular::internal::tetgen_recovery().run(cavities, filling) == 0;
  }
};

TEST(Recover_in_delaunay, Needs_no_recovery_where_all_triangles_are_facets) {
  for (unsigned n : {12u, 30u}) {
    Boundary_arrays boundary;
    add_cylinder(n, 2 * n, 0, boundary);
    Recovered_boundary recovered;
    ASSERT_TRUE(fill(boundary, 1, no_recovery, recovered));
    EXPECT_TRUE(recovered.inner_points.empty());
    expect_filled(boundary, recovered);
  }
}

TEST(Recover_in_delaunay, Leaves_room_between_vessels) {
  Boundary_arrays boundary;
  for (double x : {0., 2.2, 10.})
    add_cylinder(24, 20, x, boundary);
  Recovered_boundary recovered;
  ASSERT_TRUE(fill(boundary, 1, no_recovery, recovered));
  expect_filled(boundary, recovered);
}

TEST(Recover_in_delaunay, Does_not_depend_on_threads) {
  Boundary_arrays boundary;
  add_cylinder(40, 60, 0, boundary);
  Recovered_boundary one, two;
  ASSERT_TRUE(fill(boundary, 1, no_recovery, one));
  ASSERT_TRUE(fill(boundary, 2, no_recovery, two));
  EXPECT_EQ(one.tetrahedra, two.tetrahedra);
}

// Edges that turn inward, and lie deeper than the Delaunay triangulation has them: alone, and next to each other.
TEST_F(Recover_in_delaunay_by_tetgen, Recovers_the_few_triangles_that_are_missing) {
  const std::vector<std::vector<std::size_t>> flips = {{400}, {400, 402, 404}, {100, 900, 1700}, {0, 2, 4, 6}};
  for (const auto& flipped : flips) {
    Boundary_arrays boundary;
    add_cylinder(30, 50, 0, boundary);
    for (std::size_t f : flipped)
      flip(boundary, f);
    std::vector<std::size_t> triangles;
    Recovered_boundary recovered;
    ASSERT_TRUE(fill(boundary, 1, Tetgen{&triangles}, recovered));
    ASSERT_EQ(triangles.size(), 1u); // all cavities at once
    EXPECT_LT(triangles[0], boundary.triangles.size() / 2);
    expect_filled(boundary, recovered);
  }
}

TEST(Recover_in_delaunay, Leaves_to_others_what_it_cannot_do) {
  const auto fills = [](const Boundary_arrays& boundary, const auto& recover) {
    Recovered_boundary recovered;
    return fill(boundary, 1, recover, recovered);
  };
  Boundary_arrays twice, flat, flipped;
  add_cylinder(12, 5, 0, twice);
  twice.points[7] = twice.points[8];
  EXPECT_FALSE(fills(twice, no_recovery));

  flat.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  flat.triangles = {{0, 1, 2}, {2, 1, 3}, {0, 2, 1}, {2, 3, 1}};
  EXPECT_FALSE(fills(flat, no_recovery));

  EXPECT_FALSE(fills(test_surfaces::schoenhardt(), no_recovery)); // most of its triangles are missing

  add_cylinder(30, 50, 0, flipped);
  flip(flipped, 400);
  EXPECT_FALSE(fills(flipped, [](const Boundary_arrays&, Recovered_boundary&) { return false; }));
  EXPECT_FALSE(fills(flipped, [](const Boundary_arrays&, Recovered_boundary& filling) { // leaves a hole
    filling.tetrahedra = {{0, 1, 2, 3}};
    return true;
  }));
}

} // namespace

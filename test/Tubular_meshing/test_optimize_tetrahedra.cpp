// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The tetrahedral mesh optimizer on a cube, whose volume and sides are known.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/internal/Topology_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/remesh_worst.h>
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra.h>

#include "grid_of_tetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef CGAL::Tubular_meshing::Mixed_mesh Mesh;
namespace tubular = CGAL::Tubular_meshing;
using tubular::internal::Tetrahedron_store;
using tubular::internal::Vector_3d;

// The side of the unit cube that points lie on, 1 to 6; 0 if they share none.
template <class Points> int common_side(const Points& points) {
  for (int axis = 0; axis < 3; ++axis)
    for (int end = 0; end < 2; ++end)
      if (std::all_of(points.begin(), points.end(), [&](const Point& p) { return std::abs(p[axis] - end) < 1e-12; }))
        return 1 + 2 * axis + end;
  return 0;
}

// The unit cube, its inner vertices shaken; sides labelled 1 to 6.
Mesh make_cube(int n, double shake) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-shake / n, shake / n);
  const auto moved = [&](int x) { return x == 0 || x == n ? double(x / n) : double(x) / n + uniform(random); };
  return grid_of_tetrahedra(
      {n, n, n},
      [&](int i, int j, int k) {
        const double x = moved(i), y = moved(j), z = moved(k);
        return Point(x, y, z);
      },
      [](int axis, int end) { return 1 + 2 * axis + end; });
}

struct Cube_surface {
  Surface surface;
  Surface::Property_map<Surface::Face_index, int> patch;

  Cube_surface() {
    std::vector<Surface::Vertex_index> v;
    for (int i = 0; i < 8; ++i)
      v.push_back(surface.add_vertex(Point(i & 1, (i >> 1) & 1, i >> 2)));
    for (auto q :
         {std::array<int, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
      surface.add_face(v[q[0]], v[q[1]], v[q[2]]);
      surface.add_face(v[q[0]], v[q[2]], v[q[3]]);
    }
    patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
    for (auto f : surface.faces()) {
      std::vector<Point> p;
      for (auto u : CGAL::vertices_around_face(surface.halfedge(f), surface))
        p.push_back(surface.point(u));
      patch[f] = common_side(p);
    }
  }
};

double volume(const Mesh& m) {
  double v = 0;
  for (const auto& t : m.tetrahedra.vertices)
    v += tubular::internal::signed_volume(Vector_3d(m.points[t[0]]), Vector_3d(m.points[t[1]]),
                                          Vector_3d(m.points[t[2]]), Vector_3d(m.points[t[3]]));
  return v;
}

Mesh optimized(Mesh m, int passes, int threads) {
  const Cube_surface cube;
  tubular::optimize_tetrahedra(m, cube.surface, cube.patch,
                               tubular::parameters::optimization_passes(passes).number_of_threads(threads));
  return m;
}

TEST(Tetrahedron_store, Writes_back_what_it_read) {
  const Mesh m = make_cube(3, 0.2);
  Mesh back;
  Tetrahedron_store(m).write_to(back);
  EXPECT_EQ(back.tetrahedra.size(), m.tetrahedra.size());
  EXPECT_EQ(back.triangles.size(), m.triangles.size());
  const auto r = tubular::validity_report(back);
  EXPECT_TRUE(r.is_valid()) << r.defects();
  EXPECT_NEAR(volume(back), 1, 1e-12);
}

TEST(Tetrahedron_store, Rings_and_stars) {
  const Mesh m = make_cube(2, 0);
  const Tetrahedron_store store(m);
  Tetrahedron_store::Ring ring;
  std::vector<Tetrahedron_store::Index> star;
  std::size_t closed = 0, open = 0;
  for (Tetrahedron_store::Index t = 0; t < store.number_of_slots(); ++t)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j) {
          store.ring(t, i, j, ring);
          ++(ring.closed ? closed : open);
          ASSERT_EQ(ring.link.size(), ring.tetrahedra.size() + (ring.closed ? 0 : 1));
          for (std::size_t k = 0; k < ring.tetrahedra.size(); ++k) {
            // each tetrahedron of the ring is (a, b, link k, link k+1), positively oriented
            const auto p = [&](Tetrahedron_store::Index v) { return store.point(v); };
            EXPECT_GT(tubular::internal::signed_volume(p(ring.a), p(ring.b), p(ring.link[k]),
                                                       p(ring.link[(k + 1) % ring.link.size()])),
                      0);
          }
        }
  EXPECT_GT(closed, 0u);
  EXPECT_GT(open, 0u);
  store.star(13, star); // the cube's centre: all small cubes meet there
  std::size_t incident = 0;
  for (const auto& t : m.tetrahedra.vertices)
    incident += std::count(t.begin(), t.end(), 13u);
  EXPECT_EQ(std::set<Tetrahedron_store::Index>(star.begin(), star.end()).size(), incident);
}

TEST(Optimize_tetrahedra, Improves_a_shaken_cube_and_keeps_its_shape) {
  const Mesh before = make_cube(8, 0.2);
  ASSERT_TRUE(tubular::validity_report(before).is_valid()) << tubular::validity_report(before).defects();
  const Mesh after = optimized(before, 3, 1);
  const auto r = tubular::validity_report(after);
  EXPECT_TRUE(r.is_valid()) << r.defects();
  EXPECT_EQ(r.boundary_euler, 2);
  EXPECT_NEAR(volume(after), 1, 1e-12);
  const auto worse = tubular::quality_report(before), better = tubular::quality_report(after);
  EXPECT_GT(better.gamma_tau.min(), worse.gamma_tau.min() + 0.15);
  EXPECT_GT(better.gamma_tau.mean(), 0.7);
  EXPECT_GT(better.gamma_T.mean(), 0.9);
  for (std::size_t i = 0; i < after.triangles.size(); ++i) {
    const auto& v = after.triangles.vertices[i];
    const std::array<Point, 3> p = {after.points[v[0]], after.points[v[1]], after.points[v[2]]};
    EXPECT_EQ(common_side(p), after.triangles.label[i]);
  }
}

TEST(Optimize_tetrahedra, Keeps_corners_and_every_label) {
  const Mesh after = optimized(make_cube(4, 0.2), 2, 1);
  std::set<int> labels(after.triangles.label.begin(), after.triangles.label.end());
  EXPECT_EQ(labels.size(), 6u);
  for (int i = 0; i < 8; ++i) {
    const Point corner(i & 1, (i >> 1) & 1, i >> 2);
    EXPECT_EQ(std::count(after.points.begin(), after.points.end(), corner), 1);
  }
}

TEST(Optimize_tetrahedra, Is_the_same_on_any_number_of_threads) {
  const Mesh m = make_cube(10, 0.2), one = optimized(m, 2, 1), two = optimized(m, 2, 2);
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.tetrahedra.vertices, two.tetrahedra.vertices);
}

TEST(Optimize_tetrahedra, Does_nothing_in_no_passes_to_a_good_mesh) {
  const Mesh m = make_cube(4, 0), after = optimized(m, 0, 1);
  EXPECT_GE(tubular::quality_report(after).gamma_tau.min(), tubular::quality_report(m).gamma_tau.min() - 1e-12);
  EXPECT_NEAR(volume(after), 1, 1e-12);
}

TEST(Optimize_tetrahedra, Works_in_any_unit) {
  const Mesh m = make_cube(5, 0.2);
  const tubular::Measure_statistics unit = tubular::quality_report(optimized(m, 2, 1)).gamma_tau;
  for (double s : {1e-9, 1e9}) {
    Mesh scaled = m;
    for (Point& p : scaled.points)
      p = Point(s * p.x(), s * p.y(), s * p.z());
    Cube_surface cube;
    for (auto v : cube.surface.vertices()) {
      const Point p = cube.surface.point(v);
      cube.surface.point(v) = Point(s * p.x(), s * p.y(), s * p.z());
    }
    tubular::optimize_tetrahedra(scaled, cube.surface, cube.patch,
                                 tubular::parameters::optimization_passes(2).number_of_threads(1));
    EXPECT_NEAR(tubular::quality_report(scaled).gamma_tau.mean(), unit.mean(), 1e-3);
    EXPECT_TRUE(tubular::validity_report(scaled).is_valid());
  }
}

TEST(Optimize_tetrahedra, Keeps_the_boundary_bit_for_bit_where_asked) {
  const Mesh before = make_cube(8, 0.25);
  Mesh after = before;
  const Cube_surface cube;
  tubular::optimize_tetrahedra(after, cube.surface, cube.patch, tubular::parameters::keep_boundary(true));
  const auto r = tubular::validity_report(after);
  EXPECT_TRUE(r.is_valid()) << r.defects();
  EXPECT_NEAR(volume(after), 1, 1e-12);
  ASSERT_EQ(after.triangles.label, before.triangles.label);
  for (std::size_t i = 0; i < before.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(after.points[after.triangles.vertices[i][k]], before.points[before.triangles.vertices[i][k]]);
  const auto worse = tubular::quality_report(before), better = tubular::quality_report(after);
  EXPECT_GT(better.gamma_tau.min(), worse.gamma_tau.min() + 0.15);
  EXPECT_GT(better.gamma_tau.mean(), worse.gamma_tau.mean() + 0.05);
}

TEST(Optimize_tetrahedra, Keeps_an_interface_of_regions_with_the_boundary) {
  Mesh before = make_cube(6, 0.);
  std::map<std::array<std::uint32_t, 3>, int> seen;
  for (std::size_t i = 0; i < before.tetrahedra.size(); ++i) {
    const auto& t = before.tetrahedra.vertices[i];
    double x = 0;
    for (std::uint32_t v : t)
      x += before.points[v].x() / 4;
    before.tetrahedra.label[i] = x < 0.5 ? 1 : 2;
    for (int f = 0; f < 4 && x < 0.5; ++f) {
      const auto& c = Tetrahedron_store::facet_corners(f);
      if (std::all_of(c.begin(), c.end(), [&](int k) { return before.points[t[k]].x() == 0.5; }))
        before.triangles.push_back({t[c[0]], t[c[1]], t[c[2]]}, 7);
    }
  }
  ASSERT_EQ(std::count(before.triangles.label.begin(), before.triangles.label.end(), 7), 72);
  for (Point& p : before.points) // shaken inside, but for the interface
    if (common_side(std::array<Point, 1>{p}) == 0 && p.x() != 0.5)
      p = Point(p.x() + 0.04 * std::sin(50 * p.y()), p.y() + 0.04 * std::sin(70 * p.z()), p.z());
  Mesh after = before;
  const Cube_surface cube;
  tubular::optimize_tetrahedra(after, cube.surface, cube.patch, tubular::parameters::keep_boundary(true));
  EXPECT_EQ(tubular::validity_report(after).inverted_cells, 0u);
  EXPECT_EQ(tubular::validity_report(after).misplaced_facets, 0u);
  for (std::size_t i = 0; i < before.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(after.points[after.triangles.vertices[i][k]], before.points[before.triangles.vertices[i][k]]);
  double half = 0;
  for (std::size_t i = 0; i < after.tetrahedra.size(); ++i) {
    const auto& t = after.tetrahedra.vertices[i];
    if (after.tetrahedra.label[i] == 1)
      half += tubular::internal::signed_volume(Vector_3d(after.points[t[0]]), Vector_3d(after.points[t[1]]),
                                               Vector_3d(after.points[t[2]]), Vector_3d(after.points[t[3]]));
  }
  EXPECT_NEAR(half, 0.5, 1e-12);
}

double worst_quality(const Mesh& m) {
  return tubular::quality_report(m).gamma_tau.min();
}

TEST(Vertex_insertion, Mends_a_tetrahedron_of_boundary_vertices) {
  Mesh m;
  // four tetrahedra around the long axis of an octahedron, of which it lies at the side: two are thin
  m.points = {Point(0, 0, -1), Point(0, 0, 1),    Point(1, 0, 0.05),
              Point(0, 1, 0),  Point(-1, 0, .05), Point(0, -0.08, 0)};
  m.tetrahedra.push_back({0, 1, 2, 3}, 1);
  m.tetrahedra.push_back({0, 1, 3, 4}, 1);
  m.tetrahedra.push_back({0, 1, 4, 5}, 1);
  m.tetrahedra.push_back({0, 1, 5, 2}, 1);
  for (const auto& t : std::vector<std::array<std::uint32_t, 4>>(m.tetrahedra.vertices))
    for (int f : {0, 1}) {
      const auto& c = Tetrahedron_store::facet_corners(f);
      m.triangles.push_back({t[c[0]], t[c[1]], t[c[2]]}, 1);
    }
  ASSERT_TRUE(tubular::validity_report(m).is_valid()) << tubular::validity_report(m).defects();
  const double before = worst_quality(m), v = volume(m);
  ASSERT_LT(before, 0.15);
  Tetrahedron_store store(m);
  Tetrahedron_store::Index_list come;
  ASSERT_TRUE(tubular::internal::Vertex_insertion(store)(2, come));
  EXPECT_FALSE(come.empty());
  Mesh after = m;
  store.write_to(after);
  EXPECT_TRUE(tubular::validity_report(after).is_valid()) << tubular::validity_report(after).defects();
  EXPECT_EQ(after.points.size(), m.points.size() + 1);
  EXPECT_EQ(after.triangles.size(), m.triangles.size());
  EXPECT_NEAR(volume(after), v, 1e-14);
  EXPECT_GT(worst_quality(after), 1.5 * before);
}

TEST(Vertex_removal, Takes_away_a_vertex_that_crowds_another) {
  Mesh m = make_cube(4, 0);
  const std::uint32_t middle = (2 * 5 + 2) * 5 + 2, beside = (2 * 5 + 2) * 5 + 1;
  const Point& p = m.points[middle];
  m.points[beside] = Point(p.x() - 0.004, p.y() - 0.004, p.z() - 0.01);
  ASSERT_TRUE(tubular::validity_report(m).is_valid()) << tubular::validity_report(m).defects();
  const double before = worst_quality(m);
  Tetrahedron_store store(m);
  Tetrahedron_store::Index_list come;
  tubular::internal::Vertex_removal remove(store);
  std::size_t removed = 0;
  for (Tetrahedron_store::Index t = 0; t < store.number_of_slots(); ++t)
    if (store.is_alive(t) && std::count(store[t].v.begin(), store[t].v.end(), beside) != 0)
      removed += remove(t, come);
  EXPECT_GT(removed, 0u);
  Mesh after = m;
  store.write_to(after);
  EXPECT_TRUE(tubular::validity_report(after).is_valid()) << tubular::validity_report(after).defects();
  EXPECT_LT(after.points.size(), m.points.size());
  EXPECT_NEAR(volume(after), 1, 1e-12);
  EXPECT_GT(worst_quality(after), before);
}

TEST(Vertex_removal, Leaves_the_boundary_alone) {
  const Mesh m = make_cube(1, 0); // no vertex inside
  Tetrahedron_store store(m);
  Tetrahedron_store::Index_list come;
  tubular::internal::Vertex_removal remove(store);
  for (Tetrahedron_store::Index t = 0; t < store.number_of_slots(); ++t)
    EXPECT_FALSE(remove(t, come));
}

// Everything is better than the edge 0-1.
struct Against_an_edge {
  const Tetrahedron_store* store;
  double tetrahedron(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const std::array<std::uint32_t, 4> v = {a, b, c, d};
    if (!(tubular::internal::signed_volume(store->point(a), store->point(b), store->point(c), store->point(d)) > 0))
      return 0;
    return std::count(v.begin(), v.end(), 0u) + std::count(v.begin(), v.end(), 1u) == 2 ? 0.1 : 0.9;
  }
  double triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const std::array<std::uint32_t, 3> v = {a, b, c};
    return std::count(v.begin(), v.end(), 0u) + std::count(v.begin(), v.end(), 1u) == 2 ? 0.1 : 0.9;
  }
};
struct Any_flip {
  bool operator()(std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::int32_t) const { return true; }
};

/* A dimple of three facets, with its bottom at 0 and its rim at 1, 2, 3: flipping the edge 0-1 would bring 2-3 about
 * once more, and close the dimple by facets on top of each other. With four facets round it there is room for the flip.
 */
TEST(Topology_optimizer, Closes_no_dimple) {
  for (bool has_room : {false, true}) {
    Mesh m;
    m.points = {Point(0.5, 0, -0.4), Point(2, 0, 0),    Point(0, 1, 0), Point(0, -1, 0),
                Point(2, 0, -0.6),   Point(0.5, 0, -3), Point(-1, 0, 0)};
    std::vector<std::array<std::uint32_t, 4>> cells = {{0, 1, 2, 4}, {0, 1, 4, 3}, {0, 2, 5, 4}, {0, 3, 4, 5}};
    if (has_room) {
      cells.push_back({0, 2, 6, 5});
      cells.push_back({0, 6, 3, 5});
    } else {
      m.points.pop_back();
      cells.push_back({0, 2, 3, 5});
    }
    std::map<std::array<std::uint32_t, 3>, std::pair<int, std::array<std::uint32_t, 3>>> facets;
    for (auto& c : cells) {
      if (tubular::internal::signed_volume(Vector_3d(m.points[c[0]]), Vector_3d(m.points[c[1]]),
                                           Vector_3d(m.points[c[2]]), Vector_3d(m.points[c[3]])) < 0)
        std::swap(c[0], c[1]);
      m.tetrahedra.push_back(c, 1);
      for (int i = 0; i < 4; ++i) {
        const auto& k = Tetrahedron_store::facet_corners(i);
        const std::array<std::uint32_t, 3> f = {c[k[0]], c[k[1]], c[k[2]]};
        auto key = f;
        std::sort(key.begin(), key.end());
        ++facets[key].first;
        facets[key].second = f;
      }
    }
    for (const auto& f : facets)
      if (f.second.first == 1)
        m.triangles.push_back(f.second.second, f.first[0] == 0 ? 1 : 2); // a rim around the dimple
    ASSERT_TRUE(tubular::validity_report(m).is_valid()) << tubular::validity_report(m).defects();

    Tetrahedron_store store(m);
    tubular::internal::Topology_optimizer<Any_flip, Against_an_edge> flips(store, Any_flip(), Against_an_edge{&store},
                                                                           1);
    EXPECT_EQ(flips.improve_below(0.5), has_room ? 1u : 0u);
    Mesh after;
    store.write_to(after);
    EXPECT_TRUE(tubular::validity_report(after).is_valid()) << tubular::validity_report(after).defects();
    EXPECT_EQ(after.triangles.size(), m.triangles.size());
  }
}

} // namespace

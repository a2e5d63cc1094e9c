// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Patches mapped onto the plane: shapes whose conformal map is known, what cannot be mapped, and the patches of a
// surface.

#include "patch_shapes.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace patch_shapes;

// --- shapes whose map is known ---

TEST(Parameterization, A_cylinder_goes_onto_a_ring_by_the_exponential) {
  for (double aspect_ratio : {1., 2., 4., 20.}) {
    const int sides = 48;
    const Patch patch = tube(cylinder(2 * aspect_ratio), sides, int(sides * aspect_ratio / pi));
    const Map map = tubular::parameterize_patch(patch);
    EXPECT_EQ(map.method(), Method::conformal);
    EXPECT_EQ(map.number_of_flips(), 0u);
    expect_bijective(map);
    const bool from_bottom = patch.points[std::size_t(patch.loops[map.outer_loop()][0])].z() == 0;
    const double error =
        error_of_ring(map, [&](const Point& p) { return std::exp(from_bottom ? -p.z() : p.z() - 2 * aspect_ratio); });
    EXPECT_LT(error, 0.01 * std::max(1., aspect_ratio)) << aspect_ratio;
    EXPECT_LT(anisotropy_at_vertices(map), 0.01) << aspect_ratio;
  }
}

TEST(Parameterization, A_catenoid_and_a_cone_go_onto_the_rings_of_their_moduli) {
  const double reach = 1.5; // the catenoid's conformal parameters are its angle and its height
  const Map catenoid = tubular::parameterize_patch(tube(
      [&](double a, double t) {
        const double z = reach * (2 * t - 1);
        return Point(std::cosh(z) * std::cos(a), std::cosh(z) * std::sin(a), z);
      },
      80, 40));
  expect_bijective(catenoid);
  EXPECT_EQ(catenoid.method(), Method::conformal);
  const bool from_bottom =
      catenoid.patch().points[std::size_t(catenoid.patch().loops[catenoid.outer_loop()][0])].z() < 0;
  EXPECT_LT(
      error_of_ring(catenoid, [&](const Point& p) { return std::exp(from_bottom ? -p.z() - reach : p.z() - reach); }),
      0.01);

  const double slope = 0.5, half_angle_sine = slope / std::hypot(1, slope); // radius r: modulus r^(1 / sin)
  const Map cone = tubular::parameterize_patch(tube(
      [&](double a, double t) {
        const double r = 1 + slope * 3 * t;
        return Point(r * std::cos(a), r * std::sin(a), 3 * t);
      },
      80, 40));
  expect_bijective(cone);
  EXPECT_LT(error_of_ring(
                cone, [&](const Point& p) { return std::pow(std::hypot(p.x(), p.y()) / 2.5, 1 / half_angle_sine); }),
            0.01);
  EXPECT_LT(anisotropy_at_vertices(cone), 0.01);
}

TEST(Parameterization, A_half_sphere_goes_onto_the_disk_by_stereographic_projection) {
  const Map map = tubular::parameterize_patch(half_sphere(64, 20));
  expect_bijective(map);
  EXPECT_EQ(map.method(), Method::conformal);
  double worst = 0;
  for (int v = 0; v < int(map.number_of_vertices()); ++v) {
    const Point& p = map.patch().points[std::size_t(v)];
    worst = std::max(worst, std::abs(norm(map.uv(v)) - std::hypot(p.x(), p.y()) / (1 + p.z())));
  }
  EXPECT_LT(worst, 0.005);
  EXPECT_LT(anisotropy_at_vertices(map), 0.02);
}

TEST(Parameterization, Junctions_keep_their_holes) {
  for (int branches : {1, 2, 5}) {
    const Map map = tubular::parameterize_patch(junction(branches, 48, 15 * branches + 15, 2. * branches + 2));
    ASSERT_EQ(map.number_of_loops(), std::size_t(branches) + 2);
    expect_bijective(map);
    EXPECT_LE(map.method(), Method::conformal_repaired);
    std::vector<double> ratio;
    for (int t = 0; t < int(map.number_of_triangles()); ++t)
      ratio.push_back(map.stretch_ratio(t));
    std::sort(ratio.begin(), ratio.end());
    EXPECT_LT(ratio[ratio.size() / 2], 1.15);
    EXPECT_LT(ratio[ratio.size() * 9 / 10], 1.5);
  }
}

TEST(Parameterization, The_map_does_not_depend_on_unit_and_place) {
  const Patch patch = junction(1, 40, 30, 4);
  Patch moved = patch;
  for (Point& p : moved.points)
    p = Point(1024 * p.x(), 1024 * p.y(), 1024 * p.z()); // exact
  const Map a = tubular::parameterize_patch(patch), b = tubular::parameterize_patch(moved);
  for (int v = 0; v < int(a.number_of_vertices()); ++v)
    ASSERT_LT(std::hypot(a.uv(v).x() - b.uv(v).x(), a.uv(v).y() - b.uv(v).y()), 1e-9);
  for (double scale : {1e-6, 1e6}) {
    for (std::size_t v = 0; v < patch.points.size(); ++v)
      moved.points[v] = Point(scale * patch.points[v].x(), scale * patch.points[v].y(), scale * patch.points[v].z());
    expect_bijective(tubular::parameterize_patch(moved));
  }
}

TEST(Parameterization, Wide_triangles_are_divided_without_a_change_of_the_surface) {
  for (int sides : {4, 5, 6}) {
    const Patch patch = tube(cylinder(7), sides, 1);
    const Map map = tubular::parameterize_patch(patch);
    expect_bijective(map);
    EXPECT_EQ(map.method(), Method::conformal) << sides;
    EXPECT_GT(map.number_of_triangles(), patch.triangles.size());
    EXPECT_LT(map.number_of_triangles(), 2000u);
    std::vector<double> ratio, area(patch.triangles.size(), 0.);
    for (int t = 0; t < int(map.number_of_triangles()); ++t) {
      ratio.push_back(map.stretch_ratio(t));
      const auto& c = patch.triangles[std::size_t(map.input_triangle(t))];
      const Kernel::Plane_3 plane(patch.points[std::size_t(c[0])], patch.points[std::size_t(c[1])],
                                  patch.points[std::size_t(c[2])]);
      for (int v : map.patch().triangles[std::size_t(t)])
        EXPECT_LT(CGAL::squared_distance(plane, map.patch().points[std::size_t(v)]), 1e-28);
      const auto& d = map.patch().triangles[std::size_t(t)];
      area[std::size_t(map.input_triangle(t))] +=
          std::sqrt(CGAL::squared_area(map.patch().points[std::size_t(d[0])], map.patch().points[std::size_t(d[1])],
                                       map.patch().points[std::size_t(d[2])]));
    }
    for (std::size_t t = 0; t < area.size(); ++t) {
      const auto& c = patch.triangles[t];
      EXPECT_NEAR(area[t],
                  std::sqrt(CGAL::squared_area(patch.points[std::size_t(c[0])], patch.points[std::size_t(c[1])],
                                               patch.points[std::size_t(c[2])])),
                  1e-12);
    }
    std::sort(ratio.begin(), ratio.end());
    EXPECT_LT(ratio[ratio.size() / 2], 1.5) << sides;
    EXPECT_LT(ratio[ratio.size() * 9 / 10], 2.) << sides;
    for (std::size_t v = 0; v < patch.points.size(); ++v)
      EXPECT_EQ(map.patch().points[v], patch.points[v]);
  }
}

// --- what cannot be mapped ---

TEST(Parameterization, Patches_that_are_no_spheres_with_holes_are_refused) {
  Patch closed = half_sphere(12, 4);
  const int n = int(closed.points.size());
  for (int i = 0; i < 12; ++i)
    closed.triangles.push_back({{(i + 1) % 12, i, n}});
  closed.points.push_back(Point(0, 0, 0));
  closed.loops = tubular::border_loops(closed);
  EXPECT_TRUE(closed.loops.empty());
  EXPECT_THROW(tubular::parameterize_patch(closed), tubular::Meshing_error);

  Patch two = tube(cylinder(1), 8, 2), other = two;
  for (auto t : other.triangles)
    two.triangles.push_back({{t[0] + 24, t[1] + 24, t[2] + 24}});
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  two.loops = tubular::border_loops(two);
  EXPECT_THROW(tubular::parameterize_patch(two), tubular::Meshing_error);

  Patch torus = tube(
      [](double a, double t) {
        const double b = 2 * pi * t, r = 3 + std::cos(a);
        return Point(r * std::cos(b), r * std::sin(b), std::sin(a));
      },
      10, 20);
  for (auto& t : torus.triangles)
    for (int& v : t)
      v = v % 200;
  torus.points.resize(200);
  torus.triangles.pop_back();
  torus.loops = tubular::border_loops(torus);
  EXPECT_EQ(torus.loops.size(), 1u);
  EXPECT_THROW(tubular::parameterize_patch(torus), tubular::Meshing_error);

  Patch wrong = tube(cylinder(1), 8, 2);
  for (auto& loop : wrong.loops)
    std::reverse(loop.begin(), loop.end());
  EXPECT_THROW(tubular::parameterize_patch(wrong), tubular::Input_error);
  wrong = tube(cylinder(1), 8, 2);
  wrong.loops.pop_back();
  EXPECT_THROW(tubular::parameterize_patch(wrong), tubular::Meshing_error);
  wrong = tube(cylinder(1), 8, 2);
  wrong.triangles.push_back(wrong.triangles[0]);
  EXPECT_THROW(tubular::parameterize_patch(wrong), tubular::Input_error);
  wrong = tube(cylinder(1), 8, 2);
  wrong.triangles[3][1] = 1000;
  EXPECT_THROW(tubular::parameterize_patch(wrong), tubular::Input_error);
  wrong = tube(cylinder(1), 8, 2);
  wrong.points[3] = Point(std::nan(""), 0, 0);
  EXPECT_THROW(tubular::parameterize_patch(wrong), tubular::Input_error);
}

// --- patches of a surface ---

TEST(Parameterization, Patches_of_a_cut_surface_share_their_curves) {
  typedef CGAL::Surface_mesh<Point> Mesh;
  typedef tubular::Cut_curve Curve;
  const int sides = 24, rings = 40, middle = 17;
  const Patch whole = tube(cylinder(8), sides, rings);
  Mesh mesh;
  for (const Point& p : whole.points)
    mesh.add_vertex(p);
  tubular::Surface_cut cut;
  cut.patches.resize(2);
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    const auto& c = whole.triangles[t];
    const auto f = mesh.add_face(Mesh::Vertex_index(c[0]), Mesh::Vertex_index(c[1]), Mesh::Vertex_index(c[2]));
    cut.patches[int(t) < 2 * sides * middle ? 0 : 1].faces.push_back(f);
  }
  for (int ring : {0, middle, rings}) {
    Curve curve;
    for (int i = 0; i < sides; ++i) // the patch above is on its left
      curve.vertices.push_back(Mesh::Vertex_index(ring * sides + i));
    cut.curves.push_back(curve);
  }
  cut.patches[0].loops = {{0, true, Curve::none}, {1, false, 1}};
  cut.patches[1].loops = {{1, true, 0}, {2, false, Curve::none}};
  for (int threads : {1, 2}) {
    const auto maps = tubular::parameterize_patches(mesh, cut, tubular::parameters::number_of_threads(threads));
    ASSERT_EQ(maps.size(), 2u);
    for (const Map& map : maps) {
      EXPECT_EQ(map.method(), Method::conformal);
      expect_bijective(map);
    }
    for (std::size_t e = 0; e < std::size_t(sides); ++e) {
      const Point below = maps[0].point(maps[0].on_loop_edge(1, std::size_t(sides) - 1 - e, 0.75));
      const Point above = maps[1].point(maps[1].on_loop_edge(0, e, 0.25));
      EXPECT_LT(CGAL::squared_distance(below, above), 1e-28);
    }
  }
}

TEST(Parameterization, A_hundred_thousand_triangles_in_a_hundred_patches) {
  std::vector<Patch> patches;
  for (int i = 0; i < 50; ++i) {
    patches.push_back(tube(cylinder(6), 22, 22));
    patches.push_back(junction(1, 26, 20, 3));
  }
  std::size_t triangles = 0;
  for (const Patch& patch : patches)
    triangles += patch.triangles.size();
  EXPECT_GT(triangles, 95000u);
  const auto start = std::chrono::steady_clock::now();
  for (const Patch& patch : patches)
    tubular::parameterize_patch(patch);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("milliseconds", int(1000 * seconds));
#ifdef NDEBUG
  EXPECT_LT(seconds, 4); // 1 on a machine that does nothing else
#endif
}

} // namespace

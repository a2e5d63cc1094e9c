// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Openings at points that a user gives, where no vessel ends: on balls, and what is like them.

#include "round_ends.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Tubular_meshing/Openings/cut_round_ends.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace round_ends;
namespace np = tubular::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

// All points at a distance from the origin that depends on the direction; with poles on a slanting axis.
Mesh star(const std::function<double(const Vector&)>& distance, std::size_t n) {
  Mesh mesh;
  const auto at = [&](double latitude, double longitude) {
    const Vector d(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                   std::sin(latitude));
    const Vector turned(0.8 * d.x() + 0.6 * d.z(), d.y(), -0.6 * d.x() + 0.8 * d.z());
    return mesh.add_vertex(CGAL::ORIGIN + distance(turned) * turned);
  };
  std::vector<std::vector<Mesh::Vertex_index>> rings;
  for (std::size_t k = 1; k < n / 2; ++k) {
    rings.emplace_back();
    for (std::size_t i = 0; i < n; ++i)
      rings.back().push_back(
          at(CGAL_PI * (double(k) / double(n / 2) - 0.5), 2 * CGAL_PI * (double(i) + 0.5 * double(k % 2)) / double(n)));
  }
  const auto south = at(-CGAL_PI / 2, 0), north = at(CGAL_PI / 2, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    mesh.add_face(south, rings.front()[j], rings.front()[i]);
    mesh.add_face(north, rings.back()[i], rings.back()[j]);
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
      const auto &a = rings[k], &b = rings[k + 1];
      if (k % 2 == 0) { // the ring above begins half a step later, or earlier
        mesh.add_face(a[i], b[i], b[(i + n - 1) % n]);
        mesh.add_face(a[i], a[j], b[i]);
      } else {
        mesh.add_face(a[i], b[j], b[i]);
        mesh.add_face(a[i], a[j], b[j]);
      }
    }
  }
  return mesh;
}

Mesh ellipsoid(double a, std::size_t n) {
  return star([=](const Vector& d) { return 1 / std::sqrt((d.x() * d.x() + d.y() * d.y()) + d.z() * d.z() / (a * a)); },
              n);
}

Mesh rounded_cube(std::size_t n) {
  return star(
      [](const Vector& d) { return std::pow(std::pow(d.x(), 8) + std::pow(d.y(), 8) + std::pow(d.z(), 8), -1. / 8); },
      n);
}

Point moved(const Point& p, double scale, double angle) {
  Mesh one;
  const auto v = one.add_vertex(p);
  move(one, scale, angle);
  return one.point(v);
}

// Opens the surface, turned and in a unit of its own, at points, through which blood then flows.
void expect_openings_at(const Mesh& shape, const std::vector<Point>& points, double least_radius, double most_radius,
                        double least_share) {
  int number = 0;
  for (double scale : {1., 1e-3, 250.}) {
    const double angle = 0.4 + 0.9 * number++;
    Mesh mesh = shape;
    move(mesh, scale, angle);
    std::vector<Point> at;
    for (const Point& p : points)
      at.push_back(moved(p, scale, angle));
    const auto model = tubular::make_tubular_model(mesh, np::seeds(at));
    ASSERT_EQ(model.openings.size(), points.size()) << "scale " << scale;
    EXPECT_EQ(model.round_ends.size(), points.size());
    EXPECT_GE(model.centerlines.branches().size(), points.size() - 1);
    EXPECT_GT(PMP::volume(model.surface), least_share * PMP::volume(mesh));
    for (const Point& p : at) {
      const auto& nearest =
          *std::min_element(model.openings.begin(), model.openings.end(), [&](const auto& a, const auto& b) {
            return CGAL::squared_distance(a.center, p) < CGAL::squared_distance(b.center, p);
          });
      EXPECT_LT(tubular::internal::point_distance(nearest.center, p), 1.3 * nearest.radius) << "scale " << scale;
      EXPECT_GT(nearest.radius, least_radius * scale) << "scale " << scale;
      EXPECT_LT(nearest.radius, most_radius * scale) << "scale " << scale;
    }
  }
}

} // namespace

TEST(Openings_at_points, A_ball_is_opened_at_its_poles) {
  for (std::size_t n : {16, 32, 60}) {
    const Mesh ball = ellipsoid(1, n);
    expect_openings_at(ball, {Point(0, 0, 1), Point(0, 0, -1)}, 0.35, 0.65, 0.9);
    expect_openings_at(ball, {Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, -1)}, 0.35, 0.65, 0.85);
  }
}

TEST(Openings_at_points, An_ellipsoid_is_opened_at_its_ends_and_at_its_sides) {
  for (double a : {0.6, 1.3, 1.8})
    for (std::size_t n : {24, 48}) {
      SCOPED_TRACE("axis " + std::to_string(a) + ", n " + std::to_string(n));
      expect_openings_at(ellipsoid(a, n), {Point(0, 0, a), Point(0, 0, -a)}, 0.15, 1.01, 0.45);
      expect_openings_at(ellipsoid(a, n), {Point(1, 0, 0), Point(-1, 0, 0)}, 0.25, 1.01, 0.45);
    }
}

TEST(Openings_at_points, A_cube_with_rounded_edges_is_opened_at_its_faces_and_corners) {
  const Mesh cube = rounded_cube(48);
  expect_openings_at(cube, {Point(0, 0, 1), Point(0, 0, -1)}, 0.35, 1.3, 0.8);
  expect_openings_at(cube, {Point(0.87, 0.87, 0.87), Point(-0.87, -0.87, -0.87)}, 0.25, 1.3, 0.7);
}

TEST(Openings_at_points, A_sac_is_opened_where_a_point_says_so) {
  Skeleton s = tube_with_node();
  add_sac(s, 1, Vector(1, 0, 0), 3.8, 2.4, 0.6);
  const Mesh mesh = round_tree(s, 20);
  for (const Point& p : {Point(6.2, 0, 7), Point(3.8, 2.4, 7), Point(3.8, -1.7, 8.7)}) {
    const auto model = tubular::make_tubular_model(mesh, np::seeds(std::vector<Point>{Point(0, 0, -1), p}));
    EXPECT_EQ(model.openings.size(), 2u) << p;
    EXPECT_GT(PMP::volume(model.surface), 0.7 * PMP::volume(mesh)) << p;
  }
}

TEST(Openings_at_points, A_point_within_the_lumen_or_away_from_it_is_none) {
  const Mesh ball = ellipsoid(1, 32);
  for (const Point& p : {Point(0.05, 0, 0), Point(0, 0, 2.5)})
    EXPECT_THROW(tubular::make_tubular_model(ball, np::seeds(std::vector<Point>{Point(0, 0, 1), p})),
                 tubular::Input_error)
        << p;
}

TEST(Openings_at_points, No_cut_takes_most_of_the_surface_away) {
  for (double length : {0.02, 0.2, 0.6, 1.2, 2.5}) {
    Skeleton s;
    s.nodes = {Point(0, 0, 0)};
    add_tube(s, 0, Point(0, 0, length), 1, 1);
    const Mesh mesh = round_tree(s, 24);
    Mesh cut = mesh;
    const auto reports = tubular::cut_round_ends(cut);
    const auto number = std::count_if(reports.begin(), reports.end(), [](const auto& r) { return r.is_cut; });
    EXPECT_EQ(tubular::internal::find_any_openings(cut, {}).size(), std::size_t(number)) << length;
    if (number > 0) {
      EXPECT_GT(PMP::area(cut), 0.25 * PMP::area(mesh)) << length;
    }
  }
}

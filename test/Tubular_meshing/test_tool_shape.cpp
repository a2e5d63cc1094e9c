// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// tubular_mesh on lumens that are no plain tubes: as many points round each part as are asked for.

#include "implicit_surface.h"
#include "test_tool_helpers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;
namespace shapes = test_surfaces;

const double pi = 3.14159265358979323846;

// The mean length of the wall's edges whose middle is in a part of space.
double mean_edge(const Mesh& mesh, const std::function<bool(const Point&)>& is_in) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles.label[i] == tubular::labels::wall)
      for (int k = 0; k < 3; ++k)
        edges.insert(std::minmax<std::size_t>(mesh.triangles.vertices[i][k], mesh.triangles.vertices[i][(k + 1) % 3]));
  double sum = 0;
  std::size_t count = 0;
  for (const auto& e : edges) {
    const Point &p = mesh.points[e.first], &q = mesh.points[e.second];
    if (is_in(CGAL::midpoint(p, q))) {
      sum += std::sqrt(CGAL::squared_distance(p, q));
      ++count;
    }
  }
  return count == 0 ? 0 : sum / double(count);
}

struct Sac {
  double neck, length, radius, scale, angle;
};

TEST_F(Tool, Meshes_a_sac_and_its_neck_at_their_own_sizes) {
  const double n = 16;
  for (const Sac& s : {Sac{0.5, 1.2, 2, 1, 0}, Sac{0.4, 1, 1.2, 1e-3, 1}}) {
    const double x = 1 + s.length + s.radius;
    const auto f = shapes::united(
        shapes::vessel(Point(0, 0, -20), Point(0, 0, 20), 1),
        shapes::united(shapes::vessel(Point(0, 0, 0), Point(x, 0, 0), s.neck), shapes::ball(Point(x, 0, 0), s.radius)));
    const shapes::Transformation t = shapes::rotation(s.angle) * shapes::Transformation(CGAL::SCALING, s.scale);
    const auto back = t.inverse();
    const auto surface = shapes::transformed(
        shapes::implicit_surface(f, Point(-1.4, -2.4, -5), Point(x + s.radius + 0.4, 2.4, 5), 0.1), t);
    succeed({make("sac.off", surface), "-n", "16", "-o", out("mesh.vtu"), "--report", out("r.json")});
    const Mesh mesh = mesh_in(out("mesh.vtu"));
    const auto points_round = [&](double radius, const std::function<bool(const Point&)>& is_in) {
      return 2 * pi * radius * s.scale / mean_edge(mesh, [&](const Point& p) { return is_in(back(p)); });
    };
    const double tube = points_round(1, [](const Point& p) { return std::abs(p.z()) > 2.5 && p.x() < 1.1; });
    const double sac = points_round(s.radius, [&](const Point& p) { return p.x() > x - 0.3 * s.radius; });
    const double neck = points_round(s.neck, [&](const Point& p) {
      return p.x() > 1 + s.length * 0.4 && p.x() < 1 + s.length * 0.75 && std::hypot(p.y(), p.z()) < 1.1 * s.neck;
    });
    for (double found : {tube, sac, neck}) {
      EXPECT_GE(found, n - 1) << tube << " " << sac << " " << neck;
      EXPECT_LE(found, 1.35 * n) << tube << " " << sac << " " << neck;
    }
    EXPECT_NEAR(json_in(out("r.json"))["volume"]["relative_difference"].get<double>(), 0, 0.003);
  }
}

// Two vessels that part and join again, with one of an eighth of their radius between them, which a tree of shortest
// paths leaves out.
TEST_F(Tool, Meshes_a_vessel_without_a_centerline_at_its_own_size) {
  using shapes::united;
  using shapes::vessel;
  const auto f =
      united(united(united(vessel(Point(-4, 0, -6), Point(-4, 0, 30), 2), vessel(Point(4, 0, -6), Point(4, 0, 30), 2)),
                    vessel(Point(-4, 0, -6), Point(4, 0, -6), 2)),
             vessel(Point(-4, 0, 0), Point(4, 0, 0), 0.25));
  const auto surface = shapes::implicit_surface(f, Point(-6.6, -2.4, -8.4), Point(6.6, 2.4, 10), 0.12);
  succeed({make("h.off", surface), "-n", "12", "-o", out("mesh.vtu")});
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  const double thin = mean_edge(
      mesh, [](const Point& p) { return std::abs(p.x()) < 1.3 && std::abs(p.z()) < 0.3 && std::abs(p.y()) < 0.3; });
  const double wide = mean_edge(mesh, [](const Point& p) { return p.z() > 7.5; });
  EXPECT_GE(2 * pi * 0.25 / thin, 11);
  EXPECT_NEAR(2 * pi * 2 / wide, 12, 2);
}

} // namespace

#endif // TUBULAR_MESH_TOOL

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The radius by shape on walls of long, thin triangles: what they say of a lumen of known width, in any order.

#include "implicit_surface.h"
#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Shape_radius.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
using namespace test_surfaces;
typedef tubular::Shape_radius Shape_radius;

const double pi = 3.14159265358979323846;

/* A vessel whose axis is an arc of a circle through the origin, along z there, or straight: `bend` is 1 over its radius. */
struct Vessel {
  double length, bend;
  std::function<double(double)> radius; // by where along the axis, from 0 to 1

  Point at(double t, double angle) const {
    const double r = radius(t), x = r * std::cos(angle), y = r * std::sin(angle);
    if (bend == 0)
      return Point(x, y, t * length);
    const double turned = bend * t * length;
    return Point(1 / bend - (1 / bend - x) * std::cos(turned), y, (1 / bend - x) * std::sin(turned));
  }
};

/* Rows of triangles; each ring is turned against the one before by this part of a side. Radii are off by up to `noise`. */
Mesh in_rows(const Vessel& vessel, int sides, int rows, double twist, double noise) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> off(1 - noise, 1 + noise);
  Mesh mesh;
  std::vector<std::vector<Mesh::Vertex_index>> ring(std::size_t(rows) + 1);
  for (int k = 0; k <= rows; ++k)
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * pi * (i + twist * k) / sides, s = off(random);
      Vessel noisy = vessel;
      noisy.radius = [&](double t) { return s * vessel.radius(t); };
      ring[std::size_t(k)].push_back(mesh.add_vertex(noisy.at(double(k) / rows, angle)));
    }
  for (std::size_t k = 0; k + 1 < ring.size(); ++k)
    for (std::size_t i = 0; i < std::size_t(sides); ++i) {
      const std::size_t j = (i + 1) % std::size_t(sides);
      mesh.add_face(ring[k][i], ring[k][j], ring[k + 1][i]);
      mesh.add_face(ring[k][j], ring[k + 1][j], ring[k + 1][i]);
    }
  return mesh;
}

struct Place {
  Point point;
  double radius;
};

std::vector<Place> places_on(const Vessel& vessel) {
  std::vector<Place> result;
  for (double t = 0.0125; t < 1; t += 0.025)
    for (double angle = 0.05; angle < 2 * pi; angle += 0.5)
      result.push_back({vessel.at(t, angle), vessel.radius(t)});
  return result;
}

// Of the ratio to the true radius.
struct Bounds {
  double low, high; // of all but a hundredth at either end
  double low_median, high_median;
};

// A polygon of so many sides is between two circles.
Bounds of_sides(int sides) {
  const double inner = std::cos(pi / sides);
  return {inner - 0.09, 1.06, inner - 0.02, 1.04};
}

/* In the order given and two others, which give as many elements on the wall, as these go by 1 / radius squared. */
void expect_radii(const std::string& what, const Mesh& mesh, const std::vector<Place>& places, const Bounds& bounds) {
  std::vector<double> elements;
  for (unsigned order = 0; order < 3; ++order) {
    const Shape_radius shape{tubular::Wall_distance(order == 0 ? mesh : shuffled(mesh, order))};
    std::vector<double> ratios;
    elements.push_back(0);
    for (const Place& p : places) {
      const double r = shape(p.point);
      ASSERT_GT(r, 0) << what;
      ratios.push_back(r / p.radius);
      elements.back() += 1 / (r * r);
    }
    std::sort(ratios.begin(), ratios.end());
    const std::size_t n = ratios.size();
    EXPECT_GT(ratios[n / 2], bounds.low_median) << what << ", order " << order;
    EXPECT_LT(ratios[n / 2], bounds.high_median) << what << ", order " << order;
    EXPECT_GT(ratios[n / 100], bounds.low) << what << ", order " << order;
    EXPECT_LT(ratios[n - 1 - n / 100], bounds.high) << what << ", order " << order;
    EXPECT_NEAR(elements.back() / elements.front(), 1, 0.02) << what << ", order " << order;
  }
}

// To a third, in as many rows as make triangles of this ratio of length to width.
TEST(Long_triangles, Along_a_vessel_that_tapers) {
  const auto taper = [](double t) { return 1 - t / 1.5; };
  for (double ratio : {10., 30., 100.})
    for (double twist : {0., 0.5, 0.2})
      for (int sides : {8, 12, 30}) {
        const Vessel vessel{25, 0, taper};
        const int rows = std::max(1, int(std::lround(25 / (ratio * 2 * pi / sides * 0.67))));
        expect_radii("ratio " + std::to_string(ratio) + ", twist " + std::to_string(twist) + ", sides " +
                         std::to_string(sides),
                     in_rows(vessel, sides, rows, twist, 0), places_on(vessel), of_sides(sides));
      }
}

// Rings close to each other, of few sides.
TEST(Long_triangles, Around_a_vessel) {
  const auto taper = [](double t) { return 1 - t / 2; };
  for (double ratio : {10., 30.})
    for (int sides : {6, 8, 12})
      for (double twist : {0., 0.02}) {
        const int rows = int(std::lround(8 / (2 * std::sin(pi / sides) * 0.75 / ratio)));
        expect_radii(
            "ratio " + std::to_string(ratio) + ", sides " + std::to_string(sides) + ", twist " + std::to_string(twist),
            in_rows(Vessel{8, 0, taper}, sides, rows, twist, 0), places_on(Vessel{8, 0, taper}), of_sides(sides));
      }
}

TEST(Long_triangles, Along_an_arch) {
  for (double ratio : {10., 20.})
    for (double twist : {0., 0.5})
      for (double noise : {0., 0.02}) {
        const Vessel arch{30, 0.1, [](double t) { return 1 - t / 2; }};
        const int sides = 24, rows = int(std::lround(30 / (ratio * 2 * pi / sides * 0.75)));
        Bounds bounds = of_sides(sides);
        bounds.low -= 2 * noise;
        bounds.high += 2 * noise;
        expect_radii("ratio " + std::to_string(ratio) + ", twist " + std::to_string(twist) + ", noise " +
                         std::to_string(noise),
                     in_rows(arch, sides, rows, twist, noise), places_on(arch), bounds);
      }
}

// Two branches that leave a trunk at a small angle: the surface of it all pressed together along z, drawn out again.
TEST(Long_triangles, Along_a_bifurcation) {
  const double drawn = 12;
  const auto along = [=](const Implicit& f) {
    return [=](const Point& p) { return f(Point(p.x(), p.y(), drawn * p.z())); };
  };
  const Implicit y =
      united(vessel(Point(0, 0, -40), Point(0, 0, 0), 1),
             united(vessel(Point(0, 0, 0), Point(6, 0, 40), 0.7), vessel(Point(0, 0, 0), Point(-6, 0, 40), 0.7)));
  Mesh mesh = implicit_surface(along(y), Point(-6, -1.5, -20 / drawn), Point(6, 1.5, 24 / drawn), 0.15);
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(p.x(), p.y(), drawn * p.z());
  }
  std::vector<Place> places;
  for (double angle = 0.05; angle < 2 * pi; angle += 0.4) {
    for (double z = -18; z < -3; z += 1)
      places.push_back({Point(std::cos(angle), std::sin(angle), z), 1});
    for (double z = 11; z < 22; z += 1)
      for (double side : {-1., 1.})
        places.push_back({Point(side * 6 * z / 40 + 0.7 * std::cos(angle), 0.7 * std::sin(angle), z), 0.7});
  }
  expect_radii("bifurcation", mesh, places, Bounds{0.94, 1.04, 0.97, 1.02});
}

} // namespace

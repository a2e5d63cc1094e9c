// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The sizing field on shapes whose radius is known.

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
using namespace test_surfaces;
typedef tubular::Centerline_sizing_field Sizing_field;

const double pi = 3.14159265358979323846;

/* A tube along z whose radius is a function of z, with its axis. */
struct Round_tube {
  Mesh mesh;
  tubular::Centerline_polylines axis;

  Round_tube(double length, const std::function<double(double)>& radius, double scale = 1, int sides = 48,
             int rings = 200) {
    std::vector<std::vector<Mesh::Vertex_index>> ring(rings + 1);
    for (int i = 0; i <= rings; ++i) {
      const double z = length * i / rings;
      for (int k = 0; k < sides; ++k) {
        const double a = 2 * pi * k / sides, r = radius(z);
        ring[i].push_back(mesh.add_vertex(Point(scale * r * std::cos(a), scale * r * std::sin(a), scale * z)));
      }
      axis.points.push_back(Point(0, 0, scale * z));
    }
    for (int i = 0; i < rings; ++i)
      for (int k = 0; k < sides; ++k) {
        const int l = (k + 1) % sides;
        mesh.add_face(ring[i][k], ring[i][l], ring[i + 1][l]);
        mesh.add_face(ring[i][k], ring[i + 1][l], ring[i + 1][k]);
      }
    axis.lines.emplace_back();
    for (std::size_t i = 0; i < axis.points.size(); ++i)
      axis.lines[0].push_back(i);
  }

  template <class NamedParameters> Sizing_field field(const NamedParameters& np) const {
    const tubular::Wall_distance wall(mesh);
    tubular::Centerline_graph graph;
    tubular::build_centerline_graph(axis, wall, graph);
    return Sizing_field(tubular::Centerline_field(graph), wall, np);
  }
};

double constant_radius(double) {
  return 1;
}

TEST(Centerline_sizing_field, Is_the_circumference_over_n) {
  const Round_tube tube(12, constant_radius);
  for (double n : {8., 20., 50.}) {
    const Sizing_field h = tube.field(tubular::parameters::points_per_circumference(n));
    for (double z : {0.5, 3., 6.1, 11.5})
      for (double r : {0., 0.4, 0.99})
        EXPECT_NEAR(h(Point(r, 0, z)), 2 * pi / n, 0.01 * 2 * pi / n) << n << " " << z << " " << r;
  }
}

TEST(Centerline_sizing_field, Does_not_depend_on_units) {
  const Round_tube metres(12, constant_radius, 1e-3), nanometres(12, constant_radius, 1e6);
  const auto np = tubular::parameters::points_per_circumference(20);
  EXPECT_NEAR(metres.field(np)(Point(0, 0, 6e-3)) / 1e-3, nanometres.field(np)(Point(0, 0, 6e6)) / 1e6, 1e-6);
}

TEST(Centerline_sizing_field, Follows_a_taper) {
  const Round_tube tube(20, [](double z) { return 2 - z / 16; });
  const Sizing_field h = tube.field(tubular::parameters::points_per_circumference(20));
  for (double z = 2; z < 18; z += 1)
    EXPECT_NEAR(h(Point(0.1, 0, z)), 2 * pi * (2 - z / 16) / 20, 0.03 * 2 * pi * (2 - z / 16) / 20) << z;
}

TEST(Centerline_sizing_field, Meshes_a_sac_at_its_own_size) {
  // a bulge on one side, its centerline straight: the nearest wall is the vessel's, 1 away. The largest ball that
  // touches the bulge's end, 3 away, has a radius of about 1.8
  Round_tube tube(20, constant_radius);
  for (auto v : tube.mesh.vertices()) {
    const Point p = tube.mesh.point(v);
    const double bulge = std::exp(-(p.z() - 10) * (p.z() - 10) / 4) * (std::max)(0., p.x());
    tube.mesh.point(v) = Point(p.x() * (1 + 2 * bulge), p.y() * (1 + 2 * bulge), p.z());
  }
  const Sizing_field h = tube.field(tubular::parameters::points_per_circumference(20).gradation(2.));
  EXPECT_NEAR(h(Point(2.9, 0, 10)), 2 * pi * 1.8 / 20, 0.15 * 2 * pi * 1.8 / 20);
  EXPECT_LT(h(Point(-0.9, 0, 10)), 1.3 * 2 * pi / 20);
}

TEST(Centerline_sizing_field, Keeps_to_limits_and_gradation) {
  // a throat: the radius falls from 2 to 0.3 and rises again within a short length
  const auto throat = [](double z) { return 2 - 1.7 * std::exp(-(z - 10) * (z - 10) / 0.5); };
  const Round_tube tube(20, throat, 1, 48, 400);
  const auto n = tubular::parameters::points_per_circumference(20);
  const Sizing_field limited = tube.field(n.min_size(0.15).max_size(0.4).gradation(1e3));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const double size = limited(Point(0, 0, 20 * uniform(random)));
    EXPECT_GE(size, 0.15 * (1 - 1e-12));
    EXPECT_LE(size, 0.4 * (1 + 1e-12));
  }
  for (double gradation : {1.1, 1.3}) {
    const Sizing_field h = tube.field(n.gradation(gradation));
    for (int i = 0; i < 2000; ++i) {
      const double z = 20 * uniform(random), step = 0.5 * uniform(random), size = h(Point(0, 0, z));
      // along an axis of the octree the interpolant grows no faster than its corners
      EXPECT_LE(h(Point(0, 0, z + step)), size + 1.75 * (gradation - 1) * step + 1e-9);
    }
    EXPECT_NEAR(h(Point(0, 0, 10)), 2 * pi * 0.3 / 20, 0.15 * 2 * pi * 0.3 / 20 + 0.3 * (gradation - 1));
    EXPECT_LT(h(Point(0, 0, 10.5)), h(Point(0, 0, 10)) + 0.9 * (gradation - 1));
  }
}

TEST(Centerline_sizing_field, Is_the_same_on_any_number_of_threads) {
  const Round_tube tube(20, [](double z) { return 2 - z / 16; });
  const Sizing_field one = tube.field(tubular::parameters::number_of_threads(1));
  const Sizing_field two = tube.field(tubular::parameters::number_of_threads(2));
  for (double z = 0; z < 20; z += 0.37)
    EXPECT_EQ(one(Point(0.3, 0.2, z)), two(Point(0.3, 0.2, z)));
}

TEST(Centerline_sizing_field, Answers_outside_of_the_surface) {
  const Round_tube tube(12, constant_radius);
  const Sizing_field h = tube.field(tubular::parameters::points_per_circumference(20));
  for (const Point& p : {Point(100, 0, 0), Point(0, 0, -50), Point(-3, 4, 30)}) {
    EXPECT_TRUE(std::isfinite(h(p)));
    EXPECT_GT(h(p), 0);
  }
}

TEST(Centerline_sizing_field, Refuses_senseless_parameters) {
  const Round_tube tube(12, constant_radius, 1, 16, 20);
  using tubular::Parameter_error;
  EXPECT_THROW(tube.field(tubular::parameters::points_per_circumference(0)), Parameter_error);
  EXPECT_THROW(tube.field(tubular::parameters::points_per_circumference(std::nan(""))), Parameter_error);
  EXPECT_THROW(tube.field(tubular::parameters::min_size(-1.)), Parameter_error);
  EXPECT_THROW(tube.field(tubular::parameters::min_size(2.).max_size(1.)), Parameter_error);
  EXPECT_THROW(tube.field(tubular::parameters::max_size(0.)), Parameter_error);
  EXPECT_THROW(tube.field(tubular::parameters::gradation(0.9)), Parameter_error);
}

} // namespace

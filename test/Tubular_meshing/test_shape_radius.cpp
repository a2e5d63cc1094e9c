// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The radius by shape, and the local radius made of it, on lumens whose width is known everywhere.

#include "implicit_surface.h"
#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/Fields/Shape_radius.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
using namespace test_surfaces;
typedef tubular::Shape_radius Shape_radius;

const double pi = 3.14159265358979323846;

// The smallest and largest radius at the wall's vertices.
std::pair<double, double> range(const Mesh& mesh) {
  const Shape_radius shape{tubular::Wall_distance(mesh)};
  double least = 1e300, most = 0;
  for (const auto& b : shape.balls()) {
    least = std::min(least, b.radius);
    most = std::max(most, b.radius);
  }
  return {least, most};
}

Mesh round_tube(double length, const std::function<double(double)>& radius, int sides, int rings) {
  Tube tube;
  tube.length = length;
  tube.sides = sides;
  tube.rings = rings;
  Mesh mesh = make_tube(tube);
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(radius(p.z()) * p.x(), radius(p.z()) * p.y(), p.z());
  }
  return mesh;
}
double one(double) {
  return 1;
}

// A straight centerline through each of these segments, with radii measured on the wall.
tubular::Local_radius local_radius(const Mesh& mesh, const std::vector<std::pair<Point, Point>>& segments) {
  tubular::Centerline_polylines lines;
  for (const auto& s : segments) {
    lines.lines.emplace_back();
    for (int i = 0; i <= 100; ++i) {
      lines.lines.back().push_back(lines.points.size());
      lines.points.push_back(s.first + i / 100. * (s.second - s.first));
    }
  }
  const tubular::Wall_distance wall(mesh);
  tubular::Centerline_graph graph;
  tubular::build_centerline_graph(lines, wall, graph);
  return tubular::Local_radius(tubular::Centerline_field(graph), wall);
}

TEST(Shape_radius, Of_a_tube_is_its_own_up_to_the_rims) {
  for (int sides : {8, 20, 60}) {
    const auto r = range(round_tube(6, one, sides, sides));
    EXPECT_GT(r.first, std::cos(pi / sides) - 0.03) << sides;
    EXPECT_LT(r.second, 1.03) << sides;
  }
  const auto few_rings = range(round_tube(12, one, 32, 2));
  EXPECT_GT(few_rings.first, 0.97);
  EXPECT_LT(few_rings.second, 1.03);
}

TEST(Shape_radius, Of_a_sphere_and_of_a_torus) {
  const auto sphere = range(make_sphere(20, 30)), torus = range(make_torus(90, 30));
  EXPECT_GT(sphere.first, 0.95);
  EXPECT_LT(sphere.second, 1.05);
  EXPECT_GT(torus.first, 0.93);
  EXPECT_LT(torus.second, 1.05);
}

TEST(Shape_radius, Of_a_flat_vessel_is_half_its_width) {
  Tube tube;
  tube.sides = 60;
  tube.rings = 40;
  tube.rx = 3;
  const Mesh mesh = make_tube(tube);
  const Shape_radius shape{tubular::Wall_distance(mesh)};
  const auto half_width = [](double x) { return std::sqrt(1 - x * x / 9); };
  for (double x : {0., 0.5, 1., 1.5, 2.}) { // or that of a ball that touches half a radius away
    EXPECT_GT(shape(Point(x, 2, 4)), half_width(x) - 0.02) << x;
    EXPECT_LT(shape(Point(x, 2, 4)), half_width(std::max(0., x - 0.5)) + 0.02) << x;
  }
  EXPECT_LT(shape(Point(4, 0, 4)), 1);
}

Mesh noisy_tube(double noise, int seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> of(1 - noise, 1 + noise);
  Mesh mesh = round_tube(8, one, 40, 60);
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    const double s = of(random);
    mesh.point(v) = Point(s * p.x(), s * p.y(), p.z());
  }
  return mesh;
}

const double voxel = 0.14;

// A tube of radius 1 through (0, 0, -9) and (2, 3, 9), as an image has it.
Mesh tube_of_voxels() {
  const Implicit tube = vessel(Point(0, 0, -9), Point(2, 3, 9), 1);
  const Implicit steps = [=](const Point& p) { // of the voxel that the point is in
    const auto middle = [](double x) { return voxel * (std::floor(x / voxel) + 0.5); };
    return tube(Point(middle(p.x()), middle(p.y()), middle(p.z()))) < 0 ? -1. : 1.;
  };
  return implicit_surface(steps, Point(-3, -3, -3), Point(3, 3, 3), 0.07);
}

Mesh sac_on_a_tube() {
  const Implicit f = united(vessel(Point(0, 0, -20), Point(0, 0, 20), 1),
                            united(vessel(Point(0, 0, 0), Point(3, 0, 0), 0.5), ball(Point(3.5, 0, 0), 1.4)));
  return implicit_surface(f, Point(-2, -2, -4), Point(5.5, 2, 4), 0.12);
}

// But for rounding: at each place of the wall, whether it is regular, so that much is equally far, or not.
TEST(Shape_radius, Does_not_depend_on_unit_position_and_direction) {
  const auto taper = [](double z) { return 2 - z / 8; };
  for (const Mesh& mesh : {round_tube(8, taper, 30, 40), round_tube(12, one, 30, 60), round_tube(12, one, 32, 2),
                           noisy_tube(0.05, 7), tube_of_voxels(), sac_on_a_tube()}) {
    const auto balls = Shape_radius{tubular::Wall_distance(mesh)}.balls();
    for (double scale : {1e-6, 1., 1e3})
      for (double angle : {0., 0.7, 2.}) {
        const Transformation turned(0, -1, 0, 5, 0, 0, 1, -2, -1, 0, 0, 7); // axes become others
        const Transformation t = Transformation(CGAL::SCALING, scale) * rotation(angle) * turned;
        const auto moved = Shape_radius{tubular::Wall_distance(transformed(mesh, t))}.balls();
        ASSERT_EQ(moved.size(), balls.size());
        for (std::size_t i = 0; i < balls.size(); ++i) {
          ASSERT_NEAR(moved[i].radius / scale, balls[i].radius, 1e-9 * balls[i].radius) << scale << " " << angle;
          ASSERT_LT(CGAL::squared_distance(moved[i].center, t(balls[i].center)), 1e-18 * scale * scale);
        }
      }
  }
}

TEST(Shape_radius, Is_the_same_on_any_number_of_threads) {
  const Mesh mesh = round_tube(
      8, [](double z) { return 2 - z / 8; }, 40, 100);
  const tubular::Wall_distance wall(mesh);
  const auto one = Shape_radius(wall, tubular::parameters::number_of_threads(1)).balls();
  const auto two = Shape_radius(wall, tubular::parameters::number_of_threads(2)).balls();
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ(one[i].radius, two[i].radius);
}

TEST(Shape_radius, Is_not_set_by_vertices_out_of_place) {
  std::mt19937 random(3);
  for (double depth : {-1., 0.4, 0.8, 1.3}) {
    Mesh mesh = round_tube(12, one, 30, 60);
    for (int i = 0; i < 12; ++i) {
      const Mesh::Vertex_index v(unsigned(random() % mesh.number_of_vertices()));
      const Point p = mesh.point(v);
      mesh.point(v) = Point((1 - depth) * p.x(), (1 - depth) * p.y(), p.z());
    }
    const auto r = range(mesh);
    EXPECT_GT(r.first, 0.9) << depth;
    EXPECT_LT(r.second, 1.1) << depth;
  }
}

TEST(Shape_radius, Is_not_set_by_noise) {
  for (double noise : {0.02, 0.05}) {
    const Mesh mesh = noisy_tube(noise, 5);
    const auto r = range(mesh);
    EXPECT_GT(r.first, 1 - 3 * noise) << noise;
    EXPECT_LT(r.second, 1 + 3 * noise) << noise;
  }
}

void expect_steps_to_matter_little(const Shape_radius& shape) {
  for (double z = -2.5; z < 2.6; z += 0.25)
    for (double a = 0; a < 6; a += 0.5) {
      const double t = (z + 9) / 18;
      EXPECT_NEAR(shape(Point(2 * t + std::cos(a), 3 * t + std::sin(a), z)), 1, 0.13) << z << " " << a;
    }
  std::size_t all = 0, off = 0;
  for (const auto& b : shape.balls())
    if (std::abs(b.on_wall.z()) < 2.2) {
      ++all;
      off += std::abs(b.radius - 1) > 0.13;
    }
  EXPECT_LT(double(off), 1e-3 * double(all));
}

TEST(Shape_radius, Is_not_set_by_the_steps_of_a_segmented_image) {
  expect_steps_to_matter_little(Shape_radius{tubular::Wall_distance(tube_of_voxels())});
}

// The triangles' order decides which places are asked first: it must not decide what is found.
TEST(Shape_radius, Is_not_set_by_steps_in_any_order_of_the_triangles) {
  const Mesh mesh = tube_of_voxels();
  std::vector<std::array<Point, 3>> triangles;
  for (auto f : mesh.faces()) {
    triangles.emplace_back();
    std::size_t k = 0;
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      triangles.back()[k++] = mesh.point(v);
  }
  std::mt19937 random(2);
  for (int i = 0; i < 3; ++i) {
    std::shuffle(triangles.begin(), triangles.end(), random);
    expect_steps_to_matter_little(Shape_radius{tubular::Wall_distance(triangles)});
  }
}

TEST(Shape_radius, Keeps_a_stenosis) {
  const auto radius = [](double z) { return 1 - 0.95 * std::exp(-(z - 6) * (z - 6) / 0.5); };
  const Mesh mesh = round_tube(12, radius, 40, 600);
  const Shape_radius shape{tubular::Wall_distance(mesh)};
  EXPECT_NEAR(shape(Point(0, 0, 6)), 0.05, 0.01);
  for (double z : {1., 3., 9., 11.})
    EXPECT_NEAR(shape(Point(0, 0.5, z)), radius(z), 0.06) << z;
}

// --- the local radius ---

TEST(Local_radius, On_plain_branches_is_that_of_the_centerline) {
  const auto taper = [](double z) { return 1.5 - z / 24; };
  for (int sides : {12, 30}) {
    const Mesh mesh = round_tube(12, taper, sides, 3 * sides);
    const auto local = local_radius(mesh, {{Point(0, 0, 0), Point(0, 0, 12)}});
    for (double z = 0; z <= 12; z += 0.25) {
      const auto r = local.radii(Point(0.9 * taper(z), 0.1, z));
      EXPECT_EQ(r.share_against(r.of_centerline.radius), 0) << sides << " " << z;
      EXPECT_EQ(r.combined(r.of_centerline.radius), r.of_centerline.radius);
    }
  }
}

TEST(Local_radius, Does_not_depend_on_which_way_the_wall_is_turned) {
  Mesh mesh = round_tube(12, one, 24, 48);
  CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
  const auto local = local_radius(mesh, {{Point(0, 0, 0), Point(0, 0, 12)}});
  EXPECT_NEAR(local.radii(Point(0.9, 0, 6)).of_ball, 1, 0.02);
}

struct Sac {
  double tube, neck, sac, length; // of the neck
};

TEST(Local_radius, Is_that_of_a_sac_and_of_its_neck) {
  for (const Sac& s : {Sac{1, 0.5, 2.4, 0.9}, Sac{1, 0.7, 1.2, 1.6}, Sac{1, 0.35, 0.9, 1}}) {
    const double distance = s.length + s.tube + s.sac; // of the sac's center
    const Implicit f =
        united(vessel(Point(0, 0, -20), Point(0, 0, 20), s.tube),
               united(vessel(Point(0, 0, 0), Point(distance, 0, 0), s.neck), ball(Point(distance, 0, 0), s.sac)));
    const double high = distance + s.sac + 0.5;
    const Mesh mesh = implicit_surface(f, Point(-2, -3, -5), Point(high, 3, 5), 0.1);
    for (double scale : {1., 1e-3})
      for (double angle : {0., 1.}) {
        const Transformation t = rotation(angle) * Transformation(CGAL::SCALING, scale);
        const auto local = local_radius(transformed(mesh, t), {{t(Point(0, 0, -5)), t(Point(0, 0, 5))}});
        const auto at = [&](const Point& p) { return local(t(p)) / scale; };
        for (double z : {-4.5, -3., 3., 4.5})
          EXPECT_NEAR(at(Point(0.9, 0, z)), s.tube, 0.06) << z;
        EXPECT_NEAR(at(Point(s.tube + s.length / 2, s.neck, 0)), s.neck, 0.08 * s.neck);
        for (double a = 0; a < 2.2; a += 0.2)
          for (double turn : {0., 1., 2.5}) {
            const Point p(distance + s.sac * std::cos(a), s.sac * std::sin(a) * std::cos(turn),
                          s.sac * std::sin(a) * std::sin(turn));
            EXPECT_NEAR(at(p), s.sac, 0.04 * s.sac) << a << " " << turn << " " << s.sac;
          }
      }
  }
}

// Two vessels of radius 2, joined by one of radius 0.25 along which no centerline runs.
TEST(Local_radius, Is_that_of_a_vessel_without_a_centerline) {
  const Implicit f =
      united(united(vessel(Point(-4, 0, -20), Point(-4, 0, 20), 2), vessel(Point(4, 0, -20), Point(4, 0, 20), 2)),
             vessel(Point(-4, 0, 0), Point(4, 0, 0), 0.25));
  Mesh mesh = implicit_surface(f, Point(-6.5, -2.5, -6), Point(6.5, 2.5, 6), 0.1);
  tubular::Centerline_polylines lines;
  for (double x : {-4., 4.}) // from one inlet to two ends, past the wall between them
    for (double z : {-6., 6.}) {
      lines.lines.emplace_back();
      for (int i = 0; i <= 100; ++i) {
        lines.lines.back().push_back(lines.points.size());
        lines.points.push_back(Point(x, 0, z * i / 100));
      }
    }
  const tubular::Wall_distance wall(mesh);
  tubular::Centerline_graph graph;
  tubular::build_centerline_graph(lines, wall, graph);
  const tubular::Centerline_field field(graph);
  const tubular::Local_radius local(field, wall);
  for (double x : {-1.2, 0., 0.7, 1.3})
    EXPECT_NEAR(local(Point(x, 0.2, 0.1)), 0.25, 0.03) << x;
  for (double z : {-4., 3.})
    EXPECT_NEAR(local(Point(-4, 1.9, z)), 2, 0.1) << z;
  const tubular::Centerline_sizing_field h(local, tubular::parameters::points_per_circumference(20));
  for (double x : {-1.2, 0., 0.7, 1.3})
    EXPECT_NEAR(h(Point(x, 0.24, 0)), 2 * pi * 0.25 / 20, 0.15 * 2 * pi * 0.25 / 20) << x;
  EXPECT_NEAR(h(Point(-4, 0, 5)), 2 * pi * 2 / 20, 0.05 * 2 * pi * 2 / 20);
}

TEST(Local_radius, Is_not_set_by_a_spike_that_comes_near_the_centerline) {
  Mesh mesh = round_tube(12, one, 30, 60);
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    if (std::abs(p.z() - 6) < 0.05 && p.x() > 0.999)
      mesh.point(v) = Point(0.3, 0, p.z());
  }
  const auto local = local_radius(mesh, {{Point(0, 0, 0), Point(0, 0, 12)}});
  for (double z = 5; z <= 7; z += 0.1)
    for (double a = 0; a < 6; a += 1)
      EXPECT_GT(local(Point(0.95 * std::cos(a), 0.95 * std::sin(a), z)), 0.75) << z << " " << a;
}

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/flow_extensions.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using namespace CGAL::Tubular_meshing;
namespace params = CGAL::Tubular_meshing::parameters;

using namespace test_surfaces;
typedef std::vector<Opening> Openings;

struct Extended {
  Mesh before, mesh;
  Openings openings_before, openings;
  std::vector<double> lengths;
};

template <class Np> Extended extend(const Mesh& mesh, const Np& np) {
  Extended e;
  e.before = e.mesh = mesh;
  e.openings_before = e.openings = find_openings(e.mesh);
  e.lengths = add_flow_extensions(e.mesh, e.openings, np);
  return e;
}
Extended extend(const Mesh& mesh) {
  return extend(mesh, params::default_values());
}

double distance(const Point& p, const Point& q) {
  return std::sqrt(CGAL::squared_distance(p, q));
}

std::size_t number_of_loops(const Mesh& mesh) {
  std::vector<Mesh::Halfedge_index> loops;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(loops));
  return loops.size();
}

std::size_t number_of_crossings(const Mesh& mesh) {
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> crossings;
  PMP::self_intersections(mesh, std::back_inserter(crossings));
  return crossings.size();
}

double volume(const Extended& e) {
  Mesh closed = e.mesh;
  Openings openings = e.openings;
  auto patch = closed.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  close_openings(closed, openings, patch);
  return PMP::volume(closed);
}

double area(const Openings& openings) {
  double sum = 0;
  for (const auto& o : openings)
    sum += o.area;
  return sum;
}

double smallest_angle(const std::vector<Point>& t) {
  double least = 180;
  for (int i = 0; i < 3; ++i) {
    const Vector u = t[(i + 1) % 3] - t[i], v = t[(i + 2) % 3] - t[i];
    const double sine = std::sqrt(CGAL::cross_product(u, v).squared_length());
    least = std::min(least, std::atan2(sine, u * v) * 180 / CGAL_PI);
  }
  return least;
}

// The far ends: plane circles where the openings say.
void check_ends(const Extended& e) {
  for (std::size_t i = 0; i < e.openings.size(); ++i) {
    const Opening &o = e.openings[i], &before = e.openings_before[i];
    EXPECT_EQ(o.patch, before.patch);
    if (e.lengths[i] == 0) {
      EXPECT_EQ(o.center, before.center);
      continue;
    }
    EXPECT_NEAR(o.normal.squared_length(), 1, 1e-12);
    EXPECT_NEAR(o.radius, std::sqrt(o.area / CGAL_PI), 1e-9 * o.radius);
    EXPECT_NEAR(distance(o.center, before.center), e.lengths[i], 0.3 * before.radius) << "opening " << i;
  }
  std::vector<Mesh::Halfedge_index> loops;
  PMP::extract_boundary_cycles(e.mesh, std::back_inserter(loops));
  std::vector<std::size_t> found(e.openings.size(), 0);
  for (auto first : loops) {
    std::size_t nearest = 0;
    Vector sum(0, 0, 0);
    double n = 0;
    for (auto h : CGAL::halfedges_around_face(first, e.mesh)) {
      sum = sum + (e.mesh.point(e.mesh.target(h)) - CGAL::ORIGIN);
      n += 1;
    }
    const Point mean = CGAL::ORIGIN + sum / n;
    for (std::size_t i = 0; i < e.openings.size(); ++i)
      if (distance(mean, e.openings[i].center) < distance(mean, e.openings[nearest].center))
        nearest = i;
    ++found[nearest];
    if (e.lengths[nearest] == 0)
      continue;
    const Opening& o = e.openings[nearest];
    const double tolerance = 1e-9 * (o.radius + distance(o.center, Point(0, 0, 0)));
    for (auto h : CGAL::halfedges_around_face(first, e.mesh)) {
      const Vector v = e.mesh.point(e.mesh.target(h)) - o.center;
      EXPECT_NEAR(v * o.normal, 0, tolerance);
      EXPECT_NEAR(std::sqrt(v.squared_length()),
                  std::sqrt(CGAL::squared_distance(e.mesh.point(e.mesh.target(first)), o.center)), tolerance);
    }
    EXPECT_GE(n, 12);
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(found[i], 1u) << "opening " << i;
}

// The least angle of new triangles without an edge of the rim: theirs is given.
double smallest_inner_angle(const Extended& e) {
  double least = 180;
  for (auto f : e.mesh.faces()) {
    if (std::size_t(f) < e.before.number_of_faces())
      continue;
    std::vector<Point> corners;
    std::size_t on_rim = 0;
    for (auto v : CGAL::vertices_around_face(e.mesh.halfedge(f), e.mesh)) {
      corners.push_back(e.mesh.point(v));
      on_rim += std::size_t(v) < e.before.number_of_vertices();
    }
    if (on_rim < 2)
      least = std::min(least, smallest_angle(corners));
  }
  return least;
}

// What holds of any open surface; returns the least angle of the new triangles, in degrees.
double check_extended(const Extended& e) {
  EXPECT_TRUE(e.mesh.is_valid(false));
  EXPECT_TRUE(CGAL::is_triangle_mesh(e.mesh));
  EXPECT_FALSE(e.mesh.has_garbage());
  EXPECT_EQ(number_of_loops(e.mesh), number_of_loops(e.before));
  const std::size_t crossings = number_of_crossings(e.mesh);
  EXPECT_EQ(crossings, crossings == 0 ? 0 : number_of_crossings(e.before));
  EXPECT_EQ(find_openings(e.mesh).size(), e.openings_before.size());
  EXPECT_EQ(e.lengths.size(), e.openings.size());
  for (auto v : e.before.vertices())
    if (e.before.point(v) != e.mesh.point(v)) {
      ADD_FAILURE() << "vertex " << v << " has moved";
      break;
    }
  check_ends(e);
  double least = 180;
  for (auto f : e.mesh.faces()) {
    if (std::size_t(f) < e.before.number_of_faces())
      continue;
    std::vector<Point> corners;
    for (auto v : CGAL::vertices_around_face(e.mesh.halfedge(f), e.mesh))
      corners.push_back(e.mesh.point(v));
    least = std::min(least, smallest_angle(corners));
  }
  return least;
}

Tube fine_tube() {
  Tube tube;
  tube.sides = 64;
  tube.rings = 40;
  return tube;
}

// The radii of new vertices about the z-axis, least and greatest.
std::pair<double, double> new_radii(const Extended& e) {
  std::pair<double, double> radii(1e9, 0);
  for (auto v : e.mesh.vertices())
    if (std::size_t(v) >= e.before.number_of_vertices()) {
      const Point& p = e.mesh.point(v);
      const double r = std::hypot(p.x(), p.y());
      radii = {std::min(radii.first, r), std::max(radii.second, r)};
    }
  return radii;
}

// --- known truth ---

TEST(Flow_extensions, Tube) {
  const Extended e = extend(make_tube(fine_tube()), params::extension_length(5.));
  EXPECT_GT(check_extended(e), 50);
  const double section = e.openings_before[0].area, radius = std::sqrt(section / CGAL_PI);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(e.lengths[i], 5 * radius, 1e-9);
    EXPECT_NEAR(e.openings[i].area, section, 1e-9 * section);
    EXPECT_NEAR(e.openings[i].center.z(), e.openings[i].normal.z() > 0 ? 8 + 5 * radius : -5 * radius, 1e-9);
    EXPECT_NEAR(std::abs(e.openings[i].normal.z()), 1, 1e-12);
  }
  EXPECT_NEAR(volume(e), (8 + 10 * radius) * section, 1e-3 * volume(e));
  EXPECT_NEAR(PMP::area(e.mesh), PMP::area(e.before) * (8 + 10 * radius) / 8, 1e-3 * PMP::area(e.mesh));
  EXPECT_GE(new_radii(e).first, std::cos(CGAL_PI / 64) - 1e-9); // over the edges of the rim
  EXPECT_NEAR(new_radii(e).second, 1, 1e-9);
}

TEST(Flow_extensions, Lengths) {
  for (double length : {0.1, 0.5, 1., 2., 20.}) {
    const Extended e = extend(make_tube(fine_tube()), params::extension_length(length));
    EXPECT_GT(check_extended(e), length < 0.5 ? 25 : 45) << length;
    EXPECT_NEAR(e.lengths[0], std::max(length, 0.25), length < 0.25 ? 0.01 : 0.001 * e.lengths[0]);
  }
}

TEST(Flow_extensions, Oblique_ends_follow_the_vessel) {
  for (double tilt : {0.3, 1., 1.7}) {
    Tube tube = fine_tube();
    tube.tilt = tilt;
    const Extended e = extend(make_tube(tube));
    EXPECT_GT(check_extended(e), 15) << tilt;
    const std::size_t top = e.openings[0].center.z() > 4 ? 0 : 1;
    EXPECT_GT(e.openings[top].normal.z(), 0.9999) << tilt;
    EXPECT_NEAR(new_radii(e).first, 1, 0.01) << tilt;
    EXPECT_NEAR(new_radii(e).second, 1, 0.01) << tilt;
    EXPECT_NEAR(e.openings[top].area, CGAL_PI, 0.01) << tilt;
    EXPECT_NEAR(volume(e), CGAL_PI * (8 + 10), 0.01 * volume(e)) << tilt;
  }
}

TEST(Flow_extensions, Bent_tube_goes_on_along_its_tangent) {
  Tube tube = fine_tube();
  Mesh mesh = make_tube(tube);
  const double bend = 5; // a quarter circle in the plane y = 0
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    const double angle = p.z() / bend;
    mesh.point(v) = Point(bend - (bend - p.x()) * std::cos(angle), p.y(), (bend - p.x()) * std::sin(angle));
  }
  const Extended e = extend(mesh, params::extension_length(3.));
  EXPECT_GT(check_extended(e), 30);
  for (const auto& o : e.openings) {
    const Vector tangent = o.normal.z() < -0.5 ? Vector(0, 0, -1) : Vector(std::sin(8 / bend), 0, std::cos(8 / bend));
    EXPECT_GT(o.normal * tangent, std::cos(5 * CGAL_PI / 180)); // a radius behind the rim it has turned by 11 degrees
  }
}

TEST(Flow_extensions, Square_duct_becomes_round) {
  Tube tube;
  tube.sides = 32;
  Mesh mesh = make_tube(tube);
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    const double s = 1 / std::max(std::abs(p.x()), std::abs(p.y()));
    mesh.point(v) = Point(s * p.x(), s * p.y(), p.z());
  }
  const Extended e = extend(mesh);
  EXPECT_GT(check_extended(e), 25);
  for (const auto& o : e.openings) {
    EXPECT_NEAR(o.area, 4, 1e-9);
    EXPECT_NEAR(std::abs(o.normal.z()), 1, 1e-9);
  }
  EXPECT_NEAR(volume(e), 4 * (8 + 10 * std::sqrt(4 / CGAL_PI)), 0.01 * volume(e));
}

TEST(Flow_extensions, Ellipse_becomes_round) {
  Tube tube = fine_tube();
  tube.rx = 3;
  const Extended e = extend(make_tube(tube));
  EXPECT_GT(check_extended(e), 15);
  EXPECT_NEAR(e.openings[0].area, 3 * CGAL_PI, 0.02 * 3 * CGAL_PI);
}

TEST(Flow_extensions, Coarse_rims) {
  for (int sides : {3, 4, 5, 6, 8}) {
    Tube tube;
    tube.sides = sides;
    tube.rings = 5;
    const Extended e = extend(make_tube(tube));
    EXPECT_GT(check_extended(e), 10) << sides;
    const double section = sides / 2. * std::sin(2 * CGAL_PI / sides);
    EXPECT_NEAR(e.openings[0].area, section, 1e-9) << sides;
    EXPECT_NEAR(e.openings[1].area, section, 1e-9) << sides;
  }
}

TEST(Flow_extensions, Uneven_rims) { // from 1 to 20, and tiny edges between long ones
  for (bool alternating : {false, true}) {
    Mesh mesh = make_tube(fine_tube());
    for (auto v : mesh.vertices()) {
      const Point p = mesh.point(v);
      double a = std::atan2(p.y(), p.x());
      if (alternating)
        a += int(std::lround((a + 4) * 32 / CGAL_PI)) % 2 == 0 ? 0.04 : -0.04;
      else
        a += 0.9 * std::sin(a);
      mesh.point(v) = Point(std::cos(a), std::sin(a), p.z());
    }
    const Extended e = extend(mesh);
    check_extended(e);
    EXPECT_NEAR(e.openings[0].area, CGAL_PI, 0.02);
    EXPECT_NEAR(volume(e), CGAL_PI * (8 + 10), 0.02 * volume(e));
  }
}

TEST(Flow_extensions, Noisy_rims) {
  std::mt19937 random(3);
  for (double amplitude : {0.02, 0.05, 0.1}) {
    std::uniform_real_distribution<double> noise(-amplitude, amplitude);
    Tube tube;
    tube.sides = 40;
    tube.rings = 50;
    Mesh mesh = make_tube(tube);
    for (auto v : mesh.vertices()) {
      const Point p = mesh.point(v);
      const bool on_rim = mesh.is_border(v);
      const double r = on_rim ? noise(random) : 0, z = noise(random);
      mesh.point(v) = Point((1 + r / 2) * p.x(), (1 + r / 2) * p.y(), p.z() + (on_rim ? z : 0));
    }
    const Extended e = extend(mesh);
    check_extended(e);
    EXPECT_GT(std::abs(e.openings[0].normal.z()), 0.99);
    EXPECT_NEAR(volume(e), CGAL_PI * (8 + 10), 0.03 * volume(e));
  }
}

TEST(Flow_extensions, Saddle_shaped_rim) {
  Tube tube = fine_tube();
  tube.sag = [](double angle) { return 0.6 * std::cos(2 * angle); };
  const Extended e = extend(make_tube(tube));
  EXPECT_GT(check_extended(e), 15);
  EXPECT_NEAR(new_radii(e).first, 1, 0.01);
  EXPECT_NEAR(volume(e), CGAL_PI * (8 + 10), 0.01 * volume(e));
}

TEST(Flow_extensions, Caps_are_replaced) {
  Tube tube = fine_tube();
  tube.bottom = End::fan;
  tube.top = End::fine;
  for (const Mesh& mesh : {make_tube(tube), shuffled(make_tube(tube), 5)}) {
    const Extended e = extend(mesh);
    EXPECT_TRUE(e.mesh.is_valid(false));
    EXPECT_FALSE(e.mesh.has_garbage());
    EXPECT_EQ(number_of_loops(e.mesh), 2u);
    EXPECT_EQ(number_of_crossings(e.mesh), 0u);
    check_ends(e);
    EXPECT_NEAR(volume(e), CGAL_PI * (8 + 10), 0.005 * volume(e));
  }
}

TEST(Flow_extensions, Some_openings_only) {
  Tube tube = fine_tube();
  tube.top = End::fan;
  const Mesh mesh = make_tube(tube);
  const Extended e = extend(mesh, params::extension_length(2.).extended_openings(std::vector<std::size_t>{1}));
  EXPECT_EQ(e.lengths[0], 0);
  EXPECT_NEAR(e.lengths[1], 2, 0.01);
  EXPECT_EQ(e.openings[0].center, e.openings_before[0].center);
  const Extended none = extend(mesh, params::extended_openings(std::vector<std::size_t>()));
  EXPECT_EQ(none.mesh.number_of_faces(), mesh.number_of_faces());
}

TEST(Flow_extensions, Y_bifurcation_inside_out_and_turned) {
  const Mesh mesh = [] {
    Mesh m;
    generate_tubular_surface(y_bifurcation(), m);
    return m;
  }();
  const Extended e = extend(mesh);
  const double least = check_extended(e);
  EXPECT_GT(least, 20);
  ASSERT_EQ(e.openings.size(), 3u);

  Mesh turned = transformed(mesh, rotation(1));
  for (auto v : turned.vertices())
    turned.point(v) = Point(0, 0, 0) + 1e-3 * (turned.point(v) - CGAL::ORIGIN);
  PMP::reverse_face_orientations(turned);
  const Extended f = extend(turned);
  EXPECT_NEAR(volume(f), 1e-9 * volume(e), 1e-9 * 1e-6 * volume(e));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(f.lengths[i], 1e-3 * e.lengths[i], 1e-9 * e.lengths[i]);
}

TEST(Flow_extensions, Same_twice) {
  Mesh mesh;
  generate_tubular_surface(y_bifurcation(), mesh);
  const Extended a = extend(mesh), b = extend(mesh);
  ASSERT_EQ(a.mesh.number_of_vertices(), b.mesh.number_of_vertices());
  for (auto v : a.mesh.vertices())
    EXPECT_EQ(a.mesh.point(v), b.mesh.point(v));
}

TEST(Flow_extensions, Property_maps_stay) {
  Mesh mesh = make_tube(fine_tube());
  auto mark = mesh.add_property_map<Mesh::Face_index, int>("f:mark", 7).first;
  mark[Mesh::Face_index(3)] = 8;
  Openings openings = find_openings(mesh);
  add_flow_extensions(mesh, openings);
  EXPECT_EQ(mark[Mesh::Face_index(3)], 8);
  EXPECT_EQ(mark[*std::prev(mesh.faces().end())], 7);
}

// --- in the way ---

Mesh two_tubes_facing(double gap) {
  Mesh mesh = make_tube(fine_tube());
  append(mesh, make_tube(fine_tube()), Transformation(CGAL::TRANSLATION, Vector(0, 0, 8 + gap)));
  return mesh;
}

TEST(Flow_extensions, Two_that_meet_share_the_space) {
  const Extended e = extend(two_tubes_facing(6), params::extension_length(4.));
  check_extended(e);
  double shared = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (e.openings_before[i].center.z() > 7 && e.openings_before[i].center.z() < 15) {
      EXPECT_GT(e.lengths[i], 1.4);
      shared += e.lengths[i];
    } else
      EXPECT_NEAR(e.lengths[i], 4, 0.01);
  EXPECT_GT(shared, 3);
  EXPECT_LT(shared, 6);
}

void expect_refusal(const Mesh& mesh, double min_length, const std::string& what) {
  Mesh tried = mesh;
  Openings openings = find_openings(tried);
  const Openings before = openings;
  try {
    add_flow_extensions(tried, openings, params::extension_length(4.).min_extension_length(min_length));
    ADD_FAILURE() << "not refused";
  } catch (const Meshing_error& error) {
    EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("opening "), std::string::npos) << error.what();
  }
  EXPECT_EQ(tried.number_of_faces(), mesh.number_of_faces());
  for (std::size_t i = 0; i < openings.size(); ++i)
    EXPECT_EQ(openings[i].center, before[i].center);
}

TEST(Flow_extensions, Two_that_meet_are_refused) {
  expect_refusal(two_tubes_facing(6), 4, "would run into the extension of opening");
  expect_refusal(two_tubes_facing(1), 1, "would run into the extension of opening");
}

TEST(Flow_extensions, Wall_in_the_way) {
  Mesh mesh = make_tube(fine_tube());
  append(mesh, make_sphere(20, 20), Transformation(CGAL::TRANSLATION, Vector(0.3, 0, 12))); // its south pole at z = 11
  const Extended e = extend(mesh, params::extension_length(4.));
  EXPECT_EQ(number_of_crossings(e.mesh), 0u);
  for (std::size_t i = 0; i < 2; ++i)
    if (e.openings[i].normal.z() > 0) {
      EXPECT_GT(e.lengths[i], 2.3);
      EXPECT_LT(e.lengths[i], 3);
    }
  expect_refusal(mesh, 4, "would run into the wall");
}

TEST(Flow_extensions, Small_thing_inside) { // does not touch the tube's own triangles
  Mesh mesh = make_tube(fine_tube());
  append(mesh, make_sphere(8, 8), Transformation(0.1, 0, 0, 0.2, 0, 0.1, 0, 0, 0, 0, 0.1, 10.33));
  expect_refusal(mesh, 4, "would run into the wall");
}

TEST(Flow_extensions, Hook) { // 300 degrees of a circle: each end looks at the other's wall
  Mesh mesh;
  generate_tubular_surface(curved_tube(4, 5.2, 1), mesh);
  const Extended e = extend(mesh, params::extension_length(8.).min_extension_length(0.));
  check_extended(e);
}

TEST(Flow_extensions, Parameters) {
  Mesh mesh = make_tube(Tube());
  Openings openings = find_openings(mesh);
  EXPECT_THROW(add_flow_extensions(mesh, openings, params::extension_length(0.)), Parameter_error);
  EXPECT_THROW(add_flow_extensions(mesh, openings, params::extension_length(std::nan(""))), Parameter_error);
  EXPECT_THROW(add_flow_extensions(mesh, openings, params::extension_length(1e4)), Parameter_error);
  EXPECT_THROW(add_flow_extensions(mesh, openings, params::extension_length(1.).min_extension_length(2.)),
               Parameter_error);
  EXPECT_THROW(add_flow_extensions(mesh, openings, params::extended_openings(std::vector<std::size_t>{2})),
               Parameter_error);
  openings.pop_back();
  EXPECT_THROW(add_flow_extensions(mesh, openings), Input_error);
}

// --- real files ---

class Real_file : public ::testing::TestWithParam<const char*> {};

TEST_P(Real_file, Is_extended) {
#ifdef TUBULAR_MESHING_SHARED_DATA
  const std::string file = std::string(TUBULAR_MESHING_SHARED_DATA) + "/" + GetParam();
#else
  const std::string file = std::string("shared data/") + GetParam();
#endif
  if (!std::ifstream(file))
    GTEST_SKIP() << file << " is not there";
  Mesh mesh;
  IO::read_surface(file, mesh);
  const Openings openings = find_openings(mesh);
  const auto start = std::chrono::steady_clock::now();
  const Extended e = extend(mesh, params::extension_length(5.).min_extension_length(0.));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const bool open = number_of_loops(mesh) >= openings.size();
  const double least = open ? check_extended(e) : -1;
  if (!open) {
    EXPECT_EQ(number_of_loops(e.mesh), openings.size());
    check_ends(e);
  }
  std::size_t shortened = 0;
  for (std::size_t i = 0; i < e.openings.size(); ++i) {
    shortened += e.lengths[i] < 4.99 * e.openings[i].radius;
    // never a turn: out of the vessel
    EXPECT_GT(e.openings[i].normal * e.openings_before[i].normal, 0.5) << "opening " << i;
  }
  EXPECT_GT(PMP::area(e.mesh), PMP::area(mesh) - area(openings));
  std::printf("%s: %zu openings, %zu shortened, least angle %.1f, away from rims %.1f, %.2f s\n", GetParam(),
              openings.size(), shortened, least, open ? smallest_inner_angle(e) : -1, seconds);
}

INSTANTIATE_TEST_SUITE_P(Flow_extensions, Real_file,
                         ::testing::Values("paper/aorta.stl", "paper/carotid.stl", "paper/cerebral.stl",
                                           "paper/bypass.stl", "paper/cylemi.stl", "trees/airway_lf_open.vtp",
                                           "trees/sofa_LCA.stl", "trees/sofa_carotids.stl",
                                           "trees/sofa_phantom_network.obj"));

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using namespace CGAL::Tubular_meshing;
namespace params = CGAL::Tubular_meshing::parameters;

using namespace test_surfaces;
typedef std::vector<Opening> Openings;

// --- centerlines ---

typedef Centerline_graph Graph;

Graph line_graph(const Point& from, const Point& to, double radius, std::size_t root = 0) {
  std::vector<Point> points;
  for (int i = 0; i <= 10; ++i)
    points.push_back(from + (i / 10.) * (to - from));
  std::vector<std::size_t> line(points.size());
  std::iota(line.begin(), line.end(), std::size_t(0));
  Graph graph(points, std::vector<double>(points.size(), radius), {line});
  graph.direct_from(root);
  return graph;
}

// --- checks ---

double diagonal(const Mesh& mesh) {
  const CGAL::Bbox_3 b = PMP::bbox(mesh);
  return std::sqrt(CGAL::square(b.x_span()) + CGAL::square(b.y_span()) + CGAL::square(b.z_span()));
}

Vector normal(Mesh::Face_index f, const Mesh& mesh) {
  const auto h = mesh.halfedge(f);
  const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
              &c = mesh.point(mesh.target(mesh.next(h)));
  return CGAL::cross_product(b - a, c - a) / 2;
}

struct Closed {
  Mesh mesh;
  Openings openings;
  Mesh::Property_map<Mesh::Face_index, int> patch;
};

template <class... Np> Closed close(const Mesh& mesh, const Np&... np) {
  Closed result;
  result.mesh = mesh;
  result.openings = find_openings(result.mesh, np...);
  result.patch = result.mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  close_openings(result.mesh, result.openings, result.patch);
  return result;
}

void check_closed(const Closed& closed) {
  const Mesh& mesh = closed.mesh;
  ASSERT_TRUE(mesh.is_valid(false));
  ASSERT_FALSE(mesh.has_garbage());
  ASSERT_TRUE(CGAL::is_closed(mesh));
  ASSERT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_GT(PMP::volume(mesh), 0);
  const double size = diagonal(mesh);
  std::vector<double> area(closed.openings.size(), 0.), off_plane = area, off_normal = area;
  for (auto f : mesh.faces()) {
    const int label = closed.patch[f];
    ASSERT_GE(label, labels::wall);
    ASSERT_LT(label, labels::of_opening(int(closed.openings.size())));
    if (label == labels::wall)
      continue;
    const std::size_t i = label - labels::inlet;
    const Opening& o = closed.openings[i];
    EXPECT_EQ(o.patch, label);
    const Vector n = normal(f, mesh);
    const double length = std::sqrt(n.squared_length());
    area[i] += length;
    EXPECT_GT(length, 1e-12 * o.area);
    EXPECT_GT(n * o.normal, 0.99 * length) << "a face of cap " << i << " is turned over";
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      off_plane[i] = std::max(off_plane[i], std::abs((mesh.point(v) - o.center) * o.normal));
  }
  for (std::size_t i = 0; i < area.size(); ++i) {
    EXPECT_LT(off_plane[i], 1e-9 * size) << "cap " << i;
    EXPECT_NEAR(area[i], closed.openings[i].area, 1e-9 * area[i]) << "cap " << i;
    EXPECT_NEAR(closed.openings[i].normal.squared_length(), 1, 1e-12);
    EXPECT_NEAR(closed.openings[i].radius, std::sqrt(area[i] / CGAL_PI), 1e-9 * closed.openings[i].radius);
  }
}

// The wall of a tube along z, wherever it ends, looks away from the axis, as it did before.
void check_tube_wall(const Closed& closed, const Tube& tube) {
  const Mesh& mesh = closed.mesh;
  for (auto f : mesh.faces())
    if (closed.patch[f] == labels::wall) {
      const Vector n = normal(f, mesh);
      const auto h = mesh.halfedge(f);
      const Point c =
          CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
      const Vector out(c.x() / (tube.rx * tube.rx), c.y() / (tube.ry * tube.ry), 0);
      EXPECT_GT(n * out, 0.7 * std::sqrt(n.squared_length() * out.squared_length())) << "at " << c;
    }
}

void check_no_self_intersection(const Closed& closed) {
  EXPECT_FALSE(PMP::does_self_intersect(closed.mesh));
  EXPECT_TRUE(PMP::is_outward_oriented(closed.mesh));
}

// --- open tubes ---

TEST(Openings, Of_a_round_tube) {
  const Openings openings = find_openings(make_tube(Tube()));
  ASSERT_EQ(openings.size(), 2u);
  for (const auto& o : openings) {
    const double area = 10 * std::sin(2 * CGAL_PI / 20);
    EXPECT_NEAR(o.area, area, 1e-12);
    EXPECT_NEAR(o.perimeter, 40 * std::sin(CGAL_PI / 20), 1e-12);
    EXPECT_NEAR(o.radius, std::sqrt(area / CGAL_PI), 1e-12);
    EXPECT_NEAR(CGAL::squared_distance(o.center, Point(0, 0, o.center.z() < 4 ? 0 : 8)), 0, 1e-20);
    EXPECT_NEAR(o.normal.z(), o.center.z() < 4 ? -1 : 1, 1e-12);
    EXPECT_EQ(o.branch, o.no_branch);
  }
  EXPECT_EQ(openings[0].patch, labels::inlet);
  EXPECT_EQ(openings[1].patch, labels::first_outlet);
}

TEST(Openings, Centre_is_that_of_the_area_not_of_the_vertices) {
  Mesh mesh = make_tube(Tube());
  auto loops = internal::border_loops(mesh); // a rim with many more vertices on one side
  for (auto& loop : loops)
    for (int i = 0; i < 4; ++i) {
      const auto h = CGAL::Euler::split_edge(loop.rim[0], mesh);
      mesh.point(mesh.target(h)) = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(loop.rim[0])));
      CGAL::Euler::split_face(mesh.opposite(loop.rim[0]), mesh.next(mesh.next(mesh.opposite(loop.rim[0]))), mesh);
    }
  for (const auto& o : find_openings(mesh)) {
    EXPECT_NEAR(o.center.x(), 0, 1e-12);
    EXPECT_NEAR(o.center.y(), 0, 1e-12);
  }
}

struct Rim_case {
  int sides;
  double sag;
  int waves;
};

class Sagging_rim : public testing::TestWithParam<Rim_case> {};

TEST_P(Sagging_rim, Becomes_a_planar_cap) {
  const Rim_case c = GetParam();
  for (double ry : {1., 0.5})
    for (double tilt : {0., 0.5}) {
      Tube tube;
      tube.sides = c.sides;
      tube.rings = c.sides == 64 ? 60 : 12;
      tube.ry = ry;
      tube.tilt = tilt;
      tube.sag = [&](double angle) { return c.sag * ry * std::cos(c.waves * angle + 0.3); };
      for (double turn : {0., 0.7}) {
        const Closed closed = close(transformed(make_tube(tube), rotation(turn)));
        ASSERT_EQ(closed.openings.size(), 2u);
        check_closed(closed);
        check_no_self_intersection(closed);
        if (turn == 0) {
          check_tube_wall(closed, tube);
          double lowest = 8;
          for (auto v : closed.mesh.vertices())
            lowest = std::min(lowest, closed.mesh.point(v).z());
          EXPECT_EQ(lowest, 0);
        }
        for (const auto& o : tilt == 0 ? closed.openings : Openings())
          EXPECT_NEAR(o.radius, std::sqrt(c.sides / 2. * std::sin(2 * CGAL_PI / c.sides) * ry / CGAL_PI), 0.03);
      }
    }
}

std::vector<Rim_case> rim_cases() {
  std::vector<Rim_case> cases;
  for (int sides : {6, 8, 20, 64})
    for (double sag : {0., 0.05, 0.1, 0.19, 0.3, 0.6})
      cases.push_back({sides, sag, 2});
  cases.push_back({64, 0.05, 31}); // a zigzag
  cases.push_back({20, 0.15, 9});
  cases.push_back({20, 0.4, 3});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Tubes, Sagging_rim, testing::ValuesIn(rim_cases()), [](const auto& info) {
  return "sides" + std::to_string(info.param.sides) + "_sag" + std::to_string(int(100 * info.param.sag + 0.5)) +
         "_waves" + std::to_string(info.param.waves);
});

TEST(Openings, Little_sag_is_flattened_without_losing_length_and_much_is_trimmed) {
  Tube tube;
  tube.sag = [](double angle) { return 0.15 * std::cos(2 * angle); };
  const std::size_t faces = make_tube(tube).number_of_faces();
  Closed flattened = close(make_tube(tube));
  EXPECT_EQ(flattened.mesh.number_of_faces(), faces + 2 * 18);
  EXPECT_NEAR(PMP::volume(flattened.mesh), 8 * flattened.openings[0].area, 1e-2);
  tube.sag = [](double angle) { return 0.5 * std::cos(2 * angle); };
  Closed trimmed = close(make_tube(tube));
  EXPECT_NEAR(PMP::volume(trimmed.mesh), 7.45 * trimmed.openings[0].area, 1e-2 * 8);
}

TEST(Openings, Straight_sides_of_a_rim_give_no_degenerate_triangles) {
  Mesh mesh = make_tube([] {
    Tube tube;
    tube.sides = 6;
    return tube;
  }());
  for (const auto& loop : internal::border_loops(mesh))
    for (auto h : loop.rim) {
      const Point middle = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
      const auto split = CGAL::Euler::split_edge(mesh.opposite(h), mesh);
      mesh.point(mesh.target(split)) = middle;
      CGAL::Euler::split_face(split, mesh.next(mesh.next(split)), mesh);
    }
  for (double turn : {0., 0.3, 1.1}) {
    const Closed closed = close(transformed(mesh, rotation(turn)));
    check_closed(closed);
    check_no_self_intersection(closed);
  }
}

TEST(Openings, Ears_and_non_convex_rims) {
  Tube tube;
  tube.sides = 24;
  Mesh mesh = make_tube(tube);
  for (auto v : mesh.vertices()) { // the cross-section of a clover
    const Point p = mesh.point(v);
    const double r = 1 + 0.45 * std::cos(3 * std::atan2(p.y(), p.x()));
    mesh.point(v) = Point(r * p.x(), r * p.y(), p.z());
  }
  std::vector<Mesh::Halfedge_index> rim = internal::border_loops(mesh)[0].rim;
  for (std::size_t i = 0; i < rim.size(); i += 5) { // ears outside the rim
    const auto a = mesh.source(rim[i]), b = mesh.target(rim[i]);
    const Point m = CGAL::midpoint(mesh.point(a), mesh.point(b));
    mesh.add_face(a, b, mesh.add_vertex(Point(m.x(), m.y(), m.z() + (m.z() > 4 ? 0.1 : -0.1))));
  }
  const Closed closed = close(mesh);
  ASSERT_EQ(closed.openings.size(), 2u);
  check_closed(closed);
  check_no_self_intersection(closed);
  EXPECT_NEAR(closed.openings[0].area, closed.openings[1].area, 1e-9);
}

TEST(Openings, Ragged_rims_of_coarse_tubes_are_trimmed) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    Tube tube;
    tube.sides = 8;
    tube.rings = 6; // triangles longer than the radius
    Mesh mesh = make_tube(tube);
    std::vector<Mesh::Face_index> at_border;
    for (auto h : mesh.halfedges())
      if (mesh.is_border(h))
        at_border.push_back(mesh.face(mesh.opposite(h)));
    for (auto f : at_border)
      if (random() % 2)
        CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
    mesh.collect_garbage();
    const Closed closed = close(mesh);
    ASSERT_EQ(closed.openings.size(), 2u);
    check_closed(closed);
    check_no_self_intersection(closed);
    check_tube_wall(closed, tube);
    EXPECT_GT(PMP::volume(closed.mesh), 2.8 * 3);
  }
}

TEST(Openings, Inside_out_surfaces_are_turned) {
  for (End end : {End::open, End::fan}) {
    Tube tube;
    tube.bottom = tube.top = end;
    Mesh mesh = make_tube(tube);
    PMP::reverse_face_orientations(mesh);
    for (const auto& o : find_openings(mesh))
      EXPECT_NEAR(o.normal.z(), o.center.z() < 4 ? -1 : 1, 1e-12);
    const Closed closed = close(mesh);
    check_closed(closed);
    check_no_self_intersection(closed);
  }
}

TEST(Openings, Same_in_any_unit_and_far_from_the_origin) {
  Tube tube;
  tube.sag = [](double angle) { return 0.12 * std::cos(2 * angle); };
  tube.bottom = End::fine;
  tube.tilt = 0.3; // so that the ends are not alike
  const Closed reference = close(make_tube(tube));
  for (double scale : {1e-6, 1e-3, 1e3, 1e6})
    for (double shift : {0., 1000.}) {
      const Transformation t = Transformation(CGAL::SCALING, scale) *
                               Transformation(CGAL::TRANSLATION, Vector(shift, -shift, shift)) * rotation(0.5);
      const Closed closed = close(transformed(make_tube(tube), t));
      check_closed(closed);
      ASSERT_EQ(closed.openings.size(), 2u);
      EXPECT_EQ(closed.mesh.number_of_faces(), reference.mesh.number_of_faces());
      for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(closed.openings[i].radius, scale * reference.openings[i].radius, 1e-9 * scale);
        EXPECT_NEAR(CGAL::squared_distance(closed.openings[i].center, t(reference.openings[i].center)), 0,
                    CGAL::square(1e-9 * scale));
      }
    }
}

TEST(Openings, Pinholes_are_filled_as_wall) {
  Mesh mesh = make_tube(Tube());
  CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(100)), mesh);
  const Closed closed = close(mesh);
  EXPECT_EQ(closed.openings.size(), 2u);
  check_closed(closed);
  check_no_self_intersection(closed);
}

// --- closed tubes ---

struct Cap_case {
  int sides;
  End kind;
  double dish, noise;
};

class Capped_tube : public testing::TestWithParam<Cap_case> {};

TEST_P(Capped_tube, Has_its_ends_recognised) {
  const Cap_case c = GetParam();
  Tube tube;
  tube.sides = c.sides;
  tube.dish = c.dish;
  tube.noise = c.noise;
  for (bool mixed : {false, true}) {
    tube.bottom = mixed ? End::open : c.kind;
    tube.top = c.kind;
    for (double turn : {0., 0.7}) {
      const Mesh mesh = transformed(make_tube(tube), rotation(turn));
      const Closed closed = close(mesh);
      ASSERT_EQ(closed.openings.size(), 2u);
      check_closed(closed);
      check_no_self_intersection(closed);
      if (turn == 0)
        check_tube_wall(closed, tube);
      if (!mixed && c.noise == 0) {
        EXPECT_EQ(closed.mesh.number_of_faces(), mesh.number_of_faces()) << "caps are kept";
      }
    }
  }
}

std::vector<Cap_case> cap_cases() {
  std::vector<Cap_case> cases;
  for (int sides : {6, 8, 20, 64})
    for (End kind : {End::fan, End::fine})
      for (double dish : {0., 0.03})
        cases.push_back({sides, kind, dish, dish == 0 ? 0 : 0.003});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Tubes, Capped_tube, testing::ValuesIn(cap_cases()), [](const auto& info) {
  return "sides" + std::to_string(info.param.sides) + (info.param.kind == End::fan ? "_fan" : "_fine") +
         (info.param.dish > 0 ? "_dished" : "_flat");
});

TEST(Openings, Tilted_caps_are_recognised) {
  Tube tube;
  tube.bottom = tube.top = End::fine;
  tube.tilt = 0.8;
  const Closed closed = close(make_tube(tube));
  ASSERT_EQ(closed.openings.size(), 2u);
  check_closed(closed);
}

TEST(Openings, None_on_spheres_tori_and_boxes) {
  for (const Mesh& mesh : {make_sphere(6, 8), make_sphere(20, 40), make_torus(12, 8), make_torus(6, 6),
                           make_torus(60, 20), make_square_duct()})
    EXPECT_THROW(find_openings(mesh), Input_error) << mesh.number_of_faces() << " faces";
}

TEST(Openings, Flat_patches_and_noise_of_the_wall_are_no_openings) {
  std::mt19937 random(3);
  for (int sides : {8, 20, 64})
    for (double noise : {0.01, 0.05}) {
      Tube tube;
      tube.sides = sides;
      tube.rings = sides == 64 ? 80 : 20;
      Mesh mesh = make_tube(tube);
      std::uniform_real_distribution<double> shift(1 - noise, 1 + noise);
      for (auto v : mesh.vertices()) {
        const Point p = mesh.point(v);
        const double s = mesh.is_border(v) ? 1 : shift(random);
        mesh.point(v) = Point(std::min(s * p.x(), 0.8), s * p.y(), p.z()); // a side that is cut flat
      }
      EXPECT_EQ(find_openings(mesh).size(), 2u) << sides << " sides, noise " << noise;
    }
}

// --- with centerlines ---

TEST(Openings, Are_matched_to_the_ends_of_centerlines) {
  for (End kind : {End::open, End::fan}) {
    Tube tube;
    tube.bottom = tube.top = kind;
    const Mesh mesh = make_tube(tube);
    for (double overshoot : {-0.8, 0., 6.}) { // short of the ends, and through them as with flow extensions
      const Graph graph = line_graph(Point(0.1, 0, -overshoot), Point(0, 0.1, 8 + overshoot), 1, 1);
      const Openings openings = find_openings(mesh, params::centerline_graph(std::cref(graph)));
      ASSERT_EQ(openings.size(), 2u);
      EXPECT_NEAR(openings[0].center.z(), 8, 1e-9) << "the root is the inlet";
      EXPECT_EQ(openings[0].node, 1u);
      EXPECT_EQ(openings[1].node, 0u);
      EXPECT_EQ(openings[0].branch, 0u);
      EXPECT_EQ(openings[1].branch, 0u);
    }
  }
}

TEST(Openings, Square_ducts_need_centerlines) {
  const Graph graph = line_graph(Point(0, 0, 0.1), Point(0, 0, 7.9), 0);
  Closed closed = close(make_square_duct(), params::centerline_graph(std::cref(graph)));
  ASSERT_EQ(closed.openings.size(), 2u);
  EXPECT_NEAR(closed.openings[0].center.z(), 0, 1e-12);
  EXPECT_NEAR(closed.openings[1].center.z(), 8, 1e-12);
  check_closed(closed);
}

TEST(Openings, Centerlines_of_another_geometry_are_refused) {
  const Graph graph = line_graph(Point(50, 0, 0), Point(50, 0, 8), 1);
  for (End kind : {End::open, End::fan}) {
    Tube tube;
    tube.bottom = tube.top = kind;
    EXPECT_THROW(find_openings(make_tube(tube), params::centerline_graph(std::cref(graph))), Input_error);
  }
}

struct Centerlines_case {
  const char *surface, *centerlines;
};

class Real_centerlines : public testing::TestWithParam<Centerlines_case> {};

TEST_P(Real_centerlines, End_at_the_openings) {
#ifndef TUBULAR_MESHING_SHARED_DATA
  GTEST_SKIP() << "needs shared/data/" << GetParam().centerlines;
#else
  const std::string folder = std::string(TUBULAR_MESHING_SHARED_DATA) + "/";
  if (!std::ifstream(folder + GetParam().centerlines) || !std::ifstream(folder + GetParam().surface))
    GTEST_SKIP() << "needs shared/data/" << GetParam().centerlines;
  Mesh mesh;
  CGAL::Tubular_meshing::IO::read_surface(folder + GetParam().surface, mesh);
  Centerline_polylines lines;
  CGAL::Tubular_meshing::IO::read_centerlines(folder + GetParam().centerlines, lines);
  Graph graph;
  build_centerline_graph(lines, Wall_distance(mesh), graph);

  const Openings open = find_openings(mesh, params::centerline_graph(std::cref(graph)));
  std::vector<std::size_t> nodes;
  for (const auto& o : open) {
    ASSERT_NE(o.node, o.no_branch) << o.center;
    EXPECT_TRUE(graph.nodes()[o.node].is_end());
    EXPECT_EQ(graph.nodes()[o.node].branches[0], o.branch);
    nodes.push_back(o.node);
  }
  EXPECT_EQ(nodes[0], graph.root());
  EXPECT_TRUE(std::is_sorted(nodes.begin() + 1, nodes.end()));
  EXPECT_EQ(std::set<std::size_t>(nodes.begin(), nodes.end()).size(), open.size());

  // and so they do when the surface is closed
  const Closed closed = close(mesh, params::centerline_graph(std::cref(graph)));
  const Openings capped = find_openings(closed.mesh, params::centerline_graph(std::cref(graph)));
  ASSERT_EQ(capped.size(), open.size());
  for (std::size_t i = 0; i < capped.size(); ++i) {
    EXPECT_EQ(capped[i].node, open[i].node);
    EXPECT_EQ(capped[i].patch, open[i].patch);
  }
#endif
}

INSTANTIATE_TEST_SUITE_P(Shared_data, Real_centerlines,
                         testing::Values(Centerlines_case{"paper/aorta.stl", "paper/centerlinesAORTA.vtk"},
                                         Centerlines_case{"paper/bypass.stl", "paper/centerlinesBYPASS.msh"},
                                         Centerlines_case{"paper/carotid.stl", "paper/centerlinesCAROTID.vtk"},
                                         Centerlines_case{"paper/cerebral.stl", "paper/centerlinesCEREBRAL.vtk"}),
                         [](const auto& info) {
                           const std::string name = info.param.surface;
                           return name.substr(6, name.size() - 10);
                         });

// --- order ---

Mesh five_tubes() {
  Mesh mesh;
  const double radii[] = {1, 1.5, 0.7, 1, 0.7};
  for (int i = 0; i < 5; ++i) {
    Tube tube;
    tube.rx = tube.ry = radii[i];
    tube.length = 6 + i;
    tube.rings = 10;
    tube.top = i % 2 ? End::fan : End::open;
    append(mesh, make_tube(tube), Transformation(CGAL::TRANSLATION, Vector(4 * i, 0.3 * i * i, 0.1 * i)));
  }
  return mesh;
}

TEST(Openings, Order_survives_motions_scaling_and_renumbering) {
  const Mesh mesh = five_tubes();
  const Openings reference = find_openings(mesh);
  ASSERT_EQ(reference.size(), 10u);
  EXPECT_NEAR(reference[0].radius, 1.5, 0.05);
  for (std::size_t i = 2; i < reference.size(); ++i)
    EXPECT_LE(reference[i].area, reference[i - 1].area + 1e-9);
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Transformation t = Transformation(CGAL::SCALING, std::pow(10., int(seed) - 2)) * rotation(0.9 * seed) *
                             Transformation(CGAL::TRANSLATION, Vector(seed * 10., 3, 1));
    const Openings openings = find_openings(shuffled(transformed(mesh, t), seed));
    ASSERT_EQ(openings.size(), reference.size());
    for (std::size_t i = 0; i < openings.size(); ++i) {
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(openings[i].center, t(reference[i].center))), 0,
                  1e-9 * diagonal(mesh) * std::pow(10., int(seed) - 2))
          << "opening " << i;
      EXPECT_EQ(openings[i].patch, labels::of_opening(int(i)));
    }
  }
}

TEST(Openings, Inlet_is_the_one_nearest_to_the_point) {
  const Mesh mesh = five_tubes();
  const Point p(8, 1.2, -3);
  const Openings openings = find_openings(mesh, params::inlet(p));
  for (const auto& o : openings)
    EXPECT_GE(CGAL::squared_distance(o.center, p), CGAL::squared_distance(openings[0].center, p));
  EXPECT_NEAR(openings[1].radius, 1.5, 0.05);
  EXPECT_THROW(find_openings(mesh, params::inlet(Point(std::nan(""), 0, 0))), Parameter_error);
}

// --- bad input ---

template <class Function> std::string message_of(Function function) {
  try {
    function();
  } catch (const Input_error& error) {
    return error.what();
  }
  return "";
}

TEST(Openings, A_border_that_touches_itself_names_the_vertex) {
  Mesh mesh;
  const auto o = mesh.add_vertex(Point(0, 0, 0));
  const auto a = mesh.add_vertex(Point(1, 0, 0)), b = mesh.add_vertex(Point(1, 1, 0));
  const auto c = mesh.add_vertex(Point(-1, 0, 0)), d = mesh.add_vertex(Point(-1, -1, 0));
  mesh.add_face(o, a, b);
  mesh.add_face(o, c, d);
  const std::string message = message_of([&] { find_openings(mesh); });
  EXPECT_NE(message.find("touches itself at vertex 0 (0, 0, 0)"), std::string::npos) << message;
}

TEST(Openings, Unusable_surfaces_are_refused_with_a_sentence) {
  EXPECT_NE(message_of([] { find_openings(Mesh()); }).find("no triangles"), std::string::npos);
  Mesh broken = make_tube(Tube());
  broken.point(Mesh::Vertex_index(5)) = Point(0, std::numeric_limits<double>::infinity(), 0);
  EXPECT_NE(message_of([&] { find_openings(broken); }).find("vertex 5"), std::string::npos);
  Mesh quads;
  quads.add_face(quads.add_vertex(Point(0, 0, 0)), quads.add_vertex(Point(1, 0, 0)), quads.add_vertex(Point(1, 1, 0)),
                 quads.add_vertex(Point(0, 1, 0)));
  EXPECT_NE(message_of([&] { find_openings(quads); }).find("Face 0"), std::string::npos);
}

TEST(Openings, Close_openings_refuses_openings_of_another_surface) {
  Mesh mesh = make_tube(Tube());
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  Openings openings = find_openings(mesh), too_few(1, openings[0]);
  EXPECT_THROW(close_openings(mesh, too_few, patch), Input_error);
  openings.push_back(openings[0]);
  EXPECT_THROW(close_openings(mesh, openings, patch), Input_error);
}

// --- real data ---

struct Real_case {
  const char* file;
  std::size_t openings;
};

class Real_surface : public testing::TestWithParam<Real_case> {};

TEST_P(Real_surface, Is_closed_by_planar_caps) {
#ifndef TUBULAR_MESHING_SHARED_DATA
  GTEST_SKIP() << "needs shared/data/" << GetParam().file;
#else
  const std::string file = std::string(TUBULAR_MESHING_SHARED_DATA) + "/" + GetParam().file;
  if (!std::ifstream(file))
    GTEST_SKIP() << "needs shared/data/" << GetParam().file;
  Mesh mesh;
  CGAL::Tubular_meshing::IO::read_surface(file, mesh);
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> before, after;
  PMP::self_intersections(mesh, std::back_inserter(before));
  const double area = PMP::area(mesh);

  const auto start = std::chrono::steady_clock::now();
  const Closed closed = close(mesh);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  RecordProperty("seconds", std::to_string(time.count()));
  EXPECT_LT(time.count(), 5); // about 0.5 s for 400k triangles; a loaded machine takes longer

  ASSERT_EQ(closed.openings.size(), GetParam().openings);
  check_closed(closed);
  PMP::self_intersections(closed.mesh, std::back_inserter(after));
  EXPECT_LE(after.size(), before.size());
  double wall = 0;
  for (auto f : closed.mesh.faces())
    if (closed.patch[f] == labels::wall)
      wall += std::sqrt(normal(f, closed.mesh).squared_length());
  EXPECT_NEAR(wall, area, 0.01 * area) << "little of the wall is lost";

  // a surface that is closed by then has the same openings, with its own caps
  const Openings again = find_openings(closed.mesh);
  EXPECT_EQ(again.size(), closed.openings.size());
  for (const auto& o : again)
    EXPECT_TRUE(std::any_of(closed.openings.begin(), closed.openings.end(), [&](const Opening& c) {
      return CGAL::squared_distance(o.center, c.center) < CGAL::square(1e-6 * c.radius);
    })) << o.center;
#endif
}

INSTANTIATE_TEST_SUITE_P(Shared_data, Real_surface,
                         testing::Values(Real_case{"paper/aorta.stl", 5}, Real_case{"paper/bypass.stl", 2},
                                         Real_case{"paper/carotid.stl", 3}, Real_case{"paper/cerebral.stl", 9},
                                         Real_case{"paper/cylemi.stl", 2}, Real_case{"trees/sofa_LCA.stl", 7},
                                         Real_case{"trees/sofa_carotids.stl", 3},
                                         Real_case{"trees/airway_lf_open.vtp", 117},
                                         Real_case{"trees/sofa_phantom_network.obj", 8}),
                         [](const auto& info) {
                           std::string name = info.param.file;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

} // namespace

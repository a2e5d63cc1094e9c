// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/check_centerlines.h>
#include <CGAL/Tubular_meshing/Centerlines/clip_to_openings.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef CGAL::Tubular_meshing::Centerline_polylines Polylines;
typedef CGAL::Tubular_meshing::Centerline_graph Graph;
typedef CGAL::Tubular_meshing::Centerline_field Field;
using CGAL::Tubular_meshing::build_centerline_graph;
using CGAL::Tubular_meshing::Input_error;

const double pi = 3.14159265358979323846;

double norm(const Vector& v) {
  return std::sqrt(v * v);
}

// A path sampled with about the given step.
std::vector<Point> path(const std::vector<Point>& corners, double step) {
  std::vector<Point> result(1, corners.front());
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const int n = (std::max)(1, int(std::ceil(norm(corners[i] - corners[i - 1]) / step)));
    for (int k = 1; k <= n; ++k)
      result.push_back(corners[i - 1] + double(k) / n * (corners[i] - corners[i - 1]));
  }
  return result;
}

void add_line(Polylines& p, const std::vector<Point>& line, double radius = 1) {
  p.lines.emplace_back();
  for (const Point& q : line) {
    p.lines.back().push_back(p.points.size());
    p.points.push_back(q);
    p.radius.push_back(radius);
  }
}

void add_loose_segments(Polylines& p, const std::vector<Point>& line, double radius = 1) {
  for (std::size_t i = 1; i < line.size(); ++i)
    add_line(p, {line[i - 1], line[i]}, radius);
}

std::vector<Point> perturbed(std::vector<Point> line, double amplitude, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-amplitude, amplitude);
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    line[i] = line[i] + Vector(u(random), u(random), u(random));
  return line;
}

Graph graph_of(const Polylines& p) {
  Graph graph;
  build_centerline_graph(p, graph);
  EXPECT_TRUE(graph.is_consistent());
  return graph;
}

void expect_orthonormal(const Field::Frame& f, double tolerance = 1e-12) {
  EXPECT_NEAR(f.e_t * f.e_t, 1, tolerance);
  EXPECT_NEAR(f.e_n * f.e_n, 1, tolerance);
  EXPECT_NEAR(f.e_t * f.e_n, 0, tolerance);
  EXPECT_NEAR(norm(f.e_bn - CGAL::cross_product(f.e_t, f.e_n)), 0, tolerance);
}

const Point trunk_start(0, 0, 0), fork(10, 0, 0), upper(20, 10, 0), lower(20, -12, 0);

// VMTK's way: one line an outlet, upstream the same but for noise.
Polylines vmtk_like_fork(double noise) {
  Polylines p;
  add_line(p, perturbed(path({trunk_start, fork, upper}, 0.21), noise, 1));
  add_line(p, perturbed(path({trunk_start, fork, lower}, 0.17), noise, 2));
  return p;
}

std::vector<double> sorted_lengths(const Graph& g) {
  std::vector<double> lengths;
  for (const Graph::Branch& b : g.branches())
    lengths.push_back(b.length);
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

// A tube of radius 1 from y = 0 to y = height, open or closed.
Mesh tube(double height, bool closed) {
  Mesh mesh;
  CGAL::make_regular_prism(64, mesh, Point(0, 0, 0), height, 1., closed);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

// --- graph ---

TEST(Centerline_graph, Keeps_what_it_is_made_of) {
  const Graph g({Point(0, 0, 0), Point(3, 0, 0), Point(3, 4, 0), Point(3, 0, 2)}, {1, 2, 3, 0.5},
                {{2, 1}, {0, 1}, {1, 3}});
  EXPECT_TRUE(g.is_consistent());
  ASSERT_EQ(g.branches().size(), 3u);
  EXPECT_EQ(g.nodes().size(), 4u);
  EXPECT_EQ(g.number_of_ends(), 3u);
  EXPECT_DOUBLE_EQ(g.length(), 9);
  EXPECT_DOUBLE_EQ(g.aspect_ratio(0), 4. / 5.);
  EXPECT_EQ(g.nodes()[g.root()].point, 2u);
  EXPECT_EQ(g.branches()[0].children, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(g.branches()[1].points, (std::vector<std::size_t>{1, 0})); // turned, away from the root
}

TEST(Centerline_graph, Is_directed_away_from_any_node) {
  Graph g = graph_of(vmtk_like_fork(0));
  for (std::size_t n = 0; n < g.nodes().size(); ++n) {
    g.direct_from(n);
    EXPECT_TRUE(g.is_consistent());
    EXPECT_EQ(g.root(), n);
    for (const Graph::Branch& b : g.branches())
      EXPECT_EQ(b.parents.empty(), b.source == n);
  }
  EXPECT_THROW(g.direct_from(99), Input_error);
}

TEST(Centerline_graph, Refuses_parts_that_do_not_fit) {
  EXPECT_THROW(Graph({Point(0, 0, 0)}, {}, {}), Input_error);
  EXPECT_THROW(Graph({Point(0, 0, 0)}, {1}, {{0}}), Input_error);
  EXPECT_THROW(Graph({Point(0, 0, 0)}, {1}, {{0, 1}}), Input_error);
}

// --- merging ---

TEST(Build_centerline_graph, Straight_line) {
  Polylines p;
  add_line(p, {Point(0, 0, 0), Point(20, 0, 0)});
  const Graph g = graph_of(p);
  ASSERT_EQ(g.branches().size(), 1u);
  EXPECT_NEAR(g.length(), 20, 1e-12);
  EXPECT_NEAR(g.aspect_ratio(0), 10, 1e-12);
  EXPECT_EQ(g.number_of_ends(), 2u);
}

TEST(Build_centerline_graph, Overlapping_lines_fork_once) {
  for (double noise : {0., 0.01, 0.03}) {
    const Graph g = graph_of(vmtk_like_fork(noise));
    ASSERT_EQ(g.branches().size(), 3u) << noise;
    EXPECT_EQ(g.number_of_ends(), 3u);
    EXPECT_LT(norm(g.points()[g.nodes()[g.root()].point] - trunk_start), 0.1);
    for (const Graph::Node& n : g.nodes())
      if (!n.is_end()) {
        EXPECT_LT(norm(g.points()[n.point] - fork), 0.5);
      }
  }
}

TEST(Build_centerline_graph, Does_not_depend_on_the_order_or_direction_of_lines) {
  Polylines p = vmtk_like_fork(0.02), q = p;
  std::reverse(q.lines.begin(), q.lines.end());
  std::reverse(q.lines[0].begin(), q.lines[0].end());
  const std::vector<double> a = sorted_lengths(graph_of(p)), b = sorted_lengths(graph_of(q));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], 0.5);
}

TEST(Build_centerline_graph, Scales_moves_and_turns_with_its_input) {
  const Polylines p = vmtk_like_fork(0.02);
  const std::vector<double> expected = sorted_lengths(graph_of(p));
  for (double scale : {1e-6, 1e3, 1e6}) {
    Polylines q = p;
    const double c = std::cos(0.7), s = std::sin(0.7);
    for (Point& x : q.points)
      x = Point(scale * (c * x.x() - s * x.z() + 100), scale * (x.y() - 50), scale * (s * x.x() + c * x.z() + 7));
    for (double& r : q.radius)
      r *= scale;
    const std::vector<double> got = sorted_lengths(graph_of(q));
    ASSERT_EQ(got.size(), expected.size());
    for (std::size_t i = 0; i < got.size(); ++i)
      EXPECT_NEAR(got[i] / scale, expected[i], 1e-6);
  }
}

TEST(Build_centerline_graph, Chains_loose_segments) {
  Polylines p;
  add_loose_segments(p, path({trunk_start, fork}, 0.03));
  add_loose_segments(p, path({upper, fork}, 0.03)); // steps below the merge tolerance: unchained, they would vanish
  add_loose_segments(p, path({fork, lower}, 0.03));
  std::shuffle(p.lines.begin(), p.lines.end(), std::mt19937(3));
  const Graph g = graph_of(p);
  EXPECT_EQ(g.branches().size(), 3u);
  EXPECT_NEAR(g.length(), 10 + std::sqrt(200.) + std::sqrt(244.), 1e-6);
}

TEST(Build_centerline_graph, Overlapping_loose_segments_count_once) {
  Polylines p;
  for (int copy = 0; copy < 3; ++copy)
    add_loose_segments(p, path({trunk_start, fork}, 0.3));
  const Graph g = graph_of(p);
  EXPECT_EQ(g.branches().size(), 1u);
  EXPECT_NEAR(g.length(), 10, 1e-9);
}

TEST(Build_centerline_graph, A_line_that_leaves_and_rejoins_is_a_loop) {
  Polylines p;
  add_line(p, path({Point(0, 0, 0), Point(30, 0, 0)}, 0.2));
  add_line(p, path({Point(0, 0.01, 0), Point(10, 0.01, 0), Point(15, 6, 0), Point(20, 0, 0), Point(22, 0, 0)}, 0.2));
  const Graph g = graph_of(p);
  EXPECT_EQ(g.branches().size(), 4u);
  EXPECT_EQ(g.nodes().size(), 4u);
  EXPECT_EQ(g.number_of_ends(), 2u);
}

TEST(Build_centerline_graph, A_ring_is_one_closed_branch) {
  for (bool loose : {false, true}) {
    Polylines p;
    std::vector<Point> ring;
    for (int i = 0; i <= 200; ++i)
      ring.emplace_back(10 * std::cos(2 * pi * (i % 200) / 200), 10 * std::sin(2 * pi * (i % 200) / 200), 0);
    loose ? add_loose_segments(p, ring) : add_line(p, ring);
    const Graph g = graph_of(p);
    ASSERT_EQ(g.branches().size(), 1u);
    EXPECT_EQ(g.nodes().size(), 1u);
    EXPECT_EQ(g.number_of_ends(), 0u);
    EXPECT_NEAR(g.length(), 20 * pi, 0.01);
    EXPECT_NO_THROW(Field(g).frame(Point(0, 0, 1)));
  }
}

TEST(Build_centerline_graph, Noise_is_no_branch) {
  Polylines p;
  add_line(p, path({Point(0, 0, 0), Point(30, 0, 0)}, 0.2));
  add_line(p, path({Point(0, 0, 0), Point(10, 0, 0), Point(11, 0.5, 0), Point(12, 0, 0), Point(25, 0, 0)}, 0.2));
  add_line(p, path({Point(3, 0, 0), Point(5, 0, 0), Point(5.2, 0.6, 0)}, 0.1)); // a spur within the vessel
  EXPECT_EQ(graph_of(p).branches().size(), 1u);
}

TEST(Build_centerline_graph, A_short_outlet_is_a_branch) {
  Polylines p;
  add_line(p, path({Point(0, 0, 0), Point(30, 0, 0)}, 0.2));
  add_line(p, path({Point(0, 0, 0), Point(10, 0, 0), Point(10.5, 1.5, 0)}, 0.2));
  EXPECT_EQ(graph_of(p).branches().size(), 3u);
}

TEST(Build_centerline_graph, Repeated_and_zigzag_points_vanish) {
  Polylines p;
  std::vector<Point> line;
  for (double x : {0., 0., 1., 1.001, 1.2, 1.1, 1.3, 2., 2., 3., 3.})
    line.emplace_back(x, 0, 0);
  add_line(p, line);
  const Graph g = graph_of(p);
  EXPECT_NEAR(g.length(), 3, 1e-9);
}

TEST(Build_centerline_graph, Lines_end_to_end_with_a_gap_stay_connected_by_a_third) {
  Polylines p;
  add_line(p, path({Point(0, 0, 0), Point(10, 0, 0)}, 0.2));
  add_line(p, path({Point(10.4, 0, 0), Point(19, 0, 0)}, 0.2));
  add_line(p, path({Point(8, 0.02, 0), Point(12, 0.02, 0)}, 0.4));
  const Graph g = graph_of(p);
  EXPECT_EQ(g.branches().size(), 1u);
  EXPECT_NEAR(g.length(), 19, 0.1);
}

TEST(Build_centerline_graph, Hundreds_of_lines) {
  Polylines p; // a comb: 300 outlets, each line running along all the trunk before it
  for (int i = 1; i <= 300; ++i)
    add_line(p, path({Point(0, 0, 0), Point(4. * i, 0, 0), Point(4. * i, 20 + 0.01 * i, 0)}, 0.5));
  const Graph g = graph_of(p);
  EXPECT_EQ(g.number_of_ends(), 301u);
  EXPECT_EQ(g.branches().size(), 599u);
}

TEST(Build_centerline_graph, Refuses_what_it_cannot_use) {
  Polylines p;
  Graph g;
  EXPECT_THROW(build_centerline_graph(p, g), Input_error);
  add_line(p, {Point(0, 0, 0), Point(0, 0, 0)});
  EXPECT_THROW(build_centerline_graph(p, g), Input_error); // no length
  p = Polylines();
  add_line(p, {Point(0, 0, 0), Point(1, 0, 0)});
  EXPECT_THROW(build_centerline_graph(p, g, CGAL::Tubular_meshing::parameters::merge_tolerance(0.)),
               CGAL::Tubular_meshing::Parameter_error);
  p.radius.clear();
  EXPECT_THROW(build_centerline_graph(p, g), Input_error);
  p.radius = {1, std::nan("")};
  EXPECT_THROW(build_centerline_graph(p, g), Input_error);
  p.radius = {0, 0};
  EXPECT_THROW(build_centerline_graph(p, g), Input_error);
  p.radius = {1, 1};
  p.points[1] = Point(std::nan(""), 0, 0);
  EXPECT_THROW(build_centerline_graph(p, g), Input_error);
  p.lines[0] = {0, 7};
  EXPECT_THROW(build_centerline_graph(p, g), Input_error);
}

// --- wall, openings ---

TEST(Wall_distance, Is_the_distance_to_faces_and_leaves_caps_out) {
  Mesh mesh = tube(10, true);
  const CGAL::Tubular_meshing::Wall_distance all(mesh);
  EXPECT_NEAR(all(Point(0, 0.25, 0)), 0.25, 1e-9); // the cap
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 1).first;
  for (Mesh::Face_index f : faces(mesh)) {
    std::set<double> levels;
    for (Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh))
      levels.insert(mesh.point(v).y());
    patch[f] = levels.size() == 1 ? 2 : 1;
  }
  const CGAL::Tubular_meshing::Wall_distance wall(mesh, patch, 1);
  EXPECT_NEAR(wall(Point(0, 0.25, 0)), std::cos(pi / 64), 1e-9);
  EXPECT_NEAR(wall.closest_point(Point(0, 0.25, 0)).y(), 0.25, 1e-9);
  EXPECT_THROW((CGAL::Tubular_meshing::Wall_distance(mesh, patch, 77)), Input_error);
  EXPECT_THROW(CGAL::Tubular_meshing::Wall_distance{Mesh()}, Input_error);
}

TEST(Check_centerlines, Finds_those_of_another_geometry) {
  const Mesh mesh = tube(10, true);
  const auto line = [&](double from, double to) {
    return Graph({Point(0, from, 0), Point(0, to, 0)}, {1, 1}, {{0, 1}});
  };
  EXPECT_NO_THROW(CGAL::Tubular_meshing::check_centerlines_inside(line(-1, 11), mesh));
  EXPECT_THROW(CGAL::Tubular_meshing::check_centerlines_inside(line(-100, -50), mesh), Input_error);
  EXPECT_THROW(CGAL::Tubular_meshing::check_centerlines_inside(line(-1000, 11000), mesh), Input_error);
}

TEST(Clip_to_openings, Cuts_extensions_and_reaches_centres) {
  typedef CGAL::Tubular_meshing::Opening Opening;
  std::vector<Opening> openings(3);
  for (int i = 0; i < 3; ++i)
    openings[i].radius = 1;
  openings[0].center = Point(2, 0.1, 0); // the trunk runs out here, 2 too far
  openings[0].normal = Vector(-1, 0, 0);
  openings[1].center = upper + Vector(0.5, 0.5, 0); // stops short
  openings[1].normal = Vector(std::sqrt(0.5), std::sqrt(0.5), 0);
  openings[2].center = lower + Vector(30, 0, 0); // no end comes near
  openings[2].normal = Vector(1, 0, 0);
  Graph g = graph_of(vmtk_like_fork(0));
  const std::size_t points = g.points().size();
  const std::vector<std::size_t> nodes = CGAL::Tubular_meshing::clip_to_openings(g, openings);
  EXPECT_TRUE(g.is_consistent());
  EXPECT_LT(g.points().size(), points);
  ASSERT_EQ(g.branches().size(), 3u);
  EXPECT_EQ(nodes[0], g.root());
  EXPECT_NEAR(norm(g.points()[g.nodes()[nodes[0]].point] - Point(2, 0, 0)), 0, 1e-9);
  EXPECT_NEAR(norm(g.points()[g.nodes()[nodes[1]].point] - openings[1].center), 0, 1e-12);
  EXPECT_EQ(nodes[2], std::size_t(Opening::no_branch));
}

// --- field ---

TEST(Centerline_field, Straight_tapered_line) {
  const Graph g({Point(0, 0, 0), Point(4, 0, 0), Point(10, 0, 0)}, {1, 1.4, 2}, {{0, 1, 2}});
  const Field field(g);
  const auto both = field.descriptors_and_frame(Point(7, 0.3, 0.4));
  EXPECT_NEAR(both.first.distance, 0.5, 1e-12);
  EXPECT_NEAR(both.first.abscissa, 7, 1e-12);
  EXPECT_NEAR(both.first.radius, 1.7, 1e-12);
  EXPECT_EQ(both.first.segment, 1u);
  EXPECT_NEAR(norm(both.first.point - Point(7, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(norm(both.second.e_t - Vector(1, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(norm(both.second.e_n - Vector(0, 0.6, 0.8)), 0, 1e-12);
  EXPECT_NEAR(norm(both.second.e_bn - Vector(0, -0.8, 0.6)), 0, 1e-12);
  EXPECT_NEAR(field.descriptors(Point(-3, 4, 0)).distance, 5, 1e-12);
  EXPECT_THROW(Field{Graph()}, Input_error);
}

TEST(Centerline_field, Frames_follow_an_arc) {
  Polylines p;
  std::vector<Point> arc;
  const double big = 10;
  for (int i = 0; i <= 90; ++i)
    arc.emplace_back(big * std::cos(i * pi / 90), big * std::sin(i * pi / 90), 0);
  add_line(p, arc);
  Graph g = graph_of(p);
  for (std::size_t n = 0; n < g.nodes().size(); ++n)
    if (g.points()[g.nodes()[n].point].x() > 0)
      g.direct_from(n);
  const Field field(g);
  for (double a = 0.05; a < pi; a += 0.0137) {
    const Point on(big * std::cos(a), big * std::sin(a), 0), off(1.05 * on.x(), 1.05 * on.y(), 0.2);
    const Field::Frame f = field.frame(off);
    expect_orthonormal(f);
    EXPECT_LT(norm(f.e_t - Vector(-std::sin(a), std::cos(a), 0)), 0.003);
    EXPECT_NEAR(field.descriptors(off).abscissa, big * a, 0.02);
    expect_orthonormal(field.frame(on));
  }
}

TEST(Centerline_field, Normals_on_the_centerline_are_continuous) {
  std::vector<Point> helix;
  for (int i = 0; i <= 2000; ++i)
    helix.emplace_back(3 * std::cos(0.01 * i), 3 * std::sin(0.01 * i), 0.01 * i);
  Graph g(helix, std::vector<double>(helix.size(), 0.5), {});
  std::vector<std::size_t> all(helix.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = i;
  g = Graph(helix, g.radii(), {all});
  const Field field(g);
  Field::Frame previous = field.frame(helix[0]);
  for (std::size_t i = 1; i < helix.size(); ++i)
    for (double t : {0.25, 0.5, 0.75, 1.}) {
      const Field::Frame f = field.frame(helix[i - 1] + t * (helix[i] - helix[i - 1]));
      expect_orthonormal(f);
      EXPECT_LT(norm(f.e_n - previous.e_n), 0.02);
      EXPECT_LT(norm(f.e_t - previous.e_t), 0.02);
      previous = f;
    }
}

TEST(Centerline_field, Where_a_search_begins_makes_no_difference) {
  const Field field(graph_of(vmtk_like_fork(0.03)));
  std::mt19937 random(6);
  std::uniform_real_distribution<double> u(-15, 25);
  std::size_t hint = 0;
  for (int i = 0; i < 500; ++i) {
    const Point x(u(random), u(random), u(random));
    const Field::Descriptors near = field.descriptors(x, hint), anywhere = field.descriptors(x);
    EXPECT_LT(hint, field.number_of_segments());
    EXPECT_EQ(near.branch, anywhere.branch);
    EXPECT_EQ(near.segment, anywhere.segment);
    EXPECT_EQ(near.distance, anywhere.distance);
    EXPECT_EQ(near.abscissa, anywhere.abscissa);
  }
}

TEST(Centerline_field, Nearest_is_what_brute_force_finds) {
  Graph g = graph_of(vmtk_like_fork(0.03));
  const Field field(g);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-15, 25);
  for (int i = 0; i < 500; ++i) {
    const Point x(u(random), u(random), u(random));
    double best = 1e300;
    for (const Graph::Branch& b : g.branches())
      for (std::size_t k = 1; k < b.points.size(); ++k)
        best = (std::min)(best, CGAL::to_double(CGAL::squared_distance(
                                    x, Kernel::Segment_3(g.points()[b.points[k - 1]], g.points()[b.points[k]]))));
    EXPECT_NEAR(field.descriptors(x).distance, std::sqrt(best), 1e-9);
    expect_orthonormal(field.frame(x));
  }
}

// --- the paper's own geometries ---

struct Expected {
  const char *surface, *centerlines;
  std::size_t branches, ends;
  double length; // of the merged graph, in the file's unit
};

class Paper_centerlines : public testing::TestWithParam<Expected> {};

TEST_P(Paper_centerlines, Become_the_branches_of_the_anatomy) {
#ifndef TUBULAR_MESHING_SHARED_DATA
  GTEST_SKIP() << "needs shared/data/paper";
#else
  const Expected& e = GetParam();
  const std::string folder = std::string(TUBULAR_MESHING_SHARED_DATA) + "/paper/";
  if (!std::ifstream(folder + e.surface) || !std::ifstream(folder + e.centerlines))
    GTEST_SKIP() << "needs shared/data/paper/" << e.surface;
  Mesh mesh;
  CGAL::Tubular_meshing::IO::read_surface(folder + e.surface, mesh);
  Polylines polylines;
  CGAL::Tubular_meshing::IO::read_centerlines(folder + e.centerlines, polylines);
  const CGAL::Tubular_meshing::Wall_distance wall(mesh);
  for (double tolerance : {0.05, 0.1, 0.2}) {
    Graph g;
    build_centerline_graph(polylines, wall, g, CGAL::Tubular_meshing::parameters::merge_tolerance(tolerance));
    EXPECT_TRUE(g.is_consistent());
    EXPECT_EQ(g.branches().size(), e.branches) << tolerance;
    EXPECT_EQ(g.number_of_ends(), e.ends) << tolerance;
    EXPECT_NEAR(g.length() / e.length, 1, 0.05) << tolerance;
    for (const Graph::Node& n : g.nodes())
      EXPECT_LE(n.branches.size(), 3u); // no trifurcation
    for (std::size_t i = 0; i < g.points().size(); i += 7)
      EXPECT_NEAR(g.radii()[i], wall(g.points()[i]), 1e-12);
    const Field field(g);
    for (std::size_t i = 0; i < g.points().size(); i += 3)
      expect_orthonormal(field.frame(g.points()[i] + g.radii()[i] * Vector(0.1, 0.2, -0.3)));
  }
#endif
}

INSTANTIATE_TEST_SUITE_P(Files, Paper_centerlines,
                         testing::Values(Expected{"aorta.stl", "centerlinesAORTA.vtk", 7, 5, 0.2887},
                                         Expected{"carotid.stl", "centerlinesCAROTID.vtk", 3, 3, 0.1060},
                                         Expected{"bypass.stl", "centerlinesBYPASS.msh", 4, 2, 40.57},
                                         Expected{"cerebral.stl", "centerlinesCEREBRAL.vtk", 15, 9, 333.9}),
                         [](const testing::TestParamInfo<Expected>& i) {
                           return std::string(i.param.surface, std::string(i.param.surface).find('.'));
                         });

} // namespace

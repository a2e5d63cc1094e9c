// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "computed_centerlines.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/branched_centerlines.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace computed_centerlines;

// How far graph and skeleton are apart, in radii, away from the skeleton's nodes; both ways.
struct Error {
  double mean = 0, largest = 0, radius = 0;
};

void add_samples(const std::vector<Point>& line, double step, std::vector<Point>& samples) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const int n = std::max(1, int(distance(line[i - 1], line[i]) / step));
    for (int k = 0; k < n; ++k)
      samples.push_back(line[i - 1] + (k + 0.5) / n * (line[i] - line[i - 1]));
  }
}

Error error_of(const Graph& graph, const Skeleton& skeleton) {
  std::vector<std::vector<std::size_t>> branches;
  std::vector<Point> points, ours, truth;
  std::vector<double> radii;
  double smallest = 1e300;
  for (const auto& b : skeleton.branches) {
    branches.emplace_back();
    for (std::size_t i = 0; i < b.points.size(); ++i) {
      branches.back().push_back(points.size());
      points.push_back(b.points[i]);
      radii.push_back(b.radius[i]);
      smallest = std::min(smallest, b.radius[i]);
    }
    add_samples(b.points, smallest / 5, truth);
  }
  for (const auto& b : graph.branches()) {
    std::vector<Point> line;
    for (std::size_t p : b.points)
      line.push_back(graph.points()[p]);
    add_samples(line, smallest / 5, ours);
  }
  const tubular::Centerline_field there(Graph(points, radii, branches)), here(graph);
  Error e;
  double sum = 0, radius_sum = 0;
  std::size_t number = 0, number_of_truth = 0;
  const auto measure = [&](const Point& p, const tubular::Centerline_field& other, bool is_ours) {
    const double r = there.radius(p);
    for (const Point& node : skeleton.nodes)
      if (distance(p, node) < r || distance(p, node) < there.radius(node))
        return;
    const auto d = other.descriptors(p);
    sum += d.distance / r;
    e.largest = std::max(e.largest, d.distance / r);
    ++number;
    if (!is_ours) {
      ++number_of_truth;
      radius_sum += std::abs(d.radius - r) / r;
    }
  };
  for (const Point& p : ours)
    measure(p, there, true);
  for (const Point& p : truth)
    measure(p, here, false);
  e.mean = sum / double(number);
  e.radius = radius_sum / double(number_of_truth);
  return e;
}

/* The radius is that of the facets of a surface of so many points round, which are nearer than the skeleton's radius:
 * by their sagitta, and by the noise, since the largest inscribed sphere touches the innermost of them. */
void expect_close_to_truth(const Skeleton& skeleton, double points = 24, double noise = 0, bool loops = false) {
  const Mesh surface = surface_of(skeleton, points, noise);
  const Graph graph = centerlines_of(surface, &skeleton.nodes[skeleton.inlet], loops);
  EXPECT_EQ(graph.branches().size(), skeleton.number_of_branches());
  EXPECT_EQ(graph.number_of_ends(), skeleton.number_of_openings());
  const Error e = error_of(graph, skeleton);
  ::testing::Test::RecordProperty("errors", ::testing::PrintToString(std::vector<double>{e.mean, e.largest, e.radius}));
  EXPECT_LT(e.mean, 0.02);
  EXPECT_LT(e.largest, 0.1);
  EXPECT_LT(e.radius, 1 - std::cos(CGAL_PI / points) + noise + 0.005);
}

// --- against the truth ---

TEST(Compute_centerlines, Straight_tube) {
  const auto s = tubular::straight_tube();
  expect_close_to_truth(s);
}

TEST(Compute_centerlines, Bend) {
  const auto s = tubular::curved_tube();
  expect_close_to_truth(s);
}

TEST(Compute_centerlines, Tight_bend) {
  const auto s = tubular::curved_tube(2.5, CGAL_PI);
  expect_close_to_truth(s);
}

TEST(Compute_centerlines, Bifurcation) {
  const auto s = tubular::y_bifurcation();
  expect_close_to_truth(s);
}

TEST(Compute_centerlines, Arch) {
  const auto s = tubular::aortic_arch();
  expect_close_to_truth(s);
}

TEST(Compute_centerlines, Noisy_surface) {
  const auto s = tubular::y_bifurcation();
  expect_close_to_truth(s, 24, 0.03);
}

// Where few of the vertices are looked at.
TEST(Compute_centerlines, Surfaces_of_small_triangles) {
  for (const auto& s : {tubular::curved_tube(), tubular::curved_tube(2.5, CGAL_PI), tubular::y_bifurcation()}) {
    expect_close_to_truth(s, 50);
    expect_close_to_truth(s, 100);
  }
  expect_close_to_truth(tubular::y_bifurcation(), 60, 0.01);
}

TEST(Compute_centerlines, Loop_keeps_all_branches_unless_asked_not_to) {
  const auto s = tubular::willis_loop();
  expect_close_to_truth(s, 24, 0, true);
  EXPECT_EQ(centerlines_of(surface_of(s), &s.nodes[s.inlet]).branches().size(), 2 * s.number_of_openings() - 3);
}

// Its symmetry makes vertices of the Voronoi diagram coincide, among which a path may go round in circles.
TEST(Compute_centerlines, Smooth_loop) {
  const auto s = tubular::willis_loop();
  expect_close_to_truth(s, 30, 0, true);
}

TEST(Compute_centerlines, Tree_of_305_branches) {
  const auto s = tubular::bronchial_tree(305);
  expect_close_to_truth(s, 16);
}

// --- ends ---

TEST(Compute_centerlines, Ends_are_the_centres_of_the_caps_and_the_root_is_the_inlet) {
  const auto s = tubular::y_bifurcation();
  Closed closed(surface_of(s), &s.nodes[2]);
  Graph graph;
  tubular::compute_centerlines(closed.mesh, closed.patch, closed.openings, graph);
  ASSERT_EQ(graph.number_of_ends(), 3u);
  EXPECT_LT(distance(graph.points()[graph.nodes()[graph.root()].point], closed.openings[0].center), 1e-6);
  for (const Opening& o : closed.openings) {
    double nearest = 1e300;
    for (const auto& n : graph.nodes())
      nearest = std::min(nearest, distance(graph.points()[n.point], o.center));
    EXPECT_LT(nearest, 1e-6);
  }
}

TEST(Compute_centerlines, Points_stand_for_the_spheres_that_touch_next_to_them) {
  const Mesh torus = make_torus(120, 48);
  Graph graph;
  const std::vector<Point> ends = {Point(4, 0, 0), Point(0, 4, 0)};
  tubular::compute_centerlines(torus, ends, graph, tubular::parameters::loops(false));
  ASSERT_EQ(graph.branches().size(), 1u);
  for (const Point& p : graph.points())
    EXPECT_NEAR(std::hypot(std::hypot(p.x(), p.y()) - 3, p.z()), 0, 0.02);
  EXPECT_NEAR(graph.length(), 3 * CGAL_PI / 2, 2 * 0.08); // rings are 0.16 apart: each end is half of this off at most
}

// --- what cannot be used ---

TEST(Compute_centerlines, Refuses_open_surfaces_and_single_openings) {
  Graph graph;
  const Mesh open = make_tube(Tube());
  EXPECT_THROW(tubular::compute_centerlines(open, std::vector<Point>{Point(0, 0, 0), Point(0, 0, 8)}, graph),
               tubular::Input_error);
  const Mesh sphere = make_sphere(12, 24);
  EXPECT_THROW(tubular::compute_centerlines(sphere, std::vector<Point>{Point(0, 0, 1)}, graph), tubular::Input_error);
  EXPECT_THROW(tubular::compute_centerlines(Mesh(), std::vector<Point>{Point(0, 0, 1), Point(1, 0, 0)}, graph),
               tubular::Input_error);
}

TEST(Compute_centerlines, Refuses_points_away_from_the_surface_and_points_that_coincide) {
  Graph graph;
  const Mesh torus = make_torus(60, 24);
  const std::vector<Point> away = {Point(4, 0, 0), Point(0, 40, 0)}, same = {Point(4, 0, 0), Point(4, 0, 0.001)};
  EXPECT_THROW(tubular::compute_centerlines(torus, away, graph), tubular::Input_error);
  EXPECT_THROW(tubular::compute_centerlines(torus, same, graph), tubular::Input_error);
}

TEST(Compute_centerlines, Refuses_separate_pieces) {
  Tube tube;
  tube.bottom = tube.top = End::fine;
  Mesh two = make_tube(tube);
  append(two, make_tube(tube), Transformation(CGAL::TRANSLATION, Vector(20, 0, 0)));
  Graph graph;
  EXPECT_THROW(tubular::compute_centerlines(two, std::vector<Point>{Point(0, 0, 0), Point(20, 0, 8)}, graph),
               tubular::Input_error);
}

TEST(Compute_centerlines, Coarse_prism_is_sampled_finely_enough) {
  Tube tube;
  tube.sides = 12;
  tube.rings = 1;
  tube.length = 20;
  const Graph graph = centerlines_of(make_tube(tube));
  ASSERT_EQ(graph.branches().size(), 1u);
  for (const Point& p : graph.points())
    EXPECT_LT(std::hypot(p.x(), p.y()), 0.05);
}

// --- VMTK's arrays ---

TEST(Branched_centerlines, Cut_each_line_into_branches_and_bifurcations_by_turns) {
  const auto s = tubular::y_bifurcation();
  const auto c = tubular::branched_centerlines(centerlines_of(surface_of(s), &s.nodes[0]));
  EXPECT_EQ(c.centerline_ids, (std::vector<int>{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(c.tract_ids, (std::vector<int>{0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(c.blanking, (std::vector<int>{0, 1, 0, 0, 1, 0}));
  EXPECT_EQ(c.group_ids[0], c.group_ids[3]);
  EXPECT_EQ(c.group_ids[1], c.group_ids[4]);
  EXPECT_EQ(std::set<int>(c.group_ids.begin(), c.group_ids.end()).size(), 4u);
  for (std::size_t i = 1; i < 3; ++i) // without gaps
    EXPECT_EQ(c.lines.points[c.lines.lines[i - 1].back()], c.lines.points[c.lines.lines[i].front()]);
}

TEST(Branched_centerlines, Are_written_and_read_back) {
  const auto s = tubular::y_bifurcation();
  const auto c = tubular::branched_centerlines(centerlines_of(surface_of(s), &s.nodes[0]));
  for (const std::string extension : {"vtp", "vtk"}) {
    const std::string file = TUBULAR_MESHING_SCRATCH "/branched." + extension;
    tubular::IO::write_centerlines(file, c);
    tubular::Centerline_polylines lines;
    tubular::IO::read_centerlines(file, lines);
    EXPECT_EQ(lines.lines, c.lines.lines);
    EXPECT_EQ(lines.points, c.lines.points);
    std::ifstream in(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    for (const char* name : {"CenterlineIds", "TractIds", "GroupIds", "Blanking", "MaximumInscribedSphereRadius"})
      EXPECT_NE(text.find(name), std::string::npos) << name;
  }
}

// --- real vessels ---

void expect_shape(const std::string& file, bool loops, std::size_t branches, std::size_t ends) {
  const Mesh surface = shared_surface(file);
  if (surface.is_empty())
    GTEST_SKIP() << "needs shared/data/" << file;
  const Graph graph = centerlines_of(surface, nullptr, loops);
  EXPECT_EQ(graph.branches().size(), branches);
  EXPECT_EQ(graph.number_of_ends(), ends);
}

TEST(Compute_centerlines, Aorta) {
  expect_shape("paper/aorta.stl", false, 7, 5);
}
TEST(Compute_centerlines, Cerebral) {
  expect_shape("paper/cerebral.stl", false, 15, 9);
}
TEST(Compute_centerlines, Bypass_with_its_loop) {
  expect_shape("paper/bypass.stl", true, 4, 2);
}
TEST(Compute_centerlines, Coarse_coronary_tree) {
  expect_shape("trees/sofa_LCA.stl", false, 11, 7);
}
TEST(Compute_centerlines, Vessels_that_split_and_rejoin) {
  expect_shape("trees/sofa_phantom_network.obj", true, 16, 8);
}

} // namespace

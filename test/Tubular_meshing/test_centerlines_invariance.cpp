// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The same surface in another unit, place, direction or order has the same centerlines.

#include "computed_centerlines.h"

#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using namespace computed_centerlines;

double diagonal(const Mesh& mesh) {
  CGAL::Bbox_3 box;
  for (auto v : mesh.vertices())
    box += mesh.point(v).bbox();
  return distance(Point(box.xmin(), box.ymin(), box.zmin()), Point(box.xmax(), box.ymax(), box.zmax()));
}

// How far the points of one graph are from the other, at most.
double distance_to(const Graph& from, const Transformation& t, const std::vector<Kernel::Segment_3>& to) {
  double largest = 0;
  for (const Point& p : from.points()) {
    double nearest = (std::numeric_limits<double>::infinity)();
    for (const auto& s : to)
      nearest = std::min(nearest, CGAL::squared_distance(t(p), s));
    largest = std::max(largest, std::sqrt(nearest));
  }
  return largest;
}

std::vector<Kernel::Segment_3> segments_of(const Graph& graph, const Transformation& t) {
  std::vector<Kernel::Segment_3> segments;
  for (const auto& b : graph.branches())
    for (std::size_t i = 1; i < b.points.size(); ++i)
      segments.emplace_back(t(graph.points()[b.points[i - 1]]), t(graph.points()[b.points[i]]));
  return segments;
}

void expect_same(const Graph& a, const Graph& b, const Transformation& t, double tolerance) {
  const Transformation none(CGAL::IDENTITY);
  ASSERT_EQ(a.branches().size(), b.branches().size());
  EXPECT_EQ(a.number_of_ends(), b.number_of_ends());
  EXPECT_LE(distance_to(a, t, segments_of(b, none)), tolerance);
  EXPECT_LE(distance_to(b, none, segments_of(a, t)), tolerance);
}

/* Within 1e-6 of the size, wherever the surface lies: moved by 100 diagonals, double precision still tells points apart
 * that are 1e-14 diagonals from each other. */
void expect_invariance(const Mesh& surface, bool loops = false) {
  const double size = diagonal(surface);
  const Graph graph = centerlines_of(surface, nullptr, loops);
  const auto expect = [&](const char* what, const Mesh& other, const Transformation& t, double scale = 1) {
    SCOPED_TRACE(what);
    expect_same(graph, centerlines_of(other, nullptr, loops), t, 1e-6 * scale * size);
  };
  const Transformation none(CGAL::IDENTITY), turn = rotation(0.7), small(CGAL::SCALING, 1, 1000),
                                             large(CGAL::SCALING, 1000000, 1),
                                             move(CGAL::TRANSLATION, size * Vector(60, -80, 10));
  expect("shuffled", shuffled(surface, 3), none);
  expect("turned", transformed(surface, turn), turn);
  expect("a thousandth", transformed(surface, small), small, 1e-3);
  expect("times a million", transformed(surface, large), large, 1e6);
  expect("moved", transformed(surface, move), move);
}

void expect_invariance_of(const std::string& file, bool loops = false) {
  const Mesh surface = shared_surface(file);
  if (surface.is_empty())
    GTEST_SKIP() << "needs shared/data/" << file;
  expect_invariance(surface, loops);
}

TEST(Centerlines_invariance, Arch) {
  expect_invariance(surface_of(tubular::aortic_arch()));
}
TEST(Centerlines_invariance, Loop) {
  expect_invariance(surface_of(tubular::willis_loop(), 12), true);
}
TEST(Centerlines_invariance, Carotid) {
  expect_invariance_of("paper/carotid.stl");
}
TEST(Centerlines_invariance, Vessels_that_split_and_rejoin) {
  expect_invariance_of("trees/sofa_phantom_network.obj", true);
}

// To the last digit, on a surface large enough for several threads to share out all there is.
TEST(Centerlines_invariance, Any_number_of_threads) {
  const Closed closed(surface_of(tubular::bronchial_tree(31), 40));
  Graph graphs[3];
  for (int i = 0; i < 3; ++i)
    tubular::compute_centerlines(closed.mesh, closed.patch, closed.openings, graphs[i],
                                 tubular::parameters::number_of_threads(i + 1));
  for (int i = 1; i < 3; ++i) {
    EXPECT_EQ(graphs[i].points(), graphs[0].points()) << i + 1 << " threads";
    EXPECT_EQ(graphs[i].radii(), graphs[0].radii()) << i + 1 << " threads";
    EXPECT_EQ(graphs[i].branches().size(), graphs[0].branches().size()) << i + 1 << " threads";
  }
}

} // namespace

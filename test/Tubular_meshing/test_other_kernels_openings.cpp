// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Generators, repair, openings and flow extensions on surfaces of other kernels and other graphs of faces.

#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/flow_extensions.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include "other_graphs.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <type_traits>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace params = CGAL::Tubular_meshing::parameters;
using tubular::Surface;

typedef CGAL::Surface_mesh<CGAL::Epeck::Point_3> Exact_mesh;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3> Float_mesh;
typedef CGAL::Polyhedron_3<tubular::Kernel> Polyhedron;

template <class Mesh> struct Labels {
  typedef typename boost::graph_traits<Mesh>::face_descriptor Face;
  std::map<Face, int> labels;
  boost::associative_property_map<std::map<Face, int>> map() {
    return boost::associative_property_map<std::map<Face, int>>(labels);
  }
};

template <class Mesh> std::vector<tubular::Point_3> points_of(const Mesh& mesh) {
  std::vector<tubular::Point_3> points;
  for (auto v : vertices(mesh))
    points.push_back(tubular::internal::to_core(get(CGAL::vertex_point, mesh, v)));
  return points;
}

// Relative to coordinates of about 10: rounding to floats, or none.
template <class Mesh> double tolerance() {
  return std::is_same<Mesh, Float_mesh>::value ? 1e-5 : 0;
}

template <class Mesh> void expect_same(const Mesh& mesh, const Surface& expected) {
  EXPECT_EQ(CGAL::num_faces(mesh), expected.number_of_faces());
  const auto points = points_of(mesh), expected_points = points_of(expected);
  ASSERT_EQ(points.size(), expected_points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LE(std::sqrt(CGAL::squared_distance(points[i], expected_points[i])), tolerance<Mesh>());
}

void expect_same(const std::vector<tubular::Opening>& openings, const std::vector<tubular::Opening>& expected,
                 double tolerance) {
  ASSERT_EQ(openings.size(), expected.size());
  for (std::size_t i = 0; i < openings.size(); ++i) {
    EXPECT_LE(std::sqrt(CGAL::squared_distance(openings[i].center, expected[i].center)), tolerance);
    EXPECT_NEAR(openings[i].radius, expected[i].radius, tolerance);
    EXPECT_EQ(openings[i].patch, expected[i].patch);
  }
}

// A bifurcation of few triangles: in doubles that floats hold, so that no conversion changes it.
Surface bifurcation() {
  Surface surface;
  tubular::generate_tubular_surface(tubular::y_bifurcation(), surface, params::points_per_circumference(8));
  for (auto v : surface.vertices()) {
    const auto& p = surface.point(v);
    surface.point(v) =
        tubular::Point_3(other_graphs::rounded(p.x()), other_graphs::rounded(p.y()), other_graphs::rounded(p.z()));
  }
  return other_graphs::in_order(surface);
}

template <class Mesh> class Other_graph : public testing::Test {};
typedef testing::Types<Exact_mesh, Float_mesh, Polyhedron> Graphs;
TYPED_TEST_SUITE(Other_graph, Graphs);

TYPED_TEST(Other_graph, Is_generated) {
  TypeParam mesh;
  Surface expected;
  tubular::generate_tubular_surface(tubular::y_bifurcation(), mesh, params::points_per_circumference(8));
  tubular::generate_tubular_surface(tubular::y_bifurcation(), expected, params::points_per_circumference(8));
  expect_same(mesh, expected);
}

TYPED_TEST(Other_graph, Has_its_openings_found_and_closed) {
  Surface expected = bifurcation();
  TypeParam mesh;
  other_graphs::copy_in_order(expected, mesh);
  auto expected_openings = tubular::find_openings(expected);
  auto openings = tubular::find_openings(mesh);
  expect_same(openings, expected_openings, tolerance<TypeParam>());

  auto expected_patch = expected.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
  tubular::close_openings(expected, expected_openings, expected_patch);
  Labels<TypeParam> labels;
  tubular::close_openings(mesh, openings, labels.map());
  EXPECT_TRUE(CGAL::is_closed(mesh));
  expect_same(mesh, expected);
  expect_same(openings, expected_openings, tolerance<TypeParam>());
  std::map<int, int> count, expected_count; // of faces, by label
  for (auto f : faces(mesh))
    ++count[labels.labels.at(f)];
  for (auto f : expected.faces())
    ++expected_count[expected_patch[f]];
  EXPECT_EQ(count, expected_count);
}

TYPED_TEST(Other_graph, Is_extended) {
  Surface expected = bifurcation();
  TypeParam mesh;
  other_graphs::copy_in_order(expected, mesh);
  auto expected_openings = tubular::find_openings(expected);
  auto openings = expected_openings;
  const auto np = params::extension_length(2.).extended_openings(std::vector<std::size_t>{1, 2});
  const auto expected_lengths = tubular::add_flow_extensions(expected, expected_openings, np);
  const auto lengths = tubular::add_flow_extensions(mesh, openings, np);
  EXPECT_EQ(lengths, expected_lengths);
  EXPECT_EQ(lengths[0], 0);
  EXPECT_GT(lengths[1], 0);
  expect_same(mesh, expected);
  expect_same(openings, expected_openings, tolerance<TypeParam>());
}

TYPED_TEST(Other_graph, Is_repaired) {
  Surface clean = bifurcation();
  TypeParam mesh;
  other_graphs::copy_in_order(clean, mesh);
  const auto first = *vertices(mesh).first;
  EXPECT_TRUE(tubular::repair_surface(mesh).empty());
  EXPECT_EQ(*vertices(mesh).first, first) << "a clean mesh is touched";

  clear(mesh);
  clean.remove_face(Surface::Face_index(clean.number_of_faces() / 2)); // a pinhole
  clean.collect_garbage();
  other_graphs::copy_in_order(clean, mesh);
  Surface expected = clean;
  const auto expected_report = tubular::repair_surface(expected), report = tubular::repair_surface(mesh);
  EXPECT_EQ(report.count(tubular::Surface_defect::pinholes), expected_report.count(tubular::Surface_defect::pinholes));
  EXPECT_EQ(report.text(), expected_report.text());
  expect_same(mesh, expected);
}

// Points of the mesh's own kernel, and a mesh that takes them.
TYPED_TEST(Other_graph, Is_made_of_a_soup) {
  typedef
      typename boost::property_traits<typename boost::property_map<TypeParam, CGAL::vertex_point_t>::type>::value_type
          Point;
  const Surface surface = bifurcation();
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (auto f : surface.faces()) {
    triangles.push_back({points.size(), points.size() + 1, points.size() + 2});
    for (auto v : surface.vertices_around_face(surface.halfedge(f)))
      points.emplace_back(surface.point(v).x(), surface.point(v).y(), surface.point(v).z());
  }
  TypeParam mesh;
  const auto report = tubular::repair_surface(points, triangles, mesh);
  EXPECT_EQ(report.count(tubular::Surface_defect::duplicate_points), points.size() - surface.number_of_vertices());
  EXPECT_EQ(CGAL::num_faces(mesh), surface.number_of_faces());
  EXPECT_EQ(CGAL::num_vertices(mesh), surface.number_of_vertices());
}

// --- parameters ---

// A surface of which the points are elsewhere, ten times as large.
TEST(Other_point_map, Is_read_and_written) {
  Surface surface = bifurcation();
  auto large = surface.add_property_map<Surface::Vertex_index, tubular::Point_3>("v:large").first;
  for (auto v : surface.vertices())
    large[v] = CGAL::ORIGIN + 10 * (surface.point(v) - CGAL::ORIGIN);
  const auto np = CGAL::parameters::vertex_point_map(large);
  auto openings = tubular::find_openings(surface), large_openings = tubular::find_openings(surface, np);
  ASSERT_EQ(openings.size(), large_openings.size());
  for (std::size_t i = 0; i < openings.size(); ++i)
    EXPECT_NEAR(large_openings[i].radius, 10 * openings[i].radius, 1e-9);
}

TEST(Centerline_graph_parameter, Is_a_graph_a_reference_or_a_pointer) {
  const auto skeleton = tubular::y_bifurcation();
  const Surface surface = bifurcation();
  tubular::Centerline_graph graph;
  tubular::build_centerline_graph(tubular::centerlines_of(skeleton), graph);
  const tubular::Centerline_graph* pointer = &graph;
  const auto by_reference = tubular::find_openings(surface, params::centerline_graph(std::cref(graph)));
  const auto by_mutable_reference = tubular::find_openings(surface, params::centerline_graph(std::ref(graph)));
  const auto by_pointer = tubular::find_openings(surface, params::centerline_graph(pointer));
  const auto by_value = tubular::find_openings(surface, params::centerline_graph(graph));
  ASSERT_EQ(by_reference.size(), 3u);
  for (const auto* other : {&by_mutable_reference, &by_pointer, &by_value}) {
    ASSERT_EQ(other->size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NE((*other)[i].node, tubular::Opening::no_branch);
      EXPECT_EQ((*other)[i].node, by_reference[i].node);
    }
  }
}

TEST(Inlet_parameter, Is_a_point_of_any_kernel) {
  const Surface surface = bifurcation();
  const auto openings = tubular::find_openings(surface);
  const auto& p = openings[2].center;
  const auto exact = tubular::find_openings(surface, params::inlet(CGAL::Epeck::Point_3(p.x(), p.y(), p.z())));
  EXPECT_EQ(exact[0].center, p);
  typedef CGAL::Simple_cartesian<float>::Point_3 Float_point;
  const auto rounded =
      tubular::find_openings(surface, params::inlet(Float_point(float(p.x()), float(p.y()), float(p.z()))));
  EXPECT_EQ(rounded[0].center, p);
}

} // namespace

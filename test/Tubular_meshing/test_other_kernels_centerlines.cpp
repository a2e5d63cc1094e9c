// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Centerlines and what is measured from them, in meshes of any kernel and kind.

#include "computed_centerlines.h"
#include "other_kernels.h"

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/check_centerlines.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace {

using namespace computed_centerlines;

template <class Mesh> class Other_kernels : public ::testing::Test {};
TYPED_TEST_SUITE(Other_kernels, other_kernels::Meshes);

} // namespace

TYPED_TEST(Other_kernels, Have_the_same_centerlines) {
  typedef typename boost::graph_traits<TypeParam>::face_descriptor Face;
  const Closed closed(surface_of(tubular::straight_tube(8, 1)));
  const Graph expected = centerlines_of(closed);
  TypeParam mesh = other_kernels::converted<TypeParam>(closed.mesh);
  std::map<Face, int> labels;
  auto f = closed.mesh.faces().begin();
  for (Face face : faces(mesh))
    labels[face] = closed.patch[*f++];
  const auto patch = boost::make_assoc_property_map(labels);

  Graph graph;
  tubular::compute_centerlines(mesh, patch, closed.openings, graph);
  ASSERT_EQ(graph.branches().size(), expected.branches().size());
  EXPECT_NEAR(graph.length(), expected.length(), 0.02);
  EXPECT_NO_THROW(tubular::check_centerlines_inside(graph, mesh));

  const tubular::Wall_distance wall(mesh, patch, tubular::labels::wall), all(mesh);
  EXPECT_NEAR(wall(Point(0, 0, 0.1)),
              tubular::Wall_distance(closed.mesh, closed.patch, tubular::labels::wall)(Point(0, 0, 0.1)), 1e-6);
  EXPECT_NEAR(all(Point(0, 0, 0.1)), 0.1, 1e-6);

  Graph between_points;
  tubular::compute_centerlines(mesh, std::vector<Point>{closed.openings[0].center, closed.openings[1].center},
                               between_points);
  EXPECT_EQ(between_points.branches().size(), 1u);
  EXPECT_THROW(tubular::compute_centerlines(TypeParam(), std::vector<Point>{Point(0, 0, 1), Point(1, 0, 0)}, graph),
               tubular::Input_error);
}

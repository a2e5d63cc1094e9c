// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fields and curvatures of meshes of any kernel and kind.

#include "other_kernels.h"
#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/curvature.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Point_3 Point;
typedef tubular::Vector_3 Vector;

template <class Mesh> class Other_kernels : public ::testing::Test {};
TYPED_TEST_SUITE(Other_kernels, other_kernels::Meshes);

// A tube of radius one along z, and its centerline.
struct Example {
  tubular::Surface surface;
  tubular::Centerline_graph graph;

  Example() {
    test_surfaces::Tube tube;
    tube.sides = 32;
    tube.rings = 40;
    surface = test_surfaces::make_tube(tube);
    std::vector<Point> points;
    std::vector<std::size_t> line;
    for (int i = 0; i <= 40; ++i) {
      line.push_back(points.size());
      points.push_back(Point(0, 0, 0.2 * i));
    }
    std::vector<double> radii(points.size(), 1.);
    graph = tubular::Centerline_graph(std::move(points), std::move(radii), {line});
  }
};

} // namespace

TYPED_TEST(Other_kernels, Have_the_same_fields) {
  typedef typename boost::graph_traits<TypeParam>::face_descriptor Face;
  const Example e;
  TypeParam mesh = other_kernels::converted<TypeParam>(e.surface);
  const CGAL::Constant_property_map<Face, int> wall(tubular::labels::wall);
  const CGAL::Constant_property_map<tubular::Surface::Face_index, int> core_wall(tubular::labels::wall);

  const tubular::Centerline_field lines(e.graph);
  const tubular::Centerline_sizing_field size(lines, tubular::Wall_distance(mesh)),
      core_size(lines, tubular::Wall_distance(e.surface));
  const tubular::Centerline_metric_field metric(mesh, wall, e.graph), core_metric(e.surface, core_wall, e.graph);
  for (const Point& p : {Point(0, 0, 4), Point(0.9, 0, 3), Point(0.1, -0.8, 5)}) {
    EXPECT_NEAR(size(p), core_size(p), 1e-5);
    const CGAL::Simple_cartesian<float>::Point_3 q(float(p.x()), float(p.y()), float(p.z())); // as Mesh_3 asks
    EXPECT_NEAR(size(q, 3, 0), core_size(p), 1e-5);
    const auto h = metric(p).sizes(), core_h = core_metric(p).sizes();
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(h[i] / core_h[i], 1, 1e-2);
  }
}

TYPED_TEST(Other_kernels, Have_the_same_curvatures) {
  typedef typename boost::graph_traits<TypeParam>::vertex_descriptor Vertex;
  typedef tubular::Vertex_curvature<CGAL::Simple_cartesian<double>::Vector_3> Curvature;
  const Example e;
  TypeParam mesh = other_kernels::converted<TypeParam>(e.surface);
  std::map<Vertex, Curvature> curvatures;
  const std::function<double(const Point&)> radius = [](const Point&) { return 1.; };
  tubular::compute_curvatures(mesh, boost::make_assoc_property_map(curvatures),
                              tubular::parameters::local_radius(radius));
  ASSERT_EQ(curvatures.size(), e.surface.number_of_vertices());
  for (const auto& k : curvatures)
    EXPECT_NEAR(k.second.max_curvature, 1, 0.05);
}

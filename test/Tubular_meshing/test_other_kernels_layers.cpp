// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Layers for callers with other kernels, other surfaces, and other function objects than the core's.

#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include "other_graphs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace labels = tubular::labels;
namespace parameters = tubular::parameters;
typedef CGAL::Exact_predicates_exact_constructions_kernel Epeck;
typedef CGAL::Simple_cartesian<float> Floats;

double one(const tubular::Point_3&) {
  return 1;
}

// A tube of quads of radius 1 along z, with caps of triangles; patches 1, 2 (z = 0) and 3.
tubular::Labelled_surface tube() {
  const int sides = 16, rows = 6;
  tubular::Labelled_surface result;
  tubular::Surface& surface = result.surface;
  std::vector<tubular::Surface::Vertex_index> v;
  for (int k = 0; k <= rows; ++k)
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * CGAL_PI * i / sides;
      v.push_back(surface.add_vertex(tubular::Point_3(
          other_graphs::rounded(std::cos(a)), other_graphs::rounded(std::sin(a)), k / 2.))); // as floats have it
    }
  const auto at = [&](int k, int i) { return v[std::size_t(k * sides + i % sides)]; };
  const auto bottom = surface.add_vertex(tubular::Point_3(0, 0, 0));
  const auto top = surface.add_vertex(tubular::Point_3(0, 0, rows / 2.));
  for (int i = 0; i < sides; ++i) {
    for (int k = 0; k < rows; ++k)
      result.patch[surface.add_face(at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i))] = labels::wall;
    result.patch[surface.add_face(at(0, i + 1), at(0, i), bottom)] = labels::inlet;
    result.patch[surface.add_face(at(rows, i), at(rows, i + 1), top)] = labels::inlet + 1;
  }
  return result;
}

template <class FaceGraph> class Layers_on : public testing::Test {};
typedef testing::Types<CGAL::Surface_mesh<Epeck::Point_3>, CGAL::Surface_mesh<Floats::Point_3>,
                       CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>>
    Surfaces;
TYPED_TEST_SUITE(Layers_on, Surfaces);

void expect_the_same(const tubular::Mixed_mesh& found, const tubular::Mixed_mesh& expected) {
  EXPECT_EQ(found.hexahedra.vertices, expected.hexahedra.vertices);
  EXPECT_EQ(found.quads.vertices, expected.quads.vertices);
  EXPECT_EQ(found.quads.label, expected.quads.label);
  ASSERT_EQ(found.points.size(), expected.points.size());
  for (std::size_t i = 0; i < found.points.size(); ++i)
    EXPECT_LT(CGAL::squared_distance(found.points[i], expected.points[i]), 1e-10); // floats
}

TYPED_TEST(Layers_on, Any_surface_gives_the_same_cells) {
  typedef typename boost::graph_traits<TypeParam>::face_descriptor Face;
  const tubular::Labelled_surface core = tube();
  TypeParam surface;
  const auto copies = other_graphs::copy_in_order(core.surface, surface);
  std::map<Face, int> labels_of_faces;
  for (const auto& f : copies)
    labels_of_faces[f.second] = core.patch[f.first];
  const auto patch = boost::make_assoc_property_map(labels_of_faces);

  const auto np = parameters::wall_thickness(0.3).wall_layers(2);
  const auto wall = tubular::extrude_wall(surface, patch, one, np);
  const auto expected_wall = tubular::extrude_wall(core.surface, core.patch, one, np);
  EXPECT_EQ(wall.mesh.hexahedra.size(), 2u * 16 * 6);
  EXPECT_EQ(wall.report.hexahedra, wall.mesh.hexahedra.size());
  expect_the_same(wall.mesh, expected_wall.mesh);

  const auto layer = tubular::extrude_boundary_layer(surface, patch, one, parameters::boundary_layer_prisms(3));
  const auto expected_layer =
      tubular::extrude_boundary_layer(core.surface, core.patch, one, parameters::boundary_layer_prisms(3));
  EXPECT_EQ(layer.report.hexahedra, 3u * 16 * 6);
  expect_the_same(layer.layers, expected_layer.layers);
  EXPECT_EQ(layer.inner.number_of_faces(), expected_layer.inner.number_of_faces());
}

TEST(Layer_options, Are_the_named_parameters) {
  const tubular::Extrude_wall_options plain, by_default(CGAL::parameters::default_values()),
      six(parameters::wall_layers(6).wall_growth(1.5));
  EXPECT_TRUE(by_default.wall_thickness.is_relative());
  EXPECT_EQ(by_default.wall_thickness.radii(), plain.wall_thickness.radii());
  EXPECT_EQ(by_default.second_wall_layers, plain.second_wall_layers);
  EXPECT_EQ(six.second_wall_layers, 6);
  EXPECT_EQ(six.second_wall_growth, 1.5);
  const tubular::Extrude_boundary_layer_options inward(parameters::first_height(0.01));
  EXPECT_EQ(inward.first_height.value(), 0.01);
  EXPECT_FALSE(inward.boundary_layer_prisms.has_value());
}

} // namespace

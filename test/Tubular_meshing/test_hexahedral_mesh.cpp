// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of hexahedra alone: which method makes them, and what those by subdivision are like.

#include "hub_of_vessels.h"
#include "looped_surfaces.h"
#include "surface_measures.h"

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Hexahedra/subdivide_into_hexahedra.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/move_boundary_to_surface.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace parameters = tubular::parameters;
namespace labels = tubular::labels;
using tubular::Hexahedral_fallback;
using tubular::Hexahedral_method;
using tubular::Mesher;
using tubular::Mesher_options;
using tubular::Mixed_mesh;
using tubular::Point_3;

#define NEEDS_FILLING()                                                                                                \
  if (tubular::default_volume_mesher() == tubular::Volume_mesher::mesh_3)                                              \
  GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1"

tubular::Tubular_model model_of(const tubular::Tubular_skeleton& skeleton, double points = 60) {
  tubular::Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(points));
  return tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton));
}

Mesher_options by_subdivision(double points = 16) {
  Mesher_options options(parameters::points_per_circumference(points));
  options.hexahedral_method = Hexahedral_method::subdivision;
  return options;
}

void expect_hexahedra_alone(const Mixed_mesh& mesh) {
  EXPECT_GT(mesh.hexahedra.size(), 0u);
  EXPECT_EQ(mesh.number_of_cells(), mesh.hexahedra.size());
  EXPECT_EQ(mesh.number_of_facets(), mesh.quads.size());
  const tubular::Validity_report report = tubular::validity_report(mesh);
  EXPECT_EQ(report.defects(), "");
  EXPECT_EQ(report.inverted_cells, 0u);
}

double relative_volume(const Mixed_mesh& mesh, const tubular::Tubular_model& model) {
  return tubular::lumen_measures(mesh, model.openings.size()).volume /
             CGAL::Polygon_mesh_processing::volume(model.surface) -
         1;
}

struct Shape {
  const char* name;
  tubular::Tubular_skeleton (*make)();
};

std::ostream& operator<<(std::ostream& out, const Shape& s) {
  return out << s.name;
}

const Shape shapes[] = {
    {"Tube", [] { return tubular::straight_tube(8, 1); }},
    {"Bend", [] { return tubular::curved_tube(4, 1.8, 1); }},
    {"Y", [] { return tubular::y_bifurcation(); }},
};

class Hexahedral_mesh : public ::testing::TestWithParam<Shape> {};

TEST_P(Hexahedral_mesh, By_subdivision_is_valid_and_has_the_surface_s_volume) {
  NEEDS_FILLING();
  const auto model = model_of(GetParam().make());
  Mesher mesher(model, by_subdivision());
  const Mixed_mesh mesh = mesher.hexahedral();
  expect_hexahedra_alone(mesh);
  EXPECT_LT(std::abs(relative_volume(mesh, model)), 0.003);
  const auto measures = tubular::lumen_measures(mesh, model.openings.size());
  for (const auto& o : model.openings)
    EXPECT_NEAR(measures.opening_area.at(o.patch), o.area, 0.005 * o.area);
  EXPECT_EQ(mesher.report().hexahedral.method, Hexahedral_method::subdivision);
  EXPECT_TRUE(mesher.report().hexahedral.places_without_blocks.empty()); // they were not asked for
  EXPECT_TRUE(mesher.report().fallbacks.empty());
  EXPECT_EQ(mesh.region_names.at(labels::lumen), "lumen");
  EXPECT_EQ(mesh.patch_names.at(labels::inlet), "inlet");
}

// There are no more of them than tetrahedra in an isotropic mesh, and not much fewer.
TEST_P(Hexahedral_mesh, By_subdivision_has_about_as_many_cells_as_an_isotropic_one) {
  NEEDS_FILLING();
  Mesher mesher(model_of(GetParam().make()), by_subdivision(20));
  const double hexahedra = double(mesher.hexahedral().number_of_cells());
  const double tetrahedra = double(mesher.isotropic().number_of_cells());
  EXPECT_GT(hexahedra, 0.7 * tetrahedra);
  EXPECT_LT(hexahedra, 1.5 * tetrahedra);
}

// Caps included. What could not come there, as in the sharp crotch of the Y, is reported.
TEST_P(Hexahedral_mesh, By_subdivision_has_its_boundary_on_the_surface) {
  NEEDS_FILLING();
  const auto model = model_of(GetParam().make());
  Mesher_options options = by_subdivision();
  options.preserve_volume = false;
  Mesher mesher(model, options);
  const Mixed_mesh mesh = mesher.hexahedral();
  expect_hexahedra_alone(mesh);
  const Triangle_tree tree = tree_of(model.surface);
  std::set<std::uint32_t> points;
  for (const auto& q : mesh.quads.vertices)
    points.insert(q.begin(), q.end());
  const std::size_t off = std::size_t(std::count_if(points.begin(), points.end(), [&](std::uint32_t p) {
    return tree.nearest(tubular::internal::to_double_point(mesh.points[p])).squared_distance > 1e-18;
  }));
  const auto& told = mesher.report().hexahedral.boundary;
  EXPECT_LE(off, told.not_found + told.held_back);
  EXPECT_LT(double(off), 0.003 * double(points.size()));
  if (model.openings.size() == 2) // smooth all over
    EXPECT_EQ(off + told.not_found + told.held_back, 0u);
}

/* However the tetrahedra came out: those that a curved wall flattens are optimized after that, so that the wall need not
 * give way. In the sharp crotch of the Y it may have to with less than twelve points round, or with layers. */
TEST(Hexahedral_mesh_by_subdivision, Holds_no_vertex_back_from_a_curved_wall) {
  NEEDS_FILLING();
  struct Row {
    tubular::Tubular_skeleton skeleton;
    double first; // N
  };
  for (const Row& row : {Row{tubular::straight_tube(8, 1), 8}, Row{tubular::curved_tube(4, 1.8, 1), 8},
                         Row{tubular::curved_tube(3, 2.2, 1), 8}, Row{tubular::y_bifurcation(), 12}}) {
    const auto model = model_of(row.skeleton);
    const bool has_crotch = model.openings.size() > 2;
    for (double points = row.first; points <= 22; points += has_crotch && points < 14 ? 0.3 : 2)
      for (bool has_layers : {false, true}) {
        Mesher_options options = by_subdivision(points);
        options.preserve_volume = false;
        if (has_layers && (points < 12 || has_crotch))
          continue;
        if (has_layers)
          options.boundary_layer = tubular::Extrude_boundary_layer_options(
              parameters::boundary_layer_prisms(3).boundary_layer_thickness(0.3).growth(1.3));
        Mesher mesher(model, options);
        const Mixed_mesh mesh = mesher.hexahedral();
        const auto& report = mesher.report().hexahedral;
        EXPECT_EQ(report.boundary.held_back, 0u) << points << " " << has_layers;
        EXPECT_EQ(report.boundary.not_found, 0u) << points << " " << has_layers;
        EXPECT_GT(report.optimization.min_scaled_jacobian, has_layers ? 0.25 : 0.33) << points << " " << has_layers;
      }
  }
}

// Layers are as high as was asked for, and stay so where vertices have come to the surface: the first one of .05 r is a
// tenth of the facets' edges, and about as high as these are far from the surface.
TEST_P(Hexahedral_mesh, By_subdivision_has_layers_inside_and_a_wall_outside) {
  NEEDS_FILLING();
  const auto model = model_of(GetParam().make());
  Mesher_options options = by_subdivision();
  options.boundary_layer = tubular::Extrude_boundary_layer_options(
      parameters::boundary_layer_prisms(4).boundary_layer_thickness(0.3).first_height(0.05).growth(1.3));
  options.wall.emplace(parameters::wall_thickness(0.2).wall_layers(3).second_wall_thickness(0.1).second_wall_layers(2));
  Mesher mesher(model, options);
  const Mixed_mesh mesh = mesher.hexahedral();
  expect_hexahedra_alone(mesh);
  EXPECT_LT(std::abs(relative_volume(mesh, model)), 0.003);
  const std::size_t on_wall = std::size_t(std::count(mesh.quads.label.begin(), mesh.quads.label.end(), labels::wall));
  const auto cells = [&](int region) {
    return std::size_t(std::count(mesh.hexahedra.label.begin(), mesh.hexahedra.label.end(), region));
  };
  EXPECT_EQ(cells(2), 3 * on_wall);
  EXPECT_EQ(cells(3), 2 * on_wall);
  EXPECT_GT(cells(labels::lumen), 4 * on_wall);
  EXPECT_GE(mesher.report().hexahedral.optimization.min_scaled_jacobian, 0.12);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Hexahedral_mesh, ::testing::ValuesIn(shapes),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Hexahedral_mesh_by_subdivision, Is_of_lumens_with_loops) {
  NEEDS_FILLING();
  looped_surfaces::Septum s;
  s.holes = 1;
  s.flap = 4;
  s.length = 7;
  const auto model = tubular::make_tubular_model(looped_surfaces::septum(s));
  Mesher mesher(model, by_subdivision());
  const Mixed_mesh mesh = mesher.hexahedral();
  expect_hexahedra_alone(mesh);
  EXPECT_EQ(tubular::validity_report(mesh).boundary_euler, 2 - 2 * 2);
  EXPECT_LT(std::abs(relative_volume(mesh, model)), 0.003);
}

// From each corner of a facet of the wall, the edge of the hexahedron on it that leads away from the facet.
std::vector<std::array<Point_3, 2>> edges_into_first_layer(const Mixed_mesh& mesh) {
  typedef tubular::internal::Cell_topology<8> Topology;
  std::set<std::set<std::uint32_t>> wall;
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    if (mesh.quads.label[i] == labels::wall)
      wall.emplace(mesh.quads.vertices[i].begin(), mesh.quads.vertices[i].end());
  std::vector<std::array<Point_3, 2>> result;
  for (const auto& h : mesh.hexahedra.vertices)
    for (const auto& f : Topology::quads()) {
      std::set<std::uint32_t> face;
      for (int k : f)
        face.insert(h[std::size_t(k)]);
      if (wall.count(face) == 0)
        continue;
      for (const auto& c : Topology::corners())
        for (int k = 1; k < 4; ++k)
          if (face.count(h[std::size_t(c[0])]) != 0 && face.count(h[std::size_t(c[k])]) == 0)
            result.push_back({{mesh.points[h[std::size_t(c[0])]], mesh.points[h[std::size_t(c[k])]]}});
    }
  return result;
}

TEST(Hexahedral_mesh_by_subdivision, Has_a_first_layer_of_the_height_asked_for) {
  NEEDS_FILLING();
  Mesher_options options = by_subdivision(24);
  options.boundary_layer = tubular::Extrude_boundary_layer_options(
      parameters::boundary_layer_prisms(4).boundary_layer_thickness(0.3).first_height(0.0485).growth(1.3));
  const Mixed_mesh mesh = Mesher(model_of(tubular::straight_tube(8, 1)), options).hexahedral();
  const auto edges = edges_into_first_layer(mesh);
  std::size_t of_height = 0, upright = 0;
  for (const auto& e : edges) {
    const tubular::Vector_3 edge = e[1] - e[0], inward(-e[0].x(), -e[0].y(), 0); // the tube is along z
    const double length = std::sqrt(edge.squared_length());
    of_height += std::abs(length - 0.0485) < 0.15 * 0.0485;
    upright += edge * inward > std::cos(10 * CGAL_PI / 180) * length * std::sqrt(inward.squared_length());
  }
  ASSERT_GT(edges.size(), 1000u);
  EXPECT_GE(double(of_height), 0.98 * double(edges.size()));
  EXPECT_GE(double(upright), 0.95 * double(edges.size()));
}

// The coarser mesh is not so coarse that it loses the vessel.
TEST(Hexahedral_mesh_by_subdivision, Is_made_with_few_points_round_a_vessel) {
  NEEDS_FILLING();
  const auto model = model_of(tubular::straight_tube(6, 1));
  for (double points : {5., 7., 9.}) {
    const Mixed_mesh mesh = Mesher(model, by_subdivision(points)).hexahedral();
    expect_hexahedra_alone(mesh);
    EXPECT_LT(std::abs(relative_volume(mesh, model)), 0.02) << points;
  }
}

TEST(Hexahedral_mesh_by_subdivision, Is_made_of_what_Mesh_3_makes_too) {
  const auto model = model_of(tubular::straight_tube(4, 1));
  Mesher_options options = by_subdivision(12);
  options.surface_mesher = tubular::Surface_mesher::mesh_3;
  options.size.number_of_threads = 1;
  const Mixed_mesh mesh = Mesher(model, options).hexahedral();
  expect_hexahedra_alone(mesh);
  EXPECT_LT(std::abs(relative_volume(mesh, model)), 0.005);
}

TEST(Hexahedral_mesh_by_subdivision, Has_the_number_of_cells_asked_for) {
  NEEDS_FILLING();
  Mesher_options options = by_subdivision();
  options.number_of_elements = 20000;
  const Mixed_mesh mesh = Mesher(model_of(tubular::straight_tube(6, 1)), options).hexahedral();
  EXPECT_NEAR(double(mesh.number_of_cells()), 20000, 2000);
}

TEST(Hexahedral_mesh_by_subdivision, Does_not_depend_on_threads_or_on_meshes_before) {
  NEEDS_FILLING();
  const auto model = model_of(tubular::y_bifurcation(), 30);
  Mesher_options options = by_subdivision(12);
  options.size.number_of_threads = 1;
  const Mixed_mesh one = Mesher(model, options).hexahedral();
  Mesher mesher(model, by_subdivision(12));
  mesher.isotropic();
  const Mixed_mesh two = mesher.hexahedral();
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.hexahedra.vertices, two.hexahedra.vertices);
  EXPECT_EQ(mesher.points_per_circumference(), 12);
  EXPECT_EQ(mesher.isotropic().points, Mesher(model, by_subdivision(12)).isotropic().points); // of the size asked for
}

// --- where there are no blocks ---

TEST(Hexahedral_mesh_without_blocks, Is_by_subdivision_and_says_why) {
  NEEDS_FILLING();
  const auto model = model_of(hub_of_ten_vessels(), 16);
  Mesher mesher(model, parameters::points_per_circumference(12));
  const Mixed_mesh mesh = mesher.hexahedral();
  expect_hexahedra_alone(mesh);
  const tubular::Hexahedral_report& report = mesher.report().hexahedral;
  EXPECT_EQ(report.method, Hexahedral_method::subdivision);
  ASSERT_FALSE(report.places_without_blocks.empty());
  EXPECT_NE(report.places_without_blocks[0].reason.find("10 vessels"), std::string::npos);
  EXPECT_LT(CGAL::squared_distance(report.places_without_blocks[0].place, tubular::Point_3(0, 0, 0)), 0.1);
  ASSERT_EQ(mesher.report().fallbacks.size(), 1u);
  EXPECT_NE(mesher.report().fallbacks[0].find("subdivision"), std::string::npos) << mesher.report().fallbacks[0];
}

TEST(Hexahedral_mesh_without_blocks, Is_none_where_no_other_is_wanted) {
  const auto model = model_of(hub_of_ten_vessels(), 16);
  Mesher mesher(model, parameters::points_per_circumference(12).hexahedral_fallback(Hexahedral_fallback::none));
  try {
    mesher.hexahedral();
    FAIL() << "there is a mesh";
  } catch (const tubular::Meshing_error& e) {
    EXPECT_NE(std::string(e.what()).find("no blocks"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("subdivision"), std::string::npos) << e.what();
  }
}

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of hexahedra in blocks whose junctions without blocks are filled with pyramids and tetrahedra.

#include "hub_of_vessels.h"
#include "looped_surfaces.h"

#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Quads/blossom_recombination.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
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
using tubular::internal::Vector_3d;

#define NEEDS_QUADS()                                                                                                  \
  if (tubular::default_volume_mesher() == tubular::Volume_mesher::mesh_3 || !tubular::has_lemon())                     \
  GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1, or without LEMON"

// --- shapes with a junction that has no blocks ---

struct Vessels {
  tubular::Tubular_skeleton skeleton;

  Vessels() { skeleton.nodes.push_back(Point_3(0, 0, 0)); }
  // From a node on; returns the node at its end.
  std::size_t add(std::size_t from, const Vector_3d& direction, double radius, double length) {
    const Vector_3d a(skeleton.nodes[from]), b = a + length * tubular::internal::normalized(direction);
    skeleton.nodes.push_back(tubular::internal::as<Point_3>(b));
    skeleton.add_branch(
        from, skeleton.nodes.size() - 1, [=](double t) { return tubular::internal::as<Point_3>((1 - t) * a + t * b); },
        [=](double) { return radius; });
    return skeleton.nodes.size() - 1;
  }
};

/* Two vessels of one that part at an angle. */
tubular::Tubular_skeleton sharp_y(double degrees) {
  const double a = degrees * CGAL_PI / 360, length = 4 + 2 / std::tan(a);
  Vessels v;
  v.skeleton.inlet = v.add(0, Vector_3d(0, -1, 0), 1, 5);
  v.add(0, Vector_3d(std::sin(a), std::cos(a), 0), 0.8, length);
  v.add(0, Vector_3d(-std::sin(a), std::cos(a), 0), 0.8, length);
  return v.skeleton;
}

/* A vessel that becomes nine, evenly round its direction, more than blocks can join; on the first of them a side branch may
 * leave at a right angle, far from there. */
constexpr double radius_of_nine = 0.3;
tubular::Tubular_skeleton fork_of_nine(double degrees, bool has_side_branch = false) {
  const double a = degrees * CGAL_PI / 180;
  Vessels v;
  v.skeleton.inlet = v.add(0, Vector_3d(0, 0, -1), 1, 5);
  for (int i = 0; i < 9; ++i) {
    const double b = 2 * CGAL_PI * i / 9;
    const Vector_3d along(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
    const std::size_t end = v.add(0, along, radius_of_nine, 4);
    if (has_side_branch && i == 0) {
      v.add(end, Vector_3d(std::cos(a), 0, -std::sin(a)), 0.25, 3);
      v.add(end, along, radius_of_nine, 3);
    }
  }
  return v.skeleton;
}

struct Shape {
  std::string name;
  std::function<tubular::Tubular_skeleton()> make;
  std::string reason; // a part of it
};
std::ostream& operator<<(std::ostream& out, const Shape& s) {
  return out << s.name;
}

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = {
      {"Fork_of_nine", [] { return fork_of_nine(60); }, "10 vessels"},
      {"Hub_of_ten", hub_of_ten_vessels, "10 vessels"},
  };
  return all;
}

tubular::Tubular_model model_of(const tubular::Tubular_skeleton& skeleton) {
  tubular::Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(30));
  return tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton));
}

Mesher_options filled(double points = 16) {
  Mesher_options options(parameters::points_per_circumference(points));
  options.hexahedral_fallback = Hexahedral_fallback::mixed;
  return options;
}

tubular::Extrude_boundary_layer_options four_layers() {
  return tubular::Extrude_boundary_layer_options(
      parameters::boundary_layer_prisms(4).first_height(0.3 / 6.187).growth(1.3));
}

// --- what the meshes are like ---

std::size_t count(const std::vector<int>& labels, int label) {
  return std::size_t(std::count(labels.begin(), labels.end(), label));
}

template <std::size_t N>
std::array<Vector_3d, N> corners(const Mixed_mesh& mesh, const std::array<std::uint32_t, N>& c) {
  std::array<Vector_3d, N> p;
  for (std::size_t i = 0; i < N; ++i)
    p[i] = Vector_3d(mesh.points[c[i]]);
  return p;
}

template <std::size_t N> double least_jacobian(const Mixed_mesh& mesh, const tubular::Element_block<N>& cells) {
  double least = 1;
  for (const auto& c : cells.vertices)
    least = (std::min)(least, tubular::internal::scaled_jacobian<N>(corners(mesh, c)));
  return least;
}

// Faces fit together, cells are not turned over, and the volume and the openings are those of the surface.
void expect_mesh_of(const Mixed_mesh& mesh, const tubular::Tubular_model& model) {
  EXPECT_EQ(tubular::validity_report(mesh).defects(), "");
  EXPECT_GT(least_jacobian(mesh, mesh.hexahedra), 0);
  EXPECT_GT(least_jacobian(mesh, mesh.pyramids), 0);
  EXPECT_GT(least_jacobian(mesh, mesh.tetrahedra), 0);
  const auto measures = tubular::lumen_measures(mesh, model.openings.size());
  const double volume = CGAL::Polygon_mesh_processing::volume(model.surface);
  EXPECT_NEAR(measures.volume, volume, 0.003 * volume);
  for (const auto& o : model.openings)
    EXPECT_NEAR(measures.opening_area.at(o.patch), o.area, 0.005 * o.area);
  EXPECT_EQ(mesh.region_names.at(labels::lumen), "lumen");
  EXPECT_EQ(mesh.patch_names.at(labels::inlet), "inlet");
}

// All pyramids and tetrahedra are in the places of the report.
void expect_report(const tubular::Mesher_report& report, const Mixed_mesh& mesh, const std::string& reason) {
  const tubular::Hexahedral_report& h = report.hexahedral;
  ASSERT_EQ(h.places_without_blocks.size(), 1u);
  const tubular::Place_without_blocks& p = h.places_without_blocks[0];
  EXPECT_EQ(h.method, Hexahedral_method::blocks);
  EXPECT_NE(p.reason.find(reason), std::string::npos) << p.reason;
  EXPECT_LT(CGAL::squared_distance(p.place, Point_3(0, 0, 0)), 1);
  EXPECT_EQ(p.pyramids, mesh.pyramids.size());
  EXPECT_EQ(p.tetrahedra, mesh.tetrahedra.size());
  EXPECT_GT(p.pyramids, 0u);
  EXPECT_GT(p.tetrahedra, 0u);
  ASSERT_EQ(report.fallbacks.size(), 1u);
  EXPECT_NE(report.fallbacks[0].find(std::to_string(p.tetrahedra) + " tetrahedra"), std::string::npos)
      << report.fallbacks[0];
}

class Filled_junction : public ::testing::TestWithParam<Shape> {};

TEST_P(Filled_junction, Fits_between_blocks) {
  NEEDS_QUADS();
  Mesher mesher(model_of(GetParam().make()), filled());
  const Mixed_mesh mesh = mesher.hexahedral();
  expect_mesh_of(mesh, mesher.model());
  expect_report(mesher.report(), mesh, GetParam().reason);
  EXPECT_GT(least_jacobian(mesh, mesh.hexahedra), 0.3);
  EXPECT_EQ(mesh.prisms.size(), 0u);
  const std::size_t vessels = mesher.model().openings.size();
  EXPECT_EQ(mesher.report().hexahedral.number_of_blocks, 12 * vessels);
  EXPECT_EQ(count(mesh.quads.label, labels::inlet), 32u); // 4 s² of the core and 8 s of the ring
}

// No layer ends at a junction: each facet of the wall has a hexahedron, as high at the wall as it was to be.
TEST_P(Filled_junction, Has_layers_that_go_on) {
  NEEDS_QUADS();
  Mesher_options options = filled();
  options.boundary_layer = four_layers();
  Mesher mesher(model_of(GetParam().make()), options);
  const Mixed_mesh mesh = mesher.hexahedral();
  expect_mesh_of(mesh, mesher.model());
  expect_report(mesher.report(), mesh, GetParam().reason);
  std::set<std::set<std::uint32_t>> wall;
  for (std::size_t k = 0; k < mesh.quads.size(); ++k)
    if (mesh.quads.label[k] == labels::wall)
      wall.emplace(mesh.quads.vertices[k].begin(), mesh.quads.vertices[k].end());
  std::size_t with_hexahedron = 0;
  for (const auto& h : mesh.hexahedra.vertices)
    for (const auto& f : tubular::internal::Cell_topology<8>::quads())
      with_hexahedron += wall.count({h[f[0]], h[f[1]], h[f[2]], h[f[3]]});
  EXPECT_EQ(with_hexahedron, wall.size());
  EXPECT_EQ(mesh.triangles.size(), 0u);
  const tubular::Layer_report& layers = mesher.report().boundary_layer;
  EXPECT_EQ(layers.hexahedra, 4 * wall.size());
  EXPECT_GT(layers.mean_ratio, 0.95);
  EXPECT_LT(double(layers.reduced_vertices), 0.1 * double(layers.vertices));
}

INSTANTIATE_TEST_SUITE_P(Shapes, Filled_junction, ::testing::ValuesIn(shapes()),
                         [](const auto& info) { return info.param.name; });

TEST(Filled_junctions, Have_a_wall_outside) {
  NEEDS_QUADS();
  Mesher_options options = filled();
  options.boundary_layer = four_layers();
  options.wall.emplace(parameters::wall_thickness(0.1).wall_layers(2));
  Mesher mesher(model_of(fork_of_nine(60)), options);
  const Mixed_mesh mesh = mesher.hexahedral();
  EXPECT_EQ(tubular::validity_report(mesh).defects(), "");
  EXPECT_EQ(count(mesh.hexahedra.label, labels::wall_region), 2 * count(mesh.quads.label, labels::wall));
  EXPECT_GT(mesh.pyramids.size(), 0u);
}

// The vessels part at a radius over the sine of half of the angle between neighbors.
TEST(Filled_junctions, Are_no_larger_than_they_must_be) {
  NEEDS_QUADS();
  const double crotch = radius_of_nine / (std::sin(60 * CGAL_PI / 180) * std::sin(CGAL_PI / 9));
  const Mixed_mesh mesh = Mesher(model_of(fork_of_nine(60)), filled()).hexahedral();
  ASSERT_GT(mesh.tetrahedra.size(), 0u);
  for (const auto& t : mesh.tetrahedra.vertices)
    for (const Vector_3d& p : corners(mesh, t)) {
      EXPECT_GT(p.z, -3);
      EXPECT_LT(norm(p), crotch + 2);
    }
}

TEST(Filled_junctions, Leave_blocks_to_others) {
  NEEDS_QUADS();
  Mesher mesher(model_of(fork_of_nine(60, true)), filled());
  const Mixed_mesh mesh = mesher.hexahedral();
  expect_mesh_of(mesh, mesher.model());
  expect_report(mesher.report(), mesh, "10 vessels");
  EXPECT_EQ(mesher.report().hexahedral.number_of_junctions, 2u);
  EXPECT_EQ(mesher.report().hexahedral.number_of_blocks, 12 * 12u);
}

TEST(Filled_junctions, Do_not_depend_on_threads) {
  NEEDS_QUADS();
  const auto model = model_of(fork_of_nine(60));
  Mesher_options options = filled();
  options.boundary_layer = four_layers();
  options.size.number_of_threads = options.boundary_layer.number_of_threads = options.pyramids.number_of_threads = 1;
  const Mixed_mesh one = Mesher(model, options).hexahedral();
  options.size.number_of_threads = options.boundary_layer.number_of_threads = options.pyramids.number_of_threads = 2;
  const Mixed_mesh two = Mesher(model, options).hexahedral();
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.tetrahedra.vertices, two.tetrahedra.vertices);
}

TEST(Filled_junctions, Are_not_made_where_nothing_else_is_wanted) {
  Mesher_options options = filled();
  options.hexahedral_fallback = Hexahedral_fallback::none;
  EXPECT_THROW(Mesher(model_of(fork_of_nine(60)), options).hexahedral(), tubular::Meshing_error);
}

// Where all is in order there are hexahedra alone.
TEST(Filled_junctions, Are_not_made_where_there_are_blocks) {
  Mesher mesher(model_of(sharp_y(60)), filled());
  const Mixed_mesh mesh = mesher.hexahedral();
  EXPECT_EQ(mesh.number_of_cells(), mesh.hexahedra.size());
  EXPECT_TRUE(mesher.report().fallbacks.empty());
}

// A septum divides the lumen: that is no junction.
TEST(Filled_junctions, Are_none_where_it_is_no_junction_that_lacks_blocks) {
  NEEDS_QUADS();
  looped_surfaces::Septum s;
  s.holes = 1;
  s.flap = 4;
  s.length = 7;
  Mesher mesher(tubular::make_tubular_model(looped_surfaces::septum(s)), filled(12));
  const Mixed_mesh mesh = mesher.hexahedral();
  EXPECT_EQ(tubular::validity_report(mesh).defects(), "");
  if (mesher.report().hexahedral.method == Hexahedral_method::blocks)
    GTEST_SKIP() << "it has blocks";
  EXPECT_EQ(mesh.number_of_cells(), mesh.hexahedra.size());
  ASSERT_EQ(mesher.report().fallbacks.size(), 1u);
  EXPECT_NE(mesher.report().fallbacks[0].find("Nor can junctions"), std::string::npos) << mesher.report().fallbacks[0];
}

} // namespace

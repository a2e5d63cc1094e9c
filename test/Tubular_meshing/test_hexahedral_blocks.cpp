// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Blocks of hexahedra along vessels: how junctions are divided, what the blocks of known shapes are like, and layers.

#include "hub_of_vessels.h"

#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Hexahedra/Block_structure.h>
#include <CGAL/Tubular_meshing/Hexahedra/hexahedral_blocks.h>
#include <CGAL/Tubular_meshing/Hexahedra/insert_wall_layers.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Disc_grid.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Junction_partition.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace parameters = tubular::parameters;
namespace labels = tubular::labels;
using tubular::Mixed_mesh;
using tubular::Point_3;
using tubular::internal::Disc_grid;
using tubular::internal::Junction_partition;
using tubular::internal::Junction_partitioner;
using tubular::internal::Vector_3d;

constexpr double pi = 3.14159265358979323846;

// --- directions round a junction ---

// Regions are four-sided, counterclockwise round their directions, and share each side with one neighbor.
void expect_partition(const std::vector<Vector_3d>& directions) {
  const std::size_t k = directions.size();
  const auto partition = Junction_partitioner(directions).partition();
  ASSERT_TRUE(partition.has_value());
  EXPECT_EQ(partition->corners.size(), k + 2);
  EXPECT_EQ(partition->sides.size(), 2 * k);
  ASSERT_EQ(partition->regions.size(), k);
  std::map<std::size_t, int> times;
  for (std::size_t v = 0; v < k; ++v) {
    const auto& r = partition->regions[v];
    EXPECT_EQ(std::set<std::size_t>(r.corners.begin(), r.corners.end()).size(), 4u);
    double turn = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& side = partition->sides[r.sides[i]];
      ++times[r.sides[i]];
      EXPECT_EQ(side.regions[r.forward[i] ? 0 : 1], v);
      EXPECT_EQ(r.forward[i] ? side.from : side.to, r.corners[i]);
      EXPECT_EQ(r.forward[i] ? side.to : side.from, r.corners[(i + 1) % 4]);
      const std::array<Vector_3d, 3> around = {partition->corners[r.corners[i]], side.middle,
                                               partition->corners[r.corners[(i + 1) % 4]]};
      for (int j = 0; j < 2; ++j) {
        const Vector_3d &a = around[j], &b = around[j + 1], &d = directions[v];
        turn += std::atan2(dot(d, cross(a, b)), dot(a, b) - dot(a, d) * dot(b, d));
      }
    }
    EXPECT_NEAR(turn, 2 * pi, 1e-6);
  }
  for (const auto& [side, n] : times)
    EXPECT_EQ(n, 2) << "side " << side;
}

std::vector<Vector_3d> in_plane(const std::vector<double>& degrees) {
  std::vector<Vector_3d> result;
  for (double d : degrees)
    result.emplace_back(std::cos(d * pi / 180), std::sin(d * pi / 180), 0);
  return result;
}

TEST(Junction_partition, Of_two_directions) {
  expect_partition(in_plane({0, 180}));
  expect_partition(in_plane({0, 120}));
}

TEST(Junction_partition, Of_directions_in_a_plane) {
  expect_partition(in_plane({0, 120, 240}));
  expect_partition(in_plane({0, 90, 180}));
  expect_partition(in_plane({0, 160, 180})); // a twig at a small angle
  expect_partition(in_plane({0, 90, 180, 270}));
  expect_partition(in_plane({0, 72, 144, 216, 288}));
}

TEST(Junction_partition, Of_directions_in_space) {
  const auto unit = [](double x, double y, double z) { return normalized(Vector_3d(x, y, z)); };
  expect_partition({unit(1, 1, 1), unit(1, -1, -1), unit(-1, 1, -1), unit(-1, -1, 1)});
  expect_partition({unit(0, 0, -1), unit(1, 0, 0.5), unit(-0.5, 0.8, 0.5), unit(-0.5, -0.8, 0.5)});
  expect_partition({unit(1, 0, 0), unit(-1, 0, 0), unit(0, 1, 0), unit(0, -1, 0), unit(0, 0, 1), unit(0, 0, -1)});
}

// Two thirds of the corners of three directions are crotches, with two vessels each.
TEST(Junction_partition, Of_three_directions_has_two_poles) {
  const auto p = Junction_partitioner(in_plane({0, 100, 200})).partition();
  ASSERT_TRUE(p.has_value());
  std::multiset<std::size_t> degrees;
  for (std::size_t c = 0; c < p->corners.size(); ++c)
    degrees.insert(p->degree(c));
  EXPECT_EQ(degrees, (std::multiset<std::size_t>{2, 2, 2, 3, 3}));
}

TEST(Junction_partition, Of_random_directions) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (std::size_t k : {3, 4, 5, 6})
    for (int n = 0; n < 20; ++n) {
      std::vector<Vector_3d> directions;
      while (directions.size() < k) {
        const Vector_3d d = normalized(Vector_3d(normal(random), normal(random), normal(random)));
        if (std::all_of(directions.begin(), directions.end(), [&](const Vector_3d& e) { return dot(d, e) < 0.8; }))
          directions.push_back(d);
      }
      const auto p = Junction_partitioner(directions).partition();
      ASSERT_TRUE(p.has_value());
      EXPECT_EQ(p->corners.size(), k + 2);
    }
}

// --- sections ---

TEST(Disc_grid, Has_a_center_axes_and_squares) {
  for (int s : {1, 2, 3, 5}) {
    const Disc_grid disc(s);
    EXPECT_EQ(disc.size(), std::size_t((2 * s + 1) * (2 * s + 1)));
    EXPECT_EQ(disc.quads().size(), std::size_t(4 * s * s));
    EXPECT_EQ(disc.boundary().size(), std::size_t(8 * s));
    for (const auto& q : disc.quads()) {
      std::array<Vector_3d, 4> p;
      for (int i = 0; i < 4; ++i) {
        const auto polar = disc.polar(q[i], 0.7);
        const double a = 2 * pi * polar.step / (8 * s);
        p[i] = Vector_3d(polar.distance * std::cos(a), polar.distance * std::sin(a), 0);
      }
      EXPECT_GT(cross(p[1] - p[0], p[3] - p[0]).z, 0);
      EXPECT_GT(cross(p[3] - p[2], p[1] - p[2]).z, 0);
    }
  }
}

TEST(Disc_grid, Seen_from_the_other_side_twice_is_what_it_was) {
  const Disc_grid disc(3);
  for (int turns = 0; turns < 4; ++turns) {
    std::set<std::size_t> found;
    for (std::size_t v = 0; v < disc.size(); ++v) {
      EXPECT_EQ(disc.mirrored(disc.mirrored(v, turns), turns), v);
      found.insert(disc.mirrored(v, turns));
    }
    EXPECT_EQ(found.size(), disc.size());
  }
}

// --- blocks of known shapes ---

// Vessels from one junction, each with its direction, radius and length.
struct Star {
  struct Vessel {
    Vector_3d direction;
    double radius, length;
  };
  std::vector<Vessel> vessels;

  tubular::Tubular_skeleton skeleton() const {
    tubular::Tubular_skeleton result;
    result.nodes.push_back(Point_3(0, 0, 0));
    for (const Vessel& v : vessels) {
      const Vector_3d e = v.length * normalized(v.direction);
      result.nodes.push_back(Point_3(e.x, e.y, e.z));
      result.add_branch(
          0, result.nodes.size() - 1, [&](double t) { return Point_3(t * e.x, t * e.y, t * e.z); },
          [&](double) { return v.radius; });
    }
    result.inlet = 1;
    return result;
  }
};

struct Shape {
  std::string name;
  std::function<tubular::Tubular_skeleton()> make;
};
std::ostream& operator<<(std::ostream& out, const Shape& s) {
  return out << s.name;
}

Shape y(double degrees, double ratio) {
  const double a = degrees * pi / 360;
  return {"Y_of_" + std::to_string(int(degrees)) + "_degrees_and_ratio_" + std::to_string(int(10 * ratio)) + "_tenths",
          [=] {
            const double length = 3 + 2 / std::tan(a);
            return Star{{{Vector_3d(0, -1, 0), 1, 5},
                         {Vector_3d(std::sin(a), std::cos(a), 0), 0.8, length},
                         {Vector_3d(-std::sin(a), std::cos(a), 0), 0.8 / ratio, length}}}
                .skeleton();
          }};
}
Shape t(double ratio) {
  return {"T_of_ratio_" + std::to_string(int(10 * ratio)) + "_tenths", [=] {
            return Star{{{Vector_3d(-1, 0, 0), 1, 5}, {Vector_3d(1, 0, 0), 1, 5}, {Vector_3d(0, 1, 0), 1 / ratio, 4}}}
                .skeleton();
          }};
}
Shape star(const std::string& name, const std::vector<Vector_3d>& directions) {
  return {name, [=] {
            Star s;
            for (const Vector_3d& d : directions)
              s.vessels.push_back({d, s.vessels.size() % 2 ? 0.8 : 1, 5});
            return s.skeleton();
          }};
}

const std::vector<Shape>& shapes() {
  typedef Vector_3d V;
  static const std::vector<Shape> all = {
      {"Tube", [] { return tubular::straight_tube(8, 1); }},
      {"Bend", [] { return tubular::curved_tube(4, 1.8, 1); }},
      {"Willis", [] { return tubular::willis_loop(); }},
      {"Arch", [] { return tubular::aortic_arch(); }},
      {"Tree", [] { return tubular::bronchial_tree(31); }},
      y(30, 1),
      y(40, 1.5),
      y(60, 1),
      y(90, 2),
      y(120, 1),
      y(150, 5),
      t(1),
      t(2),
      t(3),
      t(5),
      star("Four_in_a_plane", {V(1, 0, 0), V(0, 1, 0), V(-1, 0, 0), V(0, -1, 0)}),
      star("Tetrahedral", {V(1, 1, 1), V(1, -1, -1), V(-1, 1, -1), V(-1, -1, 1)}),
      star("Five", {V(0, 0, -1), V(1, 0, 0.4), V(0, 1, 0.4), V(-1, 0, 0.4), V(0, -1, 0.4)}),
      star("Six", {V(1, 0, 0), V(-1, 0, 0), V(0, 1, 0), V(0, -1, 0), V(0, 0, 1), V(0, 0, -1)}),
  };
  return all;
}

double least_scaled_jacobian(const Mixed_mesh& mesh, double* mean = nullptr) {
  double least = 1, sum = 0;
  for (const auto& h : mesh.hexahedra.vertices) {
    std::array<Vector_3d, 8> p;
    for (int i = 0; i < 8; ++i)
      p[i] = Vector_3d(mesh.points[h[i]]);
    const double q = tubular::internal::scaled_jacobian<8>(p);
    least = (std::min)(least, q);
    sum += q;
  }
  if (mean)
    *mean = sum / double(mesh.hexahedra.size());
  return least;
}

// Twelve blocks a vessel, that match each other and the openings, at vertices of the mesh.
void expect_structure(const tubular::Block_structure& structure, const Mixed_mesh& mesh,
                      const tubular::Hexahedral_report& report, std::size_t openings) {
  const std::size_t vessels = report.twist.size();
  EXPECT_EQ(structure.hexahedra.size(), 12 * vessels);
  EXPECT_EQ(structure.hexahedra.size(), report.number_of_blocks);
  EXPECT_EQ(structure.quads.size(), 8 * vessels + 12 * openings);
  const Mixed_mesh blocks = tubular::make_block_mesh(structure, mesh.points);
  EXPECT_EQ(blocks.region_names.size(), vessels);
  const tubular::Validity_report validity = tubular::validity_report(blocks);
  EXPECT_EQ(validity.overfull_faces, 0u);
  EXPECT_EQ(validity.nonmanifold_edges, 0u);
  EXPECT_EQ(validity.unlabelled_faces, 0u);
  EXPECT_EQ(validity.misplaced_facets, 0u);
  EXPECT_EQ(validity.connected_components, 1u);
  const std::set<Point_3> points(mesh.points.begin(), mesh.points.end());
  for (const Point_3& p : blocks.points)
    EXPECT_EQ(points.count(p), 1u);
}

class Hexahedral_blocks : public ::testing::TestWithParam<Shape> {
protected:
  static tubular::Tubular_model model() {
    const tubular::Tubular_skeleton skeleton = GetParam().make();
    tubular::Surface surface;
    tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(30));
    return tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton));
  }
};

TEST_P(Hexahedral_blocks, Are_valid_and_well_shaped) {
  tubular::Mesher mesher(model(), parameters::points_per_circumference(24));
  const Mixed_mesh mesh = mesher.hexahedral();
  ASSERT_TRUE(mesher.report().fallbacks.empty()) << mesher.report().fallbacks[0];
  EXPECT_EQ(mesher.report().hexahedral.method, tubular::Hexahedral_method::blocks);
  EXPECT_EQ(mesh.number_of_cells(), mesh.hexahedra.size());
  EXPECT_EQ(mesh.number_of_facets(), mesh.quads.size());
  EXPECT_EQ(tubular::validity_report(mesh).defects(), "");
  double mean = 0;
  EXPECT_GT(least_scaled_jacobian(mesh, &mean), 0.2);
  EXPECT_GT(mean, 0.85);
  const auto measures = tubular::lumen_measures(mesh, mesher.model().openings.size());
  const double volume = CGAL::Polygon_mesh_processing::volume(mesher.model().surface);
  EXPECT_NEAR(measures.volume, volume, 0.003 * volume);
  for (const auto& o : mesher.model().openings)
    EXPECT_NEAR(measures.opening_area.at(o.patch), o.area, 0.005 * o.area);
  expect_structure(mesher.block_structure(), mesh, mesher.report().hexahedral, mesher.model().openings.size());
}

// Four layers that take up 0.3 radii: thin ones have the height asked for, next to all of the wall.
TEST_P(Hexahedral_blocks, Take_layers_along_the_wall) {
  const double first_height = 0.3 / 6.187;
  tubular::Mesher mesher(
      model(),
      parameters::points_per_circumference(24).boundary_layer_prisms(4).first_height(first_height).growth(1.3));
  const Mixed_mesh mesh = mesher.hexahedral();
  ASSERT_TRUE(mesher.report().fallbacks.empty()) << mesher.report().fallbacks[0];
  EXPECT_EQ(mesh.number_of_cells(), mesh.hexahedra.size());
  EXPECT_EQ(tubular::validity_report(mesh).defects(), "");
  EXPECT_GT(least_scaled_jacobian(mesh), 0.15);
  const tubular::Layer_report& layers = mesher.report().boundary_layer;
  EXPECT_GT(layers.vertices, 0u);
  EXPECT_LT(double(layers.reduced_vertices), 0.15 * double(layers.vertices));
  EXPECT_GT(layers.mean_ratio, 0.95);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Hexahedral_blocks, ::testing::ValuesIn(shapes()),
                         [](const auto& info) { return info.param.name; });

// --- vessels that have no simple end ---

// Four veins and a wide, short opening: no centerline runs along what leads to the opening, as from there they part.
TEST(Hexahedral_blocks_of_an_atrium, Reach_its_wide_opening) {
  typedef Vector_3d V;
  for (const double depth : {2.6, 3.2}) {
    const Star atrium{{{V(0, 0, -1), 3.4, depth},
                       {V(1, 1, 0.7), 0.9, 7},
                       {V(-1, 1, 0.7), 0.9, 7},
                       {V(-1, -1, 0.7), 0.9, 7},
                       {V(1, -1, 0.7), 0.9, 7}}};
    tubular::Surface surface;
    tubular::generate_tubular_surface(atrium.skeleton(), surface, parameters::points_per_circumference(24));
    tubular::Mesher mesher(tubular::make_tubular_model(surface), parameters::points_per_circumference(24));
    const Mixed_mesh mesh = mesher.hexahedral();
    ASSERT_TRUE(mesher.report().fallbacks.empty()) << mesher.report().fallbacks[0];
    EXPECT_EQ(mesher.report().hexahedral.twist.size(), 5u);
    EXPECT_EQ(tubular::validity_report(mesh).defects(), "");
    EXPECT_GT(least_scaled_jacobian(mesh), 0.2);
    EXPECT_EQ(tubular::lumen_measures(mesh, 5).opening_area.size(), 5u);
    expect_structure(mesher.block_structure(), mesh, mesher.report().hexahedral, 5);
  }
}

// Segmentations leave blind ends flat, with spikes at the corners of voxels: these are no vessels of their own.
TEST(Hexahedral_blocks_of_a_blind_end, Are_valid_under_spikes) {
  const auto skeleton = y(90, 1.5).make();
  const Vector_3d center(skeleton.nodes.back()), axis = normalized(center), u(0, 0, 1), w = cross(axis, u);
  const double radius = 0.8 / 1.5;
  for (const double unit : {1., 1e-3}) {
    tubular::Surface surface;
    tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(24).capped_ends(true));
    int spikes = 0;
    for (auto v : surface.vertices()) {
      const Vector_3d d = Vector_3d(surface.point(v)) - center;
      if (std::abs(dot(d, axis)) > 0.01 || norm(d) < 0.9 * radius || norm(d) > 1.1 * radius)
        continue;
      const double angle = std::atan2(dot(d, w), dot(d, u));
      if (std::abs(std::remainder(angle, pi / 2)) < pi / 24) {
        const Vector_3d p = center + d + 0.7 * radius * axis;
        surface.point(v) = Point_3(p.x, p.y, p.z);
        ++spikes;
      }
    }
    ASSERT_GE(spikes, 3);
    for (auto v : surface.vertices())
      surface.point(v) = Point_3(unit * surface.point(v).x(), unit * surface.point(v).y(), unit * surface.point(v).z());
    const Point_3 tip(unit * center.x, unit * center.y, unit * center.z);
    tubular::Mesher mesher(tubular::make_tubular_model(surface, parameters::blind_ends(std::vector<Point_3>{tip})),
                           parameters::points_per_circumference(24));
    const Mixed_mesh mesh = mesher.hexahedral();
    ASSERT_TRUE(mesher.report().fallbacks.empty()) << mesher.report().fallbacks[0];
    EXPECT_EQ(mesher.model().openings.size(), 2u);
    EXPECT_EQ(mesher.report().hexahedral.twist.size(), 3u);
    EXPECT_EQ(mesher.block_structure().hexahedra.size(), 40u); // four more on the blind end
    EXPECT_EQ(tubular::validity_report(mesh).defects(), "");
    EXPECT_GT(least_scaled_jacobian(mesh), 0.1);
  }
}

// --- the boundary alone ---

TEST(Structured_quads, Are_the_boundary_of_blocks) {
  const auto skeleton = tubular::y_bifurcation();
  tubular::Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(30));
  tubular::Mesher mesher(tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton)),
                         parameters::points_per_circumference(16));
  const Mixed_mesh mesh = mesher.hexahedral();
  const tubular::Remeshed_surface quads = mesher.surface(tubular::Surface_elements::structured_quads);
  EXPECT_TRUE(mesher.block_structure().hexahedra.empty()); // of a mesh that is gone
  EXPECT_TRUE(CGAL::is_closed(quads.surface));
  EXPECT_TRUE(CGAL::is_quad_mesh(quads.surface));
  ASSERT_EQ(quads.surface.number_of_faces(), mesh.quads.size());
  std::map<int, std::size_t> labels_of_quads, labels_of_mesh;
  for (auto f : quads.surface.faces())
    ++labels_of_quads[quads.patch[f]];
  for (int l : mesh.quads.label)
    ++labels_of_mesh[l];
  EXPECT_EQ(labels_of_quads, labels_of_mesh);
  const std::set<Point_3> points(mesh.points.begin(), mesh.points.end());
  for (auto v : quads.surface.vertices())
    EXPECT_EQ(points.count(quads.surface.point(v)), 1u);
}

TEST(Structured_quads, Of_a_hub_of_ten_vessels_are_refused) {
  tubular::Surface surface;
  tubular::generate_tubular_surface(hub_of_ten_vessels(), surface, parameters::points_per_circumference(16));
  tubular::Mesher mesher(tubular::make_tubular_model(surface), parameters::points_per_circumference(16));
  EXPECT_THROW(mesher.surface(tubular::Surface_elements::structured_quads), tubular::Meshing_error);
  tubular::Mesher with_layers(mesher.model(),
                              parameters::points_per_circumference(16).boundary_layer_prisms(2).first_height(0.05));
  EXPECT_THROW(with_layers.surface(tubular::Surface_elements::structured_quads), tubular::Parameter_error);
}

// --- options ---

TEST(Hexahedral_blocks_of_a_tube, Have_eight_points_round_it_or_multiples) {
  const auto skeleton = tubular::straight_tube(8, 1);
  tubular::Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(60));
  const auto model = tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton));
  for (const auto& [asked, made] : std::map<double, std::size_t>{{8, 8}, {12, 16}, {20, 24}, {24, 24}, {33, 32}}) {
    tubular::Mesher mesher(model, parameters::points_per_circumference(asked));
    const Mixed_mesh mesh = mesher.hexahedral();
    EXPECT_EQ(mesher.report().hexahedral.points_per_circumference, made);
    std::set<std::uint32_t> rim, inlet;
    for (std::size_t i = 0; i < mesh.quads.size(); ++i)
      for (auto v : mesh.quads.vertices[i])
        (mesh.quads.label[i] == labels::wall ? rim : inlet).insert(v);
    std::size_t both = 0;
    for (auto v : rim)
      both += inlet.count(v);
    EXPECT_EQ(both, 2 * made);
  }
  EXPECT_THROW(tubular::Mesher(model, parameters::points_per_circumference(7)).hexahedral(), tubular::Parameter_error);
}

// The sharper the crotch, the flatter the hexahedra in it.
TEST(Hexahedral_blocks_of_a_sharp_crotch, Are_valid) {
  const auto skeleton = y(20, 1).make();
  tubular::Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(30));
  const auto model = tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton));
  for (const int layers : {0, 4}) {
    tubular::Mesher_options options(parameters::points_per_circumference(24));
    if (layers > 0)
      options.boundary_layer =
          tubular::Extrude_boundary_layer_options(parameters::boundary_layer_prisms(layers).first_height(0.3 / 6.187));
    tubular::Mesher mesher(model, options);
    const Mixed_mesh mesh = mesher.hexahedral();
    EXPECT_EQ(mesher.report().hexahedral.method, tubular::Hexahedral_method::blocks);
    EXPECT_EQ(tubular::validity_report(mesh).defects(), "");
    EXPECT_GT(least_scaled_jacobian(mesh), 0.3);
  }
}

TEST(Hexahedral_blocks_of_a_tube, Do_not_depend_on_threads) {
  const auto skeleton = tubular::y_bifurcation();
  tubular::Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(30));
  const auto model = tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton));
  const auto layers = parameters::boundary_layer_prisms(3).first_height(0.05);
  const Mixed_mesh one = tubular::make_hexahedral_mesh(model, layers.number_of_threads(1));
  const Mixed_mesh two = tubular::make_hexahedral_mesh(model, layers.number_of_threads(2));
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.hexahedra.vertices, two.hexahedra.vertices);
}

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Quadratic meshes of vessels of known volume: tube, bend, a vessel with a round end; of all types of mesh. Volumes are
// integrated by the textbooks' shape functions, cell by cell.

#include "quadratic_meshes.h"

#include <CGAL/Tubular_meshing/Quadratic/internal/Cell_straightener.h>
#include <CGAL/Tubular_meshing/Quadratic/internal/Curved_nodes.h>
#include <CGAL/Tubular_meshing/Quadratic/internal/Quadratic_cell.h>
#include <CGAL/Tubular_meshing/Quadratic/quadratic_quality.h>
#include <CGAL/Tubular_meshing/Quads/blossom_recombination.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace quadratic_meshes;
namespace parameters = tubular::parameters;

const std::vector<std::string> types = {"isotropic", "anisotropic", "mixed", "hexahedral"};

bool makes(const std::string& type) {
  if (type == "hexahedral")
    return true;
  return tubular::default_volume_mesher() != tubular::Volume_mesher::mesh_3 &&
         (type != "mixed" || tubular::has_lemon());
}

void expect_conforming(const Quadratic_mesh& mesh) {
  // each edge and quad once, and between corners of cells
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> edges;
  tubular::internal::for_each_block_of_cells(mesh.linear, [&](Element_type type, const auto& block) {
    const auto& t = tubular::topology_of(type);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const auto nodes = mesh.nodes(type, block.vertices[i].data(), i);
      for (std::size_t k = 0; k < t.number_of_edges; ++k) {
        const auto a = nodes[std::size_t(t.edges[k][0])], b = nodes[std::size_t(t.edges[k][1])];
        const auto inserted = edges.emplace(std::minmax(a, b), nodes[t.corners + k]);
        EXPECT_EQ(inserted.first->second, nodes[t.corners + k]);
        EXPECT_LT(nodes[t.corners + k], mesh.number_of_nodes());
      }
    }
  });
  EXPECT_EQ(edges.size(), mesh.edge_points.size());
  EXPECT_EQ(mesh.edge_points.size(), mesh.edge_end.size());
}

void expect_round(const Vessel& vessel, const Quadratic_mesh& mesh, double tolerance) {
  const double volume = volumes(mesh)[tubular::labels::lumen];
  EXPECT_NEAR(volume / vessel.volume, 1, tolerance);
  const auto measures = tubular::lumen_measures(mesh, vessel.openings.size());
  EXPECT_NEAR(measures.volume, volume, 1e-9 * volume); // by facets and by cells
  for (std::size_t i = 0; i < vessel.openings.size(); ++i) {
    const double area = CGAL_PI * vessel.openings[i] * vessel.openings[i];
    EXPECT_NEAR(measures.opening_area.at(tubular::labels::of_opening(int(i))) / area, 1, tolerance);
  }
}

// With straight edges.
std::size_t turned_tetrahedra(const Quadratic_mesh& mesh) {
  const auto& p = mesh.linear.points;
  std::size_t n = 0;
  for (const auto& t : mesh.linear.tetrahedra.vertices)
    n += CGAL::volume(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) > 0 ? 0 : 1;
  return n;
}

void expect_valid(const Quadratic_mesh& mesh, const tubular::Quadratic_report& report) {
  EXPECT_EQ(report.invalid, 0u) << report.text();
  EXPECT_EQ(report.not_found, 0u) << report.text();
  EXPECT_TRUE(tubular::quality_report(mesh).is_valid());
  EXPECT_EQ(turned_tetrahedra(mesh), 0u);
  tubular::Validity_report corners = tubular::validity_report(mesh.linear);
  corners.inverted_cells = 0; // a thin curved prism may be right where the straight one between its corners is not
  EXPECT_TRUE(corners.is_valid()) << corners.defects();
}

TEST(Quadratic_mesh, Tube_and_bend_have_their_volume_and_areas) {
  for (const Vessel& vessel : {tube(), quadratic_meshes::bend()})
    for (const std::string& type : types) {
      if (!makes(type))
        continue;
      SCOPED_TRACE(type);
      const Mixed_mesh linear =
          linear_mesh(vessel, type, parameters::points_per_circumference(12).preserve_volume(false));
      for (bool complete : {false, true}) {
        if (complete && linear.quads.empty()) // the same
          continue;
        Quadratic_mesh mesh;
        const auto report = curve(vessel, linear, complete, mesh);
        expect_round(vessel, mesh, 5e-4);
        expect_valid(mesh, report);
        expect_conforming(mesh);
        EXPECT_EQ(mesh.linear.number_of_cells(), linear.number_of_cells());
      }
    }
}

TEST(Quadratic_mesh, Volume_that_a_linear_mesh_was_given_is_taken_back) {
  if (!makes("isotropic"))
    GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1";
  const Vessel vessel = tube();
  const Mixed_mesh linear = linear_mesh(vessel, "isotropic", parameters::points_per_circumference(12));
  Quadratic_mesh mesh;
  const auto report = curve(vessel, linear, false, mesh);
  expect_round(vessel, mesh, 5e-4);
  expect_valid(mesh, report);
}

TEST(Quadratic_mesh, Error_falls_with_the_fourth_power_of_the_mesh_size) {
  std::vector<double> errors;
  for (double n : {8., 16.}) {
    const Vessel vessel = tube(48);
    Quadratic_mesh mesh;
    curve(vessel, linear_mesh(vessel, "hexahedral", parameters::points_per_circumference(n).preserve_volume(false)),
          true, mesh);
    errors.push_back(std::abs(volumes(mesh)[1] / vessel.volume - 1));
  }
  EXPECT_LT(errors[1], errors[0] / 12); // a sixteenth, and what the input's triangles lack
}

TEST(Quadratic_mesh, Layers_and_walls_curve_with_the_lumen) {
  for (const Vessel& vessel : {tube(), quadratic_meshes::bend()})
    for (const std::string type : {"isotropic", "mixed", "hexahedral"}) {
      if (!makes(type))
        continue;
      SCOPED_TRACE(type);
      const double thickness = 0.2;
      const Mixed_mesh linear = linear_mesh(vessel, type,
                                            parameters::points_per_circumference(12)
                                                .preserve_volume(false)
                                                .wall_thickness(type == "isotropic" ? 0. : thickness)
                                                .wall_layers(2)
                                                .boundary_layer_prisms(4)
                                                .boundary_layer_thickness(0.1)
                                                .first_height(0.004)); // a tenth of a chord's sagitta
      Quadratic_mesh mesh;
      const auto report = curve(vessel, linear, false, mesh);
      expect_round(vessel, mesh, 5e-4);
      expect_valid(mesh, report);
      EXPECT_LE(report.straightened, linear.number_of_cells() / 100) << report.text();
      if (type != "isotropic") {
        const double around = vessel.volume * ((1 + thickness) * (1 + thickness) - 1);
        EXPECT_NEAR(volumes(mesh)[tubular::labels::wall_region] / around, 1, 0.02);
      }
    }
}

TEST(Quadratic_mesh, A_round_end_is_half_a_ball) {
  if (!makes("isotropic"))
    GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1";
  // a tube that is open at one end, and ends in half a ball
  tubular::Surface surface;
  const auto skeleton = tubular::straight_tube(6, 1);
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(24).round_ends(true));
  const auto lines = tubular::centerlines_of(skeleton);
  const Point_3 first = lines.points.front(), last = lines.points.back();
  Vessel vessel;
  vessel.model = tubular::make_tubular_model(
      surface,
      parameters::seeds(std::vector<Point_3>{first}).blind_ends(std::vector<Point_3>{last}).single_opening(true));
  ASSERT_EQ(vessel.model.openings.size(), 1u);
  const auto& opening = vessel.model.openings.front();
  // the cut may be in the half ball at that end, at a height h
  const double length = std::sqrt(CGAL::squared_distance(first, last));
  const double along = (opening.center - first) * (last - first) / length, h = std::max(0., -along);
  vessel.volume = CGAL_PI * (length - std::max(0., along)) + 2 * CGAL_PI / 3 + CGAL_PI * (h - h * h * h / 3);
  vessel.openings = {std::sqrt(1 - h * h)};
  const Mixed_mesh linear =
      linear_mesh(vessel, "isotropic", parameters::points_per_circumference(12).preserve_volume(false));
  Quadratic_mesh mesh;
  const auto report = curve(vessel, linear, false, mesh);
  EXPECT_NEAR(volumes(mesh)[tubular::labels::lumen] / vessel.volume, 1, 1e-3);
  // the rim was cut through flat triangles: it is no rounder than these, whose 24 sides lack so much of the circle
  const double lacking = 2 * CGAL_PI * CGAL_PI / 3 / (24 * 24);
  const double area = CGAL_PI * vessel.openings[0] * vessel.openings[0];
  EXPECT_NEAR(tubular::lumen_measures(mesh, 1).opening_area.at(tubular::labels::inlet) / area, 1, lacking);
  expect_valid(mesh, report);
}

// --- what gives way ---

TEST(Quadratic_mesh, Thin_layers_that_do_not_follow_are_straightened_and_stay_valid) {
  if (!makes("isotropic"))
    GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1";
  const Vessel vessel = tube();
  const Mixed_mesh linear = linear_mesh(vessel, "isotropic",
                                        parameters::points_per_circumference(12)
                                            .preserve_volume(true) // corners are outside: curved edges come inside
                                            .boundary_layer_prisms(4)
                                            .boundary_layer_thickness(0.1)
                                            .first_height(0.004));
  Quadratic_mesh mesh;
  const auto report = tubular::make_quadratic_mesh(
      linear, vessel.model.surface, vessel.model.patch, [](const Point_3&) { return 1e-6; }, mesh);
  EXPECT_GT(report.relaxed, 0u);
  EXPECT_EQ(report.invalid, 0u);
  EXPECT_TRUE(tubular::quality_report(mesh).is_valid());
  EXPECT_TRUE(tubular::validity_report(mesh.linear).is_valid());
  EXPECT_NE(report.text().find("less curved"), std::string::npos) << report.text();
  // with a radius they follow, and nothing gives way
  const auto following = curve(vessel, linear, false, mesh);
  EXPECT_LT(following.relaxed, report.relaxed / 10);
}

TEST(Quadratic_mesh, A_thin_tetrahedron_does_not_turn_over_between_its_corners) {
  // Its base is on the wall, and hangs through; its apex goes below the corners of the base, but not below the wall.
  Mixed_mesh linear;
  linear.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, 0.9, 0), Point_3(0.5, 0.3, 0.05)};
  linear.tetrahedra.push_back({0, 1, 2, 3}, tubular::labels::lumen);
  const Quadratic_mesh mesh = tubular::straight_quadratic_mesh(linear);
  std::vector<tubular::internal::Vector_3d> shifts(4), bends(6);
  shifts[3] = tubular::internal::Vector_3d(0, 0, -0.1);
  for (std::uint32_t k = 0; k < 3; ++k) {
    bends[mesh.edge(k, (k + 1) % 3)] = tubular::internal::Vector_3d(0, 0, -0.3);
    bends[mesh.edge(k, 3)] = tubular::internal::Vector_3d(0, 0, -0.1);
  }
  tubular::internal::Curved_nodes nodes(mesh, shifts, bends, {});
  const auto is_valid = [&] {
    return tubular::internal::Quadratic_cell(
               nodes.cell(Element_type::tetrahedron, mesh.linear.tetrahedra.vertices[0].data()))
               .validity() == tubular::internal::Cell_validity::valid;
  };
  ASSERT_TRUE(is_valid()); // as a curved cell
  ASSERT_LT(nodes.corner(3).z, 0);

  tubular::internal::Cell_straightener straightener(mesh, nodes, 1);
  straightener.run();
  EXPECT_TRUE(is_valid());
  EXPECT_GT(nodes.corner(3).z, 0);
  EXPECT_TRUE(nodes.shifts.is_held_back(3));
  EXPECT_EQ(nodes.bends[mesh.edge(0, 1)].z, -0.3); // its edges stay as they are
  EXPECT_EQ(straightener.number_relaxed(), 0u);
  EXPECT_TRUE(straightener.invalid_ones().empty());
}

// --- all the same ---

TEST(Quadratic_mesh, Does_not_depend_on_threads) {
  const Vessel vessel = quadratic_meshes::bend();
  const Mixed_mesh linear =
      linear_mesh(vessel, "hexahedral", parameters::points_per_circumference(8).preserve_volume(false));
  Quadratic_mesh one, many;
  curve(vessel, linear, true, one, 1);
  curve(vessel, linear, true, many, 4);
  EXPECT_EQ(one.linear.points, many.linear.points);
  EXPECT_EQ(one.edge_points, many.edge_points);
  EXPECT_EQ(one.quad_points, many.quad_points);
  EXPECT_EQ(one.inner_points, many.inner_points);
}

TEST(Quadratic_mesh, Nodes_are_in_the_middle_of_what_is_straight) {
  const Vessel vessel = tube();
  const Mixed_mesh linear =
      linear_mesh(vessel, "hexahedral", parameters::points_per_circumference(8).preserve_volume(false));
  const Quadratic_mesh mesh = tubular::straight_quadratic_mesh(linear, true);
  EXPECT_EQ(mesh.inner_points.size(), linear.hexahedra.size());
  expect_conforming(mesh);
  const double volume = tubular::lumen_measures(linear, 2).volume;
  EXPECT_NEAR(volumes(mesh)[1], volume, 1e-9 * volume);
  EXPECT_NEAR(tubular::lumen_measures(mesh, 2).volume, volume, 1e-9 * volume);
}

TEST(Quadratic_mesh, An_empty_mesh_stays_empty) {
  const Vessel vessel = tube();
  Quadratic_mesh mesh;
  const auto report = curve(vessel, Mixed_mesh(), true, mesh);
  EXPECT_EQ(mesh.number_of_nodes(), 0u);
  EXPECT_EQ(report.invalid, 0u);
  EXPECT_EQ(tubular::quality_report(mesh).scaled_jacobian.count(), 0u);
  EXPECT_EQ(tubular::lumen_measures(mesh, 2).volume, 0);
}

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which loops of the border are openings, and which parts are vessels.

#include "round_ends.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/join_parts.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Repair/split_into_parts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace round_ends;
using tubular::Surface_defect;
namespace np = tubular::parameters;

// As from a file: points of their own for each component do not matter.
template <class... Options> tubular::Repair_report repair(Mesh& mesh, const Options&... options) {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  mesh.collect_garbage();
  for (auto v : mesh.vertices())
    points.push_back(mesh.point(v));
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    triangles.push_back(
        {std::size_t(mesh.source(h)), std::size_t(mesh.target(h)), std::size_t(mesh.target(mesh.next(h)))});
  }
  return tubular::repair_surface(points, triangles, mesh, options...);
}

// The tube with its side branch cut off by a plane along the tube, at a distance from its axis.
Mesh flush(double branch_radius, double angle, double distance, double n) {
  const Skeleton s = tube_with_branch(branch_radius, angle);
  Mesh mesh = round_tree(s, n);
  for (const End& end : s.ends())
    if (end.node == 3)
      cut_end(mesh, end.center, end.radius, Point(distance, 0, 0), Vector(1, 0, 0));
    else
      finish_end(mesh, end, Kind::open);
  return mesh;
}

// A bulb of radius 4 with four tubes of radius 0.9, and all below a plane cut off.
Mesh bulb(Kind bottom) {
  Skeleton s;
  s.nodes = {Point(0, 0, 0), Point(0, 0, 0.5)};
  const auto line = [](const Point& p, const Point& q) { return [=](double t) { return p + t * (q - p); }; };
  s.add_branch(0, 1, line(s.nodes[0], s.nodes[1]), [](double) { return 4.; });
  for (int k = 0; k < 4; ++k) {
    const double a = k * CGAL_PI / 2 + 0.3;
    s.nodes.push_back(Point(7 * std::cos(a), 7 * std::sin(a), 3));
    s.add_branch(1, s.nodes.size() - 1, line(s.nodes[1], s.nodes.back()), [](double) { return 0.9; });
  }
  Mesh mesh = round_tree(s, 30);
  for (const End& end : s.ends())
    if (end.node != 0)
      finish_end(mesh, end, Kind::open);
  if (bottom != Kind::round)
    finish_end(mesh, End{0, 0, Point(0, 0, -2.6), Vector(0, 0, -1), 4}, bottom);
  return mesh;
}

} // namespace

// --- loops of the border ---

TEST(Vessel_ends, Branches_cut_off_flush_are_openings) {
  for (double n : {16., 28.})
    for (double radius : {0.2, 0.3, 0.45, 0.6, 0.8})
      for (double angle : {90., 55.})
        for (double stub : {0.05, 0.1, 0.2})
          for (double scale : {1., 1e-3}) {
            SCOPED_TRACE("radius " + std::to_string(radius) + ", angle " + std::to_string(angle) + ", stub " +
                         std::to_string(stub) + ", n " + std::to_string(n));
            Mesh mesh = flush(radius, angle * CGAL_PI / 180, 1 + stub, n);
            move(mesh, scale);
            const auto report = repair(mesh);
            EXPECT_EQ(report.count(Surface_defect::pinholes), 0u) << report.text();
            EXPECT_EQ(tubular::find_openings(mesh).size(), 3u);
          }
}

TEST(Vessel_ends, A_model_of_a_flush_opening_has_a_branch_to_it) {
  const auto model = tubular::make_tubular_model(flush(0.6, CGAL_PI / 2, 1.1, 20));
  ASSERT_EQ(model.openings.size(), 3u);
  for (const auto& o : model.openings)
    EXPECT_NE(o.branch, tubular::Opening::no_branch);
}

TEST(Vessel_ends, A_bulb_open_or_capped_over_its_width_has_that_opening) {
  for (Kind kind : {Kind::open, Kind::flat}) {
    Mesh mesh = bulb(kind);
    const auto report = repair(mesh);
    EXPECT_EQ(report.count(Surface_defect::possible_openings), 0u) << report.text();
    const auto openings = tubular::find_openings(mesh);
    ASSERT_EQ(openings.size(), 5u);
    EXPECT_GT(openings.front().radius, 2.5);
  }
}

TEST(Vessel_ends, What_may_be_a_hole_or_an_opening_is_one_and_can_be_filled) {
  const Mesh clean = [] {
    const Skeleton s = tubular::straight_tube(10, 1);
    Mesh mesh = round_tree(s, 40);
    for (const End& end : s.ends())
      finish_end(mesh, end, Kind::open);
    mesh.collect_garbage();
    return mesh;
  }();
  const auto with_hole = [&](double radius) {
    Mesh mesh = clean;
    for (auto f : clean.faces()) {
      bool is_near = false;
      for (auto v : CGAL::vertices_around_face(clean.halfedge(f), clean))
        is_near = is_near || tubular::internal::point_distance(clean.point(v), Point(1, 0, 5)) < radius;
      if (is_near)
        CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
    }
    return mesh;
  };
  Mesh small = with_hole(0.15);
  EXPECT_EQ(repair(small).count(Surface_defect::pinholes), 1u);
  EXPECT_EQ(tubular::find_openings(small).size(), 2u);
  Mesh large = with_hole(0.6);
  EXPECT_EQ(repair(large).count(Surface_defect::possible_openings), 1u);
  EXPECT_EQ(tubular::make_tubular_model(large).openings.size(), 3u);
  Mesh filled = with_hole(0.6);
  EXPECT_EQ(repair(filled, np::filled_holes(std::vector<Point>{Point(1, 0, 5)})).count(Surface_defect::filled_holes),
            1u);
  EXPECT_EQ(tubular::find_openings(filled).size(), 2u);
  Mesh kept = with_hole(0.15);
  repair(kept, np::kept_openings(std::vector<Point>{Point(1, 0, 5)}));
  EXPECT_EQ(tubular::find_openings(kept).size(), 3u);
  Mesh nowhere = with_hole(0.6);
  EXPECT_THROW(repair(nowhere, np::filled_holes(std::vector<Point>{Point(50, 0, 0)})), tubular::Input_error);
}

TEST(Vessel_ends, One_opening_will_do_where_it_is_said_so) {
  const Skeleton s = tubular::y_bifurcation();
  Mesh mesh = round_tree(s, 16);
  finish_end(mesh, s.ends().front(), Kind::open);
  mesh.collect_garbage();
  EXPECT_THROW(tubular::make_tubular_model(mesh), tubular::Input_error);
  const auto model = tubular::make_tubular_model(mesh, np::single_opening(true));
  EXPECT_EQ(model.openings.size(), 1u);
  EXPECT_EQ(model.centerlines.number_of_ends(), 3u);
}

// --- parts ---

TEST(Parts, All_vessels_are_kept_and_debris_goes) {
  const Skeleton s = tubular::y_bifurcation();
  const Mesh vessel = [&] {
    Mesh mesh = round_tree(s, 14);
    for (const End& end : s.ends())
      finish_end(mesh, end, Kind::open);
    mesh.collect_garbage();
    return mesh;
  }();
  Mesh all = vessel, second = vessel, debris = round_tree(tubular::straight_tube(0.1, 0.2), 12);
  for (auto v : second.vertices())
    second.point(v) = Point(0.8 * second.point(v).x() + 20, 0.8 * second.point(v).y(), 0.8 * second.point(v).z());
  for (auto v : debris.vertices())
    debris.point(v) = debris.point(v) + Vector(-10, 0, 0);
  all += second;
  all += debris;
  Mesh largest = all;
  EXPECT_EQ(repair(largest).count(Surface_defect::islands), 2u);
  EXPECT_EQ(tubular::split_into_parts(largest).size(), 1u);
  const auto report = repair(all, np::number_of_parts(std::size_t(0)));
  EXPECT_EQ(report.count(Surface_defect::islands), 1u) << report.text();
  const auto parts = tubular::split_into_parts(all);
  ASSERT_EQ(parts.size(), 2u);

  std::vector<tubular::Mixed_mesh> meshes;
  std::vector<tubular::Tubular_model> models;
  std::vector<std::size_t> openings;
  for (const Mesh& part : parts) {
    models.push_back(tubular::make_tubular_model(part));
    meshes.push_back(tubular::Mesher(models.back(), np::points_per_circumference(10)).isotropic());
    openings.push_back(models.back().openings.size());
  }
  const auto model = tubular::join_parts(std::move(models));
  EXPECT_EQ(model.openings.size(), 6u);
  EXPECT_TRUE(model.centerlines.is_consistent());
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(model.openings[i].patch, tubular::labels::of_opening(int(i)));
    const auto& node = model.centerlines.nodes()[model.openings[i].node];
    EXPECT_LT(tubular::internal::point_distance(model.centerlines.points()[node.point], model.openings[i].center),
              model.openings[i].radius);
    EXPECT_EQ(node.branches.front(), model.openings[i].branch);
    EXPECT_EQ(model.centerlines.branches()[model.openings[i].branch].parents.empty(), i % 3 == 0);
  }
  const auto mesh = tubular::join_parts(std::move(meshes), openings);
  const auto validity = tubular::validity_report(mesh);
  EXPECT_TRUE(validity.is_valid_in(2)) << validity.defects();
  EXPECT_FALSE(validity.is_valid());
  EXPECT_EQ(validity.boundary_euler, 4);
  EXPECT_EQ(mesh.patch_names.at(5), "inlet_2");
  EXPECT_EQ(mesh.patch_names.at(6), "outlet_3");
}

TEST(Parts, Those_that_cross_are_united) {
  const auto tube = [](double length, double radius, Kind kind) {
    const Skeleton s = tubular::straight_tube(length, radius);
    Mesh mesh = round_tree(s, 24);
    for (const End& end : s.ends())
      finish_end(mesh, end, kind);
    mesh.collect_garbage();
    return mesh;
  };
  for (Kind kind : {Kind::open, Kind::flat}) {
    Mesh all = tube(10, 1, kind), branch = tube(5, 0.6, kind);
    for (auto v : branch.vertices()) // from the axis of the first tube outward
      branch.point(v) = Point(branch.point(v).z(), branch.point(v).y(), 5.1 + branch.point(v).x());
    CGAL::Polygon_mesh_processing::reverse_face_orientations(branch); // a mirror image
    all += branch;
    const auto report = repair(all, np::number_of_parts(std::size_t(0)));
    EXPECT_EQ(report.count(Surface_defect::crossing_parts), 1u) << report.text();
    EXPECT_EQ(tubular::split_into_parts(all).size(), 1u);
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(all));
    EXPECT_EQ(tubular::make_tubular_model(all).openings.size(), 3u);
  }
}

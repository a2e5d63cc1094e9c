// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "looped_surfaces.h"
#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/Patches/Indexed_patch.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Patches/remesh_patches.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace looped_surfaces;
using namespace test_surfaces;
namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Tubular_model Model;
typedef tubular::Surface_cut Cut;

int genus(const Mesh& mesh) {
  return int(2 - (long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces()))) / 2;
}

double length_of(const Mesh& mesh, const tubular::Cut_curve& curve) {
  double length = 0;
  for (auto h : curve.halfedges)
    length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  return length;
}

/* What is right whatever the surface is. */
void expect_planar_patches(const Model& model, const Cut& cut) {
  ASSERT_TRUE(CGAL::is_valid_polygon_mesh(model.surface) && CGAL::is_closed(model.surface));
  std::set<Mesh::Vertex_index> on_curves;
  std::size_t sides = 0, without_branch = 0;
  for (const auto& c : cut.curves) {
    sides += c.is_rim() ? 1 : 2;
    without_branch += !c.is_rim() && c.branch == tubular::Cut_curve::none;
    for (std::size_t k = 0; k < c.halfedges.size(); ++k) {
      EXPECT_TRUE(on_curves.insert(c.vertices[k]).second) << "curves touch";
      EXPECT_EQ(cut.patch_of_face[model.surface.face(c.halfedges[k])], int(c.left_patch));
    }
  }
  EXPECT_EQ(without_branch, cut.handle_cuts);
  for (const auto& p : cut.patches) {
    EXPECT_TRUE(p.is_sphere_with_holes());
    sides -= p.loops.size();
  }
  EXPECT_EQ(sides, 0u);
  for (const auto& p : cut.problems)
    EXPECT_NE(p.kind, tubular::Cut_problem::wrong_topology) << p.message();
}

/* Each patch is mapped, and opened where it is on both sides of a curve. */
void expect_maps(const Model& model, const Cut& cut) {
  for (const auto& patch : cut.patches) {
    const tubular::Indexed_patch indexed = tubular::make_indexed_patch(model.surface, patch, cut.curves);
    std::size_t on_loops = 0, on_border = 0;
    for (const auto& loop : indexed.loops)
      on_loops += loop.size();
    for (const auto& loop : tubular::border_loops(indexed))
      on_border += loop.size();
    EXPECT_EQ(indexed.loops.size(), tubular::border_loops(indexed).size());
    EXPECT_EQ(on_loops, on_border);
  }
  const auto maps = tubular::parameterize_patches(model.surface, cut);
  EXPECT_EQ(maps.size(), cut.patches.size());
  const tubular::Remeshed_surface remeshed =
      tubular::remesh_patches(model.surface, cut, maps, [](const Point&) { return 0.25; });
  EXPECT_TRUE(CGAL::is_closed(remeshed.surface));
  EXPECT_EQ(genus(remeshed.surface), genus(model.surface));
  EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(remeshed.surface));
}

Cut cut_of(Model& model) {
  return tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
}

struct Sample {
  const char* name;
  int genus;
  Mesh (*make)();
};

Mesh septum_with(int holes) {
  Septum s;
  s.holes = holes;
  s.flap = 3 + holes;
  s.length = s.flap + 3;
  return septum(s);
}

const Sample samples[] = {
    {"Septum", 1, [] { return septum_with(0); }},
    {"One_hole", 2, [] { return septum_with(1); }},
    {"Two_holes", 3, [] { return septum_with(2); }},
    {"Four_holes", 5, [] { return septum_with(4); }},
    {"Narrow_and_wide_lumen", 3,
     [] {
       Septum s;
       s.off_center = 0.3;
       return septum(s);
     }},
    {"Arch", 1, [] { return tube_with_arches(1, 4, 0.25); }},
    {"Thin_arches", 3, [] { return tube_with_arches(3, 9, 0.2); }},
    {"Ring", 1, [] { return chain_of_rings(1); }},
    {"Chain_of_rings", 3, [] { return chain_of_rings(3); }},
};

class Handles : public testing::TestWithParam<Sample> {};

TEST_P(Handles, Patches_become_planar) {
  for (bool loops : {true, false}) {
    SCOPED_TRACE(loops ? "all branches" : "shortest paths");
    Model model = tubular::make_tubular_model(GetParam().make(), tubular::parameters::loops(loops));
    ASSERT_EQ(genus(model.surface), GetParam().genus);
    EXPECT_EQ(model.openings.size(), 2u);
    const Cut cut = cut_of(model);
    expect_planar_patches(model, cut);
    expect_maps(model, cut);
  }
}

// In another unit, the same curves. Turned, the loops may be others of about the same length.
TEST_P(Handles, Cuts_do_not_depend_on_the_unit) {
  const Mesh mesh = GetParam().make();
  Model model = tubular::make_tubular_model(mesh, tubular::parameters::loops(false));
  const Cut cut = cut_of(model);
  const double scale = 1024;
  Model scaled = tubular::make_tubular_model(transformed(mesh, Transformation(CGAL::SCALING, scale)),
                                             tubular::parameters::loops(false));
  const Cut other = cut_of(scaled);
  ASSERT_EQ(other.curves.size(), cut.curves.size());
  EXPECT_EQ(other.handle_cuts, cut.handle_cuts);
  for (std::size_t i = 0; i < cut.curves.size(); ++i)
    EXPECT_NEAR(length_of(scaled.surface, other.curves[i]) / scale, length_of(model.surface, cut.curves[i]), 1e-9);
}

TEST_P(Handles, Patches_become_planar_in_any_direction) {
  const Mesh mesh = GetParam().make();
  Model turned = tubular::make_tubular_model(transformed(mesh, rotation(1.1)), tubular::parameters::loops(false));
  const Cut cut = cut_of(turned);
  expect_planar_patches(turned, cut);
  expect_maps(turned, cut);
}

// As many independent loops as the lumen has, and no branch that strays to the wall.
void expect_loops_of(const tubular::Centerline_graph& graph, int loops, double least_radius) {
  EXPECT_EQ(int(graph.branches().size()) - int(graph.nodes().size()) + 1, loops);
  for (const auto& b : graph.branches())
    EXPECT_GT(b.min_radius, least_radius);
}

TEST_P(Handles, Centerlines_have_the_loops_of_the_lumen) {
  const Mesh mesh = GetParam().make();
  const double least_radius = 0.14; // narrower than the narrowest vessel
  expect_loops_of(tubular::make_tubular_model(mesh).centerlines, GetParam().genus, least_radius);
  const Mesh turned = transformed(mesh, rotation(1.1) * Transformation(CGAL::SCALING, 1e-3));
  expect_loops_of(tubular::make_tubular_model(turned).centerlines, GetParam().genus, 1e-3 * least_radius);
}

std::string name_of(const testing::TestParamInfo<Sample>& info) {
  return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Of, Handles, testing::ValuesIn(samples), name_of);

// A thin arch that no centerline runs through is cut across, about where it is thinnest, by a circle.
TEST(Handle_cuts, Are_short_and_smooth) {
  const double thickness = 0.2;
  Model model = tubular::make_tubular_model(tube_with_arches(1, 4, thickness), tubular::parameters::loops(false));
  const Cut cut = cut_of(model);
  ASSERT_EQ(cut.handle_cuts, 1u);
  for (const auto& c : cut.curves)
    if (!c.is_rim() && c.branch == tubular::Cut_curve::none) {
      EXPECT_EQ(c.left_patch, c.right_patch);
      EXPECT_NEAR(length_of(model.surface, c), 2 * CGAL_PI * thickness, 0.15 * 2 * CGAL_PI * thickness);
    }
}

TEST(Handle_cuts, Are_none_on_surfaces_of_genus_0) {
  Model model = tubular::make_tubular_model(make_tube(Tube()));
  EXPECT_EQ(cut_of(model).handle_cuts, 0u);
}

// --- meshes ---

void expect_valid(const tubular::Mixed_mesh& mesh, int genus) {
  const tubular::Validity_report report = tubular::validity_report(mesh);
  EXPECT_TRUE(report.is_valid());
  EXPECT_EQ(report.boundary_euler, 2 - 2 * genus);
}

TEST(Meshes_with_loops, Are_of_every_type) {
  for (bool loops : {true, false}) {
    SCOPED_TRACE(loops ? "all branches" : "shortest paths");
    const Model model = tubular::make_tubular_model(septum_with(1), tubular::parameters::loops(loops));
    tubular::Mesher_options options;
    options.size.points_per_circumference = 16;
    tubular::Mesher mesher(model, options);
    expect_valid(mesher.isotropic(), 2);
    EXPECT_TRUE(mesher.report().fallbacks.empty());
    EXPECT_EQ(genus(mesher.surface(tubular::Surface_elements::triangles).surface), 2);
    EXPECT_TRUE(CGAL::is_closed(mesher.surface(tubular::Surface_elements::quads).surface));
    expect_valid(mesher.mixed(), 2);
  }
}

TEST(Meshes_with_loops, Have_layers_as_thick_as_there_is_room) {
  const Model model = tubular::make_tubular_model(septum_with(1));
  const tubular::Mesher_options options(tubular::parameters::points_per_circumference(16).wall_thickness(0.2));
  tubular::Mesher mesher(model, options);
  const tubular::Mixed_mesh mesh = mesher.mixed();
  EXPECT_TRUE(tubular::validity_report(mesh).is_valid());
  EXPECT_GT(mesher.report().wall.reduced_vertices, 0u); // the two sides of the septum share its thickness
}

} // namespace

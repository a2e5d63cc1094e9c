// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Walls and boundary layers on tubes, tori and bifurcations, whose volumes and thicknesses are known; where there is no
// room for them; and what cannot be done.

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Layers/internal/labelled_facets.h>
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra.h>

#include "test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace labels = tubular::labels;
namespace parameters = tubular::parameters;
using test_surfaces::Point;
using tubular::internal::Vector_3d;
typedef CGAL::Surface_mesh<Point> Surface;
typedef Surface::Property_map<Surface::Face_index, int> Patch_map;
typedef tubular::Mixed_mesh Mesh;

double one(const Point&) {
  return 1;
}

Vector_3d at(const Mesh& mesh, std::uint32_t v) {
  return Vector_3d(mesh.points[v]);
}

// Of cells whose faces are flat, or whose faces' bends cancel out.
double volume(const Mesh& mesh, int region) {
  double six_volumes = 0;
  const auto tetrahedron = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    six_volumes += dot(cross(at(mesh, b) - at(mesh, a), at(mesh, c) - at(mesh, a)), at(mesh, d) - at(mesh, a));
  };
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
    if (mesh.tetrahedra.label[i] == region) {
      const auto& c = mesh.tetrahedra.vertices[i];
      tetrahedron(c[0], c[1], c[2], c[3]);
    }
  for (std::size_t i = 0; i < mesh.prisms.size(); ++i)
    if (mesh.prisms.label[i] == region) {
      const auto& c = mesh.prisms.vertices[i];
      tetrahedron(c[0], c[1], c[2], c[5]);
      tetrahedron(c[0], c[1], c[5], c[4]);
      tetrahedron(c[0], c[4], c[5], c[3]);
    }
  for (std::size_t i = 0; i < mesh.hexahedra.size(); ++i)
    if (mesh.hexahedra.label[i] == region) {
      const auto& c = mesh.hexahedra.vertices[i];
      for (const std::array<int, 2> e : {std::array<int, 2>{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
        tetrahedron(c[0], c[e[0]], c[e[1]], c[6]);
    }
  return six_volumes / 6;
}

/* A tube of quads of radius 1 along z, with caps of triangles; patches 1, 2 (z = 0) and 3. */
struct Quad_tube {
  int sides = 24, rows = 12;
  double length = 4, scale = 1, x = 0;
  bool capped = true;

  void add_to(Mesh& mesh) const {
    const std::uint32_t first = std::uint32_t(mesh.points.size());
    for (int k = 0; k <= rows; ++k)
      for (int i = 0; i < sides; ++i) {
        const double a = 2 * CGAL_PI * i / sides;
        mesh.points.emplace_back(scale * (x + std::cos(a)), scale * std::sin(a), scale * length * k / rows);
      }
    const auto vertex = [&](int k, int i) { return first + std::uint32_t(k * sides + i % sides); };
    for (int k = 0; k < rows; ++k)
      for (int i = 0; i < sides; ++i)
        mesh.quads.push_back({vertex(k, i), vertex(k, i + 1), vertex(k + 1, i + 1), vertex(k + 1, i)}, labels::wall);
    if (!capped)
      return;
    const std::uint32_t center = std::uint32_t(mesh.points.size());
    mesh.points.emplace_back(scale * x, 0, 0);
    mesh.points.emplace_back(scale * x, 0, scale * length);
    for (int i = 0; i < sides; ++i) {
      mesh.triangles.push_back({vertex(0, i + 1), vertex(0, i), center}, 2);
      mesh.triangles.push_back({vertex(rows, i), vertex(rows, i + 1), center + 1}, 3);
    }
  }
  Mesh mesh() const {
    Mesh m;
    add_to(m);
    return m;
  }
  double section(double radius) const { return sides / 2. * std::sin(2 * CGAL_PI / sides) * radius * radius; }
};

struct Labelled_surface {
  Surface surface;
  Patch_map patch;

  Labelled_surface() { patch = surface.add_property_map<Surface::Face_index, int>("f:patch", labels::wall).first; }
  explicit Labelled_surface(const Mesh& mesh)
      : Labelled_surface() {
    typedef Surface::Vertex_index V;
    for (const Point& p : mesh.points)
      surface.add_vertex(p);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles.vertices[i];
      patch[surface.add_face(V(t[0]), V(t[1]), V(t[2]))] = mesh.triangles.label[i];
    }
    for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
      const auto& q = mesh.quads.vertices[i];
      patch[surface.add_face(V(q[0]), V(q[1]), V(q[2]), V(q[3]))] = mesh.quads.label[i];
    }
  }
  Labelled_surface(const Labelled_surface&) = delete;
};

Mesh split_quads(const Mesh& mesh) {
  Mesh result = mesh;
  result.quads = tubular::Element_block<4>();
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    const auto& q = mesh.quads.vertices[i];
    result.triangles.push_back({q[0], q[1], q[2]}, mesh.quads.label[i]);
    result.triangles.push_back({q[0], q[2], q[3]}, mesh.quads.label[i]);
  }
  return result;
}

// A generated bifurcation, capped; the openings are told by their plane.
Mesh bifurcation(double points = 16) {
  const auto skeleton = tubular::y_bifurcation();
  Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(points).capped_ends(true));
  Mesh mesh;
  for (auto v : surface.vertices())
    mesh.points.push_back(surface.point(v));
  const auto ends = skeleton.ends();
  for (auto f : surface.faces()) {
    std::array<std::uint32_t, 3> t;
    std::size_t k = 0;
    for (auto v : surface.vertices_around_face(surface.halfedge(f)))
      t[k++] = std::uint32_t(v);
    int label = labels::wall;
    for (std::size_t e = 0; e < ends.size(); ++e) {
      const auto on_end = [&](std::uint32_t v) {
        const Vector_3d d = at(mesh, v) - Vector_3d(ends[e].center);
        return std::abs(dot(d, Vector_3d(ends[e].normal))) < 1e-6 && norm(d) < 1.01 * ends[e].radius;
      };
      if (on_end(t[0]) && on_end(t[1]) && on_end(t[2]))
        label = labels::of_opening(int(e));
    }
    mesh.triangles.push_back(t, label);
  }
  return mesh;
}

// What is outside of the cells: without the openings' caps, that the cells of the wall do not have.
std::string defects_of_wall(const Mesh& mesh) {
  Mesh wall = mesh;
  tubular::internal::remove_openings(wall);
  return tubular::validity_report(wall).defects();
}

std::set<int> patches_of(const Mesh& mesh) {
  std::set<int> result(mesh.triangles.label.begin(), mesh.triangles.label.end());
  result.insert(mesh.quads.label.begin(), mesh.quads.label.end());
  return result;
}

// The outer surface of a wall, as triangles.
Surface outer_surface(const Mesh& mesh) {
  Surface surface;
  typedef Surface::Vertex_index V;
  for (const Point& p : mesh.points)
    surface.add_vertex(p);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles.label[i] == labels::outer_wall) {
      const auto& t = mesh.triangles.vertices[i];
      surface.add_face(V(t[0]), V(t[1]), V(t[2]));
    }
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    if (mesh.quads.label[i] == labels::outer_wall) {
      const auto& q = mesh.quads.vertices[i];
      surface.add_face(V(q[0]), V(q[1]), V(q[2]));
      surface.add_face(V(q[0]), V(q[2]), V(q[3]));
    }
  return surface;
}

} // namespace

// --- the wall ---

TEST(Extrude_wall, Of_a_straight_tube_has_the_volume_of_a_pipe) {
  const Quad_tube tube;
  Mesh mesh = tube.mesh();
  const Mesh before = mesh;
  const auto report = tubular::extrude_wall(mesh, one, parameters::wall_thickness(0.2).wall_layers(4));
  EXPECT_NEAR(volume(mesh, labels::wall_region), tube.length * (tube.section(1.2) - tube.section(1)), 1e-9);
  EXPECT_EQ(mesh.hexahedra.size(), 4u * 24 * 12);
  EXPECT_EQ(report.hexahedra, mesh.hexahedra.size());
  EXPECT_EQ(report.reduced_vertices, 0u);
  EXPECT_EQ(report.min_ratio, 1);
  EXPECT_EQ(defects_of_wall(mesh), "");
  EXPECT_EQ(patches_of(mesh), (std::set<int>{1, 2, 3, 100, 102, 103}));
  EXPECT_EQ(mesh.patch_names.at(100), "outer_wall");
  EXPECT_EQ(mesh.patch_names.at(102), "inlet_ring");
  EXPECT_EQ(mesh.patch_names.at(103), "outlet_ring_1");
  EXPECT_EQ(mesh.region_names.at(2), "wall");
  EXPECT_EQ(std::count(mesh.quads.label.begin(), mesh.quads.label.end(), 102), 4 * 24);
  for (std::size_t i = 0; i < before.points.size(); ++i)
    EXPECT_EQ(mesh.points[i], before.points[i]);
}

TEST(Extrude_wall, Ends_stay_in_their_planes) {
  Mesh mesh = Quad_tube().mesh();
  for (Point& p : mesh.points) // oblique ends: the lower one tilts, the upper one stays
    p = Point(p.x(), p.y(), p.z() + 0.8 * p.x() * (1 - p.z() / 4));
  tubular::extrude_wall(mesh, one, parameters::wall_thickness(0.3));
  EXPECT_EQ(defects_of_wall(mesh), "");
  std::size_t found = 0;
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    if (mesh.quads.label[i] == labels::inlet_ring)
      for (std::uint32_t v : mesh.quads.vertices[i]) {
        EXPECT_NEAR(at(mesh, v).z, 0.8 * at(mesh, v).x, 1e-9);
        ++found;
      }
  EXPECT_EQ(found, 4u * 4 * 24);
}

TEST(Extrude_wall, Layers_grow_and_a_second_wall_is_around_the_first) {
  const Quad_tube tube;
  Mesh mesh = tube.mesh();
  tubular::extrude_wall(mesh, one,
                        parameters::wall_thickness(0.21)
                            .wall_layers(3)
                            .wall_growth(2.)
                            .second_wall_thickness(0.1)
                            .second_wall_layers(2)
                            .second_wall_growth(1.));
  std::vector<double> radii;
  const std::size_t first = 13 * 24 + 2;
  for (std::size_t k = 0; k < 5; ++k) {
    const Vector_3d p = at(mesh, std::uint32_t(first + k * 13 * 24 + 6 * 24 + 1));
    radii.push_back(std::hypot(p.x, p.y));
  }
  const std::vector<double> expected = {1.03, 1.09, 1.21, 1.26, 1.31};
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(radii[k], expected[k], 1e-9) << k;
  EXPECT_NEAR(volume(mesh, 2), tube.length * (tube.section(1.21) - tube.section(1)), 1e-9);
  EXPECT_NEAR(volume(mesh, 3), tube.length * (tube.section(1.31) - tube.section(1.21)), 1e-9);
  EXPECT_EQ(mesh.region_names.at(3), "second_wall");
  EXPECT_EQ(mesh.patch_names.at(101), "middle_wall");
  EXPECT_EQ(std::count(mesh.quads.label.begin(), mesh.quads.label.end(), 101), 24 * 12);
  EXPECT_EQ(std::count(mesh.quads.label.begin(), mesh.quads.label.end(), 103), 5 * 24);
  EXPECT_EQ(defects_of_wall(mesh), "");
}

TEST(Extrude_wall, Of_a_torus_has_no_ends) {
  const Surface torus = test_surfaces::make_torus(96, 48);
  Labelled_surface s;
  s.surface = torus;
  s.patch = s.surface.add_property_map<Surface::Face_index, int>("f:patch", labels::wall).first;
  const auto wall = tubular::extrude_wall(s.surface, s.patch, one, parameters::wall_thickness(0.4));
  const Mesh& mesh = wall.mesh;
  const auto validity = tubular::validity_report(mesh);
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
  EXPECT_EQ(validity.boundary_euler, 0);
  EXPECT_EQ(wall.report.reduced_vertices, 0u);
  const double exact = 2 * CGAL_PI * CGAL_PI * 3 * (1.4 * 1.4 - 1);
  EXPECT_NEAR(volume(mesh, 2), exact, 0.01 * exact);
  EXPECT_EQ(patches_of(mesh), (std::set<int>{1, 100}));
}

TEST(Extrude_wall, Prisms_and_tetrahedra_fill_the_same_space) {
  const Mesh surface = bifurcation();
  Mesh prisms = surface, tetrahedra = surface;
  const auto np = parameters::wall_thickness(0.3).wall_layers(3);
  const auto report = tubular::extrude_wall(prisms, one, np);
  tubular::extrude_wall(tetrahedra, one, np.tetrahedral_wall(true));
  EXPECT_EQ(defects_of_wall(prisms), "");
  EXPECT_EQ(defects_of_wall(tetrahedra), "");
  EXPECT_EQ(tetrahedra.tetrahedra.size(), 3 * prisms.prisms.size());
  EXPECT_EQ(report.prisms, prisms.prisms.size());
  EXPECT_GT(tubular::quality_report(prisms, 2).prism_jacobian.percentile(1), 0.3);
  EXPECT_NEAR(volume(tetrahedra, 2), volume(prisms, 2), 1e-3 * volume(prisms, 2));
  EXPECT_EQ(patches_of(prisms), (std::set<int>{1, 2, 3, 4, 100, 102, 103, 104}));
  EXPECT_EQ(patches_of(tetrahedra), patches_of(prisms));
}

TEST(Extrude_wall, Gives_way_in_a_sharp_crotch) {
  for (double thickness : {0.5, 1., 3.}) {
    Mesh mesh = bifurcation();
    const auto report = tubular::extrude_wall(mesh, one, parameters::wall_thickness(thickness));
    EXPECT_EQ(defects_of_wall(mesh), "") << thickness;
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(outer_surface(mesh))) << thickness;
    EXPECT_GT(report.reduced_vertices, 0u) << thickness;
    EXPECT_GT(report.min_ratio, 0) << thickness;
    EXPECT_LT(report.min_ratio, report.mean_ratio) << thickness;
    EXPECT_NE(report.text().find("thinner"), std::string::npos);
  }
}

TEST(Extrude_wall, Neighbours_share_the_gap_between_them) {
  for (double gap : {0.2, 0.02, 1e-4}) {
    Mesh mesh;
    Quad_tube tube;
    tube.rows = 20;
    tube.add_to(mesh);
    tube.x = 2 + gap;
    tube.add_to(mesh);
    const auto report = tubular::extrude_wall(mesh, one, parameters::wall_thickness(0.5).wall_layers(2));
    const Surface outer = outer_surface(mesh);
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(outer)) << gap;
    EXPECT_EQ(tubular::validity_report(mesh).inverted_cells, 0u);
    // vertex 0 of a row faces vertex 12 of the other tube's: each takes three quarters of half of the gap
    EXPECT_NEAR(report.min_ratio, 0.75 * gap / 2 / 0.5, 0.1 * gap);
    EXPECT_GT(report.mean_ratio, 0.6);
    EXPECT_NEAR(std::abs(report.worst_place.x() - 1 - gap / 2), gap / 2, 1e-9);
  }
}

TEST(Extrude_wall, Thickness_follows_the_radius_without_jumps) {
  Mesh mesh = Quad_tube().mesh();
  const std::size_t n = 13 * 24;
  tubular::extrude_wall(
      mesh, [](const Point& p) { return p.z() < 1.9 ? 1. : 0.2; }, parameters::wall_thickness(0.5).wall_layers(1));
  std::vector<double> thickness;
  for (std::size_t k = 0; k < 13; ++k)
    thickness.push_back(norm(at(mesh, std::uint32_t(n + 2 + k * 24)) - at(mesh, std::uint32_t(k * 24))));
  EXPECT_NEAR(thickness[0], 0.5, 1e-9);
  EXPECT_NEAR(thickness[12], 0.1, 1e-9);
  for (std::size_t k = 0; k < 12; ++k)
    EXPECT_LE(std::abs(thickness[k + 1] - thickness[k]), 0.4 * 4. / 12 + 1e-9) << k;
}

TEST(Extrude_wall, Is_the_same_in_any_unit_and_on_any_number_of_threads) {
  const Mesh surface = bifurcation();
  Mesh serial = surface, parallel = surface, small = surface;
  for (Point& p : small.points)
    p = Point(p.x() / 1024, p.y() / 1024, p.z() / 1024);
  const auto np = parameters::wall_thickness(0.6);
  tubular::extrude_wall(serial, one, np.number_of_threads(1));
  tubular::extrude_wall(parallel, one, np.number_of_threads(3));
  tubular::extrude_wall(
      small, [](const Point&) { return 1. / 1024; }, np);
  ASSERT_EQ(serial.points.size(), small.points.size());
  for (std::size_t i = 0; i < serial.points.size(); ++i) {
    EXPECT_EQ(serial.points[i], parallel.points[i]);
    EXPECT_NEAR(1024 * small.points[i].x(), serial.points[i].x(), 1e-9);
  }
}

TEST(Extrude_wall, Point_arrays_go_on_outward) {
  Mesh mesh = Quad_tube().mesh();
  tubular::Point_array array{"height", 1, {}};
  for (const Point& p : mesh.points)
    array.values.push_back(p.z());
  mesh.point_arrays.push_back(array);
  tubular::extrude_wall(mesh, one);
  ASSERT_EQ(mesh.point_arrays[0].values.size(), mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    EXPECT_NEAR(mesh.point_arrays[0].values[i], mesh.points[i].z(), 1e-9);
}

TEST(Extrude_wall, On_an_open_surface_numbers_the_rings) {
  Quad_tube tube;
  tube.capped = false;
  Labelled_surface s(tube.mesh());
  const Mesh mesh = tubular::extrude_wall(s.surface, s.patch, one).mesh;
  const auto validity = tubular::validity_report(mesh);
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
  EXPECT_EQ(mesh.points.size(), 5 * 13 * 24u);
  EXPECT_EQ(patches_of(mesh), (std::set<int>{1, 100, 102, 103}));
}

TEST(Extrude_wall, Facets_in_the_plane_of_an_opening_belong_to_it) {
  Mesh mesh = split_quads(Quad_tube().mesh());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) // one of the cap is labelled as the wall is
    if (mesh.triangles.label[i] == 2) {
      const auto t = mesh.triangles.vertices[i];
      const std::uint32_t inner = std::uint32_t(mesh.points.size());
      mesh.points.emplace_back(0.9 * at(mesh, t[0]).x + 0.05 * at(mesh, t[1]).x,
                               0.9 * at(mesh, t[0]).y + 0.05 * at(mesh, t[1]).y, 0);
      mesh.triangles.vertices[i] = {t[0], t[1], inner};
      mesh.triangles.push_back({t[1], t[2], inner}, 2);
      mesh.triangles.push_back({t[2], t[0], inner}, 2);
      mesh.triangles.label[i] = labels::wall;
      break;
    }
  const auto report = tubular::extrude_wall(mesh, one);
  EXPECT_EQ(report.relabelled_facets, 1u);
  EXPECT_EQ(defects_of_wall(mesh), "");
}

TEST(Extrude_wall, Labels_of_many_openings_do_not_clash) {
  EXPECT_EQ(labels::outer_wall_for(4), 100);
  EXPECT_EQ(labels::outer_wall_for(99), 100);
  EXPECT_EQ(labels::outer_wall_for(100), 1000);
  EXPECT_EQ(labels::outer_wall_for(118), 1000);
  EXPECT_EQ(labels::outer_wall_for(12345), 100000);
  Mesh mesh = Quad_tube().mesh();
  for (int& label : mesh.triangles.label)
    label = label == 3 ? 118 : label;
  tubular::extrude_wall(mesh, one);
  EXPECT_EQ(patches_of(mesh), (std::set<int>{1, 2, 118, 1000, 1002, 1118}));
  EXPECT_EQ(mesh.patch_names.at(1118), "outlet_ring_116");
}

TEST(Extrude_wall, Refuses_what_it_cannot_do) {
  const Mesh good = Quad_tube().mesh();
  Mesh mesh = good;
  EXPECT_THROW(tubular::extrude_wall(mesh, one, parameters::wall_thickness(0.)), tubular::Parameter_error);
  EXPECT_THROW(tubular::extrude_wall(mesh, one, parameters::wall_thickness(-1.)), tubular::Parameter_error);
  EXPECT_THROW(tubular::extrude_wall(mesh, one, parameters::wall_layers(0)), tubular::Parameter_error);
  EXPECT_THROW(tubular::extrude_wall(mesh, one, parameters::wall_growth(0.)), tubular::Parameter_error);
  EXPECT_THROW(tubular::extrude_wall(mesh, one, parameters::second_wall_thickness(-0.1)), tubular::Parameter_error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double radius : {0., -1., nan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(tubular::extrude_wall(mesh, [&](const Point&) { return radius; }), tubular::Input_error) << radius;
  EXPECT_EQ(mesh.points.size(), good.points.size()); // as it was

  tubular::extrude_wall(mesh, one);
  EXPECT_THROW(tubular::extrude_wall(mesh, one), tubular::Input_error); // has a wall

  Mesh no_wall = good;
  no_wall.quads = tubular::Element_block<4>();
  EXPECT_THROW(tubular::extrude_wall(no_wall, one), tubular::Input_error);

  Mesh bad_index = good;
  bad_index.quads.vertices[3][1] = 100000;
  EXPECT_THROW(tubular::extrude_wall(bad_index, one), tubular::Input_error);

  Mesh no_area = good;
  no_area.points[30] = no_area.points[31];
  EXPECT_THROW(tubular::extrude_wall(no_area, one), tubular::Input_error);

  Mesh not_finite = good;
  not_finite.points[30] = Point(nan, 0, 0);
  EXPECT_THROW(tubular::extrude_wall(not_finite, one), tubular::Input_error);

  Mesh turned = good;
  std::swap(turned.quads.vertices[40][0], turned.quads.vertices[40][2]);
  EXPECT_THROW(tubular::extrude_wall(turned, one), tubular::Input_error);

  Mesh crossing; // two tubes through each other
  Quad_tube tube;
  tube.add_to(crossing);
  tube.x = 1;
  tube.add_to(crossing);
  EXPECT_THROW(tubular::extrude_wall(crossing, one), tubular::Error);
}

TEST(Extrude_wall, Of_tetrahedra_needs_triangles_where_there_are_cells) {
  const Quad_tube tube;
  Mesh surface = tube.mesh();
  const auto report = tubular::extrude_wall(surface, one, parameters::tetrahedral_wall(true));
  EXPECT_EQ(report.tetrahedra, 4u * 6 * 24 * 12); // quads without cells are split
  EXPECT_EQ(defects_of_wall(surface), "");
  // the diagonals turn the columns a little
  EXPECT_NEAR(volume(surface, 2), tube.length * (tube.section(1.2) - tube.section(1)), 1e-3);

  Labelled_surface s(tube.mesh());
  auto layer = tubular::extrude_boundary_layer(s.surface, s.patch, one);
  EXPECT_THROW(tubular::extrude_wall(layer.layers, one, parameters::tetrahedral_wall(true)), tubular::Parameter_error);
}

// --- inward ---

TEST(Extrude_boundary_layer, Heights_grow_from_the_first_one) {
  const Quad_tube tube;
  Labelled_surface s(tube.mesh());
  const auto layer = tubular::extrude_boundary_layer(
      s.surface, s.patch, one, parameters::first_height(0.02).growth(1.5).boundary_layer_prisms(4));
  const Mesh& mesh = layer.layers;
  const std::uint32_t n = 13 * 24;
  ASSERT_EQ(mesh.points.size(), 5u * n);
  double radius = 1, height = 0.02;
  for (std::uint32_t k = 1; k <= 4; ++k, height *= 1.5) {
    radius -= height;
    const Vector_3d p = at(mesh, k * n + 6 * 24 + 5);
    EXPECT_NEAR(std::hypot(p.x, p.y), radius, 1e-9);
  }
  for (std::uint32_t v = 0; v < n; ++v)
    EXPECT_EQ(mesh.points[v], s.surface.point(Surface::Vertex_index(v)));
  EXPECT_EQ(mesh.hexahedra.size(), 4u * 24 * 12);
  EXPECT_NEAR(volume(mesh, labels::lumen), tube.length * (tube.section(1) - tube.section(radius)), 1e-9);
  EXPECT_EQ(std::count(mesh.quads.label.begin(), mesh.quads.label.end(), 2), 4 * 24);
  EXPECT_EQ(tubular::validity_report(mesh).inverted_cells, 0u);

  EXPECT_TRUE(CGAL::is_closed(layer.inner));
  ASSERT_EQ(layer.mesh_points.size(), layer.inner.number_of_vertices());
  for (auto v : layer.inner.vertices())
    if (layer.mesh_points[v] != tubular::no_point) {
      EXPECT_EQ(mesh.points[layer.mesh_points[v]], layer.inner.point(v));
    }
  double area = 0;
  for (auto f : layer.inner.faces())
    if (layer.patch[f] == 3)
      area += std::sqrt(
          CGAL::squared_area(layer.inner.point(layer.inner.source(layer.inner.halfedge(f))),
                             layer.inner.point(layer.inner.target(layer.inner.halfedge(f))),
                             layer.inner.point(layer.inner.target(layer.inner.next(layer.inner.halfedge(f))))));
  EXPECT_NEAR(area, tube.section(radius), 1e-9);
}

TEST(Extrude_boundary_layer, Default_number_of_layers_makes_up_the_thickness) {
  Labelled_surface s(Quad_tube().mesh());
  const auto layer = tubular::extrude_boundary_layer(s.surface, s.patch, one); // 0.3; 0.015 · 1.3^k
  EXPECT_EQ(layer.layers.hexahedra.size(), 7u * 24 * 12);
  const auto uniform = tubular::extrude_boundary_layer(
      s.surface, s.patch, one, parameters::boundary_layer_thickness(0.2).first_height(0.05).growth(1.));
  EXPECT_EQ(uniform.layers.hexahedra.size(), 4u * 24 * 12);
}

TEST(Extrude_boundary_layer, With_a_filling_is_one_valid_mesh_and_takes_a_wall) {
  if (!tubular::has_tetgen())
    GTEST_SKIP() << "built without TetGen";
  Mesh surface = bifurcation();
  Labelled_surface s(surface);
  for (double thickness : {0.2, 0.8}) {
    auto layer = tubular::extrude_boundary_layer(s.surface, s.patch, one,
                                                 parameters::boundary_layer_thickness(thickness).first_height(0.03));
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(layer.inner));
    struct {
      typedef double FT;
      double operator()(const Point&, int, int) const { return 0.4; }
    } size;
    Mesh inside;
    tubular::fill_keeping_boundary(layer.inner, layer.patch, size, inside);
    tubular::optimize_tetrahedra(inside, layer.inner, layer.patch, parameters::keep_boundary(true));
    tubular::append_mesh(layer.layers, inside, layer.mesh_points);
    const auto validity = tubular::validity_report(layer.layers);
    EXPECT_TRUE(validity.is_valid()) << validity.defects();
    EXPECT_EQ(validity.boundary_euler, 2);
    EXPECT_EQ(patches_of(layer.layers), (std::set<int>{1, 2, 3, 4}));
    EXPECT_NEAR(volume(layer.layers, labels::lumen), CGAL::Polygon_mesh_processing::volume(s.surface),
                1e-3 * volume(layer.layers, labels::lumen));

    tubular::extrude_wall(layer.layers, one);
    const auto with_wall = tubular::validity_report(layer.layers);
    EXPECT_TRUE(with_wall.is_valid()) << with_wall.defects();
    EXPECT_EQ(with_wall.region_components, (std::map<int, std::size_t>{{1, 1}, {2, 1}}));
  }
}

TEST(Extrude_boundary_layer, Gives_way_where_the_lumen_is_narrow) {
  Mesh mesh = Quad_tube().mesh();
  for (Point& p : mesh.points) { // a stenosis, which the field does not know of
    const double t = (p.z() - 2) / 0.7, narrow = 1 - 0.8 * std::exp(-t * t);
    p = Point(narrow * p.x(), narrow * p.y(), p.z());
  }
  Labelled_surface s(mesh);
  const auto layer =
      tubular::extrude_boundary_layer(s.surface, s.patch, one, parameters::boundary_layer_thickness(0.5));
  EXPECT_GT(layer.report.reduced_vertices, 0u);
  EXPECT_NEAR(layer.report.worst_place.z(), 2, 0.4);
  EXPECT_EQ(tubular::validity_report(layer.layers).inverted_cells, 0u);
  CGAL::Polygon_mesh_processing::triangulate_faces(const_cast<Surface&>(layer.inner));
  EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(layer.inner));
}

TEST(Extrude_boundary_layer, Refuses_what_it_cannot_do) {
  Quad_tube tube;
  Labelled_surface s(tube.mesh());
  const auto grow = [&](const auto& np) { tubular::extrude_boundary_layer(s.surface, s.patch, one, np); };
  EXPECT_THROW(grow(parameters::boundary_layer_thickness(0.)), tubular::Parameter_error);
  EXPECT_THROW(grow(parameters::boundary_layer_thickness(1.)), tubular::Parameter_error);
  EXPECT_THROW(grow(parameters::first_height(-1.)), tubular::Parameter_error);
  EXPECT_THROW(grow(parameters::growth(0.9)), tubular::Parameter_error);
  EXPECT_THROW(grow(parameters::boundary_layer_prisms(0)), tubular::Parameter_error);
  EXPECT_THROW(grow(parameters::boundary_layer_prisms(30)), tubular::Parameter_error);
  tube.capped = false;
  Labelled_surface open(tube.mesh());
  EXPECT_THROW(tubular::extrude_boundary_layer(open.surface, open.patch, one), tubular::Input_error);
}

TEST(Append_mesh, Refuses_points_that_are_not_there) {
  Mesh mesh = Quad_tube().mesh(), filling;
  filling.points = {Point(0, 0, 0)};
  EXPECT_THROW(tubular::append_mesh(mesh, filling, {0, 1}), tubular::Input_error);
  EXPECT_THROW(tubular::append_mesh(mesh, filling, {100000}), tubular::Input_error);
}

// --- regions ---

TEST(Validity_of_regions, Interfaces_are_labelled_and_regions_in_one_piece) {
  Mesh mesh = Quad_tube().mesh();
  tubular::extrude_wall(mesh, one, parameters::second_wall_thickness(0.1));
  tubular::internal::remove_openings(mesh);
  ASSERT_TRUE(tubular::validity_report(mesh).is_valid());

  Mesh unlabelled = mesh;
  tubular::internal::keep_elements(unlabelled.quads, [](int label) { return label != labels::middle_wall; });
  const auto without = tubular::validity_report(unlabelled);
  EXPECT_EQ(without.unlabelled_interfaces, 24u * 12);
  EXPECT_FALSE(without.is_valid());
  EXPECT_NE(without.defects().find("unlabelled faces between regions"), std::string::npos);

  Mesh torn = mesh; // a cell in the midst of the first wall belongs to the second
  torn.hexahedra.label[24 * 6] = 3;
  const auto in_pieces = tubular::validity_report(torn);
  EXPECT_EQ(in_pieces.region_components.at(3), 2u);
  EXPECT_EQ(in_pieces.regions_in_pieces(), 1u);
  EXPECT_EQ(in_pieces.connected_components, 1u);
  EXPECT_FALSE(in_pieces.is_valid());
}

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Tetrahedra, prisms and hexahedra subdivided into hexahedra that conform.

#include "grid_of_tetrahedra.h"

#include <CGAL/Tubular_meshing/Hexahedra/subdivide_into_hexahedra.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
using tubular::Element_block;
using tubular::Mixed_mesh;
using tubular::Point_3;
using tubular::internal::Cell_topology;
using tubular::internal::Vector_3d;

/* The volume of a cell whose quads are the bilinear surfaces through their corners. */
template <std::size_t N> double volume_of(const Mixed_mesh& mesh, const std::array<std::uint32_t, N>& cell) {
  double volume = 0;
  const auto add = [&](const auto& face) {
    std::vector<Vector_3d> p;
    Vector_3d middle;
    for (int k : face) {
      p.push_back(Vector_3d(mesh.points[cell[std::size_t(k)]]));
      middle += 1. / double(face.size()) * p.back();
    }
    for (std::size_t i = 0; i < p.size(); ++i)
      volume += dot(middle, cross(p[i], p[(i + 1) % p.size()])) / 6;
  };
  for (const auto& t : Cell_topology<N>::triangles())
    add(t);
  for (const auto& q : Cell_topology<N>::quads())
    add(q);
  return volume;
}

std::vector<double> volumes_of_hexahedra(const Mixed_mesh& mesh) {
  std::vector<double> result;
  for (const auto& h : mesh.hexahedra.vertices)
    result.push_back(volume_of(mesh, h));
  return result;
}

double sum(const std::vector<double>& x) {
  double result = 0;
  for (double v : x)
    result += v;
  return result;
}

/* Adds the faces that are of one cell alone as facets, of a patch. */
template <std::size_t N>
void count_faces(const Element_block<N>& cells,
                 std::map<std::vector<std::uint32_t>, std::vector<std::uint32_t>>& faces) {
  const auto count = [&](const auto& c, const auto& face) {
    std::vector<std::uint32_t> corners;
    for (int k : face)
      corners.push_back(c[std::size_t(k)]);
    std::vector<std::uint32_t> key = corners;
    std::sort(key.begin(), key.end());
    if (!faces.emplace(key, corners).second)
      faces.erase(key);
  };
  for (const auto& c : cells.vertices) {
    for (const auto& t : Cell_topology<N>::triangles())
      count(c, t);
    for (const auto& q : Cell_topology<N>::quads())
      count(c, q);
  }
}

void add_boundary(Mixed_mesh& mesh, int patch = tubular::labels::wall) {
  std::map<std::vector<std::uint32_t>, std::vector<std::uint32_t>> faces;
  count_faces(mesh.tetrahedra, faces);
  count_faces(mesh.prisms, faces);
  count_faces(mesh.hexahedra, faces);
  for (const auto& f : faces)
    if (f.second.size() == 3)
      mesh.triangles.push_back({{f.second[0], f.second[1], f.second[2]}}, patch);
    else
      mesh.quads.push_back({{f.second[0], f.second[1], f.second[2], f.second[3]}}, patch);
}

Mixed_mesh one_tetrahedron() {
  Mixed_mesh mesh;
  mesh.points = {Point_3(0, 0, 0), Point_3(3, 0, 0), Point_3(0.5, 2, 0), Point_3(0.4, 0.3, 1.7)};
  mesh.tetrahedra.push_back({{0, 1, 2, 3}}, 7);
  add_boundary(mesh);
  return mesh;
}

Mixed_mesh one_prism() {
  Mixed_mesh mesh;
  for (double z : {0., 0.25})
    for (const auto& p : {Point_3(0, 0, z), Point_3(3, 0, z), Point_3(1, 2, z)})
      mesh.points.push_back(p);
  mesh.prisms.push_back({{0, 1, 2, 3, 4, 5}}, 1);
  add_boundary(mesh);
  return mesh;
}

/* What every result has to be. */
void expect_hexahedra(const Mixed_mesh& mesh, double volume) {
  EXPECT_EQ(mesh.number_of_cells(), mesh.hexahedra.size());
  EXPECT_EQ(mesh.number_of_facets(), mesh.quads.size());
  const tubular::Validity_report report = tubular::validity_report(mesh);
  EXPECT_EQ(report.defects(), "");
  EXPECT_EQ(report.inverted_cells, 0u);
  const std::vector<double> volumes = volumes_of_hexahedra(mesh);
  EXPECT_GT(*std::min_element(volumes.begin(), volumes.end()), 0);
  EXPECT_NEAR(sum(volumes), volume, 1e-12 * volume);
  EXPECT_NEAR(tubular::lumen_measures(mesh, 0).volume, volume, 1e-12 * volume);
}

TEST(Subdivide_into_hexahedra, Makes_four_of_a_tetrahedron) {
  const Mixed_mesh from = one_tetrahedron(), mesh = tubular::subdivide_into_hexahedra(from);
  EXPECT_EQ(mesh.points.size(), 4u + 6 + 4 + 1);
  ASSERT_EQ(mesh.hexahedra.size(), 4u);
  EXPECT_EQ(mesh.quads.size(), 12u);
  const double volume = 3. * 2 / 2 * 1.7 / 3;
  expect_hexahedra(mesh, volume);
  for (double v : volumes_of_hexahedra(mesh)) // an affine map keeps the ratios of the regular one
    EXPECT_NEAR(v, volume / 4, 1e-14);
  EXPECT_EQ(mesh.hexahedra.label, std::vector<int>(4, 7));
  EXPECT_TRUE(std::equal(from.points.begin(), from.points.end(), mesh.points.begin()));
}

TEST(Subdivide_into_hexahedra, Makes_three_of_a_prism_and_leaves_its_lateral_edges) {
  const Mixed_mesh mesh = tubular::subdivide_into_hexahedra(one_prism());
  EXPECT_EQ(mesh.points.size(), 6u + 6 + 2);
  ASSERT_EQ(mesh.hexahedra.size(), 3u);
  EXPECT_EQ(mesh.quads.size(), 3u + 3 + 2 * 3);
  expect_hexahedra(mesh, 3 * 0.25);
  for (double v : volumes_of_hexahedra(mesh))
    EXPECT_NEAR(v, 0.25, 1e-14);
  for (const Point_3& p : mesh.points)
    EXPECT_TRUE(p.z() == 0 || p.z() == 0.25) << p;
}

TEST(Subdivide_into_hexahedra, Of_a_regular_tetrahedron_has_scaled_Jacobians_of_its_angles) {
  Mixed_mesh from;
  from.points = {Point_3(1, 1, 1), Point_3(1, -1, -1), Point_3(-1, 1, -1), Point_3(-1, -1, 1)};
  from.tetrahedra.push_back({{0, 1, 2, 3}}, 1);
  if (tubular::validity_report(from).inverted_cells > 0)
    from.tetrahedra.vertices[0] = {{0, 2, 1, 3}};
  const Mixed_mesh mesh = tubular::subdivide_into_hexahedra(from);
  for (const auto& h : mesh.hexahedra.vertices) {
    std::array<Vector_3d, 8> p;
    for (std::size_t k = 0; k < 8; ++k)
      p[k] = Vector_3d(mesh.points[h[k]]);
    EXPECT_NEAR(tubular::internal::scaled_jacobian(p), std::sqrt(0.5), 1e-12); // three edges at 60 degrees
  }
}

// Prisms on the lower triangles of tetrahedra, as layers along a wall.
TEST(Subdivide_into_hexahedra, Conforms_between_tetrahedra_and_prisms) {
  Mixed_mesh mesh = grid_of_tetrahedra(
      {3, 2, 2}, [](int i, int j, int k) { return Point_3(i, 1.2 * j, 0.8 * k + 0.1 * i); },
      [](int axis, int end) { return axis == 2 && end == 0 ? 5 : 0; });
  const auto floor = mesh.triangles;
  mesh.triangles = Element_block<3>();
  std::map<std::uint32_t, std::uint32_t> below;
  for (int layer = 0; layer < 3; ++layer)
    for (const auto& t : floor.vertices) {
      std::array<std::uint32_t, 6> prism;
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint32_t top = t[k]; // of this layer
        for (int l = 0; l < layer; ++l)
          top = below.at(top);
        if (below.count(top) == 0) {
          const Point_3& p = mesh.points[top];
          below[top] = std::uint32_t(mesh.points.size());
          mesh.points.emplace_back(p.x(), p.y(), p.z() - 0.1);
        }
        prism[k] = below[top];
        prism[3 + k] = top;
      }
      std::swap(prism[1], prism[2]); // the floor's triangles look down
      std::swap(prism[4], prism[5]);
      mesh.prisms.push_back(prism, 1);
    }
  add_boundary(mesh);
  ASSERT_EQ(tubular::validity_report(mesh).defects(), "");
  const Mixed_mesh result = tubular::subdivide_into_hexahedra(mesh);
  EXPECT_EQ(result.hexahedra.size(), 4 * mesh.tetrahedra.size() + 3 * mesh.prisms.size());
  expect_hexahedra(result, 3 * 2.4 * (1.6 + 0.3));
}

/* Three cubes: of prisms along z; of one hexahedron, beside it along x; of prisms along x, beside that along y. The
 * last one's triangles divide the edges along z of all. */
Mixed_mesh cubes_of_prisms_both_ways() {
  Mixed_mesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> number;
  const auto at = [&](int x, int y, int z) {
    const auto found = number.emplace(std::array<int, 3>{{x, y, z}}, std::uint32_t(mesh.points.size()));
    if (found.second)
      mesh.points.emplace_back(x, y, z);
    return found.first->second;
  };
  mesh.prisms.push_back({{at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1)}}, 1);
  mesh.prisms.push_back({{at(0, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 1, 1), at(0, 1, 1)}}, 1);
  mesh.hexahedra.push_back(
      {{at(1, 0, 0), at(2, 0, 0), at(2, 1, 0), at(1, 1, 0), at(1, 0, 1), at(2, 0, 1), at(2, 1, 1), at(1, 1, 1)}}, 2);
  mesh.prisms.push_back({{at(1, 1, 0), at(1, 2, 0), at(1, 2, 1), at(2, 1, 0), at(2, 2, 0), at(2, 2, 1)}}, 2);
  mesh.prisms.push_back({{at(1, 1, 0), at(1, 2, 1), at(1, 1, 1), at(2, 1, 0), at(2, 2, 1), at(2, 1, 1)}}, 2);
  add_boundary(mesh);
  mesh.quads.push_back({{at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)}}, 9); // between the two regions
  return mesh;
}

TEST(Subdivide_into_hexahedra, Divides_what_its_neighbours_need_divided) {
  const Mixed_mesh from = cubes_of_prisms_both_ways();
  ASSERT_EQ(tubular::validity_report(from).defects(), "");
  const Mixed_mesh mesh = tubular::subdivide_into_hexahedra(from);
  EXPECT_EQ(mesh.hexahedra.size(), 2u * 6 + 4 + 2 * 3); // along x the hexahedron stays whole
  EXPECT_EQ(std::count(mesh.quads.label.begin(), mesh.quads.label.end(), 9), 4);
  EXPECT_EQ(std::count(mesh.hexahedra.label.begin(), mesh.hexahedra.label.end(), 2), 4 + 2 * 3);
  const tubular::Validity_report report = tubular::validity_report(mesh);
  EXPECT_EQ(report.defects(), "");
  EXPECT_NEAR(sum(volumes_of_hexahedra(mesh)), 3, 1e-12);
}

TEST(Subdivide_into_hexahedra, Leaves_a_mesh_of_hexahedra_as_it_is) {
  Mixed_mesh from = cubes_of_prisms_both_ways();
  from.prisms = Element_block<6>();
  from.triangles = Element_block<3>();
  from.quads = Element_block<4>();
  add_boundary(from);
  const Mixed_mesh mesh = tubular::subdivide_into_hexahedra(from);
  EXPECT_EQ(mesh.points, from.points);
  EXPECT_EQ(mesh.hexahedra.vertices, from.hexahedra.vertices);
  EXPECT_EQ(mesh.quads.vertices, from.quads.vertices);
}

TEST(Subdivide_into_hexahedra, Makes_hexahedra_of_any_tetrahedra) {
  std::mt19937 random(7);
  const auto shaken = [&](int i, int j, int k) {
    const auto noise = [&] { return 0.3 * (double(random()) / double(random.max()) - 0.5); };
    const double x = noise(), y = noise(), z = noise();
    return Point_3(i + x, j + y, 0.3 * (k + z)); // flat, and irregular
  };
  const Mixed_mesh from = grid_of_tetrahedra({4, 5, 6}, shaken, [](int axis, int end) { return 1 + 2 * axis + end; });
  ASSERT_EQ(tubular::validity_report(from).defects(), "");
  double volume = 0;
  for (const auto& t : from.tetrahedra.vertices)
    volume += volume_of(from, t);
  const Mixed_mesh mesh = tubular::subdivide_into_hexahedra(from);
  EXPECT_EQ(mesh.hexahedra.size(), 4 * from.tetrahedra.size());
  const tubular::Validity_report report = tubular::validity_report(mesh);
  EXPECT_EQ(report.defects(), "");
  EXPECT_EQ(report.boundary_euler, 2);
  EXPECT_NEAR(sum(volumes_of_hexahedra(mesh)), volume, 1e-12 * volume);
  for (int patch = 1; patch <= 6; ++patch)
    EXPECT_EQ(std::count(mesh.quads.label.begin(), mesh.quads.label.end(), patch),
              3 * std::count(from.triangles.label.begin(), from.triangles.label.end(), patch));
}

TEST(Subdivide_into_hexahedra, Divides_facets_that_have_no_cells) {
  Mixed_mesh from;
  from.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(1, -1, 0), Point_3(0, -1, 0)};
  from.triangles.push_back({{0, 1, 2}}, 1);
  from.quads.push_back({{0, 4, 3, 1}}, 2); // shares an edge with the triangle
  const Mixed_mesh mesh = tubular::subdivide_into_hexahedra(from);
  EXPECT_EQ(mesh.quads.label, (std::vector<int>{1, 1, 1, 2, 2}));
  EXPECT_EQ(mesh.points.size(), 5u + 4 + 1);
}

TEST(Subdivide_into_hexahedra, Keeps_names_and_goes_on_with_point_arrays) {
  Mixed_mesh from = one_tetrahedron();
  from.region_names = {{7, "clot"}};
  from.patch_names = {{1, "wall"}};
  from.patch_ids.id = {{1, 33}};
  tubular::Point_array linear{"linear", 2, {}};
  const auto value = [](const Point_3& p, int k) { return k == 0 ? 2 * p.x() - p.y() + 1 : 3 * p.z(); };
  for (const Point_3& p : from.points)
    for (int k = 0; k < 2; ++k)
      linear.values.push_back(value(p, k));
  from.point_arrays.push_back(linear);
  const Mixed_mesh mesh = tubular::subdivide_into_hexahedra(from);
  EXPECT_EQ(mesh.region_names, from.region_names);
  EXPECT_EQ(mesh.patch_names, from.patch_names);
  EXPECT_EQ(mesh.patch_ids.id, from.patch_ids.id);
  ASSERT_EQ(mesh.point_arrays.size(), 1u);
  ASSERT_EQ(mesh.point_arrays[0].values.size(), 2 * mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(mesh.point_arrays[0].values[2 * i + std::size_t(k)], value(mesh.points[i], k), 1e-14);
}

TEST(Subdivide_into_hexahedra, Refuses_pyramids) {
  Mixed_mesh mesh;
  mesh.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0), Point_3(0.5, 0.5, 1)};
  mesh.pyramids.push_back({{0, 1, 2, 3, 4}}, 1);
  try {
    tubular::subdivide_into_hexahedra(mesh);
    FAIL() << "hexahedra were made of a pyramid";
  } catch (const tubular::Input_error& e) {
    EXPECT_NE(std::string(e.what()).find("pyramids"), std::string::npos) << e.what();
  }
}

TEST(Subdivide_into_hexahedra, Refuses_points_that_are_not_there) {
  Mixed_mesh mesh = one_tetrahedron();
  mesh.tetrahedra.vertices[0][2] = 4;
  EXPECT_THROW(tubular::subdivide_into_hexahedra(mesh), tubular::Input_error);
}

TEST(Subdivide_into_hexahedra, Of_nothing_is_nothing) {
  const Mixed_mesh mesh = tubular::subdivide_into_hexahedra(Mixed_mesh());
  EXPECT_EQ(mesh.points.size() + mesh.number_of_cells() + mesh.number_of_facets(), 0u);
}

} // namespace

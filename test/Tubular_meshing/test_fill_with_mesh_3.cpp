// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh_3 on tubes whose volume is known, and where it fails, comes to no end, or the field throws.

#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_mesh_3.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include "test_surfaces.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace fs = std::filesystem;
using test_surfaces::Point;
using tubular::internal::Vector_3d;
typedef tubular::Surface Surface;
typedef tubular::Face_patch_map Patch_map;
typedef tubular::Mixed_mesh Mesh;

Patch_map all_wall(Surface& surface) {
  return surface.add_property_map<Surface::Face_index, int>("f:patch", tubular::labels::wall).first;
}

double volume(const Mesh& m) {
  double v = 0;
  for (const auto& t : m.tetrahedra.vertices)
    v += tubular::internal::signed_volume(Vector_3d(m.points[t[0]]), Vector_3d(m.points[t[1]]),
                                          Vector_3d(m.points[t[2]]), Vector_3d(m.points[t[3]]));
  return v;
}

double constant_size(const Point&) {
  return 0.25;
}

TEST(Fill_with_mesh_3, Fills_a_sphere_on_one_thread_and_on_several) {
  Surface sphere = test_surfaces::make_sphere(16, 32);
  const Patch_map patch = all_wall(sphere);
  for (int threads : {1, 2}) {
    Mesh mesh;
    tubular::fill_with_mesh_3(sphere, patch, &constant_size, mesh, tubular::parameters::number_of_threads(threads));
    const auto report = tubular::validity_report(mesh);
    EXPECT_TRUE(report.is_valid()) << report.defects();
    EXPECT_NEAR(volume(mesh) / (4 * CGAL_PI / 3), 1, 0.05);
    EXPECT_EQ(mesh.region_names.at(tubular::labels::lumen), "lumen");
    EXPECT_EQ(std::set<int>(mesh.triangles.label.begin(), mesh.triangles.label.end()),
              std::set<int>{tubular::labels::wall});
  }
}

// A field with a dimension and an index, as Mesh_3's own concept has it.
struct Mesh_domain_field {
  typedef double FT;
  template <class Index> double operator()(const Point&, int, const Index&) const { return 0.25; }
};

TEST(Fill_with_mesh_3, Takes_a_field_of_Mesh_3_and_is_the_same_each_time) {
  Surface sphere = test_surfaces::make_sphere(16, 32);
  const Patch_map patch = all_wall(sphere);
  Mesh a, b;
  tubular::fill_with_mesh_3(sphere, patch, &constant_size, a, tubular::parameters::number_of_threads(1));
  tubular::fill_with_mesh_3(sphere, patch, Mesh_domain_field(), b, tubular::parameters::number_of_threads(1));
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tetrahedra.vertices, b.tetrahedra.vertices);
}

// With one thread: Mesh_3 on several waits for ever for the thread that an exception has ended.
TEST(Fill_with_mesh_3, Lets_the_fields_exceptions_through) {
  Surface sphere = test_surfaces::make_sphere(16, 32);
  const Patch_map patch = all_wall(sphere);
  for (int most_calls : {0, 500, 20000}) {
    int calls = 0;
    const auto size = [&](const Point&) {
      if (++calls > most_calls)
        throw std::domain_error("enough");
      return 0.1;
    };
    Mesh mesh;
    EXPECT_THROW(tubular::fill_with_mesh_3(sphere, patch, size, mesh, tubular::parameters::number_of_threads(1)),
                 std::domain_error);
  }
}

TEST(Fill_with_mesh_3, Refuses_quads) {
  Surface cube = test_surfaces::make_square_duct();
  CGAL::Euler::join_face(*cube.halfedges().begin(), cube);
  const Patch_map patch = all_wall(cube);
  Mesh mesh;
  EXPECT_THROW(tubular::fill_with_mesh_3(cube, patch, &constant_size, mesh), tubular::Input_error);
}

} // namespace

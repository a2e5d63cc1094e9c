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

TEST(Fill_with_mesh_3, Fills_a_sphere) {
  Surface sphere = test_surfaces::make_sphere(16, 32);
  const Patch_map patch = all_wall(sphere);
  Mesh mesh;
  tubular::fill_with_mesh_3(sphere, patch, &constant_size, mesh);
  const auto report = tubular::validity_report(mesh);
  EXPECT_TRUE(report.is_valid()) << report.defects();
  EXPECT_NEAR(volume(mesh) / (4 * CGAL_PI / 3), 1, 0.05);
  EXPECT_EQ(mesh.region_names.at(tubular::labels::lumen), "lumen");
  EXPECT_EQ(std::set<int>(mesh.triangles.label.begin(), mesh.triangles.label.end()),
            std::set<int>{tubular::labels::wall});
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
  tubular::fill_with_mesh_3(sphere, patch, &constant_size, a);
  tubular::fill_with_mesh_3(sphere, patch, Mesh_domain_field(), b);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tetrahedra.vertices, b.tetrahedra.vertices);
}

// What Mesh_3 leaves in the current folder is seen there.
class Fill_with_mesh_3_in_its_folder : public ::testing::Test {
protected:
  void SetUp() override {
    before_ = fs::current_path();
    folder_ = fs::path(TUBULAR_MESHING_SCRATCH) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    fs::current_path(folder_);
  }
  void TearDown() override {
    fs::current_path(before_);
    EXPECT_TRUE(fs::is_empty(folder_)) << *fs::directory_iterator(folder_);
    fs::remove_all(folder_);
  }

private:
  fs::path before_, folder_;
};

// How a surface of one patch is refused, with a size for which it has some thousand points.
std::string error_of(Surface surface, double size) {
  const Patch_map patch = all_wall(surface);
  Mesh mesh;
  try {
    tubular::fill_with_mesh_3(
        surface, patch, [size](const Point&) { return size; }, mesh);
  } catch (const tubular::Meshing_error& e) {
    EXPECT_TRUE(mesh.points.empty());
    return e.what();
  }
  return "";
}

/* A blade of one patch, its edge sharper than angles of 25 degrees allow: facets there are never good, and Mesh_3
 * makes them smaller and smaller. */
Surface make_blade() {
  Surface blade = test_surfaces::make_square_duct();
  for (auto v : blade.vertices()) {
    const Point& p = blade.point(v);
    blade.point(v) = Point(p.x(), 0.05 * p.y() * (p.x() + 1), p.z());
  }
  return blade;
}

TEST_F(Fill_with_mesh_3_in_its_folder, Comes_to_an_end) {
  const std::string sentence = error_of(make_blade(), 0.3);
  EXPECT_NE(sentence.find("comes to no end"), std::string::npos) << sentence;
}

TEST_F(Fill_with_mesh_3_in_its_folder, Leaves_no_files_where_a_surface_crosses_itself) {
  Surface sphere = test_surfaces::make_sphere(16, 32);
  for (auto v : sphere.vertices()) { // the upper half is turned inside out, and more
    const Point& p = sphere.point(v);
    if (p.z() > 0.5)
      sphere.point(v) = Point(p.x(), p.y(), 0.5 - 3 * (p.z() - 0.5));
  }
  error_of(sphere, 0.2); // whether it fails or not
}

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
    EXPECT_THROW(tubular::fill_with_mesh_3(sphere, patch, size, mesh), std::domain_error);
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

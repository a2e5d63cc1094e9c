// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of all types have the volume of the surface that they were made from, branch by branch, and the areas of its
// openings.

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/preserve_volume.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace parameters = tubular::parameters;
using tubular::Mesher;
using tubular::Mixed_mesh;
using tubular::Point_3;
using tubular::Vector_3;

struct Shape {
  std::string name;
  tubular::Tubular_skeleton skeleton;
};

tubular::Tubular_skeleton cone() {
  tubular::Tubular_skeleton skeleton;
  skeleton.nodes = {Point_3(0, 0, 0), Point_3(0, 0, 8)};
  skeleton.add_branch(
      0, 1, [](double t) { return Point_3(0, 0, 8 * t); }, [](double t) { return 1.4 - 0.8 * t; });
  return skeleton;
}

std::vector<Shape> shapes() {
  return {{"tube", tubular::straight_tube(8, 1)},
          {"bend", tubular::curved_tube(4, 1.8, 1)},
          {"Y", tubular::y_bifurcation()},
          {"cone", cone()}};
}

tubular::Tubular_model model_of(const tubular::Tubular_skeleton& skeleton, double points = 72) {
  tubular::Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(points));
  return tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton));
}

// Triangles of the lumen's wall; a quad is four, around its middle.
std::vector<std::array<Point_3, 3>> wall_of(const Mixed_mesh& mesh) {
  std::vector<std::array<Point_3, 3>> result;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles.label[i] == tubular::labels::wall) {
      const auto& t = mesh.triangles.vertices[i];
      result.push_back({{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}});
    }
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    if (mesh.quads.label[i] == tubular::labels::wall) {
      const auto& q = mesh.quads.vertices[i];
      Vector_3 sum(0, 0, 0);
      for (auto v : q)
        sum = sum + 0.25 * (mesh.points[v] - CGAL::ORIGIN);
      for (int k = 0; k < 4; ++k)
        result.push_back({{mesh.points[q[k]], mesh.points[q[(k + 1) % 4]], CGAL::ORIGIN + sum}});
    }
  return result;
}

std::vector<std::array<Point_3, 3>> wall_of(const tubular::Tubular_model& model) {
  std::vector<std::array<Point_3, 3>> result;
  for (auto f : model.surface.faces())
    if (model.patch[f] == tubular::labels::wall) {
      const auto h = model.surface.halfedge(f);
      const auto point = [&](auto g) { return model.surface.point(model.surface.target(g)); };
      result.push_back({{point(model.surface.prev(h)), point(h), point(model.surface.next(h))}});
    }
  return result;
}

// The area that a plane cuts out of a wall, near a point of the plane.
double section(const std::vector<std::array<Point_3, 3>>& wall, const Point_3& o, const Vector_3& n, double reach) {
  double area = 0;
  for (const auto& t : wall) {
    std::array<double, 3> d;
    for (int k = 0; k < 3; ++k)
      d[k] = (t[k] - o) * n;
    Point_3 in, out;
    int found = 0;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      if ((d[k] < 0) == (d[l] < 0))
        continue;
      (d[k] < 0 ? out : in) = t[k] + d[k] / (d[k] - d[l]) * (t[l] - t[k]);
      ++found;
    }
    if (found == 2 && CGAL::squared_distance(CGAL::midpoint(in, out), o) < reach * reach) // not of another branch
      area += CGAL::cross_product(out - o, in - o) * n / 2;
  }
  return std::abs(area);
}

// The largest difference, of all branches, between their mean cross sections in the mesh and in the surface.
double largest_loss(const Shape& shape, const tubular::Tubular_model& model, const Mixed_mesh& mesh) {
  const auto before = wall_of(model), after = wall_of(mesh);
  double largest = 0;
  for (const auto& b : shape.skeleton.branches) {
    double sum_before = 0, sum_after = 0;
    const std::size_t n = b.points.size();
    for (std::size_t i = n / 4; i < n - n / 4; ++i)
      for (double t : {0.1, 0.35, 0.6, 0.85}) {
        const Vector_3 d = b.points[i + 1] - b.points[i];
        const Vector_3 unit = d / std::sqrt(d.squared_length());
        const Point_3 o = b.points[i] + t * d;
        sum_before += section(before, o, unit, 1.6 * b.radius[i]);
        sum_after += section(after, o, unit, 1.6 * b.radius[i]);
      }
    largest = std::max(largest, std::abs(sum_after / sum_before - 1));
  }
  return largest;
}

void expect_volume(const Shape& shape, const tubular::Tubular_model& model, const Mixed_mesh& mesh,
                   const std::string& what) {
  const auto measures = tubular::lumen_measures(mesh, model.openings.size());
  const double volume = CGAL::Polygon_mesh_processing::volume(model.surface);
  EXPECT_NEAR(measures.volume / volume, 1, 0.002) << shape.name << ", " << what;
  for (const auto& o : model.openings)
    EXPECT_NEAR(measures.opening_area.at(o.patch) / o.area, 1, 0.003) << shape.name << ", " << what;
  EXPECT_LT(largest_loss(shape, model, mesh), 0.004) << shape.name << ", " << what;
  EXPECT_EQ(tubular::validity_report(mesh).defects(), "") << shape.name << ", " << what;
}

Mixed_mesh as_mesh(const tubular::Remeshed_surface& surface) {
  Mixed_mesh mesh;
  tubular::surface_to_mixed_mesh(surface, mesh);
  return mesh;
}

bool keeps_boundary() {
  return tubular::default_volume_mesher() != tubular::Volume_mesher::mesh_3;
}

TEST(Preserve_volume, Of_surfaces) {
  for (const Shape& shape : shapes()) {
    const auto model = model_of(shape.skeleton);
    for (double n : {12., 20., 40.}) {
      const std::string what = "surface, " + std::to_string(int(n));
      Mesher mesher(model, parameters::points_per_circumference(n).curvature_points(n).number_of_threads(1));
      const auto check = [&](tubular::Surface_elements elements) {
        const auto measures = as_mesh(mesher.surface(elements));
        const auto m = tubular::lumen_measures(measures, model.openings.size());
        const double volume = CGAL::Polygon_mesh_processing::volume(model.surface);
        EXPECT_NEAR(m.volume / volume, 1, 0.002) << shape.name << ", " << what << " " << int(elements);
        for (const auto& o : model.openings)
          EXPECT_NEAR(m.opening_area.at(o.patch) / o.area, 1, 0.003) << shape.name << ", " << what;
        EXPECT_LT(largest_loss(shape, model, measures), 0.004) << shape.name << ", " << what << " " << int(elements);
      };
      check(tubular::Surface_elements::triangles);
      if (n < 30)
        check(tubular::Surface_elements::anisotropic_triangles);
      if (tubular::has_lemon())
        check(tubular::Surface_elements::quads);
    }
  }
}

TEST(Preserve_volume, Without_it_a_polygon_loses_what_it_must) {
  const auto model = model_of(tubular::straight_tube(8, 1));
  const double volume = CGAL::Polygon_mesh_processing::volume(model.surface);
  const double n = 12;
  Mesher mesher(model, parameters::points_per_circumference(n).preserve_volume(false).number_of_threads(1));
  const auto m = tubular::lumen_measures(as_mesh(mesher.surface()), 2);
  EXPECT_NEAR(1 - m.volume / volume, 2 * CGAL_PI * CGAL_PI / 3 / (n * n), 0.02);
  EXPECT_EQ(mesher.report().volume.volume, 0);
}

TEST(Preserve_volume, Of_isotropic_meshes_by_patches) {
  if (!keeps_boundary())
    GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1";
  for (const Shape& shape : shapes())
    for (double n : {12., 20.}) {
      const auto model = model_of(shape.skeleton);
      Mesher mesher(model, parameters::points_per_circumference(n).number_of_threads(1));
      const Mixed_mesh mesh = mesher.isotropic();
      EXPECT_TRUE(mesher.report().fallbacks.empty());
      expect_volume(shape, model, mesh, "by patches, " + std::to_string(int(n)));
      const double sagitta = 1 - std::cos(CGAL_PI / n);
      EXPECT_LT(mesher.report().volume.largest_shift, 2 * sagitta * 1.4) << shape.name; // of the widest radius
      EXPECT_NEAR(mesher.report().volume.volume, tubular::lumen_measures(mesh, model.openings.size()).volume,
                  1e-9 * mesher.report().volume.volume);
    }
}

TEST(Preserve_volume, Of_isotropic_meshes_by_Mesh_3) {
  for (const Shape& shape : shapes())
    for (double n : {12., 20.}) {
      const auto model = model_of(shape.skeleton);
      Mesher mesher(model, parameters::points_per_circumference(n)
                               .surface_mesher(tubular::Surface_mesher::mesh_3)
                               .volume_mesher(tubular::Volume_mesher::mesh_3)
                               .number_of_threads(1));
      expect_volume(shape, model, mesher.isotropic(), "by Mesh_3, " + std::to_string(int(n)));
    }
}

TEST(Preserve_volume, Of_anisotropic_meshes) {
  for (const Shape& shape : shapes()) {
    const auto model = model_of(shape.skeleton);
    Mesher mesher(
        model, parameters::points_per_circumference(12).curvature_points(12).first_height(0.06).number_of_threads(1));
    expect_volume(shape, model, mesher.anisotropic(), "anisotropic");
  }
}

TEST(Preserve_volume, Of_mixed_meshes_and_of_layers) {
  if (!keeps_boundary() || !tubular::has_lemon())
    GTEST_SKIP() << "built without LEMON, or with neither TetGen nor CGAL 6.1";
  for (const Shape& shape : shapes()) {
    const auto model = model_of(shape.skeleton);
    const auto np = parameters::points_per_circumference(12).number_of_threads(1);
    expect_volume(shape, model, Mesher(model, np.wall_thickness(0.2)).mixed(), "mixed, with a wall");
    expect_volume(shape, model, Mesher(model, np.boundary_layer_prisms(3)).isotropic(), "with prisms");
  }
}

// The wall keeps its thickness: it grows on the lumen as it is.
TEST(Preserve_volume, Keeps_the_thickness_of_walls) {
  const auto model = model_of(tubular::straight_tube(8, 1));
  Mesher mesher(model, parameters::points_per_circumference(12).number_of_threads(1));
  Mixed_mesh mesh = as_mesh(mesher.surface());
  const auto report = tubular::extrude_wall(
      mesh, [](const Point_3&) { return 1.; }, parameters::wall_thickness(0.2).wall_layers(2));
  EXPECT_EQ(report.reduced_vertices, 0u);
  EXPECT_NEAR(report.mean_ratio, 1, 0.01);
}

// Where the mesh is as fine as the input there is nothing to move.
TEST(Preserve_volume, Of_a_surface_coarser_than_the_mesh_moves_little) {
  const auto model = model_of(tubular::straight_tube(8, 1), 10);
  Mesher mesher(model, parameters::points_per_circumference(40).number_of_threads(1));
  const auto m = tubular::lumen_measures(as_mesh(mesher.surface()), 2);
  EXPECT_NEAR(m.volume / CGAL::Polygon_mesh_processing::volume(model.surface), 1, 0.001);
  EXPECT_LT(mesher.report().volume.largest_shift, 0.05);
}

TEST(Preserve_volume, Does_not_depend_on_the_number_of_threads) {
  const auto model = model_of(tubular::y_bifurcation(), 40);
  Mixed_mesh meshes[2];
  for (int threads : {1, 2}) {
    Mesher mesher(model, parameters::points_per_circumference(16).number_of_threads(threads));
    meshes[threads - 1] = as_mesh(mesher.surface());
  }
  EXPECT_EQ(meshes[0].points, meshes[1].points);
}

} // namespace

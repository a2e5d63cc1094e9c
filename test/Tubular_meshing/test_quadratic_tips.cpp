// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Closed ends of vessels, round and pointed, of which the truth is known: the smooth surface behind their triangles, and
// quadratic meshes on it. Lengths are radii of the vessel.

#include "quadratic_meshes.h"

#include <CGAL/Tubular_meshing/Quadratic/internal/Smooth_wall.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/cgal_compatibility.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadratic_meshes;
namespace parameters = tubular::parameters;
using tubular::Surface;

/* A tube along z of radius 1, open at z = 0, that ends in a cone of a height, or in half a ball where that is 0. */
struct Tipped_tube {
  double height;
  static constexpr double length = 4;

  bool is_round() const { return height == 0; }
  double tip() const { return length + (is_round() ? 1 : height); }
  double volume() const { return CGAL_PI * (length + (is_round() ? 2. / 3 : height / 3)); }

  // From a point to the exact surface, whatever is behind its open end.
  double distance(const Vector& p) const {
    const double r = std::hypot(p.x, p.y), z = p.z - length;
    if (is_round())
      return std::abs((z > 0 ? std::hypot(r, z) : r) - 1);
    const double slant = std::hypot(1, height);
    const double along = std::min(std::max(((1 - r) + z * height) / (slant * slant), 0.), 1.);
    const double to_cone = std::hypot(r - (1 - along), z - along * height);
    return std::min(to_cone, z > 0 ? std::hypot(r - 1, z) : std::abs(r - 1));
  }

  // The rings of vertices (r, z), from the open end on; the tip is not one.
  std::vector<std::pair<double, double>> rings(std::size_t sides) const {
    const double edge = 2 * CGAL_PI / double(sides);
    std::vector<std::pair<double, double>> result;
    const auto along_tube = std::size_t(std::lround(length / edge));
    for (std::size_t k = 0; k < along_tube; ++k)
      result.emplace_back(1, length * double(k) / double(along_tube));
    const double slant = is_round() ? CGAL_PI / 2 : std::hypot(1, height);
    const auto along_tip = std::max(std::size_t(3), std::size_t(std::lround(slant / edge)));
    for (std::size_t k = 0; k < along_tip; ++k) {
      const double t = double(k) / double(along_tip), a = CGAL_PI / 2 * t;
      if (is_round())
        result.emplace_back(std::cos(a), length + std::sin(a));
      else
        result.emplace_back(1 - t, length + t * height);
    }
    return result;
  }

  // Of triangles, with a cap or open.
  Surface surface(std::size_t sides, bool capped) const {
    Surface mesh;
    auto patch = mesh.add_property_map<Surface::Face_index, int>("f:patch", tubular::labels::wall).first;
    std::vector<Surface::Vertex_index> below, ring;
    for (const auto& rz : rings(sides)) {
      ring.clear();
      for (std::size_t i = 0; i < sides; ++i) {
        const double a = 2 * CGAL_PI * double(i) / double(sides);
        ring.push_back(mesh.add_vertex(Point_3(rz.first * std::cos(a), rz.first * std::sin(a), rz.second)));
      }
      for (std::size_t i = 0; i < sides && !below.empty(); ++i) {
        const std::size_t j = (i + 1) % sides;
        mesh.add_face(below[i], below[j], ring[j]);
        mesh.add_face(below[i], ring[j], ring[i]);
      }
      if (below.empty() && capped) {
        const auto center = mesh.add_vertex(Point_3(0, 0, 0));
        for (std::size_t i = 0; i < sides; ++i)
          patch[mesh.add_face(ring[(i + 1) % sides], ring[i], center)] = tubular::labels::inlet;
      }
      below = ring;
    }
    const auto top = mesh.add_vertex(Point_3(0, 0, tip()));
    for (std::size_t i = 0; i < sides; ++i)
      mesh.add_face(below[i], below[(i + 1) % sides], top);
    return mesh;
  }
};

const std::vector<double> pointed = {0.2, 0.4, 0.6, 0.8, 1, 1.5, 2.5, 4}; // half angles of 79 to 14 degrees

/* How far a wall is from the exact one at most, over the longest edge of the triangle there. */
struct Deviation {
  double smooth = 0, flat = 0;
};

Deviation deviation_of_smooth_wall(const Tipped_tube& tube, std::size_t sides) {
  const Surface surface = tube.surface(sides, true);
  const auto patch = *tubular::internal::property_map_of<Surface::Face_index, int>(surface, "f:patch");
  const tubular::internal::Smooth_wall wall(surface, patch, 1);
  Deviation result;
  for (auto f : surface.faces()) {
    if (patch[f] != tubular::labels::wall)
      continue;
    std::vector<Vector> p;
    for (auto v : surface.vertices_around_face(surface.halfedge(f)))
      p.emplace_back(surface.point(v));
    const Vector normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
    const double edge = std::max({norm(p[1] - p[0]), norm(p[2] - p[1]), norm(p[0] - p[2])});
    const std::size_t n = 6;
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = 0; i + j <= n; ++j) {
        // not at the corners, where other triangles are as near
        const double u = 0.01 + 0.97 * double(i) / double(n), v = 0.01 + 0.97 * double(j) / double(n);
        const Vector x = (1 - u - v) * p[0] + u * p[1] + v * p[2];
        const auto found = wall.nearest(x, normal, edge);
        EXPECT_TRUE(found);
        if (found)
          result.smooth = std::max(result.smooth, tube.distance(found->point) / edge);
        result.flat = std::max(result.flat, tube.distance(x) / edge);
      }
  }
  return result;
}

TEST(Smooth_wall, Follows_round_ends) {
  for (std::size_t sides : {8u, 12u, 24u, 48u}) {
    const Deviation d = deviation_of_smooth_wall(Tipped_tube{0}, sides);
    EXPECT_LT(d.smooth, 0.2 * d.flat) << sides << " sides";
  }
}

TEST(Smooth_wall, Does_not_bulge_at_pointed_ends) {
  for (double height : pointed)
    for (std::size_t sides : {8u, 12u, 24u, 48u}) {
      const Deviation d = deviation_of_smooth_wall(Tipped_tube{height}, sides);
      EXPECT_LT(d.smooth, 0.06) << "height " << height << ", " << sides << " sides";
    }
}

// --- meshes ---

Vessel vessel_of(const Tipped_tube& tube) {
  Vessel vessel;
  vessel.model = tubular::make_tubular_model(tube.surface(24, false),
                                             parameters::seeds(std::vector<Point_3>{Point_3(0, 0, 0)})
                                                 .blind_ends(std::vector<Point_3>{Point_3(0, 0, tube.tip())})
                                                 .single_opening(true));
  vessel.volume = tube.volume();
  vessel.openings = {1};
  return vessel;
}

// Of the curved facets of the wall; of those that cross the crease between tube and cone; and how far the exact tip is from
// them.
struct Mesh_deviation : Deviation {
  double crease = 0, tip = 1;
};

Mesh_deviation deviation_of_mesh(const Tipped_tube& tube, const Quadratic_mesh& mesh) {
  const double least_edge = CGAL_PI / 12; // smaller ones, of a few facets round a tip, count as half of those elsewhere
  Mesh_deviation result;
  const auto& triangles = mesh.linear.triangles;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (triangles.label[i] != tubular::labels::wall)
      continue;
    const auto& t = triangles.vertices[i];
    std::vector<Vector> p, middle;
    for (std::size_t k = 0; k < 3; ++k) {
      p.emplace_back(mesh.linear.points[t[k]]);
      middle.emplace_back(mesh.edge_points[mesh.edge(t[k], t[(k + 1) % 3])]);
    }
    const double edge = std::max({norm(p[1] - p[0]), norm(p[2] - p[1]), norm(p[0] - p[2]), least_edge});
    const auto z = std::minmax({p[0].z, p[1].z, p[2].z});
    const bool crosses =
        !tube.is_round() && z.first < tube.length - 0.05 * edge && z.second > tube.length + 0.05 * edge;
    double& smooth = crosses ? result.crease : result.smooth;
    const std::size_t n = 8;
    for (std::size_t a = 0; a <= n; ++a)
      for (std::size_t b = 0; a + b <= n; ++b) {
        const double u = double(a) / double(n), v = double(b) / double(n), w = 1 - u - v;
        const Vector curved = u * (2 * u - 1) * p[0] + v * (2 * v - 1) * p[1] + w * (2 * w - 1) * p[2] +
                              4 * u * v * middle[0] + 4 * v * w * middle[1] + 4 * w * u * middle[2];
        smooth = std::max(smooth, tube.distance(curved) / edge);
        result.flat = std::max(result.flat, tube.distance(u * p[0] + v * p[1] + w * p[2]) / edge);
        result.tip = std::min(result.tip, norm(curved - Vector(0, 0, tube.tip())));
      }
  }
  return result;
}

TEST(Quadratic_mesh, Ends_round_or_pointed_have_their_volume_and_shape) {
  if (tubular::default_volume_mesher() == tubular::Volume_mesher::mesh_3)
    GTEST_SKIP() << "built with neither TetGen nor CGAL 6.1";
  for (double height : {0., 0.4, 0.6, 0.8, 1., 1.5, 2.5, 4.}) { // 0 is round
    SCOPED_TRACE("height " + std::to_string(height));
    const Tipped_tube tube{height};
    const Vessel vessel = vessel_of(tube);
    ASSERT_EQ(vessel.model.openings.size(), 1u);
    const Mixed_mesh linear =
        linear_mesh(vessel, "isotropic", parameters::points_per_circumference(12).preserve_volume(false));
    Quadratic_mesh mesh;
    const auto report = curve(vessel, linear, false, mesh);
    EXPECT_EQ(report.invalid, 0u);
    const double volume = volumes(mesh)[tubular::labels::lumen] / vessel.volume;
    const Mesh_deviation d = deviation_of_mesh(tube, mesh);
    EXPECT_NEAR(volume, 1, tube.is_round() ? 5e-4 : 1.5e-3);
    EXPECT_LT(d.smooth, tube.is_round() ? 0.2 * d.flat : 0.1);
    EXPECT_LT(d.crease, 0.2); // where an edge crosses it anywhere
    EXPECT_LT(d.tip, 0.05);   // a tenth of an edge
  }
}

} // namespace

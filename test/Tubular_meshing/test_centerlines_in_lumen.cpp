// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Computed centerlines stay in the lumen, and do not cross from one vessel to another that it touches. Judged by exact
// predicates on the closed surface, which compute_centerlines() does not use.

#include "computed_centerlines.h"

#include <CGAL/Tubular_meshing/base/cgal_compatibility.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>

namespace {

using namespace computed_centerlines;

/* Which points of a graph are not inside the closed surface, which of its segments cross the wall, and which of its
 * radii are not the distance to the wall. */
class Lumen {
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
  typedef CGAL::AABB_tree<tubular::internal::Aabb_traits<Kernel, Primitive>> Tree;

public:
  explicit Lumen(const Closed& closed)
      : side_(closed.mesh) {
    std::vector<Mesh::Face_index> wall;
    for (auto f : closed.mesh.faces())
      if (closed.patch[f] == tubular::labels::wall)
        wall.push_back(f);
    wall_.rebuild(wall.begin(), wall.end(), closed.mesh);
  }

  // The ends lie on the caps, on either side of their facets by a rounding error.
  std::size_t points_outside(const Graph& graph) const {
    std::vector<bool> is_end(graph.points().size(), false);
    for (const auto& n : graph.nodes())
      is_end[n.point] = n.is_end();
    std::size_t result = 0;
    for (std::size_t i = 0; i < graph.points().size(); ++i)
      result += !is_end[i] && side_(graph.points()[i]) != CGAL::ON_BOUNDED_SIDE;
    return result;
  }

  std::size_t segments_that_cross_the_wall(const Graph& graph) const {
    std::size_t result = 0;
    for (const auto& b : graph.branches())
      for (std::size_t i = 1; i < b.points.size(); ++i)
        result += wall_.do_intersect(Kernel::Segment_3(graph.points()[b.points[i - 1]], graph.points()[b.points[i]]));
    return result;
  }

  double largest_radius_error(const Graph& graph) const {
    double result = 0;
    for (std::size_t i = 0; i < graph.points().size(); ++i) {
      const double r = std::sqrt(wall_.squared_distance(graph.points()[i]));
      result = std::max(result, std::abs(graph.radii()[i] - r) / r);
    }
    return result;
  }

private:
  CGAL::Side_of_triangle_mesh<Mesh, Kernel> side_;
  Tree wall_;
};

void expect_in_lumen(const Closed& closed, const Graph& graph) {
  const Lumen lumen(closed);
  EXPECT_EQ(lumen.points_outside(graph), 0u);
  EXPECT_EQ(lumen.segments_that_cross_the_wall(graph), 0u);
  EXPECT_LT(lumen.largest_radius_error(graph), 1e-3);
}

Graph expect_in_lumen(const Mesh& open, bool loops = false) {
  const Closed closed(open);
  const Graph graph = centerlines_of(closed, loops);
  expect_in_lumen(closed, graph);
  return graph;
}

// --- generated shapes ---

TEST(Centerlines_in_lumen, Tight_bend) {
  expect_in_lumen(surface_of(tubular::curved_tube(1.5, CGAL_PI)));
}

TEST(Centerlines_in_lumen, Noisy_bifurcation) {
  expect_in_lumen(surface_of(tubular::y_bifurcation(), 16, 0.1));
}

TEST(Centerlines_in_lumen, Loop) {
  expect_in_lumen(surface_of(tubular::willis_loop(), 16), true);
}

TEST(Centerlines_in_lumen, Tree) {
  expect_in_lumen(surface_of(tubular::bronchial_tree(61), 12));
}

/* A tube of radius 1 that comes up, goes round a wide turn and back down beside itself: over a length of six radii the
 * two legs are apart by `gap`, vertex to vertex. */
Mesh hairpin(double gap, int sides, double& length) {
  const int steps = 3 * sides;
  std::vector<Point> axis;
  const auto leg = [&](double z) {
    const double u = std::min(1., std::max(0., (std::abs(z) - 3) / 6));
    return 1 + gap / 2 + 3 * u * u * (3 - 2 * u);
  };
  for (int i = 0; i <= steps; ++i)
    axis.push_back(Point(-leg(-9 + 18. * i / steps), 0, -9 + 18. * i / steps));
  for (int i = 1; i < steps; ++i)
    axis.push_back(Point(-leg(9) * std::cos(CGAL_PI * i / steps), 0, 9 + leg(9) * std::sin(CGAL_PI * i / steps)));
  for (int i = 0; i <= steps; ++i)
    axis.push_back(Point(leg(9 - 18. * i / steps), 0, 9 - 18. * i / steps));

  Mesh mesh;
  length = 0;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    Vector t = axis[std::min(i + 1, axis.size() - 1)] - axis[i > 0 ? i - 1 : 0];
    t = t / std::sqrt(t.squared_length());
    length += i > 0 ? distance(axis[i - 1], axis[i]) : 0;
    for (int k = 0; k < sides; ++k) {
      const double a = 2 * CGAL_PI * k / sides;
      mesh.add_vertex(axis[i] + std::cos(a) * Vector(-t.z(), 0, t.x()) + std::sin(a) * Vector(0, 1, 0));
    }
  }
  const auto at = [&](std::size_t i, int k) { return Mesh::Vertex_index(unsigned(i * sides + k % sides)); };
  for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    for (int k = 0; k < sides; ++k) {
      mesh.add_face(at(i, k), at(i + 1, k + 1), at(i, k + 1));
      mesh.add_face(at(i, k), at(i + 1, k), at(i + 1, k + 1));
    }
  return mesh;
}

TEST(Centerlines_in_lumen, Do_not_cross_between_vessels_that_nearly_touch) {
  for (double gap : {0.01, 0.001})
    for (int sides : {8, 16, 32}) {
      SCOPED_TRACE(::testing::Message() << "gap " << gap << ", " << sides << " sides");
      double length;
      const Mesh surface = hairpin(gap, sides, length);
      const Graph graph = expect_in_lumen(surface);
      ASSERT_EQ(graph.branches().size(), 1u);
      EXPECT_NEAR(graph.length(), length, 0.02 * length);
    }
}

// --- real vessels ---

void expect_real_one_in_lumen(const std::string& file, bool loops = false) {
  const Mesh surface = shared_surface(file);
  if (surface.is_empty())
    GTEST_SKIP() << "needs shared/data/" << file;
  expect_in_lumen(surface, loops);
}

TEST(Centerlines_in_lumen, Aorta) {
  expect_real_one_in_lumen("paper/aorta.stl");
}
TEST(Centerlines_in_lumen, Carotid) {
  expect_real_one_in_lumen("paper/carotid.stl");
}
TEST(Centerlines_in_lumen, Cerebral) {
  expect_real_one_in_lumen("paper/cerebral.stl");
}
TEST(Centerlines_in_lumen, Bypass_with_its_loop) {
  expect_real_one_in_lumen("paper/bypass.stl", true);
}
TEST(Centerlines_in_lumen, Cylinder) {
  expect_real_one_in_lumen("paper/cylemi.stl");
}
TEST(Centerlines_in_lumen, Coarse_coronary_tree) {
  expect_real_one_in_lumen("trees/sofa_LCA.stl");
}
TEST(Centerlines_in_lumen, Vessels_that_split_and_rejoin) {
  expect_real_one_in_lumen("trees/sofa_phantom_network.obj", true);
}
TEST(Centerlines_in_lumen, Airway) {
  expect_real_one_in_lumen("trees/airway_lf_open.vtp");
}

TEST(Centerlines_in_lumen, Noisy_carotid_bifurcation_repaired) {
  Mesh surface = shared_surface("trees/sofa_carotids.stl");
  if (surface.is_empty())
    GTEST_SKIP() << "needs shared/data/trees/sofa_carotids.stl";
  tubular::repair_surface(surface);
  const Graph graph = expect_in_lumen(surface);
  EXPECT_EQ(graph.number_of_ends(), 3u);
  EXPECT_EQ(graph.branches().size(), 3u);
}

} // namespace

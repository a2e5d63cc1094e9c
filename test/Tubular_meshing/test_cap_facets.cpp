// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Facets of surfaces of few triangles are no ends; flat caps of few triangles are.

#include "round_ends.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace round_ends;
namespace np = CGAL::parameters;
namespace simplification = CGAL::Surface_mesh_simplification;

enum class Decimation { default_cost, edge_length, quadrics };

// Leaves a share of the edges.
void decimate(Mesh& mesh, Decimation how, double share) {
  const simplification::Count_ratio_stop_predicate<Mesh> stop(share);
  if (how == Decimation::default_cost)
    simplification::edge_collapse(mesh, stop);
  else if (how == Decimation::edge_length)
    simplification::edge_collapse(mesh, stop,
                                  np::get_cost(simplification::Edge_length_cost<Mesh>())
                                      .get_placement(simplification::Midpoint_placement<Mesh>()));
  else {
    typedef simplification::GarlandHeckbert_policies<Mesh, tubular::Kernel> Policies;
    Policies policies(mesh);
    simplification::edge_collapse(mesh, stop,
                                  np::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  }
  mesh.collect_garbage();
}

// A tube of n sides, from file coordinates of single precision. Its caps are fans without a vertex of their own; their
// rims rise and fall by a share of the radius, twice round.
Mesh capped_tube(std::size_t n, double rise, double angle) {
  const std::size_t rings = 9;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (std::size_t k = 0; k < rings; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      const double a = 2 * CGAL_PI * double(i) / double(n);
      const bool is_rim = k == 0 || k + 1 == rings;
      v.push_back(mesh.add_vertex(Point(std::cos(a), std::sin(a), double(k) + (is_rim ? rise * std::sin(2 * a) : 0))));
    }
  for (std::size_t k = 0; k + 1 < rings; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = k * n + i, b = k * n + (i + 1) % n;
      mesh.add_face(v[a], v[b], v[b + n]);
      mesh.add_face(v[a], v[b + n], v[a + n]);
    }
  const std::size_t last = (rings - 1) * n;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    mesh.add_face(v[0], v[i + 1], v[i]);
    mesh.add_face(v[last], v[last + i], v[last + i + 1]);
  }
  move(mesh, 37, angle);
  for (auto w : mesh.vertices()) {
    const Point& p = mesh.point(w);
    mesh.point(w) = Point(double(float(p.x())), double(float(p.y())), double(float(p.z())));
  }
  return mesh;
}

} // namespace

// Of facets that are as large as a vessel is wide, one in a hundred may still look like a cap: these are coarser than 12
// points round a vessel by half.
TEST(Cap_facets, Facets_of_decimated_domes_are_no_ends) {
  for (const Skeleton& s : {tubular::y_bifurcation(), tubular::aortic_arch()})
    for (double n : {12., 24.})
      for (Decimation how : {Decimation::default_cost, Decimation::edge_length, Decimation::quadrics})
        for (double share : {0.5, 0.25}) {
          SCOPED_TRACE("n " + std::to_string(n) + ", decimation " + std::to_string(int(how)) + " to " +
                       std::to_string(share));
          Mesh mesh = round_tree(s, n);
          move(mesh, 1, 0.3 * n);
          decimate(mesh, how, share);
          EXPECT_TRUE(tubular::internal::find_any_openings(mesh, {}).empty());
        }
}

TEST(Cap_facets, Flat_caps_of_few_triangles_are_ends) {
  for (std::size_t n : {6, 7, 8, 10, 14})
    for (double angle : {0., 0.5, 1.1, 2.3}) {
      SCOPED_TRACE(std::to_string(n) + " sides, turned by " + std::to_string(angle));
      EXPECT_EQ(tubular::find_openings(capped_tube(n, 0, angle)).size(), 2u);
    }
}

TEST(Cap_facets, Caps_without_vertices_on_rims_that_are_not_flat_are_ends) {
  for (std::size_t n : {8, 10, 12, 16, 24})
    for (double rise : {0.02, 0.08, 0.15}) {
      SCOPED_TRACE(std::to_string(n) + " sides, rise " + std::to_string(rise));
      EXPECT_EQ(tubular::find_openings(capped_tube(n, rise, 0.4)).size(), 2u);
    }
}

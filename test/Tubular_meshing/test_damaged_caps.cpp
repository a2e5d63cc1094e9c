// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Flat caps with a vertex of their rims thrown out of place, and labels of caps whose rims have new faces.

#include "round_ends.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Repair/carry_labels.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace round_ends;

/* A vessel with a branch, closed by flat caps at all three ends. */
struct Capped_vessel {
  Mesh mesh;
  std::vector<int> labels; ///< by face: 1 the wall, 2 to 4 the caps

  Capped_vessel(double points_round, double branch_radius) {
    const Skeleton skeleton = tube_with_branch(branch_radius, 1.2, 8);
    mesh = round_tree(skeleton, points_round);
    auto label = mesh.add_property_map<Mesh::Face_index, int>("f:label", 1).first;
    int last = 1;
    for (const End& end : skeleton.ends()) {
      ++last;
      for (auto f : finish_end(mesh, end, Kind::flat))
        label[f] = last;
    }
    mesh.collect_garbage();
    for (auto f : mesh.faces())
      labels.push_back(label[f]);
    mesh.remove_property_map(label);
  }

  /* The vertices of the caps, all of which are on rims, that have many triangles: most of a cap hangs on them. */
  std::vector<Mesh::Vertex_index> rim_vertices(std::size_t least_degree) const {
    std::set<Mesh::Vertex_index> result;
    for (auto f : mesh.faces())
      if (labels[std::size_t(f)] > 1)
        for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
          if (mesh.degree(v) >= least_degree)
            result.insert(v);
    return {result.begin(), result.end()};
  }
};

/* By a multiple of the longest edge, along the normal there, or along that of the cap. */
void throw_out(const Capped_vessel& vessel, Mesh& mesh, Mesh::Vertex_index v, double edges, bool along_vessel) {
  double longest = 0;
  Vector normal(0, 0, 0);
  for (auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh)) {
    longest = std::max(longest, tubular::internal::point_distance(mesh.point(v), mesh.point(mesh.source(h))));
    if (!along_vessel || vessel.labels[std::size_t(mesh.face(h))] > 1)
      normal = normal + tubular::internal::area_vector(h, mesh);
  }
  mesh.point(v) = mesh.point(v) + edges * longest * normalized(normal);
}

struct Soup {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;

  explicit Soup(const Mesh& mesh) {
    for (auto v : mesh.vertices())
      points.push_back(mesh.point(v));
    for (auto f : mesh.faces()) {
      const auto h = mesh.halfedge(f);
      triangles.push_back(
          {std::size_t(mesh.source(h)), std::size_t(mesh.target(h)), std::size_t(mesh.target(mesh.next(h)))});
    }
  }
};

/* How many connected sets of faces each label has. */
std::map<int, std::size_t> numbers_of_regions(const Mesh& mesh,
                                              const Mesh::Property_map<Mesh::Face_index, int>& label) {
  std::map<int, std::size_t> result;
  std::vector<bool> visited(mesh.num_faces(), false);
  for (auto first : mesh.faces()) {
    if (visited[std::size_t(first)])
      continue;
    ++result[label[first]];
    visited[std::size_t(first)] = true;
    std::vector<Mesh::Face_index> region = {first};
    for (std::size_t i = 0; i < region.size(); ++i)
      for (auto g : CGAL::faces_around_face(mesh.halfedge(region[i]), mesh))
        if (g != Mesh::null_face() && label[g] == label[first] && !visited[std::size_t(g)]) {
          visited[std::size_t(g)] = true;
          region.push_back(g);
        }
  }
  return result;
}

// Each vertex in turn, in and out, in different units and directions; `check` gets the damaged mesh, the clean one,
// the labels, and whether the vertex was thrown outward.
template <class Check> void for_each_damage(std::size_t least_degree, const Check& check) {
  int number = 0;
  for (double n : {13., 16., 24.})
    for (double branch : {0.5, 0.8}) {
      const Capped_vessel vessel(n, branch);
      for (auto v : vessel.rim_vertices(least_degree))
        for (double edges : {-2., 1.5, 3.})
          for (bool along_vessel : {false, true}) {
            SCOPED_TRACE(std::to_string(n) + " points round, branch of radius " + std::to_string(branch) + ", vertex " +
                         std::to_string(std::size_t(v)) + " thrown by " + std::to_string(edges) + " edges" +
                         (along_vessel ? " along the vessel" : ""));
            Mesh clean = vessel.mesh, mesh = vessel.mesh;
            throw_out(vessel, mesh, v, edges, along_vessel);
            const double scale = std::array<double, 3>{{1, 1e-3, 1e3}}[std::size_t(number % 3)];
            move(clean, scale, 0.4 * number);
            move(mesh, scale, 0.4 * number);
            ++number;
            check(mesh, clean, vessel.labels, edges > 0);
          }
    }
}

TEST(Damaged_caps, Are_ends_still) {
  for_each_damage(9, [](const Mesh& mesh, const Mesh& clean, const std::vector<int>&, bool is_outward) {
    const Soup soup(mesh);
    Mesh repaired;
    tubular::repair_surface(soup.points, soup.triangles, repaired);
    const auto openings = tubular::find_openings(repaired);
    EXPECT_EQ(openings.size(), 3u);
    if (!is_outward)
      return; // the rim may be notched
    for (const auto& o : tubular::find_openings(clean))
      EXPECT_TRUE(std::any_of(openings.begin(), openings.end(),
                              [&](const auto& p) {
                                return tubular::internal::point_distance(o.center, p.center) < 0.2 * o.radius &&
                                       std::abs(p.radius - o.radius) < 0.15 * o.radius;
                              }))
          << "the opening at " << o.center;
  });
}

TEST(Damaged_caps, Are_the_ends_that_labels_say) {
  for_each_damage(10, [](const Mesh& mesh, const Mesh&, const std::vector<int>& labels, bool) {
    const Soup soup(mesh);
    Mesh repaired;
    tubular::repair_surface(soup.points, soup.triangles, repaired);
    auto label = repaired.add_property_map<Mesh::Face_index, int>("f:label", 0).first;
    tubular::carry_labels(soup.points, soup.triangles, labels, repaired, label);
    EXPECT_EQ(tubular::open_labelled_ends(repaired, label).ends.size(), 3u);
    EXPECT_EQ(tubular::find_openings(repaired).size(), 3u);
  });
}

// All faces are new, and none has a side on a rim.
TEST(Carried_labels, Are_regions_whatever_the_new_faces_are) {
  for (double n : {12., 20.})
    for (double size : {0.25, 0.4, 0.6}) {
      SCOPED_TRACE(std::to_string(n) + " points round, new edges of " + std::to_string(size));
      const Capped_vessel vessel(n, 0.6);
      const Soup soup(vessel.mesh);
      Mesh mesh = vessel.mesh;
      CGAL::Polygon_mesh_processing::isotropic_remeshing(mesh.faces(), size, mesh,
                                                         CGAL::parameters::number_of_iterations(3));
      mesh.collect_garbage();
      auto label = mesh.add_property_map<Mesh::Face_index, int>("f:label", 0).first;
      tubular::carry_labels(soup.points, soup.triangles, vessel.labels, mesh, label);
      EXPECT_EQ(numbers_of_regions(mesh, label), (std::map<int, std::size_t>{{1, 1}, {2, 1}, {3, 1}, {4, 1}}));
    }
}

} // namespace

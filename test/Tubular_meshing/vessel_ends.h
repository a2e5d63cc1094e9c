// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_VESSEL_ENDS_H
#define TUBULAR_MESHING_TEST_VESSEL_ENDS_H

// Generated vessels whose ends are open, capped flat or round, or cut off flush with the wall; the truth is known.

#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/planar_cap.h>
#include <CGAL/Tubular_meshing/Rims/trim_by_plane.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/boost/graph/copy_face_graph.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace vessel_ends {

namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Point_3 Point;
typedef tubular::Vector_3 Vector;
typedef tubular::Surface Mesh;
typedef tubular::Tubular_skeleton Skeleton;
typedef Skeleton::End End;

enum class Kind { open, flat, round };

/* Closed all over, by half balls. */
inline Mesh round_tree(const Skeleton& skeleton, double points_per_circumference) {
  Mesh mesh;
  tubular::generate_tubular_surface(
      skeleton, mesh, tubular::parameters::points_per_circumference(points_per_circumference).round_ends(true));
  return mesh;
}

/* The vertex that is farthest out along a normal, of those within a distance from a point. */
inline Mesh::Vertex_index outermost(const Mesh& mesh, const Point& center, const Vector& normal, double within) {
  Mesh::Vertex_index best = Mesh::null_vertex();
  double highest = 0;
  for (auto v : mesh.vertices()) {
    const Vector d = mesh.point(v) - center;
    if (d.squared_length() < within * within && d * normal > highest) {
      highest = d * normal;
      best = v;
    }
  }
  return best;
}

/* Cuts off what a plane leaves of a vessel's end. */
inline Mesh::Halfedge_index cut_end(Mesh& mesh, const Point& tip, double radius, const Point& origin,
                                    const Vector& normal) {
  const auto seed = outermost(mesh, tip, normal, 1.5 * radius);
  const auto rim = seed == Mesh::null_vertex()
                       ? Mesh::null_halfedge()
                       : tubular::internal::trim_by_plane(mesh, origin, normal, std::vector<Mesh::Vertex_index>{seed});
  if (rim == Mesh::null_halfedge())
    throw std::runtime_error("a generated end cannot be cut");
  return rim;
}

/* Makes an end of a round tree open, or flat; returns the faces of the cap. */
inline std::vector<Mesh::Face_index> finish_end(Mesh& mesh, const End& end, Kind kind) {
  if (kind == Kind::round)
    return {};
  const auto rim = cut_end(mesh, end.center, end.radius, end.center, end.normal);
  if (kind == Kind::open)
    return {};
  std::vector<Mesh::Halfedge_index> loop;
  for (auto h : CGAL::halfedges_around_face(rim, mesh))
    loop.push_back(h);
  const auto shape = tubular::internal::measure_rim(tubular::internal::rim_points(loop, mesh));
  return tubular::internal::fill_loop(loop, shape.plane, mesh);
}

/* A tube along z of radius 1, and a branch that leaves it at an angle from its axis; the branch's end comes last. */
inline Skeleton tube_with_branch(double branch_radius, double angle, double length = 10) {
  Skeleton s;
  const Point middle(0, 0, length / 2);
  const Vector along(std::sin(angle), 0, std::cos(angle));
  s.nodes = {Point(0, 0, 0), middle, Point(0, 0, length), middle + 4. * along};
  const auto line = [](const Point& p, const Point& q) { return [=](double t) { return p + t * (q - p); }; };
  s.add_branch(0, 1, line(s.nodes[0], middle), [](double) { return 1.; });
  s.add_branch(1, 2, line(middle, s.nodes[2]), [](double) { return 1.; });
  s.add_branch(1, 3, line(middle, s.nodes[3]), [=](double) { return branch_radius; });
  return s;
}

} // namespace vessel_ends

#endif // TUBULAR_MESHING_TEST_VESSEL_ENDS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_BALL_AT_WALL_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_BALL_AT_WALL_H

#include <CGAL/Tubular_meshing/Openings/internal/Lumen_tree.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace CGAL::Tubular_meshing::internal {

// Where the wall is to be opened although no vessel ends there, as on a ball.

/* The direction of the wall at a vertex: that of the area around it, within two edges. Zero if it is degenerate. */
inline Vector_3 wall_normal(const Surface& mesh, Surface::Vertex_index v) {
  std::set<Surface::Vertex_index> near = {v};
  for (auto w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
    near.insert(w);
  Vector_3 normal(0, 0, 0);
  for (auto w : near)
    for (auto h : CGAL::halfedges_around_target(mesh.halfedge(w), mesh))
      if (!mesh.is_border(h))
        normal = normal + area_vector(h, mesh);
  const double length = std::sqrt(normal.squared_length());
  return length > 0 ? normal / length : Vector_3(0, 0, 0);
}

/* The radius of the largest ball that touches the wall at a vertex from inside. Other vertices may reach into it by a
 * tenth of it, so that neither noise nor the vertices around stop it. Infinite if there is none. Linear in the size of
 * the surface, which is closed and turned outward. */
inline double radius_of_ball_at(const Surface& mesh, Surface::Vertex_index v, const Vector_3& inward) {
  const double share = 0.8; // of the distance of the centre from the vertex: nothing else is nearer to it
  const double c = 1 - share * share;
  double distance = (std::numeric_limits<double>::infinity)();
  for (auto w : mesh.vertices()) {
    const Vector_3 d = mesh.point(w) - mesh.point(v);
    const double along = d * inward, root2 = along * along - c * d.squared_length();
    if (along > 0 && root2 > 0)
      distance = (std::min)(distance, (along - std::sqrt(root2)) / c);
  }
  return 0.5 * (1 + share) * distance;
}

/* A line from where a plane cuts a cap off that ball whose rim is half as wide as the ball, on into the ball: the end of
 * a vessel as wide as the rim would have it. Empty if there is no ball. */
inline Lumen_tree::Line line_into_ball(const Surface& mesh, Surface::Vertex_index v) {
  Lumen_tree::Line line;
  const Vector_3 inward = -wall_normal(mesh, v);
  const double radius = radius_of_ball_at(mesh, v, inward), rim = 0.5 * radius;
  if (!(inward.squared_length() > 0) || !std::isfinite(radius))
    return line;
  const double depth = radius - std::sqrt(radius * radius - rim * rim);
  for (int k = 0; k <= 8; ++k) {
    line.way.push_back(0.25 * k * rim);
    line.points.push_back(mesh.point(v) + (depth + line.way.back()) * inward);
    line.radii.push_back(rim);
  }
  return line;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_BALL_AT_WALL_H

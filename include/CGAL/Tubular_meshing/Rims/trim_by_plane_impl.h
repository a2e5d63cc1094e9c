// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_TRIM_BY_PLANE_IMPL_H
#define CGAL_TUBULAR_MESHING_RIMS_TRIM_BY_PLANE_IMPL_H

#include <CGAL/Tubular_meshing/Rims/internal/Trim_plan.h>
#include <CGAL/Tubular_meshing/Rims/internal/Trim_planner.h>
#include <CGAL/Tubular_meshing/Rims/trim_by_plane.h>

#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE Halfedge trim_by_plane(Surface& mesh, const Point_3& origin, const Vector_3& normal,
                                                   const std::vector<Vertex>& seeds, double reach) {
  Trim_planner planner(mesh, Oriented_plane(origin, normal / std::sqrt(normal.squared_length())));
  if (seeds.empty() || !planner.plan(seeds, reach))
    return Surface::null_halfedge();
  return Trim_applier(mesh, planner.result()).apply();
}

CGAL_TUBULAR_MESHING_INLINE Halfedge trim_by_plane(Surface& mesh, const Point_3& origin, const Vector_3& normal,
                                                   Halfedge seed, double reach) {
  std::vector<Vertex> seeds;
  if (!mesh.is_border(seed))
    seeds.push_back(mesh.target(seed));
  else
    for (auto h : CGAL::halfedges_around_face(seed, mesh))
      seeds.push_back(mesh.target(h));
  return trim_by_plane(mesh, origin, normal, seeds, reach);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_TRIM_BY_PLANE_IMPL_H

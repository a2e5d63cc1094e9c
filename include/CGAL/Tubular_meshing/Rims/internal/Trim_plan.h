// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_INTERNAL_TRIM_PLAN_H
#define CGAL_TUBULAR_MESHING_RIMS_INTERNAL_TRIM_PLAN_H

#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* What trim_by_plane() does to a mesh, where.
 *
 * A vertex is `above` (it goes: on the positive side and connected to the seed through vertices of that side), `on` (it
 * is moved onto the plane) or below (it stays, whichever side it lies on). An edge between above and below is crossing,
 * and is split. A face is removed when it has an above and no below vertex, split when it has both. */
struct Trim_plan {
  typedef Surface::Vertex_index Vertex;

  Oriented_plane plane;
  std::unordered_map<Vertex, Point_3> on;           ///< with the places that they move to
  std::unordered_set<Vertex> above;                 ///< unless they are on the plane
  std::vector<Surface::Halfedge_index> split_edges; ///< each directed down
  std::vector<Surface::Face_index> split_faces, removed_faces;
  Vertex loop_vertex; ///< of the cut, if no edge is split

  bool is_on(Vertex v) const { return on.count(v) != 0; }
  bool is_above(Vertex v) const { return above.count(v) != 0 && !is_on(v); }
  bool is_below(Vertex v) const { return above.count(v) == 0 && !is_on(v); }

  /* Where the plane crosses, as a fraction of an edge from its end above. */
  double crossing_fraction(const Point_3& from, const Point_3& to) const {
    const double above_height = plane.height(from), below_height = plane.height(to);
    return above_height > below_height ? above_height / (above_height - below_height) : 0.5;
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_INTERNAL_TRIM_PLAN_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_INTERNAL_TRIM_PLAN_H
#define CGAL_TUBULAR_MESHING_RIMS_INTERNAL_TRIM_PLAN_H

#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
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
  Oriented_plane plane;
  std::unordered_map<Vertex, Point_3> on; ///< with the places that they move to
  std::unordered_set<Vertex> above;       ///< unless they are on the plane
  std::vector<Halfedge> split_edges;      ///< each directed down
  std::vector<Face> split_faces, removed_faces;
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

/* Does what a Trim_plan says, on the mesh that it was made for. */
class Trim_applier {
public:
  Trim_applier(Surface& mesh, const Trim_plan& plan)
      : mesh_(mesh)
      , plan_(plan) {}

  /* A halfedge of the border that the cut leaves. */
  Halfedge apply() {
    for (const auto& [v, p] : plan_.on) {
      mesh_.point(v) = p;
      cut_vertices_.insert(v);
    }
    Vertex last_cut_vertex = plan_.loop_vertex;
    for (Halfedge h : plan_.split_edges) {
      const Point_3 p = crossing_point(h); // before the edge is no more
      const Vertex v = mesh_.target(CGAL::Euler::split_edge(h, mesh_));
      mesh_.point(v) = p;
      cut_vertices_.insert(v);
      last_cut_vertex = v;
    }
    std::vector<Face> removed = plan_.removed_faces;
    for (Face f : plan_.split_faces)
      removed.push_back(split_face(f));
    for (Face f : removed)
      CGAL::Euler::remove_face(mesh_.halfedge(f), mesh_);
    for (Halfedge h : CGAL::halfedges_around_target(last_cut_vertex, mesh_))
      if (mesh_.is_border(h))
        return h;
    return Surface::null_halfedge();
  }

private:
  // Crossings at the very end of an edge, left over where snapping was refused, keep a little distance from it.
  Point_3 crossing_point(Halfedge h) const {
    const Point_3 &p = mesh_.point(mesh_.source(h)), &q = mesh_.point(mesh_.target(h));
    const double t = (std::min)((std::max)(plan_.crossing_fraction(p, q), 0.02), 0.98);
    return plan_.plane.projection(p + t * (q - p));
  }

  // Splits the polygon that a split triangle has become along the cut, and returns the part above.
  Face split_face(Face f) {
    std::vector<Halfedge> to_cut;
    for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
      if (cut_vertices_.count(mesh_.target(h)))
        to_cut.push_back(h);
    const Halfedge cut = CGAL::Euler::split_face(to_cut[0], to_cut[1], mesh_);
    const bool left_is_above = plan_.is_above(mesh_.target(mesh_.next(cut)));
    const Halfedge below = left_is_above ? mesh_.opposite(cut) : cut;
    const Face above = mesh_.face(mesh_.opposite(below));
    const Halfedge second = mesh_.next(below), third = mesh_.next(second);
    if (mesh_.next(third) == below)
      return above;
    if (diagonal(below, third) <= diagonal(second, mesh_.next(third)))
      CGAL::Euler::split_face(below, third, mesh_);
    else
      CGAL::Euler::split_face(second, mesh_.next(third), mesh_);
    return above;
  }

  double diagonal(Halfedge a, Halfedge b) const {
    return CGAL::squared_distance(mesh_.point(mesh_.target(a)), mesh_.point(mesh_.target(b)));
  }

  Surface& mesh_;
  const Trim_plan& plan_;
  std::unordered_set<Vertex> cut_vertices_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_INTERNAL_TRIM_PLAN_H

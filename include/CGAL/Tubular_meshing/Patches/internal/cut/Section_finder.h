// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_SECTION_FINDER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_SECTION_FINDER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/graph_segments.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Cut_surface.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Plane_section.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/shape_searches.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Finds the disks across a tube: of all curves in which a plane meets the surface, the one around a point of the
 * centerlines. It is walked triangle by triangle from a first one that a ray hits, so that it costs what the curve
 * costs, not what the surface does.
 *
 * A section is accepted if it runs over the wall alone, meets no curve cut before, goes once round the point, and the
 * centerlines go through the disk in this one point: then it separates the part of the branch before the point from
 * the part behind it, and nothing else. */
class Section_finder {
public:
  Section_finder(const Cut_surface& surface, const Centerline_graph& graph)
      : surface_(surface)
      , first_hit_(triangles(surface))
      , centerlines_(Graph_segments(graph).segments) {}

  /* The section around the plane's origin, no point of it further than `reach`. False if there is none to accept. */
  bool find(const Section_plane& plane, double reach, Plane_section& section) const {
    const int directions = 5; // where the lumen's section has holes, a ray may meet the rim of one
    for (int i = 0; i < directions; ++i) {
      const Face start = face_in_direction(plane, 2 * CGAL_PI * i / directions);
      if (start != Surface::null_face() && surface_.is_wall(start) && walk(start, plane, reach, section) &&
          section.winding_number({0, 0}) == -1)
        return centerlines_through(plane, section) == 1;
    }
    return false;
  }

private:
  static std::vector<First_hit::Triangle> triangles(const Cut_surface& surface) {
    const Surface& mesh = surface.mesh();
    std::vector<First_hit::Triangle> triangles;
    triangles.reserve(mesh.number_of_faces());
    for (Face f : mesh.faces()) {
      const Halfedge h = mesh.halfedge(f);
      triangles.emplace_back(to_double_point(mesh.point(mesh.source(h))), to_double_point(mesh.point(mesh.target(h))),
                             to_double_point(mesh.point(mesh.target(mesh.next(h)))));
    }
    return triangles;
  }

  bool is_above(Vertex v, const Section_plane& plane) const { return plane.height(surface_.point(v)) >= 0; }

  // A face that the plane crosses, as seen from its origin.
  Face face_in_direction(const Section_plane& plane, double angle) const {
    const First_hit::Ray ray{plane.origin(), plane.direction(angle)};
    const First_hit::Hit hit = first_hit_(ray);
    if (hit.triangle == First_hit::none)
      return Surface::null_face();
    const Vector_3d p = ray.origin + hit.distance * ray.direction;
    Face best = Surface::null_face();
    double best_depth = -(std::numeric_limits<double>::infinity)();
    for (Face f : surface_.parts(hit.triangle))
      if (exit_of(f, plane) != Surface::null_halfedge() && depth(p, f) > best_depth) {
        best = f;
        best_depth = depth(p, f);
      }
    return best;
  }

  // The least barycentric coordinate of a point in a face.
  double depth(const Vector_3d& p, Face f) const {
    const auto [a, b, c] = surface_.corners(f);
    const Vector_3d n = cross(b - a, c - a);
    return (std::min)({dot(cross(b - a, p - a), n), dot(cross(c - b, p - b), n), dot(cross(a - c, p - c), n)}) /
           squared_norm(n);
  }

  // The halfedge of the face that goes from above the plane to below.
  Halfedge exit_of(Face f, const Section_plane& plane) const {
    const Surface& mesh = surface_.mesh();
    Halfedge h = mesh.halfedge(f);
    for (int i = 0; i < 3; ++i, h = mesh.next(h))
      if (is_above(mesh.source(h), plane) && !is_above(mesh.target(h), plane))
        return h;
    return Surface::null_halfedge();
  }

  // With what is below the plane on the left.
  bool walk(Face start, const Section_plane& plane, double reach, Plane_section& section) const {
    const Surface& mesh = surface_.mesh();
    section.clear();
    const Halfedge first = exit_of(start, plane);
    Halfedge h = first;
    Vector_3d above = surface_.point(mesh.source(h)), below = surface_.point(mesh.target(h));
    do {
      if (surface_.is_on_curve(h))
        return false;
      const double p = plane.height(above), q = plane.height(below), t = p / (p - q);
      const Vector_3d x = above + t * (below - above);
      if (squared_norm(x - plane.origin()) > reach * reach)
        return false;
      section.add(Plane_section::Crossing{h, t, p, q}, x, plane);
      h = mesh.opposite(h);
      const Vector_3d third = surface_.point(mesh.target(mesh.next(h)));
      if (plane.height(third) >= 0) {
        above = third;
        h = mesh.prev(h);
      } else {
        below = third;
        h = mesh.next(h);
      }
    } while (h != first);
    section.close();
    return true;
  }

  // How often the centerlines go through the disk.
  int centerlines_through(const Section_plane& plane, const Plane_section& section) const {
    int count = 0;
    centerlines_.for_each(section.bbox(), [&](const Segments_in_box::Segment& s) {
      const Vector_3d a(s.source()), b(s.target());
      const double p = plane.height(a), q = plane.height(b);
      if ((p >= 0) != (q >= 0) && section.winding_number(plane.coordinates(a + p / (p - q) * (b - a))) != 0)
        ++count;
    });
    return count;
  }

  const Cut_surface& surface_;
  First_hit first_hit_;
  Segments_in_box centerlines_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_SECTION_FINDER_H

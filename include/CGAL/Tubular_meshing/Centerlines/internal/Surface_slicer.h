// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SURFACE_SLICER_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SURFACE_SLICER_H

#include <CGAL/Tubular_meshing/base/Box_tree.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Cuts a closed surface of triangles by planes. Points in a plane count as above it, so that a triangle is cut in two of
 * its edges or not at all, and a cut goes on until it is closed. */
class Surface_slicer {
public:
  typedef std::vector<Vector_3d> Loop;

  explicit Surface_slicer(const Surface& surface)
      : surface_(surface) {
    typedef Box_tree<3>::Box Box;
    std::vector<Box> boxes;
    std::vector<Box_tree<3>::Place> centers;
    for (Face f : surface.faces()) {
      faces_.push_back(f);
      boxes.emplace_back();
      for (Vertex v : surface.vertices_around_face(surface.halfedge(f))) {
        const Vector_3d p = point(v);
        boxes.back().add({p.x, p.y, p.z});
      }
      const Box& b = boxes.back();
      centers.push_back({b.low[0] + b.high[0], b.low[1] + b.high[1], b.low[2] + b.high[2]});
    }
    tree_ = Box_tree<3>(std::move(boxes), centers);
  }

  // The loop that the plane cuts out of the surface where it is first met from `center`, in the direction `along` of the
  // plane; empty if there is none, or it comes to a border.
  Loop loop(const Vector_3d& center, const Vector_3d& normal, const Vector_3d& along) const {
    const Plane plane = {center, normal, along, cross(normal, along)};
    const Halfedge start = first_cut(plane);
    return start == Surface::null_halfedge() ? Loop() : follow(plane, start);
  }

private:
  struct Plane {
    Vector_3d center, normal, u, v;
    bool is_below(const Vector_3d& p) const { return dot(p - center, normal) < 0; }
    // Between points on different sides.
    Vector_3d cut(const Vector_3d& p, const Vector_3d& q) const {
      const double a = dot(p - center, normal), b = dot(q - center, normal);
      return p + (a / (a - b)) * (q - p);
    }
  };

  Vector_3d point(Vertex v) const { return Vector_3d(surface_.point(v)); }
  bool is_cut(const Plane& plane, Halfedge h) const {
    return plane.is_below(point(surface_.source(h))) != plane.is_below(point(surface_.target(h)));
  }
  Vector_3d cut(const Plane& plane, Halfedge h) const {
    // from below, whichever way the edge is walked: both of its triangles get the same point
    const Vector_3d p = point(surface_.source(h)), q = point(surface_.target(h));
    return plane.is_below(p) ? plane.cut(p, q) : plane.cut(q, p);
  }

  // The edges in which the triangle of a halfedge is cut: two or none.
  std::size_t cuts_of(const Plane& plane, Halfedge h, std::array<Halfedge, 3>& cuts) const {
    std::size_t n = 0;
    for (int i = 0; i < 3; ++i, h = surface_.next(h))
      if (is_cut(plane, h))
        cuts[n++] = h;
    return n;
  }

  // An edge of the triangle that the ray from the center meets first.
  Halfedge first_cut(const Plane& plane) const {
    Halfedge first = Surface::null_halfedge();
    double bound = (std::numeric_limits<double>::infinity)();
    tree_.visit_near({plane.center.x, plane.center.y, plane.center.z}, bound, [&](Box_tree<3>::Index i) {
      std::array<Halfedge, 3> cuts;
      if (cuts_of(plane, surface_.halfedge(faces_[i]), cuts) != 2)
        return;
      const Vector_3d p = cut(plane, cuts[0]) - plane.center, q = cut(plane, cuts[1]) - plane.center;
      const double a = dot(p, plane.v), b = dot(q, plane.v);
      if ((a < 0) == (b < 0))
        return;
      const double x = dot(p, plane.u) + a / (a - b) * (dot(q, plane.u) - dot(p, plane.u));
      if (x > 0 && x * x < bound) {
        bound = x * x;
        first = cuts[0];
      }
    });
    return first;
  }

  Loop follow(const Plane& plane, Halfedge start) const {
    Loop loop;
    Halfedge h = start;
    do {
      loop.push_back(cut(plane, h));
      std::array<Halfedge, 3> cuts;
      if (cuts_of(plane, h, cuts) != 2 || loop.size() > surface_.number_of_faces())
        return Loop();
      h = surface_.opposite(cuts[0] == h ? cuts[1] : cuts[0]);
      if (surface_.is_border(h))
        return Loop();
    } while (h != start);
    return loop;
  }

  const Surface& surface_;
  std::vector<Face> faces_;
  Box_tree<3> tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SURFACE_SLICER_H

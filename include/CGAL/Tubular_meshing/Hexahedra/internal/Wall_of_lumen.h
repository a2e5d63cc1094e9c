// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_WALL_OF_LUMEN_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_WALL_OF_LUMEN_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The wall of a closed surface, as its inside sees it: the nearest point, and the first one along a ray. */
class Wall_of_lumen {
public:
  Wall_of_lumen(const Surface& surface, Face_patch_map patch)
      : tree_(triangles_of(surface, patch)) {}

  Vector_3d nearest(const Vector_3d& p) const { return Vector_3d(tree_.nearest(to_double_point(p)).point); }
  double distance(const Vector_3d& p) const { return std::sqrt(tree_.nearest(to_double_point(p)).squared_distance); }

  /* How far the wall is from p along the unit vector d, where it is nearer than the bound; else the bound. O(log n). */
  double along(const Vector_3d& p, const Vector_3d& d, double bound) const {
    First_hit hit{p, {1 / d.x, 1 / d.y, 1 / d.z}, d, bound};
    tree_.visit(0, hit);
    return hit.bound;
  }

private:
  typedef Double_kernel::Triangle_3 Triangle;

  static std::vector<Triangle> triangles_of(const Surface& surface, Face_patch_map patch) {
    std::vector<Triangle> result;
    for (Face f : surface.faces())
      if (patch[f] == labels::wall) {
        const Halfedge h = surface.halfedge(f);
        const Triangle t(to_double_point(surface.point(surface.source(h))),
                         to_double_point(surface.point(surface.target(h))),
                         to_double_point(surface.point(surface.target(surface.next(h)))));
        if (CGAL::cross_product(t[1] - t[0], t[2] - t[0]).squared_length() > 0)
          result.push_back(t);
      }
    return result;
  }

  // The traversal traits of a ray that ends at its first hit.
  struct First_hit {
    Vector_3d origin, inverse, direction;
    double bound;

    bool go_further() const { return true; }
    template <class Node> bool do_intersect(int, const Node& node) const {
      const CGAL::Bbox_3& b = node.bbox();
      double near = 0, far = bound;
      for (int i = 0; i < 3; ++i) {
        const double s = ((b.min)(i)-origin[i]) * inverse[i], t = ((b.max)(i)-origin[i]) * inverse[i];
        near = (std::max)(near, (std::min)(s, t));
        far = (std::min)(far, (std::max)(s, t));
      }
      return near <= far;
    }
    template <class Primitive> void intersection(int, const Primitive& primitive) {
      const Triangle& t = primitive.datum();
      const Vector_3d a(t[0]), u = Vector_3d(t[1]) - a, v = Vector_3d(t[2]) - a;
      const Vector_3d n = cross(direction, v);
      const double det = dot(u, n);
      if (det == 0)
        return;
      const Vector_3d w = origin - a, m = cross(w, u);
      const double x = dot(w, n) / det, y = dot(direction, m) / det;
      if (x < -1e-9 || y < -1e-9 || x + y > 1 + 1e-9)
        return;
      const double s = dot(v, m) / det;
      if (s > 0 && s < bound)
        bound = s;
    }
  };

  Nearest_tree<Triangle> tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_WALL_OF_LUMEN_H

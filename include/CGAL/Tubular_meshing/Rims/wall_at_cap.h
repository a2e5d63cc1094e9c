// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_WALL_AT_CAP_H
#define CGAL_TUBULAR_MESHING_RIMS_WALL_AT_CAP_H

#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* By face, of length one; zero for a degenerate face. */
inline std::vector<Vector_3> unit_normals(const Surface& mesh) {
  std::vector<Vector_3> normals(mesh.num_faces(), Vector_3(0, 0, 0));
  for_each_range(normals.size(), 0, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Face f = Face(Surface::size_type(i));
      if (mesh.is_removed(f))
        continue;
      const Vector_3 n = area_vector(mesh.halfedge(f), mesh);
      const double length = std::sqrt(n.squared_length());
      if (length > 0)
        normals[i] = n / length;
    }
  });
  return normals;
}

/* How the wall goes on behind the rim of a cap. */
struct Wall_at_cap {
  double length = 0;       ///< of the rim
  double inner_length = 0; ///< of that part of it from which the wall goes back into the lumen's side of its plane
  double cosine = 0;       ///< of the angle between the wall's normals and the plane's, times the length

  /* All around, and as upright on the plane as a bound on the mean cosine says. */
  bool stands(double max_cosine) const {
    return inner_length >= 0.9 * length && std::abs(cosine) <= max_cosine * length;
  }
};

/* `inwards`: 1 if the faces' normals point into the lumen, else -1. */
inline Wall_at_cap wall_at_cap(const Opening_site& end, const std::vector<Vector_3>& normals, double inwards,
                               const Surface& mesh) {
  const Rim_plane& plane = end.shape.plane;
  Wall_at_cap wall;
  for (Halfedge h : end.rim) {
    const Halfedge o = mesh.opposite(h);
    const Point_3 &a = mesh.point(mesh.source(o)), &b = mesh.point(mesh.target(o)),
                  &c = mesh.point(mesh.target(mesh.next(o)));
    const double length = point_distance(a, b);
    wall.length += length;
    wall.cosine += length * (normals[std::size_t(mesh.face(o))] * plane.normal());
    if (inwards * (plane.height(c) - (plane.height(a) + plane.height(b)) / 2) > 0)
      wall.inner_length += length;
  }
  return wall;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_WALL_AT_CAP_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_WALL_ALIGNMENT_H
#define CGAL_TUBULAR_MESHING_RIMS_WALL_ALIGNMENT_H

#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <cmath>

namespace CGAL::Tubular_meshing::internal {

/* How much a border loop lies in the wall: the mean over its edges, by length, of the cosine between the normals of the
 * loop and of the faces behind it. Near 0 at the end of a tube, however oblique, since the wall stands upright on its
 * rim and what leans out on one side leans in on the other; near 1 round a hole of the wall, since the loop continues
 * the faces. Does not depend on the orientation of the mesh. On real vessels and airways the rims of openings stay
 * below 0.22, holes of the wall above 0.8; a branch that is cut off flush with the wall is between. */
inline double alignment_with_wall(const Opening_site& loop, const Surface& mesh) {
  double sum = 0, perimeter = 0;
  for (auto h : loop.rim) {
    const Vector_3 n = area_vector(mesh.opposite(h), mesh);
    const double area = std::sqrt(n.squared_length());
    if (!(area > 0))
      continue;
    const double length = point_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    sum += length * (n * loop.shape.plane.normal()) / area;
    perimeter += length;
  }
  return perimeter > 0 ? sum / perimeter : 1;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_WALL_ALIGNMENT_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_CHECK_BIJECTION_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_CHECK_BIJECTION_H

#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Filled_patch.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::vector<Eigen::Vector2d> Plane_points;

inline CGAL::Exact_predicates_inexact_constructions_kernel::Point_2 exact_point(const Eigen::Vector2d& p) {
  return {p.x(), p.y()};
}

/* Whether a triangle is counterclockwise in the plane, decided exactly. */
inline bool is_upright(const Patch_triangle& t, const Plane_points& uv) {
  const Eigen::Vector2d &a = uv[std::size_t(t[0])], &b = uv[std::size_t(t[1])], &c = uv[std::size_t(t[2])];
  if (!a.allFinite() || !b.allFinite() || !c.allFinite())
    return false;
  return CGAL::orientation(exact_point(a), exact_point(b), exact_point(c)) == CGAL::LEFT_TURN;
}

/* Of the patch's own triangles, those that are not counterclockwise. */
inline std::vector<int> flipped_triangles(const Filled_patch& patch, const Plane_points& uv) {
  std::vector<int> flipped;
  for (std::size_t t = 0; t < patch.own_triangles; ++t)
    if (!is_upright(patch.triangles[t], uv))
      flipped.push_back(int(t));
  return flipped;
}

/* Whether each loop is a polygon that does not meet itself, the outer one counterclockwise, the others clockwise. */
inline bool are_loops_simple(const Filled_patch& patch, const Plane_points& uv) {
  for (std::size_t l = 0; l < patch.loops.size(); ++l) {
    std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_2> polygon;
    for (int v : patch.loops[l])
      polygon.push_back(exact_point(uv[std::size_t(v)]));
    if (!CGAL::is_simple_2(polygon.begin(), polygon.end()) ||
        CGAL::orientation_2(polygon.begin(), polygon.end()) !=
            (l == patch.outer ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE))
      return false;
  }
  return true;
}

/* Whether a map is one to one: no triangle is flipped, and all loops are simple. For as many triangles cover a point as
 * the loops together wind around it: the outer one at most once, each of the others, which run clockwise, at most once
 * less. So at most one does; and as their number is not negative, loops do not cross each other either. */
inline bool is_bijective(const Filled_patch& patch, const Plane_points& uv) {
  return flipped_triangles(patch, uv).empty() && are_loops_simple(patch, uv);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_CHECK_BIJECTION_H

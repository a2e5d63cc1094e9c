// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_POLYGONS_IMPL_H
#define CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_POLYGONS_IMPL_H

#include <CGAL/Tubular_meshing/Plane/triangulate_polygons.h>
#include <CGAL/Tubular_meshing/Plane/internal/Polygon_triangulator.h>
#include <CGAL/Tubular_meshing/base/config.h>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

CGAL_TUBULAR_MESHING_INLINE std::optional<Plane_store> triangulate_polygons(const Plane_polygons& polygons,
                                                                            std::string& problem) {
  Polygon_triangulator triangulator(polygons);
  problem = triangulator.problem();
  if (!problem.empty())
    return std::nullopt;
  return triangulator.store();
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_POLYGONS_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_PLANE_TRIANGULATION_H
#define CGAL_TUBULAR_MESHING_PLANE_PLANE_TRIANGULATION_H

#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPlane
 *
 * A triangulated domain of the plane. The first points are those of the polygons that bound it, in their order, each
 * point as it was given; those inside follow. Triangles are counterclockwise. */
template <class Point_2> struct Plane_triangulation {
  std::vector<Point_2> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

namespace internal {

typedef Kernel::Point_2 Plane_point;
typedef std::vector<std::vector<Plane_point>> Plane_polygons; // the outer one first
typedef Function_view<Metric_tensor_2(const Plane_point&)> Plane_field;
typedef Function_view<Vector_3d(const Plane_point&)> Plane_embedding;

} // namespace internal
} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PLANE_PLANE_TRIANGULATION_H

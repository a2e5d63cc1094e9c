// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPERATORS_EXTRUDE_WALL_H
#define CGAL_TUBULAR_MESHING_OPERATORS_EXTRUDE_WALL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Operators/Layer_report.h>
#include <CGAL/Tubular_meshing/Operators/internal/layers/Wall_extruder.h>
#include <CGAL/Tubular_meshing/exceptions.h>
#include <CGAL/Tubular_meshing/labels.h>
#include <CGAL/Tubular_meshing/parameters.h>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 */
template <class Point, class LocalRadius, class NamedParameters = CGAL::parameters::Default_named_parameters>
Layer_report<Point> extrude_wall(Mixed_mesh<Point>& mesh, const LocalRadius& radius,
                                 const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Wall_parameters parameters(np);
  return internal::Wall_extruder<Point>(mesh, parameters).run(radius);
}

template <class Point, class NamedParameters = CGAL::parameters::Default_named_parameters>
Layer_report<Point> extrude_wall(Mixed_mesh<Point>& mesh, const Centerline_field<Point>& centerlines,
                                 const NamedParameters& np = CGAL::parameters::default_values()) {
  return extrude_wall(
      mesh, [&](const Point& p) { return centerlines.radius(p); }, np);
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_OPERATORS_EXTRUDE_WALL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_WALL_IMPL_H
#define CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_WALL_IMPL_H

#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Layers/internal/Wall_extruder.h>
#include <CGAL/Tubular_meshing/Layers/internal/labelled_facets.h>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE Layer_report extrude_wall(Mixed_mesh& mesh, Length_function radius,
                                                      const Extrude_wall_options& options) {
  return Wall_extruder(mesh, options).run(radius);
}

CGAL_TUBULAR_MESHING_INLINE Extruded_wall extrude_wall(const Surface& surface, Face_patch_map patch,
                                                       Length_function radius, const Extrude_wall_options& options) {
  Extruded_wall wall;
  wall.mesh = labelled_facets(surface, patch);
  wall.report = internal::extrude_wall(wall.mesh, radius, options);
  remove_openings(wall.mesh);
  return wall;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_WALL_IMPL_H

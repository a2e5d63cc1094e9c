// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_UNFOLD_WALL_H
#define CGAL_TUBULAR_MESHING_LAYERS_UNFOLD_WALL_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>

namespace CGAL::Tubular_meshing::internal {

struct Unfolded_wall {
  std::size_t vertices = 0; ///< that were moved
  double distance = 0;      ///< of the one that went furthest
  Point_3 place{0, 0, 0};   ///< where that one was
};

/* Makes room for layers at vertices of a wall whose faces hardly any direction leads away from, as coarse triangles have
 * them in folds of a surface: these vertices go towards the middle of their neighbours, and if that does not do, their
 * neighbours too. Those of rims stay. Where a fold remains, or layers fail for another reason, such as faces that cross,
 * extrude_boundary_layer() says so. Linear. */
Unfolded_wall unfold_wall(Surface& surface, Face_patch_map patch);

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Layers/unfold_wall_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_LAYERS_UNFOLD_WALL_H

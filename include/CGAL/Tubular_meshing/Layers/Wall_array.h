// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_WALL_ARRAY_H
#define CGAL_TUBULAR_MESHING_LAYERS_WALL_ARRAY_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingLayers
 * What an array has a value for. */
enum class Array_of { points, triangles };

/*! \ingroup PkgTubularMeshingLayers
 *
 * Values on a surface, as its file has them: of points, or of triangles. The surface that is meshed may be another one,
 * repaired and meshed again: values are those of the nearest point of the triangles here. */
struct Wall_array {
  std::string name; ///< for sentences
  Array_of of = Array_of::points;
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<double> values; ///< one a point, or one a triangle
};

/*! \ingroup PkgTubularMeshingLayers
 *
 * Leaves the triangles on the wall: those whose middle is nearer to a face of patch labels::wall than to any other. What
 * an array says on the caps of a closed surface has no part in a wall.
 *
 * \param array its triangles, and values of triangles, are reduced
 * \param surfaces all that are meshed
 *
 * O(n log n).
 */
void keep_wall(Wall_array& array, const std::vector<const Labelled_surface*>& surfaces);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Layers/Wall_array_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_LAYERS_WALL_ARRAY_H

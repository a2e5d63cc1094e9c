// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_WALL_MATERIALS_H
#define CGAL_TUBULAR_MESHING_LAYERS_WALL_MATERIALS_H

#include <CGAL/Tubular_meshing/Layers/Wall_array.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <functional>
#include <string>

namespace CGAL::Tubular_meshing {

namespace labels {

constexpr int first_material = wall_region + 2; ///< the region of the first material in the wall

/*! The patch of the facets between the wall and its materials, and between these, where the wall's outer patch is
 * `outer`. */
constexpr int material_interface(int outer) {
  return 2 * outer;
}

} // namespace labels

/*! \ingroup PkgTubularMeshingLayers
 *
 * What parts of a wall are made of: areas of the lumen's surface, as plaque, a stent or a graft, over which the cells of
 * the wall are a region of their own. A second wall is one region all the same. */
struct Wall_materials {
  /// The region of the wall over a point of the surface: labels::wall_region, or labels::first_material and on.
  std::function<int(const Point_3&)> region;
  Label_names names; ///< of the regions of materials

  bool empty() const { return !region; }
};

/*! \ingroup PkgTubularMeshingLayers
 *
 * The materials that an array of integers says: a region for each of its values, in ascending order, but for the wall's
 * own, which is 0, or one that is called *wall*. Of values at points, that of the corner which is nearest in a triangle
 * counts.
 *
 * \param array values on the wall
 * \param names from value to name, as far as they are known; another region has the array's name with the value,
 *   `plaque_2`
 *
 * \throws Input_error if there are no triangles, or a value is no integer
 */
Wall_materials materials_of_array(const Wall_array& array, const Label_names& names = Label_names());

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Layers/Wall_materials_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_LAYERS_WALL_MATERIALS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_SPLIT_INTO_PARTS_H
#define CGAL_TUBULAR_MESHING_REPAIR_SPLIT_INTO_PARTS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

std::vector<Surface> split_into_parts(const Surface& surface);

} // namespace internal

/*! \ingroup PkgTubularMeshingRepair
 *
 * Splits a surface into its connected components, the one of the largest area first: several vessels in one file, each
 * of which make_tubular_model() takes. What repair_surface() leaves with `number_of_parts(0)` has vessels only.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `MutableFaceGraph`
 * \param surface a triangle mesh
 * \param np an optional sequence of named parameters: `vertex_point_map`, the points of the vertices of `surface`
 * \return the components; a surface in one piece is the only one, unchanged
 *
 * Complexity: O(n) in the number of faces.
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<TriangleMesh> split_into_parts(const TriangleMesh& surface,
                                           const NamedParameters& np = CGAL::parameters::default_values()) {
  if constexpr (internal::is_core_surface<TriangleMesh, NamedParameters>)
    return internal::split_into_parts(surface);
  else {
    Surface core;
    internal::copy_to_core(surface, core, np);
    std::vector<TriangleMesh> parts;
    for (const Surface& part : internal::split_into_parts(core)) {
      parts.emplace_back();
      internal::copy_from_core(part, parts.back(), CGAL::parameters::default_values());
    }
    return parts;
  }
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Repair/split_into_parts_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_REPAIR_SPLIT_INTO_PARTS_H

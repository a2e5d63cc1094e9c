// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_SURFACE_TO_MIXED_MESH_H
#define CGAL_TUBULAR_MESHING_PATCHES_SURFACE_TO_MIXED_MESH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>

namespace CGAL::Tubular_meshing {

namespace internal {
void surface_to_mixed_mesh(const Surface& surface, Face_patch_map patch, Mixed_mesh& mesh);
}

/*! \ingroup PkgTubularMeshingPatches
 *
 * A closed labelled surface as a mesh without cells: its points, triangles and quads, in the surface's own order.
 * Linear.
 *
 * \param surface closed, of triangles and quads, a model of `FaceListGraph`
 * \param patch a readable property map from its faces to `int`: their labels
 * \param mesh is replaced
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a readable property map from vertices to points}
 *     \cgalParamDefault{that of the surface}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Meshing_error if the surface is empty, not closed, or has faces of more than four edges
 */
template <class FaceGraph, class FacePatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
void surface_to_mixed_mesh(const FaceGraph& surface, FacePatchMap patch, Mixed_mesh& mesh,
                           const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(surface, patch, np);
  internal::surface_to_mixed_mesh(core.surface(), core.patch(), mesh);
}

/*! \ingroup PkgTubularMeshingPatches
 *
 * The same, with the point array `metric` (xx, xy, xz, yy, yz, zz) of a surface that was made by a metric.
 *
 * \throws Meshing_error as above
 */
void surface_to_mixed_mesh(const Remeshed_surface& remeshed, Mixed_mesh& mesh);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_SURFACE_TO_MIXED_MESH_H

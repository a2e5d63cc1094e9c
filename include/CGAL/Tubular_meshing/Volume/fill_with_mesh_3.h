// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_MESH_3_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_MESH_3_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingVolume
 * The named parameters of fill_with_mesh_3(), as a struct. */
struct Fill_with_mesh_3_options {
  double facet_distance = 0.07;

  Fill_with_mesh_3_options() = default;
  template <class NamedParameters> explicit Fill_with_mesh_3_options(const NamedParameters& np) {
    facet_distance = internal::choose(np, internal_np::facet_distance, facet_distance);
  }
};

namespace internal {

void fill_with_mesh_3(const Surface& surface, Face_patch_map patch, Length_function size, Mixed_mesh& mesh,
                      const Fill_with_mesh_3_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingVolume
 *
 * fills a closed labelled surface with tetrahedra by CGAL's Mesh_3: the surface is remeshed, its rims are protected as
 * features, its labels are kept. Refinement only; what makes the mesh good is optimize_tetrahedra().
 *
 * \tparam FaceGraph a model of `FaceListGraph`
 * \tparam FacePatchMap a readable property map from its faces to `int`
 *
 * \param surface a closed triangle mesh without self-intersections, its faces turned outward
 * \param patch labels::wall, and one label a cap. Caps do not touch each other.
 * \param size a model of `MeshDomainField_3`, or a function object of a point: the wanted length of edges. Must outlive
 *   the call only. What it throws comes through.
 * \param mesh is replaced: tetrahedra of region labels::lumen, and all boundary triangles
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{facet_distance}
 *     \cgalParamDescription{how far the middle of a surface triangle may be from the surface, relative to the local
 *       mesh size}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{0.07, a third more than a triangle of edge h has on a tube of 20 h circumference}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if the surface has faces other than triangles
 * \throws Meshing_error if Mesh_3 fails, or comes to no end: it is stopped when it has made many times the points that
 *   the sizes ask for, as on surfaces that cross themselves, or have edges sharper than 25 degrees inside of a patch.
 *   `mesh` is empty then.
 *
 * One thread, so that the same input gives the same mesh: Mesh_3 on several is reproducible in no version of CGAL, and
 * waits without end where one of its threads throws.
 */
template <class FaceGraph, class FacePatchMap, class SizingField,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void fill_with_mesh_3(const FaceGraph& surface, FacePatchMap patch, const SizingField& size, Mixed_mesh& mesh,
                      const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(surface, patch, np);
  internal::fill_with_mesh_3(core.surface(), core.patch(), internal::Field_at_point<SizingField>(size), mesh,
                             Fill_with_mesh_3_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Volume/fill_with_mesh_3_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_MESH_3_H

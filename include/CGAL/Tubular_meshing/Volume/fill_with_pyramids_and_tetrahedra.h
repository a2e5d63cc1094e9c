// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_PYRAMIDS_AND_TETRAHEDRA_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_PYRAMIDS_AND_TETRAHEDRA_H

#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingVolume
 * The named parameters of fill_with_pyramids_and_tetrahedra(), as a struct: those of fill_keeping_boundary(), and more.
 */
struct Fill_with_pyramids_and_tetrahedra_options : Fill_keeping_boundary_options {
  bool split_quads = false;
  int optimization_passes = 2;

  Fill_with_pyramids_and_tetrahedra_options() = default;
  template <class NamedParameters>
  explicit Fill_with_pyramids_and_tetrahedra_options(const NamedParameters& np)
      : Fill_keeping_boundary_options(np) {
    split_quads = internal::choose(np, internal_np::split_quads, split_quads);
    optimization_passes = internal::choose(np, internal_np::optimization_passes, optimization_passes);
  }
};

namespace internal {

// Throws where the tetrahedra between pyramids cannot be made by this mesher.
void check_keeps_boundary(Volume_mesher mesher);

void fill_with_pyramids_and_tetrahedra(const Surface& surface, Face_patch_map patch, Length_function size,
                                       Mixed_mesh& mesh, const Fill_with_pyramids_and_tetrahedra_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingVolume
 *
 * fills a closed labelled surface of triangles and quads, and keeps it as it is, facet for facet: a pyramid stands on
 * the inside of each quad (\cgalCite{owen1997}), and tetrahedra fill what is left (section 2.5 of the paper). A mesh of
 * the wall, of hexahedra on the same quads, conforms with it.
 *
 * Pyramids are about as high as makes their sides equilateral, and lower where the surface folds inward or where it is
 * near to itself, so that they meet nowhere. What they leave is filled as by fill_keeping_boundary(), and optimized as
 * by optimize_tetrahedra(), together with the pyramids' apexes.
 *
 * \tparam FaceGraph a model of `FaceListGraph`
 * \tparam FacePatchMap a readable property map from its faces to `int`
 *
 * \param surface a closed mesh of triangles and quads without self-intersections, its faces turned outward
 * \param patch the labels of its faces
 * \param size a model of `MeshDomainField_3`, or a function object of a point: the wanted length of edges; near the
 *   surface they are no longer than its own, if these are shorter. Must outlive the call only.
 * \param mesh is replaced: pyramids and tetrahedra of region labels::lumen, and the surface's faces. Its first points
 *   are the surface's, followed by the pyramids' apexes; its triangles and quads are the surface's faces, in their
 *   order and bit for bit; pyramid i stands on quad i.
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{volume_mesher}
 *     \cgalParamDescription{what makes the tetrahedra: `Volume_mesher::tetgen` or `Volume_mesher::ccdt`}
 *     \cgalParamType{`Volume_mesher`}
 *     \cgalParamDefault{default_volume_mesher()}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{split_quads}
 *     \cgalParamDescription{whether quads on which no pyramid fits become two triangles each, which follow the
 * surface's own in the mesh. No mesh of the wall conforms with these} \cgalParamType{`bool`} \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{optimization_passes}
 *     \cgalParamDescription{see optimize_tetrahedra()}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{2}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0 takes all cores; the result does not depend on it}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{in_child_process}
 *     \cgalParamDescription{see fill_keeping_boundary()}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{time_limit}
 *     \cgalParamDescription{see fill_keeping_boundary()}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{see fill_keeping_boundary()}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * About linear in the number of cells.
 *
 * No pyramid fits on a quad that has a corner of about 180 degrees or more, in the plane or by being bent, as one with
 * two edges on the rim of a cap; nor where the surface meets itself.
 *
 * \throws Meshing_error if the surface is not closed, if no pyramid fits on a quad, or if the mesher of the tetrahedra
 *   fails or is not there
 */
template <class FaceGraph, class FacePatchMap, class SizingField,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void fill_with_pyramids_and_tetrahedra(const FaceGraph& surface, FacePatchMap patch, const SizingField& size,
                                       Mixed_mesh& mesh,
                                       const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(surface, patch, np);
  internal::fill_with_pyramids_and_tetrahedra(core.surface(), core.patch(), internal::Field_at_point<SizingField>(size),
                                              mesh, Fill_with_pyramids_and_tetrahedra_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Volume/fill_with_pyramids_and_tetrahedra_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_PYRAMIDS_AND_TETRAHEDRA_H

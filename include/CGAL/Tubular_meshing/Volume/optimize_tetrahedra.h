// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_H
#define CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingVolume
 * The named parameters of optimize_tetrahedra(), as a struct. */
struct Optimize_tetrahedra_options {
  int optimization_passes = 2;
  bool keep_boundary = false;
  int number_of_threads = 0;

  Optimize_tetrahedra_options() = default;
  template <class NamedParameters> explicit Optimize_tetrahedra_options(const NamedParameters& np) {
    optimization_passes = internal::choose(np, internal_np::optimization_passes, optimization_passes);
    keep_boundary = internal::choose(np, internal_np::keep_boundary, keep_boundary);
    number_of_threads = internal::choose(np, internal_np::number_of_threads, number_of_threads);
  }
};

namespace internal {

void optimize_tetrahedra(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch,
                         const Optimize_tetrahedra_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingVolume
 *
 * improves the shape of a tetrahedral mesh, its surface included, by flips and by moving vertices.
 *
 * Rounds of flips, each raising the worst quality \f$ \gamma_\tau \f$ (13) of the few tetrahedra it changes, alternate
 * with sweeps that move each vertex down the sum of \f$ Q_\tau \f$ (16) around it. Vertices on the surface stay on the
 * given surface and in their patch, vertices on rims on their rim; no element is inverted, no facet changes its label,
 * and the sizes of elements stay what they are. In the last round the mesh is brought to those vertices of the surface
 * that it cuts off by more than a small part of its edges. The improvement of the first rounds is by far the largest.
 *
 * With `keep_boundary(true)` only the inside changes: all labelled triangles, interfaces between regions included, and
 * their vertices stay bit for bit, in their order. Where tetrahedra of vertices that may not move stay bad, vertices
 * are added or taken away around them.
 *
 * Linear in the size of the mesh for each round. Sweeps run in parallel; the result does not depend on the number of
 * threads.
 *
 * \tparam FaceGraph a model of `FaceListGraph`
 * \tparam FacePatchMap a readable property map from its faces to `int`
 *
 * \param mesh tetrahedra, positively oriented, and all their boundary triangles, labelled
 * \param surface the closed triangulated surface that the mesh approximates
 * \param patch the labels of its faces: those of the mesh's triangles
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{optimization_passes}
 *     \cgalParamDescription{number of rounds}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{2}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{keep_boundary}
 *     \cgalParamDescription{only the inside is improved; `surface` and `patch` make no difference then}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0 takes all cores}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * References: edge removal by dynamic programming, \cgalCite{klincsek1980}; swapping and smoothing in turn,
 * \cgalCite{freitag1997}; new vertices in cavities that grow, \cgalCite{klingner2007}.
 */
template <class FaceGraph, class FacePatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
void optimize_tetrahedra(Mixed_mesh& mesh, const FaceGraph& surface, FacePatchMap patch,
                         const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(surface, patch, np);
  internal::optimize_tetrahedra(mesh, core.surface(), core.patch(), Optimize_tetrahedra_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_PRESERVE_VOLUME_H
#define CGAL_TUBULAR_MESHING_VOLUME_PRESERVE_VOLUME_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <map>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingVolume
 * The named parameters of preserve_volume(), as a struct. */
struct Preserve_volume_options {
  int number_of_threads = 0; ///< 0 takes all cores

  Preserve_volume_options() = default;
  template <class NamedParameters>
  explicit Preserve_volume_options(const NamedParameters& np)
      : number_of_threads(internal::choose(np, internal_np::number_of_threads, 0)) {}
};

/*! \ingroup PkgTubularMeshingVolume
 * What preserve_volume() has done. Volumes are those inside of the surface, or of the lumen. */
struct Preserve_volume_report {
  double input_volume = 0;    ///< of the surface that was meshed
  double volume_before = 0;   ///< of the mesh as it came
  double volume = 0;          ///< of the mesh as it is now
  double largest_shift = 0;   ///< the furthest that a vertex has moved
  std::size_t held_back = 0;  ///< vertices that could not move as far as wanted, without cells turned over or crossings
  std::map<int, double> area; ///< of each opening, by its label, as it is now
};

namespace internal {

Preserve_volume_report preserve_volume(Surface& mesh, Face_patch_map mesh_patch, const Surface& input,
                                       Face_patch_map input_patch, const Preserve_volume_options& options);
Preserve_volume_report preserve_volume(Mixed_mesh& mesh, const Surface& input, Face_patch_map input_patch,
                                       Length_function radius, const Preserve_volume_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingVolume
 *
 * moves the vertices of a surface mesh so that it encloses the volume of the surface it was made from, locally.
 *
 * Vertices on a curved surface span facets inside of it. A polygon of N sides in a circle loses
 * \f$ (2\pi^2/3)/N^2 \f$ of its area, 1.6 % for N = 20, 4.6 % for N = 12; and the resistance to flow goes with the
 * area squared. Here each vertex of the wall moves along its normal by t, so that, with \f$ \varphi \f$ the vertex's
 * hat function and d the distance along the facets' normals from the facets to the input surface,
 * \f$ \int \varphi\,(d - t) = 0 \f$: the volume between the two surfaces vanishes round every vertex, hence in every
 * vessel and every stretch of it. On a circle t is two thirds of the sagitta, so facets' middles stay inside by a third
 * of it. Where the mesh is finer than the input's facets, d is zero, and nothing moves.
 *
 * Vertices on the rim of an opening move in the opening's plane, by the same rule along the rim, and then all by the
 * same small length, so that the opening's area is that of the input's. What their facets miss is shared among the
 * wall's vertices next to them.
 *
 * Facets that meet others than their neighbors afterwards, as in a gap between two vessels that is narrower than the
 * sagitta, are moved back, half of the way or all of it.
 *
 * O(n log n) for n facets of both surfaces; the result does not depend on the number of threads.
 *
 * \param mesh triangles and quads, closed, turned outward, its vertices on the input surface
 * \param input the closed surface that the mesh was made from, with flat caps of the same labels
 * \param input_patch a readable property map from its faces to `int`: labels::wall, or the label of an opening
 * \param np `number_of_threads`, and `vertex_point_map` of the input
 */
template <class FaceGraph, class FacePatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
Preserve_volume_report preserve_volume(Labelled_surface& mesh, const FaceGraph& input, FacePatchMap input_patch,
                                       const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(input, input_patch, np);
  return internal::preserve_volume(mesh.surface, mesh.patch, core.surface(), core.patch(), Preserve_volume_options(np));
}

/*! \ingroup PkgTubularMeshingVolume
 *
 * does the same for a mesh whose boundary is not that of a surface mesh, as Mesh_3 makes it,
 * anisotropic_tetrahedral_remeshing(), or subdivide_into_hexahedra() with what comes after it. Vertices inside follow those of the wall, fully next to it, less and less up to
 * half the local radius, so that layers along the wall keep their thickness. Vertices in an opening stay in its plane.
 *
 * \param mesh cells of any kind and their boundary facets, without a wall
 * \param input,input_patch,np as above
 * \param radius the local radius: a function object of a `Point_3`
 */
template <class FaceGraph, class FacePatchMap, class LocalRadius,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Preserve_volume_report preserve_volume(Mixed_mesh& mesh, const FaceGraph& input, FacePatchMap input_patch,
                                       const LocalRadius& radius,
                                       const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(input, input_patch, np);
  return internal::preserve_volume(mesh, core.surface(), core.patch(), radius, Preserve_volume_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Volume/preserve_volume_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_VOLUME_PRESERVE_VOLUME_H

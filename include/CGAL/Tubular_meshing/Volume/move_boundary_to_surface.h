// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_MOVE_BOUNDARY_TO_SURFACE_H
#define CGAL_TUBULAR_MESHING_VOLUME_MOVE_BOUNDARY_TO_SURFACE_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingVolume
 * The named parameters of move_boundary_to_surface(), as a struct. */
struct Move_boundary_to_surface_options {
  int number_of_threads = 0; ///< 0 takes all cores

  Move_boundary_to_surface_options() = default;
  template <class NamedParameters>
  explicit Move_boundary_to_surface_options(const NamedParameters& np)
      : number_of_threads(internal::choose(np, internal_np::number_of_threads, 0)) {}
};

/*! \ingroup PkgTubularMeshingVolume
 * What move_boundary_to_surface() has done. */
struct Move_boundary_to_surface_report {
  double largest_shift = 0;  ///< the furthest that a vertex has moved
  std::size_t not_found = 0; ///< vertices of the wall that have no part of the surface's wall next to them: they stay
  std::size_t held_back = 0; ///< vertices that could not go all of the way, without cells turned over or crossings
};

namespace internal {

Move_boundary_to_surface_report move_boundary_to_surface(Mixed_mesh& mesh, const Surface& input,
                                                         Face_patch_map input_patch, Length_function radius,
                                                         const Move_boundary_to_surface_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingVolume
 *
 * moves the vertices of a mesh's wall to the surface that it was made from: of a mesh that was subdivided, whose new
 * vertices lie on the facets of the coarser one.
 *
 * A vertex of the wall goes to the nearest point of the surface's wall, if that is not further than the edges around the
 * vertex are long and the wall faces the same way there; one on the rim of an opening goes to the nearest point of the
 * surface's rim. Vertices inside follow those of the wall, fully next to it, less and less up to half the local radius,
 * so that layers along the wall keep their thickness. Vertices in an opening stay in its plane, and those between two
 * openings where they are.
 *
 * Where facets would meet others than their neighbors, or a cell would lose 95 % of its volume at a corner, or more, the
 * vertices there move half of the way, a quarter, or not at all. The mesh stays valid; cells may be flat, and are to be
 * optimized: see optimize_hexahedra().
 *
 * O(n log n) for n facets and cells; the result does not depend on the number of threads.
 *
 * \param mesh cells of any kind and their boundary facets, without a wall, turned outward
 * \param input the closed surface that the mesh was made from, with flat caps of the same labels
 * \param input_patch a readable property map from its faces to `int`: labels::wall, or the label of an opening
 * \param radius the local radius: a function object of a `Point_3`
 * \param np `number_of_threads`, and `vertex_point_map` of the input
 *
 * \throws Meshing_error if the mesh's facets are no manifold surface
 */
template <class FaceGraph, class FacePatchMap, class LocalRadius,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Move_boundary_to_surface_report
move_boundary_to_surface(Mixed_mesh& mesh, const FaceGraph& input, FacePatchMap input_patch, const LocalRadius& radius,
                         const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(input, input_patch, np);
  return internal::move_boundary_to_surface(mesh, core.surface(), core.patch(), radius,
                                            Move_boundary_to_surface_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Volume/move_boundary_to_surface_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_VOLUME_MOVE_BOUNDARY_TO_SURFACE_H

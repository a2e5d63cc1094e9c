// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_REMESH_PATCHES_H
#define CGAL_TUBULAR_MESHING_PATCHES_REMESH_PATCHES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Isotropic_sizes.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Metric_sizes.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Piece_mesher.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Surface_remesher.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Surface_mesh.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

template <class Field>
using Is_metric_field =
    std::is_same<std::decay_t<decltype(std::declval<const Field&>()(std::declval<const Point_3&>()))>, Metric_tensor_3>;

template <class Field>
using Sizes_of = std::conditional_t<Is_metric_field<Field>::value, Metric_sizes<Field>, Isotropic_sizes<Field>>;

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * meshes a cut surface anew with triangles of a given size, or of unit size in a given metric, patch by patch in the
 * parametric plane (section 3.1 of the paper).
 *
 * The curves between patches are divided first, each once, by the size along them; then every patch is meshed by
 * triangulate_in_metric() in the metric (11) that its parameterization induces, and mapped back onto the surface it was
 * cut from: all vertices are on it. Caps are meshed likewise, in their planes. As patches share the points of their
 * curves, the result is conforming.
 *
 * A metric makes triangles that are stretched in space, and are near equilateral with edges near length one in the
 * metric's shadow on the surface, metric_shadow(): what is thin across the wall, as a boundary layer is, does not
 * matter on it. On caps the metric's metric_section() counts, there a layer along the wall shows. The number of
 * triangles on the wall is near the integral of the root of the shadow's determinant, divided by
 * \f$ \sqrt 3 / 4 \f$. Triangles are no better than the metric is continuous, see triangulate_in_metric(): sizes should
 * not change by more than a factor of two or so over an edge, and directions not by more than some 20 degrees; for a
 * thin layer in a cap, whose rim is round, see there too. The metric at the vertices goes with the result.
 *
 * Where new triangles meet others than their neighbours, as they do if they are too large for the gap between two
 * vessels, the patches concerned are meshed again with smaller sizes. What is returned is closed, manifold and free of
 * self-intersections, as CGAL's `Polygon_mesh_processing::does_self_intersect()` sees them.
 *
 * \param surface the surface that was cut
 * \param cut its patches, see cut_by_centerlines()
 * \param maps their parameterizations, see parameterize_patches()
 * \param size a function object: the wanted length of edges at a `Point_3`, such as a Centerline_sizing_field; or a
 *   model of `MetricField_3`, such as a Centerline_metric_field. Several threads call it at once
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{even_curves} \cgalParamDescription{whether each curve gets an even number of points, as meshes
 *     of quads need} \cgalParamDefault{`false`} \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{threads that mesh patches at the same time; 0: as many as
 *     there are cores. The result does not depend on it} \cgalParamDefault{0} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * O(n log n) in the number of new triangles, and that of old ones on curves.
 *
 * \throws Input_error if there is not one parameterization a patch
 * \throws Parameter_error if a metric is not finite and positive definite somewhere on the surface
 * \throws Meshing_error if the new triangles meet each other even where they are eight times finer
 */
template <class Size, class NamedParameters = CGAL::parameters::Default_named_parameters>
Remeshed_surface remesh_patches(const CGAL::Surface_mesh<Point_3>& surface, const Surface_cut& cut,
                                const std::vector<Patch_parameterization>& maps, const Size& size,
                                const NamedParameters& np = CGAL::parameters::default_values()) {
  if (maps.size() != cut.patches.size())
    throw Input_error("There are " + std::to_string(maps.size()) + " parameterizations of " +
                      std::to_string(cut.patches.size()) + " patches; pass what parameterize_patches() returns.");
  typedef internal::Sizes_of<Size> Sizes;
  typedef internal::Piece_mesher<Sizes> Mesher;
  const Sizes sizes(surface, cut, maps, size);
  Mesher mesher(surface, cut, maps, sizes, internal::choose(np, internal_np::even_curves, false),
                internal::choose(np, internal_np::number_of_threads, 0));
  Remeshed_surface result = internal::Surface_remesher<Mesher>(surface, cut, maps, mesher).run();
  if constexpr (internal::Is_metric_field<Size>::value)
    for (auto v : result.surface.vertices())
      result.metrics.push_back(size(result.surface.point(v)));
  return result;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_REMESH_PATCHES_H

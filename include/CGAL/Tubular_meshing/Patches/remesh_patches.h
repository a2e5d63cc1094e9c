// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_REMESH_PATCHES_H
#define CGAL_TUBULAR_MESHING_PATCHES_REMESH_PATCHES_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/metric_on_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {
/*! \ingroup PkgTubularMeshingPatches
 * The named parameters of remesh_patches(). */
struct Remesh_patches_options {
  bool even_curves = false;  ///< whether each curve gets an even number of points
  int number_of_threads = 0; ///< 0: as many as there are cores

  Remesh_patches_options() = default;
  template <class NamedParameters>
  explicit Remesh_patches_options(const NamedParameters& np)
      : even_curves(internal::choose(np, internal_np::even_curves, false))
      , number_of_threads(internal::choose(np, internal_np::number_of_threads, 0)) {}
};

namespace internal {

Remeshed_surface remesh_patches_by_size(const Surface& surface, const Surface_cut& cut,
                                        const std::vector<Patch_parameterization>& maps, Length_function size,
                                        const Remesh_patches_options& options);
Remeshed_surface remesh_patches_by_metric(const Surface& surface, const Surface_cut& cut,
                                          const std::vector<Patch_parameterization>& maps, Metric_function metric,
                                          const Remesh_patches_options& options);

template <class Field>
using Is_metric_field =
    std::is_same<std::decay_t<decltype(std::declval<const Field&>()(std::declval<const Point_3&>()))>, Metric_tensor_3>;

} // namespace internal

/*! \ingroup PkgTubularMeshingPatches
 *
 * meshes a cut surface again with triangles of a given size, or of unit size in a given metric, patch by patch in the
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
 * vessels, the patches concerned are meshed again with smaller sizes; twice also where a triangle is turned over, as one
 * is that passes from one side of a vessel to the other through its lumen. What is returned is closed, manifold and free of
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
 *   \cgalParamNBegin{even_curves}
 *     \cgalParamDescription{whether each curve gets an even number of points, as meshes of quads need}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{threads that mesh patches at the same time; 0: as many as there are cores. The result does
 *       not depend on it}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * O(n log n) in the number of new triangles, and that of old ones on curves.
 *
 * \throws Input_error if there is not one parameterization a patch
 * \throws Parameter_error if a metric is not finite and positive definite somewhere on the surface
 * \throws Meshing_error if the new triangles meet each other even where they are eight times finer
 */
template <class Size, class NamedParameters = CGAL::parameters::Default_named_parameters>
Remeshed_surface remesh_patches(const Surface& surface, const Surface_cut& cut,
                                const std::vector<Patch_parameterization>& maps, const Size& size,
                                const NamedParameters& np = CGAL::parameters::default_values()) {
  if constexpr (internal::Is_metric_field<Size>::value)
    return internal::remesh_patches_by_metric(surface, cut, maps, size, Remesh_patches_options(np));
  else
    return internal::remesh_patches_by_size(surface, cut, maps, size, Remesh_patches_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/remesh_patches_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_REMESH_PATCHES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_H

#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingOpenings
 *
 * The options of add_flow_extensions(): its named parameters of the same names. */
struct Add_flow_extensions_options {
  double extension_length = 5;                               ///< in radii
  std::optional<double> min_extension_length;                ///< none: the smaller of 1 and `extension_length`
  std::optional<std::vector<std::size_t>> extended_openings; ///< none: all

  Add_flow_extensions_options() = default;
  template <class NamedParameters>
  explicit Add_flow_extensions_options(const NamedParameters& np)
      : extension_length(internal::choose(np, internal_np::extension_length, 5.))
      , min_extension_length(internal::choose(np, internal_np::min_extension_length, std::optional<double>()))
      , extended_openings(
            internal::choose(np, internal_np::extended_openings, std::optional<std::vector<std::size_t>>())) {}
};

namespace internal {

std::vector<double> add_flow_extensions(Surface& surface, std::vector<Opening>& openings,
                                        const Add_flow_extensions_options& options);

} // namespace internal

/*!
 * \ingroup PkgTubularMeshingOpenings
 *
 * Adds flow extensions (section 2.1 of the paper, footnote): attaches a straight tube to each opening of a tubular
 * surface, so that the flow develops, and centerlines run, beyond the ends of the vessel.
 *
 * - An extension goes on in the direction of the wall within a radius behind the opening, so that it is tangent to the
 *   vessel even where this is cut obliquely; at an opening whose wall has no direction (a hole in a dome), along the
 *   opening's normal.
 * - Its profile is the rim's own where it begins and becomes a circle, smoothly (with no slope at either end), within
 *   two radii, or as much as there is. The circle has the area that the rim has across this direction; the far end is
 *   planar.
 * - Its edges are as long as those of the rim (the mean, weighted by length; at least twelve around the circle), and
 *   finer where the rim is. The rim's vertices stay where they are, and no vertex is added to its edges: the surface
 *   stays manifold.
 * - The extensions of openings that are closed by a flat cap take the place of the cap.
 * - An extension stops half a radius or less before a tube 5 % wider would meet the wall; two that would come too near
 *   each other grow alike until they do.
 *
 * Compute centerlines after this: their ends are then those of the extensions.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph`; a Surface is changed in place
 *
 * \param surface a triangle mesh, manifold, as given to find_openings(). Faces are oriented outwards (all are reversed,
 *   if they were not). Where caps are removed, descriptors are not kept, as garbage is collected; property maps of a
 *   Surface are, with default values for new elements.
 * \param openings what find_openings() has returned for this surface. Those extended are updated: centre, normal, area,
 *   perimeter and radius are those of the far end. Their order, labels and centerline branches do not change.
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{extension_length}
 *     \cgalParamDescription{in radii, of the disk that has the area of the opening across the extension's direction;
 *       from the opening's centre to the far end. At least a quarter of a radius is added to the outermost vertex of
 *       the rim. From above 0 to 1000}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{5}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{min_extension_length}
 *     \cgalParamDescription{how short an extension may become where it would run into something, in radii; equal to
 *       `extension_length`, nothing is shortened}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{the smaller of 1 and `extension_length`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{extended_openings}
 *     \cgalParamDescription{the indices of the openings to extend}
 *     \cgalParamType{`std::vector<std::size_t>`}
 *     \cgalParamDefault{all}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices of `surface`}
 *     \cgalParamType{a model of `ReadWritePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return for each opening the length of its extension from centre to centre, in the unit of the surface; 0 for those
 *   not extended
 *
 * \throws Input_error as find_openings() does, and if the openings are not those of the surface
 * \throws Parameter_error if a length is out of its range, or an index is
 * \throws Meshing_error naming the opening, if its extension would be shorter than the least length, or if its rim is
 *   such that no straight tube can begin there without crossing the wall or itself
 *
 * Where it throws, the surface and the openings are as before, but property maps have to be looked up again.
 *
 * Complexity: O(n log n) in the number of faces, of the surface and of the extensions, where a rim's height along the
 * vessel is a few radii.
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<double> add_flow_extensions(TriangleMesh& surface, std::vector<Opening>& openings,
                                        const NamedParameters& np = CGAL::parameters::default_values()) {
  const Add_flow_extensions_options options(np);
  if constexpr (internal::is_core_surface<TriangleMesh, NamedParameters>)
    return internal::add_flow_extensions(surface, openings, options);
  else {
    Surface extended;
    internal::copy_to_core(surface, extended, np);
    const std::vector<double> lengths = internal::add_flow_extensions(extended, openings, options);
    internal::copy_from_core(extended, surface, np);
    return lengths;
  }
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Openings/flow_extensions_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_H

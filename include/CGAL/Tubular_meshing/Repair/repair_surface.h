// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_REPAIR_SURFACE_H
#define CGAL_TUBULAR_MESHING_REPAIR_REPAIR_SURFACE_H

#include <CGAL/Tubular_meshing/Repair/Repair_report.h>
#include <CGAL/Tubular_meshing/Repair/Repair_surface_options.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

Repair_report repair_soup(const std::vector<Point_3>& points, const std::vector<std::array<std::size_t, 3>>& triangles,
                          Surface& mesh, const Repair_surface_options& options);

Repair_report repair_mesh(Surface& mesh, const Repair_surface_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingRepair
 *
 * Makes a clean tubular surface of triangles as they come: connected, manifold, oriented outward, without triangles
 * that cross each other, open or closed by flat caps at its ends as before.
 *
 * In this order:
 * - points of equal coordinates are merged; triangles with two equal corners, and repeated ones, are removed;
 * - free edges that nearly coincide over a length (within a fifth of the local edge length) are sewn together,
 *   splitting edges where the two sides have different points;
 * - fins and membranes are removed where they make an edge have more than two triangles, and the sides of the surface
 *   are separated where they touch in a point;
 * - the triangles are oriented consistently, and the whole outward;
 * - all components but the one of the largest area are dropped, or, if more are wanted, all that are no vessels: a
 *   vessel has two ends or more, open or flat, and a thousandth of the area of the largest, or is much longer than wide
 *   and has a hundredth of it. A component with a rim close to and facing one of the part that is kept is a piece of
 *   the vessel: then the gap is refused. Each that is kept is turned outward;
 * - triangles less high than a thousandth of their longest side are collapsed or flipped away, or replaced with the
 *   faces around them;
 * - pinholes are filled. A border loop is an opening if the wall stands upright on it, as it does at any end of a tube,
 *   however oblique, coarse or ragged, at a stub, and at a branch that is cut off flush with the vessel. Of the loops
 *   that lie in the wall, a pinhole has less than half the local radius (half the way to the opposite wall), a tenth of
 *   it if it is plane and round as if it had been cut; or at most six edges; cracks are filled as well. A hole that
 *   touches an opening in a point is distinguished from it, and filled by itself. A larger loop in the wall may be a
 *   hole or an opening: it is taken for an opening, and reported. Only a loop that no flat cap closes, a wide slit or
 *   a tear along the vessel, is refused;
 * - vertices that were thrown out of the wall, making spikes into the lumen or outward, are put back into it. A spike is
 *   sharper than a cone 1.25 times as high as wide, and stands on a wall that turns back what the spike turns: pointed
 *   ends, carinas, stenoses, creases and coarse walls are none. At the rim of a flat cap, where the wall turns back less,
 *   it is what keeps the cap from being flat;
 * - triangles that cross, or fold back on their neighbours by more than 154 degrees, are smoothed or replaced by a
 *   patch that continues the wall; at a rim they are removed. If that loses or adds an opening, it is taken back;
 * - vessels that cross each other are united (corefine_and_compute_union()); one inside of another is dropped;
 * - where this fails, the surface, its ends closed, is replaced by an alpha wrap (CGAL's Alpha_wrap_3) with alpha a
 *   third of the smallest opening's radius, drawn back onto the surface and cut open at the ends. A wrap that would
 *   take more than about half a minute, that loses or adds an opening, or in which vessels grow together is refused;
 * - loops of vessels, which may be vessels that touch and are fused, are reported, not cut.
 *
 * A surface with none of these is exactly what `IO::read_surface()` makes of it, and the report is empty.
 *
 * \tparam Point a model of `Kernel::Point_3`, of any kernel
 * \tparam TriangleMesh a model of `MutableFaceGraph`; a Surface receives the result without a copy
 *
 * \param points, triangles the soup, as from `IO::read_triangle_soup()`
 * \param mesh receives the surface; what it held before is removed
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{repair_mode}
 *     \cgalParamDescription{how far the repair goes}
 *     \cgalParamType{Repair_mode}
 *     \cgalParamDefault{`Repair_mode::automatic`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{smooth}
 *     \cgalParamDescription{whether staircase noise is smoothed off at last, keeping the volume (Taubin's filter, pass
 *       band 0.1); rims stay curves along themselves, flat caps stay}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_parts}
 *     \cgalParamDescription{how many vessels are kept where the surface has several, by decreasing area; 0: all of
 *       them. See split_into_parts()}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{1}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{filled_holes}
 *     \cgalParamDescription{points: the border loop nearest to each is filled as a hole of the wall, however large}
 *     \cgalParamType{`std::vector<Point_3>`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{kept_openings}
 *     \cgalParamDescription{points: a border loop whose centre is within one and a half of its radii from one of them
 *       is an opening, however small}
 *     \cgalParamType{`std::vector<Point_3>`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices of `mesh`}
 *     \cgalParamType{a model of `ReadWritePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return what was done, in order
 *
 * \throws Input_error naming what cannot be repaired and its place: no triangles, indices out of range, coordinates
 *   that are not finite, a tear of the wall, a point of `filled_holes` without a border loop, a gap too wide, a wrap that loses an opening.
 * \throws Meshing_error if smoothing makes the surface intersect itself
 *
 * Complexity: O(n log n) in the number of triangles. About 2 s for 400,000 clean ones, most of it the test for
 * self-intersections.
 */
template <class Point, class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Repair_report repair_surface(const std::vector<Point>& points, const std::vector<std::array<std::size_t, 3>>& triangles,
                             TriangleMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values()) {
  const Repair_surface_options options(np);
  if constexpr (!std::is_same<Point, Point_3>::value) {
    std::vector<Point_3> converted;
    converted.reserve(points.size());
    for (const Point& p : points)
      converted.push_back(internal::to_core(p));
    return repair_surface(converted, triangles, mesh, np);
  } else if constexpr (internal::is_core_surface<TriangleMesh, NamedParameters>)
    return internal::repair_soup(points, triangles, mesh, options);
  else {
    Surface repaired;
    Repair_report report = internal::repair_soup(points, triangles, repaired, options);
    internal::copy_from_core(repaired, mesh, np);
    return report;
  }
}

/*! \ingroup PkgTubularMeshingRepair
 *
 * repairs a mesh in place. If nothing is wrong it is not touched; else its descriptors and property maps are lost.
 *
 * \throws Input_error as above, and if a face is not a triangle; the mesh may then be changed
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Repair_report repair_surface(TriangleMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values()) {
  const Repair_surface_options options(np);
  if constexpr (internal::is_core_surface<TriangleMesh, NamedParameters>)
    return internal::repair_mesh(mesh, options);
  else {
    Surface repaired;
    internal::copy_to_core(mesh, repaired, np);
    Repair_report report = internal::repair_mesh(repaired, options);
    if (!report.empty())
      internal::copy_from_core(repaired, mesh, np);
    return report;
  }
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Repair/repair_surface_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_REPAIR_REPAIR_SURFACE_H

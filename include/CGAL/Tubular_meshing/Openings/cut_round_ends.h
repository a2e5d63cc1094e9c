// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_CUT_ROUND_ENDS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_CUT_ROUND_ENDS_H

#include <CGAL/Tubular_meshing/Openings/Round_end_report.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <optional>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

std::vector<Round_end_report> cut_round_ends(Surface& surface, const Cut_round_ends_options& options);

/* Cuts the ends at the points; all of them, where there are no points, and the surface has no opening or is closed and
 * has ends behind creases. `openings` becomes those that find_unordered_openings() has found, unless ends were to be cut. */
std::vector<Round_end_report> open_round_ends(Surface& surface, const std::vector<Point_3>& points,
                                              const std::vector<Point_3>& blind_ends,
                                              std::optional<std::vector<Opening>>& openings);

} // namespace internal

/*! \ingroup PkgTubularMeshingOpenings
 *
 * Cuts vessels open that end in domes, as the surfaces of segmentations do: each by a plane across its axis where the
 * radius is still that of the vessel. Nothing is lost but the domes; find_openings() then finds the openings.
 *
 * - The ends are the leaves of the computed centerlines (compute_centerlines()) that lead to tips: places from which the
 *   way along the wall is longest. Each leaf is the centre of the largest ball in the lumen that touches the tip.
 * - A bump is no end: its last ball gets out of the balls of the vessel that it sits on by less than 1.2 of its radii
 *   (a half ball on a wall by 1; by less than 3 out of balls against which it is thinner than 0.15). What gets out
 *   further, and thus goes on at its radius, is a vessel, be it a stub shorter than it is wide.
 * - A sac is no end. It is what is more than 1.15 times wider than its neck, or its necks together, and is at most two
 *   radii long between the places where it begins to narrow; the longer it is, the narrower its neck has to be. What sits
 *   on a sac is a lobe of it, unless it goes on at its own radius for one and a half radii: then it is a vessel that
 *   leaves the sac. Of a sac with several lobes there is one report.
 * - The dome begins where the radius, seen from the tip, is within 8 % of that three quarters of a radius further in.
 *   The plane lies there, or further out as far as the wall keeps 98.5 % of its distance from the axis.
 * - Where that plane does not cut the vessel in one loop, one nearer to the tip is taken, as of a stub that is short or
 *   widens like a funnel; else one further in, by at most two radii.
 * - No cut takes away more than 40 % of the area of the surface (30 % at a point), nor all of them together more than
 *   75 %: the plane is moved out; where that does not help, the end is one that cannot be cut.
 * - Where no vessel ends at a point that `ends_to_cut` names, but the wall is within half a radius of it, a cap of the
 *   largest ball that touches the wall there is cut off, its rim half as wide as the ball: so a ball is opened.
 * - Single vertices that stick out of the surface or into it, further than their neighbours are apart, do not count.
 * - Openings that the surface has already, open, capped flat or behind a crease, stay as they are.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph`; a Surface is changed in place
 *
 * \param surface a triangle mesh, manifold, in one piece, closed or with openings. Descriptors are not kept; property
 *   maps of a Surface are, with default values for new elements. Not touched if nothing is cut
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{ends_to_cut}
 *     \cgalParamDescription{points, on the wall or in the lumen: the end of a vessel nearest to each is cut open,
 *       whatever its shape; where none is near, the wall. One that lies at an opening asks for nothing}
 *     \cgalParamType{`std::vector<Point_3>`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{blind_ends}
 *     \cgalParamDescription{points: the end nearest to each, if it is within two radii, stays blind}
 *     \cgalParamType{`std::vector<Point_3>`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{all_round_ends}
 *     \cgalParamDescription{whether all ends of vessels are cut, or only those that `ends_to_cut` names}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices of `surface`}
 *     \cgalParamType{a model of `ReadWritePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the ends that were found: those that are cut, and those that are not, with the reason
 *
 * \throws Input_error as find_openings() and compute_centerlines() do; and if an end that a point names cannot be cut,
 *   or is neither a vessel's nor near the wall
 *
 * Complexity: that of compute_centerlines(), O(n log n).
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Round_end_report> cut_round_ends(TriangleMesh& surface,
                                             const NamedParameters& np = CGAL::parameters::default_values()) {
  const Cut_round_ends_options options(np);
  if constexpr (internal::is_core_surface<TriangleMesh, NamedParameters>)
    return internal::cut_round_ends(surface, options);
  else {
    Surface cut;
    internal::copy_to_core(surface, cut, np);
    const auto report = internal::cut_round_ends(cut, options);
    internal::copy_from_core(cut, surface, np);
    return report;
  }
}

/*! \ingroup PkgTubularMeshingOpenings
 *
 * opens what has to be open before a surface can be meshed for flow: cuts the round ends at the points, or all of them
 * where there are no points and the surface has no opening. So it does where the surface is closed and has ends behind
 * creases: of domes that close vessels some may meet the wall in a crease, and others go over into it smoothly.
 * make_tubular_model() does all this by itself. */
inline std::vector<Round_end_report> open_round_ends(Surface& surface, const std::vector<Point_3>& points = {},
                                                     const std::vector<Point_3>& blind_ends = {}) {
  std::optional<std::vector<Opening>> openings;
  return internal::open_round_ends(surface, points, blind_ends, openings);
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Openings/cut_round_ends_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_OPENINGS_CUT_ROUND_ENDS_H

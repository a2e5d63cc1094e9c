// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_BUILD_CENTERLINE_GRAPH_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_BUILD_CENTERLINE_GRAPH_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * The options of build_centerline_graph(): its named parameters.
 */
struct Build_centerline_graph_options {
  double merge_tolerance = 0.1; ///< a fraction of the local radius, in (0, 0.5]

  Build_centerline_graph_options() = default;
  template <class NamedParameters>
  explicit Build_centerline_graph_options(const NamedParameters& np)
      : merge_tolerance(internal::choose(np, internal_np::merge_tolerance, 0.1)) {}
};

namespace internal {

void build_centerline_graph(const Centerline_polylines& polylines, Length_function radius, Centerline_graph& graph,
                            const Build_centerline_graph_options& options);
void build_centerline_graph(const Centerline_polylines& polylines, Centerline_graph& graph,
                            const Build_centerline_graph_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * Makes the branches of a vessel or airway tree from centerlines as programs write them: VMTK one polyline an outlet,
 * all of them nearly, but not exactly, equal upstream; Gmsh loose segments.
 *
 * Segments are chained, steps of less than 0.01 r and zigzags removed, long steps refined to half a radius. Lines are
 * then overlaid, long ones first: where a line runs within `merge_tolerance` radii of those before, it adds nothing;
 * where it gets further than 3/4 of the radius away from them, it is a branch, open (an outlet) or, when it comes back,
 * closed (a bypass). Smaller excursions are noise. The root is the end at which most lines start or end, if there is
 * one, else the end of largest radius.
 *
 * Deterministic; scales, moves and turns with its input. O(n log n) in the number of points.
 *
 * \param polylines the lines; their `radius` is not read
 * \param radius a function object from a point to its local radius, such as Wall_distance of the surface: "the distance
 *        from a point on the centerline to the tubular geometry" (section 2.2)
 * \param graph is replaced
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{merge_tolerance}
 *     \cgalParamDescription{a fraction of the local radius, in (0, 0.5]}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{0.1}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if there are no lines, or a line is broken; Parameter_error if the tolerance is out of range
 */
template <class RadiusFunction, class NamedParameters = CGAL::parameters::Default_named_parameters>
void build_centerline_graph(const Centerline_polylines& polylines, const RadiusFunction& radius,
                            Centerline_graph& graph, const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::build_centerline_graph(polylines, radius, graph, Build_centerline_graph_options(np));
}

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * The same, with the radii that the file gives (VMTK's MaximumInscribedSphereRadius), where there is no surface.
 *
 * \throws Input_error also if there is not one finite radius a point
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void build_centerline_graph(const Centerline_polylines& polylines, Centerline_graph& graph,
                            const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::build_centerline_graph(polylines, graph, Build_centerline_graph_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_BUILD_CENTERLINE_GRAPH_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_BOUNDARY_LAYER_REPORT_H
#define CGAL_TUBULAR_MESHING_QUALITY_BOUNDARY_LAYER_REPORT_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuality
 *
 * How well the tetrahedra of an anisotropic mesh follow the wall and the vessel.
 */
struct Boundary_layer_report {
  /*! One value a vertex of the wall: the height of the first layer there, over the one asked for. The height is that of
   * the tetrahedra that stand on the wall's facets at the vertex (three times their volume over the area), in the mean
   * weighted by area; asked for is the smallest size of the metric at the vertex. In a metric that grows by 1.3 from
   * layer to layer, it is 0.86 for regular tetrahedra. */
  Measure_statistics first_height;

  /*! One value a long edge: the angle between it and e_t, in degrees; e_t is the centerline's direction, made
   * perpendicular to the metric's direction of smallest size, the wall's normal. An edge is long if it is at least as
   * long as the size that the metric asks for along e_t, where that is at least twice the one around, along e_bn. Edges
   * within two radii of a bifurcation, measured along the centerline, do not count. */
  Measure_statistics alignment;

  /// The share of the wall's vertices where the first layer is as high as asked for, to a relative tolerance.
  double share_of_first_heights(double tolerance = 0.3) const {
    return first_height.share_below(1 + tolerance) - first_height.share_below(1 - tolerance);
  }
};

namespace internal {

Boundary_layer_report boundary_layer_report_on(int threads, const Mixed_mesh& mesh,
                                               const Centerline_graph& centerlines);

} // namespace internal

/*! \ingroup PkgTubularMeshingQuality
 *
 * measures the first layer at the wall, and how the long edges lie along the vessel.
 *
 * \param mesh tetrahedra, with triangles of patch labels::wall and the point array `metric`, as make_anisotropic_mesh()
 *   gives it
 * \param centerlines of the vessel, with radii, as in a Tubular_model
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0: all cores. The result does not depend on it}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * O(n log n).
 *
 * \throws Input_error if the mesh has no `metric`, or there are no centerlines
 */
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
Boundary_layer_report boundary_layer_report(const Mixed_mesh& mesh, const Centerline_graph& centerlines,
                                            const CGAL_NP_CLASS& np = CGAL::parameters::default_values()) {
  return internal::boundary_layer_report_on(internal::choose(np, internal_np::number_of_threads, 0), mesh, centerlines);
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quality/boundary_layer_report_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUALITY_BOUNDARY_LAYER_REPORT_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CHECK_CENTERLINES_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CHECK_CENTERLINES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Tubular_meshing {

namespace internal {

void check_centerlines_inside(const Centerline_graph& graph, const Surface& surface);

} // namespace internal

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * Makes sure that centerlines and surface belong together: more than half of the centerlines' length lies inside. (Not
 * all of it must: centerlines of a surface with flow extensions run out of the openings.) 256 points are tried, each in
 * O(log n).
 *
 * \param graph the centerlines
 * \tparam TriangleMesh a model of `FaceListGraph`, of any kernel
 * \param surface a closed triangle mesh
 * \param np CGAL's `vertex_point_map`
 * \throws Input_error, with both bounding boxes, if none, or less than half, of the centerlines is inside
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void check_centerlines_inside(const Centerline_graph& graph, const TriangleMesh& surface,
                              const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_surface<TriangleMesh, NamedParameters> core(surface, np);
  internal::check_centerlines_inside(graph, *core);
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Centerlines/check_centerlines_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CHECK_CENTERLINES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_METRIC_SURFACE_REPORT_H
#define CGAL_TUBULAR_MESHING_PATCHES_METRIC_SURFACE_REPORT_H

#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>

#include <cmath>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPatches
 *
 * How triangles fit a metric. Each has the mean of the metrics at its corners, restricted to its plane.
 */
struct Metric_fit {
  Measure_statistics shape;       ///< \f$ 4\sqrt 3 A / \sum l^2 \f$ in the metric: 1 is equilateral, 0 degenerate
  Measure_statistics edge_length; ///< (10), once for each triangle beside an edge: 1 is what is wanted
  double wanted_triangles = 0;    ///< equilateral ones of unit edges that have the area of all

  /// The share of edges whose length is in \f$ [1/\sqrt 2, \sqrt 2] \f$; 1 where there are none.
  double share_of_unit_edges() const {
    if (edge_length.count() == 0)
      return 1;
    return edge_length.share_below(std::sqrt(2.)) - edge_length.share_below(std::sqrt(0.5));
  }
};

/*! \ingroup PkgTubularMeshingPatches
 *
 * How a surface fits the metric that it was made by: see metric_surface_report().
 */
struct Metric_surface_report {
  Metric_fit wall; ///< in the shadow of the metric, metric_shadow()
  Metric_fit caps; ///< in its section, metric_section()
};

/*! \ingroup PkgTubularMeshingPatches
 *
 * measures the triangles of a surface in the metric that it was made by. O(n log n).
 *
 * \param remeshed of triangles, by remesh_patches() with a metric, or make_anisotropic_surface_mesh(). Of one that has
 *   no metrics the report is empty
 */
Metric_surface_report metric_surface_report(const Remeshed_surface& remeshed);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/metric_surface_report_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_METRIC_SURFACE_REPORT_H

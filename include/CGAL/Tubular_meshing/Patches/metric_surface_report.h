// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_METRIC_SURFACE_REPORT_H
#define CGAL_TUBULAR_MESHING_PATCHES_METRIC_SURFACE_REPORT_H

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/metric_on_surface.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
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

/*! \ingroup PkgTubularMeshingRef
 *
 * How a surface fits the metric that it was made by: see metric_surface_report().
 */
struct Metric_surface_report {
  Metric_fit wall; ///< in the shadow of the metric, metric_shadow()
  Metric_fit caps; ///< in its section, metric_section()
};

namespace internal {

/* Collects the measures of triangles in their metrics. */
class Metric_fit_collector {
public:
  // Corners in space, and the metrics of the triangle's plane at them, along `first` and `second`.
  void add(const std::array<Vector_3d, 3>& p, const Vector_3d& first, const Vector_3d& second,
           const std::array<Metric_tensor_2, 3>& m) {
    const Metric_tensor_2 mean = 1. / 3 * (m[0] + m[1] + m[2]);
    double squares = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const double x = dot(p[j] - p[i], first), y = dot(p[j] - p[i], second);
      squares += mean.squared_length(x, y);
      edge_lengths_.push_back(logarithmic_mean(m[i].length(x, y), m[j].length(x, y)));
    }
    const double flat_area = norm(cross(p[1] - p[0], p[2] - p[0])) / 2;
    const double area = flat_area * std::sqrt((std::max)(mean.determinant(), 0.));
    shapes_.push_back(squares > 0 ? 4 * root_three * area / squares : 0);
    fit_.wanted_triangles += area * 4 / root_three;
  }

  Metric_fit take() {
    fit_.shape = Measure_statistics(std::move(shapes_));
    fit_.edge_length = Measure_statistics(std::move(edge_lengths_));
    return std::move(fit_);
  }

private:
  static constexpr double root_three = 1.7320508075688772;

  static double logarithmic_mean(double a, double b) {
    return std::abs(a - b) > 1e-6 * (a + b) ? (a - b) / std::log(a / b) : (a + b) / 2;
  }

  Metric_fit fit_;
  std::vector<double> shapes_, edge_lengths_;
};

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * measures the triangles of a surface in the metric that it was made by. O(n log n).
 *
 * \param remeshed of triangles, by remesh_patches() with a metric, or make_anisotropic_surface_mesh(). Of one that has
 *   no metrics the report is empty
 */
inline Metric_surface_report metric_surface_report(const Remeshed_surface& remeshed) {
  typedef internal::Vector_3d Vector;
  internal::Metric_fit_collector wall, caps;
  const auto& surface = remeshed.surface;
  for (auto f : surface.faces()) {
    if (remeshed.metrics.empty())
      break;
    const auto h = surface.halfedge(f);
    const std::array<std::size_t, 3> v = {std::size_t(surface.source(h)), std::size_t(surface.target(h)),
                                          std::size_t(surface.target(surface.next(h)))};
    const std::array<Vector, 3> p = {Vector(surface.point(surface.source(h))), Vector(surface.point(surface.target(h))),
                                     Vector(surface.point(surface.target(surface.next(h))))};
    const Vector normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
    const Vector first = normalized(p[1] - p[0]), second = cross(normal, first);
    const bool is_wall = remeshed.patch[f] == labels::wall;
    std::array<Metric_tensor_2, 3> m;
    for (std::size_t i = 0; i < 3; ++i)
      m[i] = is_wall ? metric_shadow(remeshed.metrics[v[i]], first, second)
                     : metric_section(remeshed.metrics[v[i]], first, second);
    (is_wall ? wall : caps).add(p, first, second, m);
  }
  return {wall.take(), caps.take()};
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_METRIC_SURFACE_REPORT_H

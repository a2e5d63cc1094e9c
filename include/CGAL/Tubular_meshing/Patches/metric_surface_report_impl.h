// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_METRIC_SURFACE_REPORT_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_METRIC_SURFACE_REPORT_IMPL_H

#include <CGAL/Tubular_meshing/Patches/metric_surface_report.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Patches/metric_on_surface.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/constants.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

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
    shapes_.push_back(squares > 0 ? 4 * root_of_3 * area / squares : 0);
    fit_.wanted_triangles += area * 4 / root_of_3;
  }

  Metric_fit take() {
    fit_.shape = Measure_statistics(std::move(shapes_));
    fit_.edge_length = Measure_statistics(std::move(edge_lengths_));
    return std::move(fit_);
  }

private:
  // To the last digit, which Metric_tensor_2::edge_length() gives up for the mesher's speed.
  static double logarithmic_mean(double a, double b) {
    return std::abs(a - b) > 1e-6 * (a + b) ? (a - b) / std::log(a / b) : (a + b) / 2;
  }

  Metric_fit fit_;
  std::vector<double> shapes_, edge_lengths_;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Metric_surface_report metric_surface_report(const Remeshed_surface& remeshed) {
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

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_METRIC_SURFACE_REPORT_IMPL_H

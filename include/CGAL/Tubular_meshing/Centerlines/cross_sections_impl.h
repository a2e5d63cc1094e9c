// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CROSS_SECTIONS_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CROSS_SECTIONS_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Branch_curve.h>
#include <CGAL/Tubular_meshing/Centerlines/cross_sections.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Surface_slicer.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/curve_shape.h>
#include <CGAL/Tubular_meshing/base/Plane_frame.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Tubular_meshing {
namespace internal {

// Points of a branch half the spacing before and behind each of which the next one's part begins.
inline void add_abscissas(const Centerline_graph& graph, std::size_t b, double spacing,
                          std::vector<Cross_section>& sections) {
  const auto& branch = graph.branches()[b];
  const Branch_curve curve(graph, b);
  const double least = branch.length / 1e5; // radii may be 0
  for (double s = 0;;) {
    s += (std::max)(0.5 * spacing * curve.radius(s), least);
    if (!(s < branch.length))
      return;
    sections.emplace_back();
    sections.back().branch = b;
    sections.back().abscissa = s;
    s += (std::max)(0.5 * spacing * curve.radius(s), least);
  }
}

inline Vector_3d any_normal_to(const Vector_3d& v) {
  const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
  return normalized(cross(v, x <= y && x <= z ? Vector_3d(1, 0, 0) : y <= z ? Vector_3d(0, 1, 0) : Vector_3d(0, 0, 1)));
}

/* Area, perimeter and center of a plane loop, and the eccentricity of the ellipse that has its second moments of area. */
inline void measure(const Surface_slicer::Loop& loop, const Vector_3d& normal, Cross_section& section) {
  const Plane_frame frame(loop.front(), normal);
  double area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector_3d &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const auto p = frame.in_plane(a), q = frame.in_plane(b);
    const double part = 0.5 * (p[0] * q[1] - p[1] * q[0]); // of the triangle with the origin
    area += part;
    x += part / 3 * (p[0] + q[0]);
    y += part / 3 * (p[1] + q[1]);
    xx += part / 6 * (p[0] * p[0] + p[0] * q[0] + q[0] * q[0]);
    xy += part / 12 * (2 * p[0] * p[1] + p[0] * q[1] + q[0] * p[1] + 2 * q[0] * q[1]);
    yy += part / 6 * (p[1] * p[1] + p[1] * q[1] + q[1] * q[1]);
    section.perimeter += norm(b - a);
  }
  section.area = std::abs(area);
  if (area == 0)
    return;
  x /= area;
  y /= area;
  section.center = as<Point_3>(frame.point(x, y, 0));
  xx = xx / area - x * x;
  xy = xy / area - x * y;
  yy = yy / area - y * y;
  const double half = 0.5 * (xx + yy), difference = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
  if (half > 0)
    section.eccentricity = std::sqrt((std::min)(2 * difference / (half + difference), 1.));
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE double Cross_section::radius() const {
  return std::sqrt(area / internal::pi);
}

CGAL_TUBULAR_MESHING_INLINE double Cross_section::hydraulic_diameter() const {
  return perimeter > 0 ? 4 * area / perimeter : 0;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Cross_section>
cross_sections(const Surface& surface, const Centerline_graph& graph, double spacing, int number_of_threads) {
  using internal::Vector_3d;
  if (!(spacing >= 0.01))
    throw Parameter_error("The spacing of cross-sections is in local radii, and at least 0.01.");
  std::vector<Cross_section> sections;
  for (std::size_t b = 0; b < graph.branches().size(); ++b)
    internal::add_abscissas(graph, b, spacing, sections);
  const internal::Surface_slicer slicer(surface);
  internal::for_each_range(sections.size(), number_of_threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Cross_section& section = sections[i];
      const internal::Branch_curve curve(graph, section.branch);
      const Vector_3d point = curve.point(section.abscissa), normal = curve.tangent(section.abscissa);
      section.point = section.center = internal::as<Point_3>(point);
      section.normal = internal::as<Vector_3>(normal);
      section.inscribed_radius = curve.radius(section.abscissa);
      const internal::Curve_shape shape = internal::curve_shape(curve, section.abscissa);
      section.curvature = shape.curvature;
      section.torsion = shape.torsion;
      const auto loop = slicer.loop(point, normal, internal::any_normal_to(normal));
      if (!loop.empty())
        internal::measure(loop, normal, section);
    }
  });
  return sections;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CROSS_SECTIONS_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CROSS_SECTIONS_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CROSS_SECTIONS_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/cross_sections.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Surface_slicer.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Tubular_meshing {
namespace internal {

/* A branch by its abscissa. */
class Branch_curve {
public:
  Branch_curve(const Centerline_graph& graph, const Centerline_graph::Branch& branch)
      : graph_(graph)
      , branch_(branch) {}

  Vector_3d point(double s) const {
    const At at = find(s);
    return (1 - at.t) * point_of(at.segment) + at.t * point_of(at.segment + 1);
  }
  double radius(double s) const {
    const At at = find(s);
    return (1 - at.t) * radius_of(at.segment) + at.t * radius_of(at.segment + 1);
  }
  // As it runs over one radius.
  Vector_3d direction(double s) const {
    const double half = 0.5 * radius(s);
    const Vector_3d d = point((std::min)(s + half, branch_.length)) - point((std::max)(s - half, 0.));
    return squared_norm(d) > 0 ? normalized(d) : normalized(point(branch_.length) - point(0));
  }

private:
  struct At {
    std::size_t segment;
    double t;
  };
  At find(double s) const {
    const auto& a = branch_.abscissa;
    const std::size_t next = std::size_t(std::upper_bound(a.begin() + 1, a.end() - 1, s) - a.begin());
    const double length = a[next] - a[next - 1];
    return {next - 1, length > 0 ? (std::min)((std::max)((s - a[next - 1]) / length, 0.), 1.) : 0};
  }
  Vector_3d point_of(std::size_t i) const { return Vector_3d(graph_.points()[branch_.points[i]]); }
  double radius_of(std::size_t i) const { return graph_.radii()[branch_.points[i]]; }

  const Centerline_graph& graph_;
  const Centerline_graph::Branch& branch_;
};

// Points of a branch half the spacing before and behind each of which the next one's part begins.
inline void add_abscissas(const Centerline_graph& graph, std::size_t b, double spacing,
                          std::vector<Cross_section>& sections) {
  const auto& branch = graph.branches()[b];
  const Branch_curve curve(graph, branch);
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

// Area, perimeter and center of a plane loop.
inline void measure(const Surface_slicer::Loop& loop, const Vector_3d& normal, Cross_section& section) {
  const Vector_3d origin = loop.front();
  Vector_3d moment;
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector_3d p = loop[i] - origin, q = loop[(i + 1) % loop.size()] - origin;
    const double part = 0.5 * dot(cross(p, q), normal);
    area += part;
    moment += (part / 3) * (p + q);
    section.perimeter += norm(q - p);
  }
  section.area = std::abs(area);
  if (area != 0)
    section.center = as<Point_3>(origin + (1 / area) * moment);
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE double Cross_section::radius() const {
  return std::sqrt(area / internal::pi);
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
      const internal::Branch_curve curve(graph, graph.branches()[section.branch]);
      const Vector_3d point = curve.point(section.abscissa), normal = curve.direction(section.abscissa);
      section.point = section.center = internal::as<Point_3>(point);
      section.normal = internal::as<Vector_3>(normal);
      section.inscribed_radius = curve.radius(section.abscissa);
      const auto loop = slicer.loop(point, normal, internal::any_normal_to(normal));
      if (!loop.empty())
        internal::measure(loop, normal, section);
    }
  });
  return sections;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CROSS_SECTIONS_IMPL_H

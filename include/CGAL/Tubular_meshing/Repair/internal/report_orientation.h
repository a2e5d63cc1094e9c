// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REPORT_ORIENTATION_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REPORT_ORIENTATION_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Repair/Repair_report.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Repair/internal/Soup_edges.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// "1 triangle", "2 triangles"
inline std::string counted(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

inline std::string short_number(double x) {
  std::ostringstream out;
  out.precision(3);
  out << x;
  return out.str();
}

// Points may have been doubled meanwhile: corners are compared as points.
inline bool is_reversed(const std::vector<Point_3>& points, const Index_triangle& before, const Index_triangle& after) {
  for (int k = 0; k < 3; ++k)
    if (points[before[0]] == points[after[k]])
      return points[before[1]] != points[after[(k + 1) % 3]];
  return false;
}

/* Reports what orienting a soup has changed: triangles that were turned, and points that were doubled. */
inline void report_orientation(const std::vector<Point_3>& points, const std::vector<Index_triangle>& before,
                               const std::vector<Index_triangle>& after, Repair_report& report) {
  std::size_t turned = 0, first_turned = after.size(), first_kept = after.size();
  std::size_t doubled = 0, first_doubled = points.size();
  std::size_t old_points = 0;
  for (const Index_triangle& t : before)
    old_points = (std::max)(old_points, *std::max_element(t.begin(), t.end()) + 1);
  for (std::size_t f = 0; f < after.size(); ++f) {
    const bool is_turned = is_reversed(points, before[f], after[f]);
    turned += is_turned;
    std::size_t& first = is_turned ? first_turned : first_kept;
    first = (std::min)(first, f);
  }
  if (points.size() > old_points) {
    doubled = points.size() - old_points;
    first_doubled = old_points;
  }
  // which of the two ways is right is not known here
  const bool most = 2 * turned > after.size();
  const std::size_t n = most ? after.size() - turned : turned;
  if (n > 0) {
    const Point_3& place = points[after[most ? first_kept : first_turned][0]];
    report.add(Surface_defect::turned_triangles, n, 0,
               counted(n, "triangle was", "triangles were") + " oriented against the others and turned, the first at " +
                   coordinates(place) + ".",
               place);
  }
  if (doubled > 0)
    report.add(Surface_defect::nonmanifold_points, doubled, 0,
               "The surface touches itself in " + counted(doubled, "point", "points") + ", the first at " +
                   coordinates(points[first_doubled]) + ": its sides were separated there.",
               points[first_doubled]);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REPORT_ORIENTATION_H

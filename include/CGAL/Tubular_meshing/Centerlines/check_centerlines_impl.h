// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CHECK_CENTERLINES_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CHECK_CENTERLINES_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/check_centerlines.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline std::string to_string(const CGAL::Bbox_3& b) {
  std::ostringstream s;
  s.precision(4);
  s << "[" << b.xmin() << ", " << b.xmax() << "] x [" << b.ymin() << ", " << b.ymax() << "] x [" << b.zmin() << ", "
    << b.zmax() << "]";
  return s.str();
}

// Points at equal distances along the graph.
inline std::vector<Point_3> evenly_spaced_points(const Centerline_graph& graph, int number) {
  std::vector<Point_3> result;
  const double step = graph.length() / number;
  double next = 0.5 * step, before = 0; // along the branches, one after the other
  for (const auto& b : graph.branches()) {
    for (std::size_t i = 1; i < b.points.size(); ++i)
      for (; int(result.size()) < number && next <= before + b.abscissa[i]; next += step) {
        const double l = b.abscissa[i] - b.abscissa[i - 1];
        const double t = l > 0 ? (std::max)(0., (next - before - b.abscissa[i - 1]) / l) : 0;
        const Point_3 &p = graph.points()[b.points[i - 1]], &q = graph.points()[b.points[i]];
        result.push_back(p + t * (q - p));
      }
    before += b.length;
  }
  return result;
}

CGAL_TUBULAR_MESHING_INLINE void check_centerlines_inside(const Centerline_graph& graph, const Surface& surface) {
  const int number = 256;
  const CGAL::Side_of_triangle_mesh<Surface, Kernel> side(surface);
  int inside = 0, tried = 0;
  CGAL::Bbox_3 box;
  for (const Point_3& p : graph.points())
    box += p.bbox();
  for (const Point_3& p : evenly_spaced_points(graph, number)) {
    ++tried;
    if (side(p) != CGAL::ON_UNBOUNDED_SIDE)
      ++inside;
  }
  if (2 * inside > tried)
    return;
  const std::string share = inside == 0 ? "none" : "only " + std::to_string(100 * inside / tried) + " %";
  throw Input_error("These centerlines belong to another geometry, or are in other units: " + share +
                    " of their length lies inside the surface; the centerlines span " + to_string(box) +
                    ", the surface " + to_string(CGAL::Polygon_mesh_processing::bbox(surface)) + ".");
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CHECK_CENTERLINES_IMPL_H

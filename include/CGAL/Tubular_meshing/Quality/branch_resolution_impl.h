// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_BRANCH_RESOLUTION_IMPL_H
#define CGAL_TUBULAR_MESHING_QUALITY_BRANCH_RESOLUTION_IMPL_H

#include <CGAL/Tubular_meshing/Quality/branch_resolution.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/edges_of.h>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE std::vector<double>
points_per_circumference(const Mixed_mesh& mesh, const Centerline_field& centerlines, std::size_t number_of_branches) {
  std::vector<double> distance(number_of_branches, 0), length(number_of_branches, 0);
  for (const auto& e : internal::edges_of(mesh.triangles, [](int label) { return label == labels::wall; })) {
    const Point_3 &p = mesh.points[e.first], &q = mesh.points[e.second];
    const auto d = centerlines.descriptors(midpoint(p, q));
    distance[d.branch] += d.distance;
    length[d.branch] += internal::norm(internal::Vector_3d(q) - internal::Vector_3d(p));
  }
  std::vector<double> points(number_of_branches, 0);
  for (std::size_t b = 0; b < number_of_branches; ++b)
    if (length[b] > 0)
      points[b] = 2 * CGAL_PI * distance[b] / length[b];
  return points;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUALITY_BRANCH_RESOLUTION_IMPL_H

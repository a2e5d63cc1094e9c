// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_BRANCH_RESOLUTION_IMPL_H
#define CGAL_TUBULAR_MESHING_QUALITY_BRANCH_RESOLUTION_IMPL_H

#include <CGAL/Tubular_meshing/Quality/branch_resolution.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/edges_of.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE std::vector<double> points_per_circumference(const Mixed_mesh& mesh,
                                                                         const Centerline_field& centerlines,
                                                                         std::size_t number_of_branches,
                                                                         int number_of_threads) {
  const auto edges = internal::edges_of(
      mesh.triangles, mesh.points.size(), [](int label) { return label == labels::wall; }, number_of_threads);
  std::vector<std::size_t> branch(edges.size());
  std::vector<double> to_centerline(edges.size());
  internal::for_each_range(edges.size(), number_of_threads, [&](std::size_t first, std::size_t last) {
    std::size_t hint = 0; // edges in order are near each other
    for (std::size_t e = first; e < last; ++e) {
      const auto d = centerlines.descriptors(midpoint(mesh.points[edges[e].first], mesh.points[edges[e].second]), hint);
      branch[e] = d.branch;
      to_centerline[e] = d.distance;
    }
  });
  std::vector<double> distance(number_of_branches, 0), length(number_of_branches, 0);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const internal::Vector_3d p(mesh.points[edges[e].first]), q(mesh.points[edges[e].second]);
    distance[branch[e]] += to_centerline[e];
    length[branch[e]] += internal::norm(q - p);
  }
  std::vector<double> points(number_of_branches, 0);
  for (std::size_t b = 0; b < number_of_branches; ++b)
    if (length[b] > 0)
      points[b] = 2 * CGAL_PI * distance[b] / length[b];
  return points;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUALITY_BRANCH_RESOLUTION_IMPL_H

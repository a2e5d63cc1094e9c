// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_MAKE_QUAD_REPORT_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_MAKE_QUAD_REPORT_H

#include <CGAL/Tubular_meshing/Quads/internal/surface/Quad_piece_mesher.h>
#include <CGAL/Tubular_meshing/Quality/internal/element_measures.h>
#include <CGAL/Tubular_meshing/Surface/Quad_report.h>
#include <CGAL/Tubular_meshing/Surface/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/internal/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Measures the faces of a surface of quads; `kinds` are those of its pieces. */
template <class Point_3>
Quad_report make_quad_report(const Remeshed_surface<Point_3>& result, const std::vector<Quad_piece_kind>& kinds) {
  const auto& surface = result.surface;
  Quad_report report;
  std::vector<int> quads_at(std::size_t(surface.number_of_vertices()), 0);
  double sum = 0;
  for (auto f : surface.faces()) {
    std::vector<Vector_3d> corners;
    for (auto v : surface.vertices_around_face(surface.halfedge(f)))
      corners.emplace_back(surface.point(v));
    const int k = result.patch_of_face[f];
    if (k < 0) {
      ++(corners.size() == 4 ? report.cap_quads : report.cap_triangles);
      for (auto v : surface.vertices_around_face(surface.halfedge(f)))
        quads_at[std::size_t(v)] = 4; // of no concern
      continue;
    }
    ++(kinds[std::size_t(k)] == Quad_piece_kind::grid ? report.structured_quads : report.unstructured_quads);
    const double eta = corners.size() == 4 ? quad_eta({corners[0], corners[1], corners[2], corners[3]}) : 0;
    report.least_eta = (std::min)(report.least_eta, eta);
    sum += eta;
  }
  if (report.wall_quads() > 0)
    report.mean_eta = sum / double(report.wall_quads());
  for (auto v : surface.vertices())
    if (quads_at[std::size_t(v)] == 0 && surface.degree(v) != 4)
      ++report.irregular_vertices;
  report.annular_patches_without_grid =
      std::size_t(std::count(kinds.begin(), kinds.end(), Quad_piece_kind::unstructured_for_grid));
  return report;
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_MAKE_QUAD_REPORT_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_OPTIMIZE_SUBDIVIDED_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_OPTIMIZE_SUBDIVIDED_H

#include <CGAL/Tubular_meshing/Hexahedra/optimize_hexahedra.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Tubular_meshing::internal {

inline std::size_t number_of_hexahedra_below(double quality, const Mixed_mesh& mesh) {
  std::size_t n = 0;
  for (const auto& h : mesh.hexahedra.vertices) {
    std::array<Vector_3d, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
      corners[i] = Vector_3d(mesh.points[h[i]]);
    n += scaled_jacobian<8>(corners) < quality;
  }
  return n;
}

/* Improves hexahedra that have come of tetrahedra and prisms. Layers keep the proportions of their cells, but where these
 * are bad: there quality comes first. */
inline Optimize_hexahedra_report optimize_subdivided(Mixed_mesh& mesh, const Labelled_surface& surface,
                                                     Optimize_hexahedra_options options, bool has_layers) {
  constexpr double bad = 0.2;
  const double tempering = options.tempering, wanted = options.quality_wanted;
  if (has_layers)
    options.tempering = 0;
  const Optimize_hexahedra_report first = optimize_hexahedra(mesh, surface.surface, surface.patch, options);
  if (!has_layers || first.min_scaled_jacobian >= bad)
    return first;
  options.tempering = tempering;
  options.quality_wanted = (std::min)(bad, wanted);
  Optimize_hexahedra_report report = optimize_hexahedra(mesh, surface.surface, surface.patch, options);
  report.min_scaled_jacobian_before = first.min_scaled_jacobian_before;
  report.mean_scaled_jacobian_before = first.mean_scaled_jacobian_before;
  report.inverted_before = first.inverted_before;
  report.below_wanted_before = first.below_wanted_before;
  report.below_wanted = number_of_hexahedra_below(wanted, mesh);
  report.movable_vertices = (std::max)(report.movable_vertices, first.movable_vertices);
  report.sweeps += first.sweeps;
  report.held_vertices += first.held_vertices;
  return report;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_OPTIMIZE_SUBDIVIDED_H

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

/* Of two runs, one after the other. */
inline Optimize_hexahedra_report joined(const Optimize_hexahedra_report& first, Optimize_hexahedra_report second) {
  second.min_scaled_jacobian_before = first.min_scaled_jacobian_before;
  second.mean_scaled_jacobian_before = first.mean_scaled_jacobian_before;
  second.inverted_before = first.inverted_before;
  second.below_wanted_before = first.below_wanted_before;
  second.movable_vertices = (std::max)(second.movable_vertices, first.movable_vertices);
  second.sweeps += first.sweeps;
  second.held_vertices += first.held_vertices;
  return second;
}

/* Improves hexahedra that have come of tetrahedra and prisms. Layers keep the proportions of their cells, but where these
 * are bad: there quality comes first. Elsewhere the worst cells get other proportions than all others: those that they have
 * come to, in more sweeps, as the shape of a corner is all that counts there. */
inline Optimize_hexahedra_report optimize_subdivided(Mixed_mesh& mesh, const Labelled_surface& surface,
                                                     Optimize_hexahedra_options options, bool has_layers) {
  const double bad = has_layers ? 0.2 : 0.35;
  const int most_rounds = has_layers ? 1 : 2, more_sweeps = 5;
  const double tempering = options.tempering, wanted = options.quality_wanted;
  const auto optimize = [&] { return optimize_hexahedra(mesh, surface.surface, surface.patch, options); };
  if (has_layers)
    options.tempering = 0;
  Optimize_hexahedra_report report = optimize();
  options.tempering = has_layers ? tempering : 0;
  options.quality_wanted = (std::min)(bad, wanted);
  if (!has_layers)
    options.number_of_sweeps *= more_sweeps;
  for (int round = 0; round < most_rounds && report.min_scaled_jacobian < options.quality_wanted; ++round) {
    report = joined(report, optimize());
    report.below_wanted = number_of_hexahedra_below(wanted, mesh);
  }
  return report;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_OPTIMIZE_SUBDIVIDED_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_PATCHES_IMPL_H
#define CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_PATCHES_IMPL_H

#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher.h>
#include <CGAL/Tubular_meshing/Quads/internal/surface/Quad_piece_mesher.h>
#include <CGAL/Tubular_meshing/Quads/internal/surface/Quad_surface_improver.h>
#include <CGAL/Tubular_meshing/Quads/quadrangulate_patches.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <algorithm>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE void measure_quads(Remeshed_surface& surface) {
  const Wall_quads wall(surface);
  Quad_report& report = surface.quads;
  report.least_eta = 1;
  report.folded_quads = 0;
  double sum = 0;
  for (int q = 0; q < int(wall.mesh.quads.size()); ++q) {
    const Quad_patch::Quad& c = wall.mesh.quad(q);
    const double eta =
        quad_eta({wall.mesh.point(c[0]), wall.mesh.point(c[1]), wall.mesh.point(c[2]), wall.mesh.point(c[3])});
    report.least_eta = (std::min)(report.least_eta, eta);
    sum += eta;
    report.folded_quads += !(wall.mesh.quality(q) > 0);
  }
  report.mean_eta = wall.mesh.quads.empty() ? 1 : sum / double(wall.mesh.quads.size());
}

/* Counts the faces of a surface of quads; `kinds` are those of its pieces. */
inline Quad_report make_quad_report(const Remeshed_surface& result, const std::vector<Quad_piece_kind>& kinds) {
  Quad_report report;
  for (auto f : result.surface.faces())
    if (result.patch_of_face[f] < 0)
      ++(result.surface.degree(f) == 4 ? report.cap_quads : report.cap_triangles);

  const Wall_quads wall(result);
  for (int q = 0; q < int(wall.mesh.quads.size()); ++q) {
    const bool is_of_grid = kinds[wall.patch_of_quad[std::size_t(q)]] == Quad_piece_kind::grid;
    ++(is_of_grid ? report.structured_quads : report.unstructured_quads);
  }
  for (int v = int(wall.mesh.on_loops); v < int(wall.mesh.places.size()); ++v)
    report.irregular_vertices += wall.mesh.valence(v) != 4;
  report.annular_patches_without_grid =
      std::size_t(std::count(kinds.begin(), kinds.end(), Quad_piece_kind::unstructured_for_grid));
  return report;
}

CGAL_TUBULAR_MESHING_INLINE Remeshed_surface quadrangulate_patches(const Surface& surface, const Surface_cut& cut,
                                                                   const std::vector<Patch_parameterization>& maps,
                                                                   Length_function size,
                                                                   const Quadrangulate_patches_options& options) {
  return quadrangulate_patches(surface, cut, maps, size, options, {});
}

CGAL_TUBULAR_MESHING_INLINE Remeshed_surface
quadrangulate_patches(const Surface& surface, const Surface_cut& cut, const std::vector<Patch_parameterization>& maps,
                      Length_function size, const Quadrangulate_patches_options& options,
                      const std::vector<std::vector<Curve_position>>& given) {
  Quad_piece_mesher mesher(surface, cut, maps, size, options.quad_caps, options.number_of_threads, given);
  Remeshed_surface result = mesh_by_pieces(mesher);
  result.quads = make_quad_report(result, mesher.kinds());
  measure_quads(result);
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_PATCHES_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_QUAD_REPORT_H
#define CGAL_TUBULAR_MESHING_PATCHES_QUAD_REPORT_H

#include <cstddef>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPatches
 *
 * The quads of a surface: how they were made, and how good those of the wall are.
 */
struct Quad_report {
  std::size_t structured_quads = 0;             ///< of grids on annular patches
  std::size_t unstructured_quads = 0;           ///< of the wall's other patches
  std::size_t cap_quads = 0;                    ///< of caps
  std::size_t cap_triangles = 0;                ///< of caps
  std::size_t irregular_vertices = 0;           ///< of the wall, its rims left out: those of other than four quads
  std::size_t annular_patches_without_grid = 0; ///< whose grids had bad or folded cells: unstructured
  std::size_t folded_quads = 0; ///< with a corner that turns the other way than the surface: 0 unless it is folded
  double least_eta = 1;         ///< the least \f$ \eta_q \f$ (14) of the wall's quads
  double mean_eta = 1;          ///< its mean

  std::size_t wall_quads() const { return structured_quads + unstructured_quads; }
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_QUAD_REPORT_H

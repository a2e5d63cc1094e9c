// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_REMESHED_SURFACE_H
#define CGAL_TUBULAR_MESHING_PATCHES_REMESHED_SURFACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Patches/Patch_report.h>

#include <cstddef>
#include <vector>

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

/*! \ingroup PkgTubularMeshingPatches
 *
 * A closed surface in new triangles or quads, turned outward, with the labels of its patches: `labels::wall`, or the
 * label of an opening.
 */
struct Remeshed_surface : Labelled_surface {
  Face_patch_map patch_of_face; ///< the number of the patch of the cut, −1 on caps: property map `f:surface_patch`
  std::vector<std::vector<Surface::Vertex_index>> curves; ///< the vertices on each curve of the cut, in order
  std::vector<Metric_tensor_3> metrics;                   ///< of the vertices, if it was made by a metric; else empty
  Patch_report report;                                    ///< on the patches that it was meshed by
  Quad_report quads;                                      ///< on its quads, if it has some

  Remeshed_surface() {
    patch_of_face = surface.add_property_map<Surface::Face_index, int>("f:surface_patch", -1).first;
  }
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_REMESHED_SURFACE_H

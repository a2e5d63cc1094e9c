// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_REMESHED_SURFACE_H
#define CGAL_TUBULAR_MESHING_PATCHES_REMESHED_SURFACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Patches/Patch_report.h>
#include <CGAL/Tubular_meshing/Patches/Quad_report.h>

#include <vector>

namespace CGAL::Tubular_meshing {

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

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_REMESHED_SURFACE_H
#define CGAL_TUBULAR_MESHING_PATCHES_REMESHED_SURFACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Patches/Patch_report.h>
#include <CGAL/Tubular_meshing/Patches/Quad_report.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Surface_mesh.h>

#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * A closed surface in new triangles or quads, with the labels of its patches.
 */
struct Remeshed_surface {
  typedef Tubular_meshing::Point_3 Point_3;
  typedef CGAL::Surface_mesh<Point_3> Surface;
  typedef typename Surface::template Property_map<typename Surface::Face_index, int> Face_map;

  Surface surface;        ///< closed, turned outward
  Face_map patch;         ///< `labels::wall`, or the label of an opening: property map `f:patch` of the surface
  Face_map patch_of_face; ///< the number of the patch of the cut, −1 on caps: property map `f:surface_patch`
  std::vector<std::vector<typename Surface::Vertex_index>> curves; ///< the vertices on each curve of the cut, in order
  std::vector<Metric_tensor_3> metrics; ///< of the vertices, if it was made by a metric; else empty
  Patch_report report;                  ///< on the patches that it was meshed by
  Quad_report quads;                    ///< on its quads, if it has some

  Remeshed_surface() {
    patch = surface.add_property_map<typename Surface::Face_index, int>("f:patch", labels::wall).first;
    patch_of_face = surface.add_property_map<typename Surface::Face_index, int>("f:surface_patch", -1).first;
  }
  Remeshed_surface(const Remeshed_surface&) = delete; // the maps refer to the surface's own properties
  Remeshed_surface& operator=(const Remeshed_surface&) = delete;
  Remeshed_surface(Remeshed_surface&&) = default;
  Remeshed_surface& operator=(Remeshed_surface&&) = default;
};

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_REMESHED_SURFACE_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_LABELLED_SURFACE_H
#define CGAL_TUBULAR_MESHING_BASE_LABELLED_SURFACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingBase
 *
 * A surface and the label of each of its faces (see labels.h), kept together. It moves, and is not copied: the map is
 * one of the surface's own properties.
 */
struct Labelled_surface {
  Surface surface;
  Face_patch_map patch; ///< the property map `f:patch` of the surface

  Labelled_surface() { patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first; }
  explicit Labelled_surface(const Surface& s)
      : surface(s) {
    patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
  }
  Labelled_surface(const Labelled_surface&) = delete;
  Labelled_surface& operator=(const Labelled_surface&) = delete;
  Labelled_surface(Labelled_surface&&) = default;
  Labelled_surface& operator=(Labelled_surface&&) = default;
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_LABELLED_SURFACE_H

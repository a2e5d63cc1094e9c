// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_KEEPING_BOUNDARY_IMPL_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_KEEPING_BOUNDARY_IMPL_H

#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/fill_by_recovery.h>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE void fill_keeping_boundary(const Surface& surface, Face_patch_map patch,
                                                       Length_function size, Mixed_mesh& mesh,
                                                       const Fill_keeping_boundary_options& options) {
  const Boundary_recovery recovery = recovery_by(options.volume_mesher);
  const Filling_limits limits(options, surface, "use fill_with_mesh_3(), which makes the surface anew");
  const std::optional<Sentence> failure = fill_by_recovery(surface, patch, size, recovery, limits, mesh);
  if (failure)
    throw Meshing_error(*failure);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_KEEPING_BOUNDARY_IMPL_H

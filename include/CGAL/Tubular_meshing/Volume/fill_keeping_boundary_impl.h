// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_KEEPING_BOUNDARY_IMPL_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_KEEPING_BOUNDARY_IMPL_H

#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Filled_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/optimize_inside.h>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE void fill_keeping_boundary(const Surface& surface, Face_patch_map patch,
                                                       Length_function size, Mixed_mesh& mesh,
                                                       const Fill_keeping_boundary_options& options,
                                                       Function_view<void()> before_optimization) {
  const Boundary_recovery recovery = recovery_by(options.volume_mesher);
  const Filling_limits limits(options, surface, "use fill_with_mesh_3(), which makes the surface anew");
  Filled_surface filling;
  const std::optional<Sentence> failure = filling.fill(surface, patch, size, recovery, limits);
  if (failure)
    throw Meshing_error(*failure);
  before_optimization();
  if (options.optimization_passes > 0)
    optimize_inside(filling.tetrahedra(), options.optimization_passes, options.number_of_threads);
  filling.write_to(mesh);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_KEEPING_BOUNDARY_IMPL_H

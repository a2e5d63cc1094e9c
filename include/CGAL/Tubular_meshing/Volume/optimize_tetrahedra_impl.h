// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_IMPL_H
#define CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_IMPL_H

#include <CGAL/Tubular_meshing/Volume/internal/Deviation_reducer.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/optimize_inside.h>
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra.h>

namespace CGAL::Tubular_meshing::internal {

inline void optimize_with_surface(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch, int passes,
                                  int threads) {
  const Patch_projection projection(surface, patch);
  Tetrahedron_store store(mesh, threads);
  const Surface_flip_guard guard(store, projection);
  const auto move_vertices = [&](int pass) {
    Vertex_optimizer<Patch_projection> vertices(store, projection, threads);
    vertices.sweep();
    vertices.sweep();
    if (pass + 1 == passes)
      Deviation_reducer(surface, patch, store, vertices, threads).run();
  };
  optimize_in_passes(store, guard, passes, threads, move_vertices, [] {});
  store.write_to(mesh);
}

CGAL_TUBULAR_MESHING_INLINE void optimize_tetrahedra(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch,
                                                     const Optimize_tetrahedra_options& options) {
  if (!options.keep_boundary)
    return optimize_with_surface(mesh, surface, patch, options.optimization_passes, options.number_of_threads);
  Tetrahedron_store store(mesh, options.number_of_threads);
  optimize_inside(store, options.optimization_passes, options.number_of_threads);
  store.write_inside_to(mesh);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_IMPL_H

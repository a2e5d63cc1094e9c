// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_IMPL_H
#define CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_IMPL_H

#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_remesher.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL::Tubular_meshing::internal {

/* All work is done on a copy: `mesh` is as it was until the end. `make_projection(store)` gives the surface on which
 * the vertices of the boundary stay. */
template <class MakeProjection>
void remesh_to_metric(Mixed_mesh& mesh, Metric_function metric, const MakeProjection& make_projection,
                      const Anisotropic_tetrahedral_remeshing_options& options) {
  if (options.number_of_threads < 0)
    throw Parameter_error("number_of_threads is negative; pass the number of threads, or 0 for all cores.");
  check_mesh_to_remesh(mesh, options.number_of_threads);
  std::unique_ptr<Tetrahedron_store> store(new Tetrahedron_store(mesh, options.number_of_threads));
  const Patch_projection projection(make_projection(*store));
  Metric_mesh metric_mesh(*store, metric, projection, options.keep_boundary, options.boundary_layer_patches,
                          options.number_of_threads);
  Metric_remesher(metric_mesh).run();
  metric_mesh.renumber();
  const std::vector<Metric_tensor_3> metrics = metric_mesh.take_metrics();

  Mixed_mesh result;
  const auto number = store->write_to(result);
  store.reset();
  Point_array array{metric_array_name, 6, std::vector<double>(6 * result.points.size())};
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != Tetrahedron_store::none) {
      const auto components = metrics[v].components();
      std::copy(components.begin(), components.end(), array.values.begin() + 6 * std::ptrdiff_t(number[v]));
    }
  mesh.points.swap(result.points);
  std::swap(mesh.tetrahedra, result.tetrahedra);
  std::swap(mesh.triangles, result.triangles);
  mesh.point_arrays.assign(1, std::move(array));
}

CGAL_TUBULAR_MESHING_INLINE void
anisotropic_tetrahedral_remeshing(Mixed_mesh& mesh, Metric_function metric,
                                  const Anisotropic_tetrahedral_remeshing_options& options) {
  remesh_to_metric(
      mesh, metric, [](const Tetrahedron_store& store) { return Patch_projection(store); }, options);
}

CGAL_TUBULAR_MESHING_INLINE void
anisotropic_tetrahedral_remeshing(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch,
                                  Metric_function metric, const Anisotropic_tetrahedral_remeshing_options& options) {
  remesh_to_metric(
      mesh, metric, [&](const Tetrahedron_store&) { return Patch_projection(surface, patch); }, options);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_IMPL_H

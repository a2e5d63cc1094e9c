// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_H
#define CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_H

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_remesher.h>
#include <CGAL/Tubular_meshing/parameters.h>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// A user's field, as the remesher asks it.
template <class Point, class MetricField> struct Metric_at_vector {
  const MetricField& field;
  Metric_tensor_3 operator()(const Vector_3d& p) const { return field(Point(p.x, p.y, p.z)); }
};

template <class Point, class MetricField>
void remesh_to_metric(Mixed_mesh<Point>& mesh, const MetricField& metric, bool keep_boundary, int threads) {
  Tetrahedron_store store(mesh);
  const Patch_projection projection(store);
  const Metric_at_vector<Point, MetricField> field{metric};
  Metric_mesh<Metric_at_vector<Point, MetricField>> metric_mesh(store, field, projection, keep_boundary, threads);
  Metric_remesher<Metric_at_vector<Point, MetricField>>(metric_mesh).run();
  metric_mesh.renumber();
  store.write_to(mesh);
}

} // namespace internal

template <class Point, class MetricField, class NamedParameters = CGAL::parameters::Default_named_parameters>
void anisotropic_tetrahedral_remeshing(Mixed_mesh<Point>& mesh, const MetricField& metric,
                                       const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::remesh_to_metric(mesh, metric, false, internal::choose(np, internal_np::number_of_threads, 0));
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_H

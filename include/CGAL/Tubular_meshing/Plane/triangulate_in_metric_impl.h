// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_IN_METRIC_IMPL_H
#define CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_IN_METRIC_IMPL_H

#include <CGAL/Tubular_meshing/Plane/triangulate_in_metric.h>
#include <CGAL/Tubular_meshing/Plane/internal/Frontal_delaunay.h>
#include <CGAL/Tubular_meshing/Plane/internal/Plane_size_control.h>
#include <CGAL/Tubular_meshing/Plane/internal/Plane_smoothing.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_polygons.h>
#include <CGAL/Tubular_meshing/base/config.h>

namespace CGAL::Tubular_meshing::internal {

// The points that the caller wants, into the few triangles that there are yet. One on the boundary, or outside, is
// none.
inline void insert_given_points(Metric_plane& plane, const std::vector<Plane_point>& points) {
  Point_insertion insertion(plane);
  for (const Plane_point& p : points) {
    const auto place = insertion.find(p);
    if (place.half_edge != Plane_store::none)
      insertion.insert(place, plane.node_at(p));
  }
}

// Points from the front inwards; again, where edges turn out to be too long after all.
inline void insert_points(Metric_plane& plane, const std::vector<Plane_point>& given) {
  const int most_rounds = 4;
  Plane_flips(plane).make_delaunay();
  insert_given_points(plane, given);
  Plane_size_control sizes(plane);
  std::size_t added = 1;
  for (int round = 0; round < most_rounds && added > 0; ++round) {
    Frontal_delaunay(plane).run();
    added = sizes.split_long_edges();
  }
}

inline void optimize_plane(Metric_plane& plane, int passes) {
  const int sweeps = 3;
  Plane_flips flips(plane);
  Plane_size_control sizes(plane);
  for (int pass = 0; pass < passes; ++pass) {
    sizes.remove_crowded_vertices();
    flips.improve();
    Plane_smoothing smoothing(plane);
    for (int k = 0; k < sweeps; ++k)
      smoothing.sweep();
    flips.improve();
  }
}

CGAL_TUBULAR_MESHING_INLINE std::optional<Plane_triangulation<Plane_point>>
mesh_plane(const Plane_polygons& polygons, Plane_field metric, const Plane_embedding* embedding,
           const std::vector<Plane_point>& interior_points, const Triangulate_in_metric_options& options,
           std::string& problem) {
  if (options.optimization_passes < 0)
    throw Parameter_error("The number of optimization passes must not be negative, but is " +
                          std::to_string(options.optimization_passes) + ".");
  std::optional<Plane_store> store = triangulate_polygons(polygons, problem);
  if (!store)
    return std::nullopt;
  Metric_plane plane(*std::move(store), polygons, metric, embedding);
  insert_points(plane, interior_points);
  optimize_plane(plane, options.optimization_passes);
  return plane.triangulation();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_IN_METRIC_IMPL_H

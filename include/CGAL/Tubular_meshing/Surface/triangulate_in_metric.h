// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_SURFACE_TRIANGULATE_IN_METRIC_H
#define CGAL_TUBULAR_MESHING_SURFACE_TRIANGULATE_IN_METRIC_H

#include <CGAL/Tubular_meshing/Surface/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Surface/internal/plane/Frontal_delaunay.h>
#include <CGAL/Tubular_meshing/Surface/internal/plane/Metric_plane.h>
#include <CGAL/Tubular_meshing/Surface/internal/plane/Plane_flips.h>
#include <CGAL/Tubular_meshing/Surface/internal/plane/Plane_size_control.h>
#include <CGAL/Tubular_meshing/Surface/internal/plane/Plane_smoothing.h>
#include <CGAL/Tubular_meshing/Surface/internal/plane/triangulate_polygons.h>
#include <CGAL/Tubular_meshing/exceptions.h>
#include <CGAL/Tubular_meshing/parameters.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

template <class Point_2> struct Plane_triangulation {
  std::vector<Point_2> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

namespace internal {

// Points from the front inwards, again where edges turn out to be long after all.
template <class Plane> void insert_points(Plane& plane) {
  Plane_flips<Plane>(plane).make_delaunay();
  Plane_size_control<Plane> sizes(plane);
  std::size_t added = 1;
  for (int round = 0; round < 8 && added > 0; ++round) {
    Frontal_delaunay<Plane>(plane).run();
    added = sizes.split_long_edges();
  }
}

template <class Plane> void optimize_plane(Plane& plane, int passes) {
  Plane_flips<Plane> flips(plane);
  Plane_size_control<Plane> sizes(plane);
  for (int pass = 0; pass < passes; ++pass) {
    sizes.remove_crowded_vertices();
    flips.improve();
    Plane_smoothing<Plane> smoothing(plane);
    for (int k = 0; k < 3; ++k)
      smoothing.sweep();
    flips.improve();
  }
}

template <class Point_2, class Plane> Plane_triangulation<Point_2> triangulation_of(const Plane& plane) {
  Plane_triangulation<Point_2> result;
  std::vector<std::size_t> number(plane.nodes.size());
  for (Plane_store::Index v = 0; v < plane.nodes.size(); ++v)
    if (plane.store.is_vertex_alive(v)) {
      number[v] = result.points.size();
      result.points.emplace_back(plane.nodes[v].point.x(), plane.nodes[v].point.y());
    }
  for (Plane_store::Index t = 0; t < plane.store.number_of_triangles(); ++t)
    if (plane.store.is_alive(t))
      result.triangles.push_back({number[plane.store.origin(3 * t)], number[plane.store.origin(3 * t + 1)],
                                  number[plane.store.origin(3 * t + 2)]});
  return result;
}

} // namespace internal

template <class PolygonRange, class Metric_field, class NamedParameters = CGAL::parameters::Default_named_parameters>
auto triangulate_in_metric(const PolygonRange& polygons, const Metric_field& metric,
                           const NamedParameters& np = CGAL::parameters::default_values()) {
  typedef typename std::decay<decltype(*std::begin(*std::begin(polygons)))>::type Point_2;
  const auto embedding = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, internal_np::embedding), internal::No_embedding());
  typedef internal::Metric_plane<Metric_field, typename std::decay<decltype(embedding)>::type> Plane;
  internal::Plane_polygons rings;
  for (const auto& polygon : polygons) {
    rings.emplace_back();
    for (const auto& p : polygon)
      rings.back().emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  }
  Plane plane(internal::Polygon_triangulator(rings).store(), rings, metric, embedding);
  internal::insert_points(plane);
  internal::optimize_plane(plane, internal::choose(np, internal_np::optimization_passes, 2));
  return internal::triangulation_of<Point_2>(plane);
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_SURFACE_TRIANGULATE_IN_METRIC_H

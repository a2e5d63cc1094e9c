// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_FLATTEN_SPIKES_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_FLATTEN_SPIKES_H

#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Whether a vertex alone stands far out of the ring of its neighbours, or into it: further than these are apart. What is
 * the corner of a crease between long triangles is none. */
inline bool is_spike(const std::vector<Point_3>& ring, const Point_3& center, const Point_3& p) {
  Vector_3 normal(0, 0, 0);
  double longest = 0, total = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point_3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    normal = normal + CGAL::cross_product(a - center, b - center);
    longest = (std::max)(longest, point_distance(a, b));
    total += point_distance(a, b);
  }
  const double length = std::sqrt(normal.squared_length());
  if (!(length > 0))
    return false;
  const double height = std::abs((p - center) * normal) / length;
  return height > 0.75 * total / double(ring.size()) && height > 0.6 * longest;
}

/* Moves single vertices that stick out of a closed surface, or into it, among their neighbours, so that they do not set
 * the radius of the lumen; of several next to each other, one after the other. The surface is meant to be a copy, to
 * look at. Linear in its size. */
inline void flatten_spikes(Surface& mesh) {
  std::vector<Point_3> ring;
  for (int sweep = 0; sweep < 2; ++sweep)
    for (Vertex v : mesh.vertices()) {
      ring.clear();
      Vector_3 sum(0, 0, 0);
      for (Vertex w : CGAL::vertices_around_target(mesh.halfedge(v), mesh)) {
        ring.push_back(mesh.point(w));
        sum = sum + (ring.back() - ring.front());
      }
      const Point_3 center = ring.front() + sum / double(ring.size());
      if (ring.size() > 2 && is_spike(ring, center, mesh.point(v)))
        mesh.point(v) = center;
    }
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_FLATTEN_SPIKES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_FIND_SPIKES_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_FIND_SPIKES_H

#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <cmath>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Which vertices are further from the plane of their neighbours than these are from their middle. */
inline std::vector<char> find_spikes(const Indexed_wall& wall) {
  typedef Indexed_wall::Index Index;
  const double as_far = 1 + 1e-9; // what is as far but for rounding is so in any place, unit and direction
  std::vector<char> is_spike(wall.number_of_vertices(), 0);
  std::vector<Vector_3d> area(wall.number_of_vertices());
  for (const auto& t : wall.triangles())
    for (int k = 0; k < 3; ++k) // what the opposite edges enclose, seen from any point of their plane
      area[t[k]] += cross(wall.point(t[(k + 1) % 3]) - wall.point(t[k]), wall.point(t[(k + 2) % 3]) - wall.point(t[k]));
  for (Index v = 0; v < wall.number_of_vertices(); ++v) {
    const double n = double(wall.neighbors_end(v) - wall.neighbors_begin(v));
    if (n < 3)
      continue;
    Vector_3d middle;
    for (const Index* w = wall.neighbors_begin(v); w != wall.neighbors_end(v); ++w)
      middle += (1 / n) * wall.point(*w);
    double apart = 0;
    for (const Index* w = wall.neighbors_begin(v); w != wall.neighbors_end(v); ++w)
      apart += norm(wall.point(*w) - middle) / n;
    const Vector_3d d = wall.point(v) - middle;
    is_spike[v] =
        wall.is_on_rim(v) ? norm(d) > as_far * 1.5 * apart : std::abs(dot(d, normalized(area[v]))) > as_far * apart;
  }
  return is_spike;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_FIND_SPIKES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_TUBE_ENDS_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_TUBE_ENDS_H

#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/Rims/flat_ends.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <algorithm>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline std::vector<Opening_site> flat_ends(const Surface& mesh) {
  return Flat_end_finder(mesh, false).find(certain_flat_end());
}

inline void append_shapes(const std::vector<Opening_site>& sites, std::vector<Rim_shape>& ends) {
  for (const auto& site : sites)
    ends.push_back(site.shape);
}

/* Whether the end of a tube is where, and as wide as, another was. */
inline bool is_same_end(const Rim_shape& a, const Rim_shape& b) {
  return point_distance(a.center, b.center) < 0.5 * b.radius && a.radius > 0.6 * b.radius &&
         b.radius > 0.6 * a.radius && a.plane.normal() * b.plane.normal() > 0.5;
}

/* The first of the ends that is not among others; null if there is none. O(k^2) for k ends. */
inline const Rim_shape* first_not_among(const std::vector<Rim_shape>& ends, const std::vector<Rim_shape>& others) {
  for (const auto& end : ends)
    if (std::none_of(others.begin(), others.end(), [&](const auto& other) { return is_same_end(other, end); }))
      return &end;
  return nullptr;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_TUBE_ENDS_H

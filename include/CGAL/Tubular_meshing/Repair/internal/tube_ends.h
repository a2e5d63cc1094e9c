// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_TUBE_ENDS_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_TUBE_ENDS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/flat_ends.h>
#include <CGAL/Tubular_meshing/Repair/internal/drop_islands.h>


#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Where a tube ends, and how. */
struct Tube_end {
  Point_3 center;
  Vector_3 normal; ///< unit, out of the lumen
  double radius = 0, reach = 0, sag = 0;
  bool is_open = true; ///< else there is a flat cap
};

inline Tube_end tube_end(const Opening_site& site) {
  Tube_end end;
  end.center = site.shape.center;
  end.normal = site.shape.plane.normal();
  end.radius = site.shape.radius;
  end.reach = site.shape.reach;
  end.sag = site.shape.sag;
  end.is_open = site.is_open();
  return end;
}

inline void append_ends(const std::vector<Opening_site>& sites, std::vector<Tube_end>& ends) {
  for (const auto& site : sites)
    ends.push_back(tube_end(site));
}

inline std::vector<Opening_site> flat_ends(const Surface& mesh) {
  return Flat_end_finder(mesh, false).find(certain_flat_end());
}

/* Whether an end is where, and as wide as, another was. */
inline bool is_same_end(const Tube_end& a, const Tube_end& b) {
  return point_distance(a.center, b.center) < 0.5 * b.radius && a.radius > 0.6 * b.radius &&
         b.radius > 0.6 * a.radius && a.normal * b.normal > 0.5;
}

/* The first of the ends that is not among others; null if there is none. O(k^2) for k ends. */
inline const Tube_end* first_not_among(const std::vector<Tube_end>& ends, const std::vector<Tube_end>& others) {
  for (const auto& end : ends)
    if (std::none_of(others.begin(), others.end(), [&](const auto& other) { return is_same_end(other, end); }))
      return &end;
  return nullptr;
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_TUBE_ENDS_H

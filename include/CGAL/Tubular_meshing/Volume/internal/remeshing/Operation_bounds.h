// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_OPERATION_BOUNDS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_OPERATION_BOUNDS_H

#include <algorithm>

namespace CGAL::Tubular_meshing::internal {

/* What a split or a collapse has to keep to: the worst quality of its cavity, and the lengths of the new edges. By
 * itself it allows what makes the worst quality no worse. */
struct Operation_bounds {
  double quality_floor = 1;  // a cavity may become as bad as this,
  double quality_factor = 1; // or as bad as this times what it was
  double shortest = 0;       // of the new edges
  double longest = 1e300;
  double urgent_floor = 1; // the same where it is urgent: neither may be passed
  double urgent_factor = 1;

  bool allow(double before, double after) const {
    return after >= (std::min)(quality_floor, quality_factor * before) ||
           (after >= urgent_floor && after >= urgent_factor * before);
  }

  Operation_bounds& quality(double floor, double factor) {
    quality_floor = floor;
    quality_factor = factor;
    return *this;
  }
  Operation_bounds& lengths(double from, double to) {
    shortest = from;
    longest = to;
    return *this;
  }
  Operation_bounds& urgent_quality(double floor, double factor) {
    urgent_floor = floor;
    urgent_factor = factor;
    return *this;
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_OPERATION_BOUNDS_H

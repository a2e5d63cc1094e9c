// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_REMESHING_SCHEDULE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_REMESHING_SCHEDULE_H

#include <algorithm>
#include <cmath>

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

/* How the remesher goes about it: what is done how often, from which quality on, and what each operation has to keep
 * to. Lengths are those of the metric, where they should be one; qualities are those of (16), inverted: one is best.
 */
struct Remeshing_schedule {
  static constexpr double sqrt_2 = 1.4142135623730951;

  // Ratios of sizes that are brought about at once, and how many elements are left to those above.
  static constexpr double ratio_at_once = 32;
  static constexpr double negligible_share = 0.1;

  /* Sizes: edges longer than √2 of the unit at hand are split, those shorter than 1/√2 of it collapsed. The coarse one is
   * somewhat above 2, since coarse elements, of poorer shapes, are more than the metric asks for. */
  static constexpr double coarse_unit = 2.1;
  static constexpr int most_rounds_at_full_size = 6;
  static constexpr double few_splits = 0.15;   // of the number of vertices: the last round of them
  static constexpr double longest_first = 0.6; // a round of splits goes down to this part of the longest edge
  static constexpr int most_rounds_of_collapses = 20;

  // Shapes: rounds of relocations and flips.
  static constexpr int rounds_with_limited_ratio = 3;
  static constexpr int rounds_of_improvement = 5; // one less after refinement
  static constexpr int rounds_while_coarse = 4;
  static constexpr double poor = 0.2, few_poor = 0.05; // the quality, and the share, of what may be refined at once
  static constexpr int rounds_with_splits = 2;         // the first ones
  static constexpr int rounds_of_repair = 3;
  static constexpr int most_rounds_of_last_repair = 6; // while there is something to repair

  // The qualities below which tetrahedra are flipped, and repaired.
  static constexpr double flipped_after_splits = 0.5;
  static constexpr double flipped_while_adapting = 0.5;
  static constexpr double flipped_while_improving = 0.75;
  static constexpr double flipped_at_the_end = 0.8;
  static constexpr double repaired = 0.3;
  static constexpr double repaired_at_last = 0.35;

  // The mean volumes of tetrahedra, over the regular one's, at which vertices are too many or too few, and the edges
  // that are collapsed or split there.
  static constexpr double dense = 0.9, longest_collapsed = 0.8;
  static constexpr double sparse = 1.08, shortest_split = 1.2;

  /* Bad shapes may be split and collapsed as long as it does not make them much worse. Where an edge is many times too
   * long, that it goes comes first, even if short ones come of it; but a bound there must be, as halves of bad shapes
   * would be worse without end. */
  static Operation_bounds split(double unit, double length) {
    const double excess = (std::max)(1., length / (sqrt_2 * unit));
    return Operation_bounds()
        .quality(0.2, 0.8)
        .lengths(0.6 * unit * (std::min)(1., 2 / excess), 1e300)
        .urgent_quality(0.002, 0.8 / std::sqrt(excess));
  }
  static Operation_bounds collapse(double unit) {
    return Operation_bounds().quality(0.2, 0.8).lengths(0, sqrt_2 * unit);
  }
  static Operation_bounds collapse_where_dense(double unit) {
    return Operation_bounds().quality(0.15, 0.5).lengths(0, 1.75 * unit);
  }
  static Operation_bounds split_where_sparse(double unit) {
    return Operation_bounds().quality(0.25, 0.8).lengths(0.6 * unit, 1e300);
  }
  // The worst quality must get better.
  static Operation_bounds repair() { return Operation_bounds().quality(1, 1.1).lengths(0.4, 2); }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_REMESHING_SCHEDULE_H

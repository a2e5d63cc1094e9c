// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_TUBE_DIVIDER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_TUBE_DIVIDER_H

#include <CGAL/Tubular_meshing/Patches/internal/cut/Disk_cutter.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Divides tubes that are too long for their width (the second half of Algorithm 2): into as many parts, equally long in
 * local diameters, as it takes. A disk that cannot be cut at its place, or that runs into a sac there, moves along the
 * branch. */
class Tube_divider {
public:
  Tube_divider(Disk_cutter& cutter, double aspect_ratio)
      : cutter_(cutter)
      , aspect_ratio_(aspect_ratio) {}

  size_type number_of_moved() const { return moved_; }

  // Divides what is between a branch's cuts and ends; not the parts that belong to junctions.
  void divide(size_type branch) {
    const auto& b = cutter_.graph().branches()[branch];
    std::vector<double> places;
    if (cutter_.graph().nodes()[b.source].is_end())
      places.push_back(0);
    for (size_type c : cutter_.cuts_of(branch))
      places.push_back(cutter_.abscissa_of(c));
    if (cutter_.graph().nodes()[b.target].is_end())
      places.push_back(b.length);
    for (size_type i = 0; i + 1 < places.size(); ++i)
      divide(branch, places[i], places[i + 1]);
  }

private:
  static constexpr double margin = 0.9;           // parts this much shorter than allowed: disks may have to move
  static constexpr double price_of_a_step = 0.04; // what a disk must be narrower by to be worth it

  void divide(size_type branch, double from, double to) {
    const Branch_curve axis = cutter_.axis(branch);
    const double eta = axis.aspect_ratio(from, to);
    if (eta <= aspect_ratio_)
      return;
    const double parts = std::ceil(eta / (margin * aspect_ratio_)), first_parts = std::floor(parts / 2);
    const double wanted = axis.division(from, to, first_parts / parts);
    const Disk disk = disk_near(branch, wanted, from, to);
    if (!disk.is_cuttable() || !cutter_.cut(branch, disk))
      return;
    divide(branch, from, disk.abscissa);
    divide(branch, disk.abscissa, to);
  }

  // A cuttable disk near the place wanted: the narrowest within a radius, if any, or the nearest.
  Disk disk_near(size_type branch, double wanted, double from, double to) {
    const Branch_curve axis = cutter_.axis(branch);
    const double step = 0.2 * axis.radius(wanted), least_part = (std::min)(axis.radius(wanted), (to - from) / 4);
    const double first = from + least_part, last = to - least_part;
    Disk best;
    int best_steps = 0;
    double best_cost = (std::numeric_limits<double>::infinity)();
    const auto consider = [&](int steps) {
      const double s = wanted + steps * step;
      if (s < first || s > last)
        return;
      const Disk disk = cutter_.probe(branch, s);
      const double cost = disk.perimeter * (1 + price_of_a_step * std::abs(steps));
      if (cost < best_cost) {
        best = disk;
        best_steps = steps;
        best_cost = cost;
      }
    };
    const int steps_of_a_radius = 5;
    for (int steps = 0; !best.is_cuttable() || steps <= steps_of_a_radius; ++steps) {
      if (wanted + steps * step > last && wanted - steps * step < first)
        break;
      consider(steps);
      if (steps > 0)
        consider(-steps);
    }
    if (!best.is_cuttable())
      best = cutter_.probe_tilted(branch, wanted);
    if (best.is_cuttable() && (best.tilt != 0 || std::abs(best_steps) > steps_of_a_radius))
      ++moved_;
    return best;
  }

  Disk_cutter& cutter_;
  const double aspect_ratio_;
  size_type moved_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_TUBE_DIVIDER_H

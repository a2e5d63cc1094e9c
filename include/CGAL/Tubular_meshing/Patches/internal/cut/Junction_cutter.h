// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_JUNCTION_CUTTER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_JUNCTION_CUTTER_H

#include <CGAL/Tubular_meshing/Patches/internal/cut/Disk_cutter.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Cuts branches off their junctions (the first half of Algorithm 2).
 *
 * The paper's disk at the bifurcation itself would run over into the other branches. A branch's own tube begins about
 * where its centerline leaves the ball inscribed at the bifurcation; there the search begins, and takes the first disk
 * whose perimeter is hardly greater than those of the disks behind it: before, the disk widens into the junction. */
class Junction_cutter {
public:
  // `clearance`: how much farther from junctions than they need be disks are, in radii, where the branch is long enough.
  explicit Junction_cutter(Disk_cutter& cutter, double clearance)
      : cutter_(cutter)
      , graph_(cutter.graph())
      , clearance_(clearance) {}

  const std::vector<size_type>& merged() const { return merged_; } // too short to be cut off, or no disk closes
  size_type number_of_moved() const { return moved_; }

  // Cuts one branch off the junctions that it joins.
  void cut_off(size_type branch) {
    const Branch_curve axis = cutter_.axis(branch);
    const auto& b = graph_.branches()[branch];
    const bool at_source = is_junction(b.source), at_target = is_junction(b.target);
    if (!at_source && !at_target)
      return;
    const double from = at_source ? axis.exit(true, outside * radius_at(b.source)) : axis.radius(0);
    const double to =
        axis.length() - (at_target ? axis.exit(false, outside * radius_at(b.target)) : axis.radius(axis.length()));
    const bool is_cut =
        from <= to ? cut_in_range(branch, from, to, at_source, at_target) : at_source && at_target && cut_short(branch);
    if (!is_cut)
      merged_.push_back(branch);
  }

private:
  static constexpr double outside = 0.8;        // of a bifurcation's radius, away from it
  static constexpr double step = 0.15;          // of the local radius, from try to try
  static constexpr double hardly_greater = 1.1; // than the least perimeter behind
  static constexpr double round = 1.8;          // a section's perimeter over its inscribed circle's

  // A closed curve's one node counts as well: there it is cut open.
  bool is_junction(size_type node) const { return !graph_.nodes()[node].is_end(); }
  double radius_at(size_type node) const { return graph_.radii()[graph_.nodes()[node].point]; }

  bool cut_in_range(size_type branch, double from, double to, bool at_source, bool at_target) {
    const Disk first = at_source ? nearest_good_disk(branch, from, to) : Disk();
    const Disk last = at_target ? nearest_good_disk(branch, to, from) : Disk();
    if (!first.is_cuttable() && !last.is_cuttable())
      return cut_tilted(branch, from, to);
    if (!first.is_cuttable() || !last.is_cuttable())
      return cutter_.cut(branch, (std::min)(first, last));
    const Branch_curve axis = cutter_.axis(branch);
    const double gap = (axis.radius(first.abscissa) + axis.radius(last.abscissa)) / 2;
    if (last.abscissa - first.abscissa < gap)
      return cutter_.cut(branch, (std::min)(first, last));
    const bool is_cut = cutter_.cut(branch, first);
    return cut_again(branch, last, first.abscissa + gap, to) || is_cut;
  }

  // The other end's disk may have become impossible by the first one's cut, if triangles are large.
  bool cut_again(size_type branch, const Disk& disk, double from, double to) {
    if (cutter_.cut(branch, disk))
      return true;
    const Disk other = nearest_good_disk(branch, to, from);
    ++moved_;
    return other.is_cuttable() && cutter_.cut(branch, other);
  }

  /* The first disk on the way from one abscissa to another that is hardly wider than all those within its own radius
   * behind it. */
  Disk nearest_good_disk(size_type branch, double from, double to) {
    const Branch_curve axis = cutter_.axis(branch);
    const double direction = to >= from ? 1 : -1, length = std::abs(to - from);
    std::vector<Disk> disks;
    std::vector<double> way;
    const auto probe_next = [&] {
      const double w = way.empty() ? 0
                                   : way.back() + (std::max)(step * axis.radius(from + direction * way.back()),
                                                             1e-3 * axis.length());
      if (w > length)
        return false;
      way.push_back(w);
      disks.push_back(cutter_.probe(branch, from + direction * w));
      return true;
    };
    for (size_type i = 0; i < disks.size() || probe_next(); ++i) {
      if (!disks[i].is_cuttable())
        continue;
      const double end = way[i] + disks[i].perimeter / (2 * CGAL_PI);
      while (way.back() < end && probe_next()) {
      }
      Disk least = disks[i];
      for (size_type j = i + 1; j < disks.size() && way[j] <= end; ++j)
        least = (std::min)(least, disks[j]);
      if (disks[i].perimeter <= hardly_greater * least.perimeter)
        return farther(branch, disks[i], from, to);
    }
    return Disk();
  }

  // A disk that is farther on the way, by the clearance if there is a disk and the way is so long, or by a part of it.
  Disk farther(size_type branch, const Disk& disk, double from, double to) {
    constexpr double most = 0.4; // of the way: there may be a cut at its other end
    const double way = disk.abscissa - from, room = most * std::abs(to - from) - std::abs(way);
    const double wanted = (std::min)(clearance_ * disk.perimeter / (2 * CGAL_PI), room);
    for (double part = 1; wanted > 0 && part > 0.2; part -= 0.25) {
      const Disk result = cutter_.probe(branch, disk.abscissa + (to >= from ? part : -part) * wanted);
      if (result.is_cuttable() && result.perimeter <= hardly_greater * disk.perimeter)
        return result;
    }
    return disk;
  }

  // Where no disk across the branch closes, one that is tilted may.
  bool cut_tilted(size_type branch, double from, double to) {
    const int places = 5;
    Disk best;
    for (int i = 0; i < places; ++i)
      best = (std::min)(best, cutter_.probe_tilted(branch, from + (to - from) * i / (places - 1)));
    if (!best.is_cuttable() || cutter_.roundness(branch, best) > round)
      return false;
    ++moved_;
    return cutter_.cut(branch, best);
  }

  // Between bifurcations so close that there is no tube of the branch's own, one cut may part them yet.
  bool cut_short(size_type branch) {
    const auto& b = graph_.branches()[branch];
    const Branch_curve axis = cutter_.axis(branch);
    const double from = axis.exit(true, outside / 2 * radius_at(b.source));
    const double to = axis.length() - axis.exit(false, outside / 2 * radius_at(b.target));
    if (from > to)
      return false;
    const int places = 5;
    Disk best;
    for (int i = 0; i < places; ++i)
      best = (std::min)(best, cutter_.probe(branch, from + (to - from) * i / (places - 1)));
    if (best.is_cuttable() && cutter_.roundness(branch, best) <= round)
      return cutter_.cut(branch, best);
    return cut_tilted(branch, from, to);
  }

  Disk_cutter& cutter_;
  const Centerline_graph& graph_;
  const double clearance_;
  std::vector<size_type> merged_;
  size_type moved_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_JUNCTION_CUTTER_H

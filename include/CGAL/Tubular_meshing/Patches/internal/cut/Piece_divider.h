// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_PIECE_DIVIDER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_PIECE_DIVIDER_H

#include <CGAL/Tubular_meshing/Patches/internal/cut/Disk_cutter.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Graph_pieces.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Tube_divider.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* What Algorithm 2 leaves undone where branches stayed uncut: cycles of centerlines inside one piece are cut open, and
 * pieces around bifurcations that are too long are divided. */
class Piece_divider {
public:
  Piece_divider(Disk_cutter& cutter, Tube_divider& tubes, double aspect_ratio)
      : cutter_(cutter)
      , graph_(cutter.graph())
      , tubes_(tubes)
      , aspect_ratio_(aspect_ratio) {}

  size_type number_of_cuts() const { return cuts_; }

  /* Two cuts open a cycle so that no piece lies on both sides of one. O(n log n) in the branches. */
  void open_cycles() {
    std::vector<size_type> branches(graph_.branches().size());
    std::iota(branches.begin(), branches.end(), 0);
    // Uncut ones first, short ones first: the branch that closes a cycle is then one with room for a cut.
    std::stable_sort(branches.begin(), branches.end(), [this](size_type a, size_type b) {
      return std::make_pair(cutter_.cuts_of(a).size(), graph_.branches()[a].length) <
             std::make_pair(cutter_.cuts_of(b).size(), graph_.branches()[b].length);
    });
    boost::disjoint_sets_with_storage<> pieces(graph_.nodes().size());
    for (size_type b : branches) {
      const auto& branch = graph_.branches()[b];
      if (cutter_.cuts_of(b).size() >= 2)
        break;
      const size_type source = pieces.find_set(branch.source), target = pieces.find_set(branch.target);
      if (source != target && cutter_.cuts_of(b).empty()) {
        pieces.link(source, target);
      } else if (source == target) {
        while (cutter_.cuts_of(b).size() < 2 && cut_somewhere(b)) {
        }
        tubes_.divide(b);
      }
    }
  }

  // Divides the pieces around nodes until their aspect ratios are right.
  void divide_long_pieces() {
    Piece_finder finder(cutter_);
    std::vector<bool> done(graph_.nodes().size(), false);
    std::vector<size_type> stack(graph_.nodes().size());
    std::iota(stack.rbegin(), stack.rend(), 0);
    while (!stack.empty()) {
      const size_type node = stack.back();
      stack.pop_back();
      if (done[node])
        continue;
      const Graph_piece piece = finder.piece_at(node);
      const size_type branch = piece.aspect_ratio() > aspect_ratio_ ? cut_midway(piece) : none;
      if (branch == none) {
        for (size_type n : piece.nodes)
          done[n] = true;
      } else {
        tubes_.divide(branch);
        stack.push_back(graph_.branches()[branch].target);
        stack.push_back(graph_.branches()[branch].source);
      }
    }
  }

private:
  static constexpr size_type none = (std::numeric_limits<size_type>::max)();
  static constexpr double round = 2.5; // a section's perimeter over its inscribed circle's, at most
  static constexpr double step = 0.25; // radii

  struct Place {
    size_type branch;
    double abscissa, order;
  };

  // The first of the places, in their order, where a disk can be cut, off the cuts there are.
  size_type cut_at_first(std::vector<Place>& places) {
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.order < b.order; });
    for (int tilted = 0; tilted < 2; ++tilted)
      for (const Place& p : places) {
        const Disk disk = tilted ? cutter_.probe_tilted(p.branch, p.abscissa) : cutter_.probe(p.branch, p.abscissa);
        if (disk.is_cuttable() && cutter_.roundness(p.branch, disk) <= round && cutter_.cut(p.branch, disk)) {
          ++cuts_;
          return p.branch;
        }
      }
    return none;
  }

  // Every so often between two abscissae, half a radius away from them.
  template <class Order>
  void add_places(size_type branch, double from, double to, const Order& order, std::vector<Place>& places) const {
    const Branch_curve axis = cutter_.axis(branch);
    const double first = from + 0.5 * axis.radius(from), last = to - 0.5 * axis.radius(to);
    for (double s = first; s <= last; s += (std::max)(step * axis.radius(s), 1e-3 * axis.length()))
      places.push_back(Place{branch, s, order(s)});
  }

  // As far as possible from the branch's cut, if there is one, and from its ends.
  bool cut_somewhere(size_type branch) {
    const double length = graph_.branches()[branch].length;
    std::vector<Place> places;
    std::vector<double> limits(1, 0);
    for (size_type c : cutter_.cuts_of(branch))
      limits.push_back(cutter_.abscissa_of(c));
    limits.push_back(length);
    for (size_type i = 0; i + 1 < limits.size(); ++i)
      add_places(
          branch, limits[i], limits[i + 1], [&](double s) { return -(std::min)(s - limits[i], limits[i + 1] - s); },
          places);
    return cut_at_first(places) != none;
  }

  // As near as possible to the middle of its longest way.
  size_type cut_midway(const Graph_piece& piece) {
    std::vector<Place> places;
    double before = 0;
    for (size_type i = 0; i < piece.longest_way.size(); ++i) {
      const Branch_part& p = piece.longest_way[i];
      // parts follow each other at nodes: which end comes first does not matter for a part at either end of the way
      const bool reversed = is_reversed(piece.longest_way, i);
      add_places(
          p.branch, p.from, p.to,
          [&](double s) { return std::abs(before + (reversed ? p.to - s : s - p.from) - piece.length / 2); }, places);
      before += p.length();
    }
    return cut_at_first(places);
  }

  // Whether the way leads through its part against the branch's direction.
  bool is_reversed(const std::vector<Branch_part>& way, size_type i) const {
    const auto& b = graph_.branches()[way[i].branch];
    const bool has_source = way[i].from == 0, has_target = way[i].to == b.length;
    const auto touches = [&](size_type node, size_type j) {
      const auto& other = graph_.branches()[way[j].branch];
      return (way[j].from == 0 && other.source == node) || (way[j].to == other.length && other.target == node);
    };
    if (i + 1 < way.size())
      return has_source && touches(b.source, i + 1) && !(has_target && touches(b.target, i + 1));
    return i > 0 && has_target && touches(b.target, i - 1) && !(has_source && touches(b.source, i - 1));
  }

  Disk_cutter& cutter_;
  const Centerline_graph& graph_;
  Tube_divider& tubes_;
  const double aspect_ratio_;
  size_type cuts_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_PIECE_DIVIDER_H

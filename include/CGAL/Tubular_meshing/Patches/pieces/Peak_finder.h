// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_PEAK_FINDER_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_PEAK_FINDER_H

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The vertices inside a triangulation at which a function peaks, at `prominence` times or more the highest pass on the
 * way to a higher peak, or to the border. By union-find over the vertices in descending order: O(n log n).
 *
 * A blind vessel shrinks in the plane, to a spot that edges around may step over: its peak of the metric's density
 * tells where it is. */
class Peak_finder {
public:
  Peak_finder(const std::vector<double>& height, const std::vector<std::array<int, 3>>& triangles,
              const std::vector<std::vector<int>>& border)
      : height_(height)
      , components_(height.size())
      , peak_(height.size())
      , is_known_(height.size(), 0) {
    std::iota(peak_.begin(), peak_.end(), 0);
    for (const auto& loop : border)
      for (int v : loop)
        is_known_[std::size_t(v)] = 1;
    for (const auto& t : triangles)
      for (std::size_t i = 0; i < 3; ++i)
        passes_.emplace_back(t[i], t[(i + 1) % 3]);
    std::sort(passes_.begin(), passes_.end(),
              [&](const Pass& a, const Pass& b) { return std::make_pair(level(b), b) < std::make_pair(level(a), a); });
  }

  std::vector<int> find(double prominence) {
    std::vector<int> found;
    const auto look_at = [&](std::size_t c, double pass) {
      if (is_known_[c] || height_[std::size_t(peak_[c])] < prominence * pass)
        return;
      found.push_back(peak_[c]);
      is_known_[c] = 1;
    };
    for (const Pass& p : passes_) {
      const std::size_t a = components_.find_set(std::size_t(p.first));
      const std::size_t b = components_.find_set(std::size_t(p.second));
      if (a == b)
        continue;
      look_at(a, level(p));
      look_at(b, level(p));
      join(a, b);
    }
    return found;
  }

private:
  typedef std::pair<int, int> Pass;

  double level(const Pass& p) const {
    return (std::min)(height_[std::size_t(p.first)], height_[std::size_t(p.second)]);
  }
  // The higher peak stands for both.
  void join(std::size_t a, std::size_t b) {
    const int peak = height_[std::size_t(peak_[a])] < height_[std::size_t(peak_[b])] ? peak_[b] : peak_[a];
    const char is_known = char(is_known_[a] | is_known_[b]);
    components_.link(a, b);
    const std::size_t both = components_.find_set(a);
    peak_[both] = peak;
    is_known_[both] = is_known;
  }

  const std::vector<double>& height_;
  boost::disjoint_sets_with_storage<> components_;
  std::vector<int> peak_;      // of each component
  std::vector<char> is_known_; // of components: they reach the border, or have a peak that was found
  std::vector<Pass> passes_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_PEAK_FINDER_H

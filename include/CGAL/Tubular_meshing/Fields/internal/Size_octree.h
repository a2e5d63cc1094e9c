// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_SIZE_OCTREE_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_SIZE_OCTREE_H

#include <CGAL/Tubular_meshing/Fields/internal/Corner_octree.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A positive function on space, sampled at the corners of an octree that is as fine as the function asks for, limited
 * in its growth, and interpolated. A query costs a descent through the tree (about 0.1 µs) instead of a search for the
 * nearest wall and the nearest centerline (about 5 µs), which is what makes it fit for a mesher's inner loop.
 *
 * Building: O(n log n) in the number n of leaves, each corner sampled once.
 */
class Size_octree {
public:
  typedef Corner_octree::Position Position;

  /* `need`: see Corner_octree; `size(Position)`, at most `largest`, is wanted inside of the domain only, and grows from
   * there outside. Both are safe to call from several threads. |size(x) - size(y)| <= slope |x - y| along the tree's
   * edges. */
  Size_octree(const Bbox_3& box, Function_view<Corner_octree::Need(const Position&, double reach)> need,
              Function_view<double(const Position&)> size, double largest, double slope, int threads)
      : tree_(box, need, threads)
      , values_(tree_.number_of_corners(), largest) {
    tree_.for_each_corner_at_domain([&](std::size_t i, const Position& x) { values_[i] = size(x); }, threads);
    limit_growth(slope, threads);
    tree_.release_corners();
  }

  double operator()(double x, double y, double z) const {
    const Corner_octree::Place at = tree_.locate(x, y, z);
    const double u = at.t[0], v = at.t[1], t = at.t[2];
    const std::uint32_t* c = at.corners;
    const auto along_x = [&](int i) { return values_[c[i]] + u * (values_[c[i + 1]] - values_[c[i]]); };
    const double y0 = along_x(0) + v * (along_x(2) - along_x(0));
    const double y1 = along_x(4) + v * (along_x(6) - along_x(4));
    return y0 + t * (y1 - y0);
  }

  /* The integral of 1 / size³ over the leaves whose center lies in the domain. */
  double number_of_cubes() const {
    double sum = 0;
    for (const auto& leaf : tree_.leaves_in_domain()) {
      double size = 0;
      for (int c = 0; c < 8; ++c)
        size += values_[tree_.leaf_corners()[8 * std::size_t(leaf.first) + c]] / 8;
      sum += std::pow(leaf.second / size, 3);
    }
    return sum;
  }

  std::size_t number_of_leaves() const { return tree_.number_of_leaves(); }
  std::size_t number_of_samples() const { return values_.size(); }

private:
  // The leaves at each corner, in one array: those of corner i are from first[i] to first[i + 1].
  struct Leaves_of_corners {
    std::vector<std::uint32_t> first, leaves;
  };

  Leaves_of_corners leaves_of_corners() const {
    Leaves_of_corners result;
    result.first.assign(tree_.number_of_corners() + 1, 0);
    for (std::uint32_t corner : tree_.leaf_corners())
      ++result.first[corner + 1];
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
    result.leaves.resize(tree_.leaf_corners().size());
    for (std::size_t i = 0; i < tree_.leaf_corners().size(); ++i)
      result.leaves[next[tree_.leaf_corners()[i]]++] = std::uint32_t(i / 8);
    return result;
  }

  // Calls lower(q, bound) for each neighbour q of a corner whose value is above what the corner's value allows.
  template <class Lower>
  void for_each_too_large(std::uint32_t corner, double slope, const Leaves_of_corners& around,
                          const Lower& lower) const {
    const double value = values_[corner];
    for (std::uint32_t k = around.first[corner]; k < around.first[corner + 1]; ++k)
      for (int c = 0; c < 8; ++c) {
        const std::uint32_t q = tree_.leaf_corners()[8 * std::size_t(around.leaves[k]) + c];
        if (!(value < values_[q]))
          continue;
        const double bound = bound_by(corner, q, slope);
        if (bound < values_[q])
          lower(q, bound);
      }
  }

  /* Gives corners away from the domain what those next to them allow, on all threads: most of them have their values
   * then, before the queue of one thread begins. */
  void grow_from_domain(double slope, const Leaves_of_corners& around, int threads) {
    const int layers = 2;
    std::vector<double> grown;
    for (int layer = 0; layer < layers; ++layer) {
      grown = values_;
      for_each_range(values_.size(), threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          if (!tree_.is_at_domain(i))
            grown[i] = largest_allowed(std::uint32_t(i), slope, around);
      });
      values_.swap(grown);
    }
  }

  // At a corner: by the values of those that it shares leaves with.
  double largest_allowed(std::uint32_t corner, double slope, const Leaves_of_corners& around) const {
    double result = values_[corner];
    for (std::uint32_t k = around.first[corner]; k < around.first[corner + 1]; ++k)
      for (int c = 0; c < 8; ++c) {
        const std::uint32_t q = tree_.leaf_corners()[8 * std::size_t(around.leaves[k]) + c];
        if (values_[q] < result)
          result = (std::min)(result, bound_by(q, corner, slope));
      }
    return result;
  }

  // What corner p allows at corner q.
  double bound_by(std::uint32_t p, std::uint32_t q, double slope) const {
    return values_[p] + slope * tree_.unit() * lattice_distance(tree_.corners()[p], tree_.corners()[q]);
  }

  // Dijkstra's algorithm from all corners that limit a neighbour: the smallest sizes spread first.
  void limit_growth(double slope, int threads) {
    const Leaves_of_corners around = leaves_of_corners();
    grow_from_domain(slope, around, threads);
    typedef std::pair<double, std::uint32_t> Entry;
    std::vector<char> limits(values_.size(), 0);
    for_each_range(values_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        for_each_too_large(std::uint32_t(i), slope, around, [&](std::uint32_t, double) { limits[i] = 1; });
    });
    std::vector<Entry> initial;
    for (std::uint32_t i = 0; i < values_.size(); ++i)
      if (limits[i])
        initial.emplace_back(values_[i], i);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue(std::greater<Entry>(),
                                                                              std::move(initial));
    while (!queue.empty()) {
      const Entry e = queue.top();
      queue.pop();
      if (e.first > values_[e.second])
        continue;
      for_each_too_large(e.second, slope, around, [&](std::uint32_t q, double bound) {
        values_[q] = bound;
        queue.emplace(bound, q);
      });
    }
  }

  static double lattice_distance(const Corner_octree::Lattice_point& a, const Corner_octree::Lattice_point& b) {
    const double x = double(a[0]) - b[0], y = double(a[1]) - b[1], z = double(a[2]) - b[2];
    return std::sqrt(x * x + y * y + z * z);
  }

  Corner_octree tree_;
  std::vector<double> values_; // one a corner
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_SIZE_OCTREE_H

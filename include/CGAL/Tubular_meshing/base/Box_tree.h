// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_BOX_TREE_H
#define CGAL_TUBULAR_MESHING_BASE_BOX_TREE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Boxes around items, numbered from 0 on, in a tree: of D dimensions, of sizes that may be of very different orders.
 * Unlike in CGAL's AABB tree, on which Nearest_tree is built, items may lie in the plane, a search may pass over some as
 * the caller pleases, and pairs with overlapping boxes are found in one descent. It splits in another order: of items
 * equally near, either would find others. Built in O(n log n). */
template <std::size_t D> class Box_tree {
public:
  typedef std::uint32_t Index;
  typedef std::array<double, D> Place;

  // That of nothing, to begin with.
  struct Box {
    Place low, high;

    Box() {
      low.fill((std::numeric_limits<double>::infinity)());
      high.fill(-(std::numeric_limits<double>::infinity)());
    }
    void add(const Place& p) {
      for (std::size_t i = 0; i < D; ++i) {
        low[i] = (std::min)(low[i], p[i]);
        high[i] = (std::max)(high[i], p[i]);
      }
    }
    bool overlaps(const Box& b) const {
      for (std::size_t i = 0; i < D; ++i)
        if (low[i] > b.high[i] || b.low[i] > high[i])
          return false;
      return true;
    }
    double squared_distance(const Place& p) const {
      double d2 = 0;
      for (std::size_t i = 0; i < D; ++i) {
        const double d = (std::max)({low[i] - p[i], p[i] - high[i], 0.});
        d2 += d * d;
      }
      return d2;
    }
  };

  Box_tree() = default;
  // `centers`: of the items, by which they are parted.
  Box_tree(std::vector<Box> boxes, const std::vector<Place>& centers)
      : boxes_(std::move(boxes))
      , order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), Index(0));
    nodes_.reserve(boxes_.size());
    if (!boxes_.empty())
      build(centers, 0, Index(boxes_.size()));
  }

  const Box& box(Index item) const { return boxes_[item]; }

  // Calls visit(item) for the items in boxes that are closer to q than the bound, which it may lower; nearer boxes first.
  template <class Visit> void visit_near(const Place& q, const double& squared_bound, const Visit& visit) const {
    if (!nodes_.empty())
      visit_within(0, q, squared_bound, visit);
  }

  // Calls visit(item) for the items in boxes that overlap the given one.
  template <class Visit> void for_each_overlapping(const Box& box, const Visit& visit) const {
    if (!nodes_.empty())
      visit_overlapping(0, box, visit);
  }

  // Calls visit(s, t) with s < t for each two items with overlapping boxes.
  template <class Visit> void for_each_overlap(const Visit& visit) const {
    if (!nodes_.empty())
      overlaps_within(0, visit);
  }

private:
  static constexpr Index leaf_size = 4;

  struct Node {
    Box box;
    Index first, last;  // in order_
    Index second_child; // 0 for a leaf; the first child comes right after its parent
  };

  Index build(const std::vector<Place>& centers, Index first, Index last) {
    const Index index = Index(nodes_.size());
    nodes_.push_back({Box(), first, last, 0});
    Box box, middles;
    for (Index k = first; k < last; ++k) {
      box.add(boxes_[order_[k]].low);
      box.add(boxes_[order_[k]].high);
      middles.add(centers[order_[k]]);
    }
    nodes_[index].box = box;
    if (last - first > leaf_size) {
      std::size_t axis = 0;
      for (std::size_t i = 1; i < D; ++i)
        if (middles.high[i] - middles.low[i] > middles.high[axis] - middles.low[axis])
          axis = i;
      const Index middle = (first + last) / 2;
      std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](Index a, Index b) {
        const double x = centers[a][axis], y = centers[b][axis];
        return x < y || (x == y && a < b);
      });
      build(centers, first, middle);
      const Index second = build(centers, middle, last);
      nodes_[index].second_child = second;
    }
    return index;
  }

  template <class Visit>
  void visit_within(Index n, const Place& q, const double& squared_bound, const Visit& visit) const {
    const Node& node = nodes_[n];
    if (node.second_child == 0) {
      for (Index k = node.first; k < node.last && squared_bound > 0; ++k)
        visit(order_[k]);
      return;
    }
    const Index children[2] = {n + 1, node.second_child};
    const double d[2] = {nodes_[children[0]].box.squared_distance(q), nodes_[children[1]].box.squared_distance(q)};
    const int nearer = d[1] < d[0];
    for (int k : {nearer, 1 - nearer})
      if (d[k] < squared_bound)
        visit_within(children[k], q, squared_bound, visit);
  }

  template <class Visit> void visit_overlapping(Index n, const Box& box, const Visit& visit) const {
    const Node& node = nodes_[n];
    if (!node.box.overlaps(box))
      return;
    if (node.second_child != 0) {
      visit_overlapping(n + 1, box, visit);
      visit_overlapping(node.second_child, box, visit);
      return;
    }
    for (Index k = node.first; k < node.last; ++k)
      if (boxes_[order_[k]].overlaps(box))
        visit(order_[k]);
  }

  template <class Visit> void overlaps_within(Index n, const Visit& visit) const {
    const Node& node = nodes_[n];
    if (node.second_child == 0) {
      for (Index i = node.first; i < node.last; ++i)
        for (Index j = i + 1; j < node.last; ++j)
          meet(order_[i], order_[j], visit);
      return;
    }
    overlaps_within(n + 1, visit);
    overlaps_within(node.second_child, visit);
    overlaps_between(n + 1, node.second_child, visit);
  }

  template <class Visit> void overlaps_between(Index m, Index n, const Visit& visit) const {
    const Node &a = nodes_[m], &b = nodes_[n];
    if (!a.box.overlaps(b.box))
      return;
    if (a.second_child == 0 && b.second_child == 0) {
      for (Index i = a.first; i < a.last; ++i)
        for (Index j = b.first; j < b.last; ++j)
          meet(order_[i], order_[j], visit);
    } else if (b.second_child == 0 || (a.second_child != 0 && a.last - a.first >= b.last - b.first)) {
      overlaps_between(m + 1, n, visit);
      overlaps_between(a.second_child, n, visit);
    } else {
      overlaps_between(m, n + 1, visit);
      overlaps_between(m, b.second_child, visit);
    }
  }

  template <class Visit> void meet(Index s, Index t, const Visit& visit) const {
    if (boxes_[s].overlaps(boxes_[t]))
      visit((std::min)(s, t), (std::max)(s, t));
  }

  std::vector<Box> boxes_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_BOX_TREE_H

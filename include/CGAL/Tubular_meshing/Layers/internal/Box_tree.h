// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_BOX_TREE_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_BOX_TREE_H

#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Triangles in a tree of boxes. Unlike CGAL's AABB tree, a search may pass over triangles as the caller pleases, and
 * pairs of triangles with overlapping boxes are found in one descent. Nearest_tree is that AABB tree, which splits in
 * another order: of triangles equally near, it would find others. Built in O(n log n). */
class Box_tree {
public:
  typedef std::uint32_t Index;
  typedef std::array<Index, 3> Triangle;

  struct Box {
    std::array<double, 3> low, high;

    static Box empty() {
      const double inf = (std::numeric_limits<double>::infinity)();
      return {{inf, inf, inf}, {-inf, -inf, -inf}};
    }
    void add(const Vector_3d& p) {
      for (int i = 0; i < 3; ++i) {
        low[i] = (std::min)(low[i], p[i]);
        high[i] = (std::max)(high[i], p[i]);
      }
    }
    void add(const Box& b) {
      for (int i = 0; i < 3; ++i) {
        low[i] = (std::min)(low[i], b.low[i]);
        high[i] = (std::max)(high[i], b.high[i]);
      }
    }
    bool overlaps(const Box& b) const {
      return low[0] <= b.high[0] && b.low[0] <= high[0] && low[1] <= b.high[1] && b.low[1] <= high[1] &&
             low[2] <= b.high[2] && b.low[2] <= high[2];
    }
    double squared_distance(const Vector_3d& p) const {
      double d2 = 0;
      for (int i = 0; i < 3; ++i) {
        const double d = (std::max)({low[i] - p[i], p[i] - high[i], 0.});
        d2 += d * d;
      }
      return d2;
    }
  };

  struct Nearest {
    Index triangle; // none, if there is none within the bound
    Vector_3d point;
    double squared_distance;
  };
  static constexpr Index none = Index(-1);

  Box_tree(const std::vector<Vector_3d>& points, const std::vector<Triangle>& triangles)
      : points_(points)
      , triangles_(triangles)
      , order_(triangles.size())
      , boxes_(triangles.size()) {
    std::iota(order_.begin(), order_.end(), Index(0));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      boxes_[t] = Box::empty();
      for (Index v : triangles[t])
        boxes_[t].add(points[v]);
    }
    if (!triangles.empty())
      build(0, Index(triangles.size()));
  }

  // The nearest point of the triangles t with `accepts(t)` that are closer than the bound.
  template <class Accepts> Nearest nearest(const Vector_3d& q, double squared_bound, const Accepts& accepts) const {
    Nearest best{none, q, squared_bound};
    if (!nodes_.empty())
      search(0, q, accepts, best);
    return best;
  }

  // Calls visit(s, t) with s < t for each two triangles with overlapping boxes.
  template <class Visitor> void for_each_overlap(const Visitor& visit) const {
    if (!nodes_.empty())
      overlaps_within(0, visit);
  }

private:
  static constexpr Index leaf_size = 4;

  struct Node {
    Box box;
    Index first, last;  // in order_
    Index second_child; // none for a leaf; the first child comes right after its parent
  };

  Index build(Index first, Index last) {
    const Index index = Index(nodes_.size());
    nodes_.push_back({Box::empty(), first, last, none});
    Box box = Box::empty(), centers = Box::empty();
    for (Index k = first; k < last; ++k) {
      box.add(boxes_[order_[k]]);
      centers.add(center(order_[k]));
    }
    nodes_[index].box = box;
    if (last - first > leaf_size) {
      int axis = 0;
      for (int i = 1; i < 3; ++i)
        if (centers.high[i] - centers.low[i] > centers.high[axis] - centers.low[axis])
          axis = i;
      const Index middle = (first + last) / 2;
      std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](Index a, Index b) {
        const double x = boxes_[a].low[axis] + boxes_[a].high[axis], y = boxes_[b].low[axis] + boxes_[b].high[axis];
        return x < y || (x == y && a < b);
      });
      build(first, middle);
      const Index second = build(middle, last);
      nodes_[index].second_child = second;
    }
    return index;
  }

  Vector_3d center(Index t) const {
    const Box& b = boxes_[t];
    return {(b.low[0] + b.high[0]) / 2, (b.low[1] + b.high[1]) / 2, (b.low[2] + b.high[2]) / 2};
  }

  template <class Accepts> void search(Index n, const Vector_3d& q, const Accepts& accepts, Nearest& best) const {
    const Node& node = nodes_[n];
    if (node.second_child == none) {
      for (Index k = node.first; k < node.last; ++k) {
        const Index t = order_[k];
        if (boxes_[t].squared_distance(q) >= best.squared_distance || !accepts(t))
          continue;
        const Vector_3d p = nearest_point(triangles_[t], q);
        const double d2 = squared_norm(p - q);
        if (d2 < best.squared_distance)
          best = {t, p, d2};
      }
      return;
    }
    const Index children[2] = {n + 1, node.second_child};
    const double d[2] = {nodes_[children[0]].box.squared_distance(q), nodes_[children[1]].box.squared_distance(q)};
    const int nearer = d[1] < d[0];
    for (int k : {nearer, 1 - nearer})
      if (d[k] < best.squared_distance)
        search(children[k], q, accepts, best);
  }

  // By the part of the plane that q is over: C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
  Vector_3d nearest_point(const Triangle& t, const Vector_3d& q) const {
    const Vector_3d &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
    const Vector_3d ab = b - a, ac = c - a, aq = q - a, bq = q - b, cq = q - c;
    const double d1 = dot(ab, aq), d2 = dot(ac, aq), d3 = dot(ab, bq), d4 = dot(ac, bq), d5 = dot(ab, cq),
                 d6 = dot(ac, cq);
    if (d1 <= 0 && d2 <= 0)
      return a;
    if (d3 >= 0 && d4 <= d3)
      return b;
    if (d6 >= 0 && d5 <= d6)
      return c;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 > 0 && d3 < 0)
      return a + (d1 / (d1 - d3)) * ab;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 > 0 && d6 < 0)
      return a + (d2 / (d2 - d6)) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 > d3 && d5 > d6)
      return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
    const double sum = va + vb + vc;
    return sum > 0 ? a + (vb / sum) * ab + (vc / sum) * ac : a;
  }

  template <class Visitor> void overlaps_within(Index n, const Visitor& visit) const {
    const Node& node = nodes_[n];
    if (node.second_child == none) {
      for (Index i = node.first; i < node.last; ++i)
        for (Index j = i + 1; j < node.last; ++j)
          meet(order_[i], order_[j], visit);
      return;
    }
    overlaps_within(n + 1, visit);
    overlaps_within(node.second_child, visit);
    overlaps_between(n + 1, node.second_child, visit);
  }

  template <class Visitor> void overlaps_between(Index m, Index n, const Visitor& visit) const {
    const Node &a = nodes_[m], &b = nodes_[n];
    if (!a.box.overlaps(b.box))
      return;
    if (a.second_child == none && b.second_child == none) {
      for (Index i = a.first; i < a.last; ++i)
        for (Index j = b.first; j < b.last; ++j)
          meet(order_[i], order_[j], visit);
    } else if (b.second_child == none || (a.second_child != none && a.last - a.first >= b.last - b.first)) {
      overlaps_between(m + 1, n, visit);
      overlaps_between(a.second_child, n, visit);
    } else {
      overlaps_between(m, n + 1, visit);
      overlaps_between(m, b.second_child, visit);
    }
  }

  template <class Visitor> void meet(Index s, Index t, const Visitor& visit) const {
    if (boxes_[s].overlaps(boxes_[t]))
      visit((std::min)(s, t), (std::max)(s, t));
  }

  const std::vector<Vector_3d>& points_;
  const std::vector<Triangle>& triangles_;
  std::vector<Index> order_;
  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_BOX_TREE_H

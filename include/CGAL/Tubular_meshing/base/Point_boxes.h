// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_POINT_BOXES_H
#define CGAL_TUBULAR_MESHING_BASE_POINT_BOXES_H

#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Points in a tree of boxes, for searches of the kind branch and bound. A point carries a value; a box knows the
 * smallest value in it. Built in O(n log n); safe to search from several threads. */
class Point_boxes {
public:
  typedef std::uint32_t Index;

  struct Box {
    Vector_3d low, high;
    double half_diagonal, smallest_value;
    Index first, last;         // its points, in the tree's order
    Index left = 0, right = 0; // its children; 0: it has none

    double squared_distance(const Vector_3d& q) const {
      const double dx = (std::max)((std::max)(low.x - q.x, q.x - high.x), 0.);
      const double dy = (std::max)((std::max)(low.y - q.y, q.y - high.y), 0.);
      const double dz = (std::max)((std::max)(low.z - q.z, q.z - high.z), 0.);
      return dx * dx + dy * dy + dz * dz;
    }
    /* In the norm of the largest coordinate. */
    double distance_of_cubes(const Vector_3d& q) const {
      const double dx = (std::max)(low.x - q.x, q.x - high.x), dy = (std::max)(low.y - q.y, q.y - high.y);
      return (std::max)({dx, dy, (std::max)(low.z - q.z, q.z - high.z), 0.});
    }
  };

  Point_boxes() = default;
  Point_boxes(const std::vector<Vector_3d>& points, const std::vector<double>& values) {
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index(0));
    if (!points.empty())
      build(points, values, order, 0, Index(points.size()));
    points_.reserve(points.size());
    for (Index i : order) {
      points_.push_back(points[i]);
      values_.push_back(values[i]);
    }
  }

  bool empty() const { return points_.empty(); }

  /* Calls visit(point, value) for the points of all boxes that enter(box) says may matter; of two boxes, the one nearer
   * to `start` is the first. */
  template <class Enter, class Visit>
  void search(const Vector_3d& start, const Enter& enter, const Visit& visit) const {
    if (empty())
      return;
    Index stack[128];
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
      const Box& box = boxes_[stack[--size]];
      if (!enter(box))
        continue;
      if (box.left == 0) {
        for (Index i = box.first; i < box.last; ++i)
          visit(points_[i], values_[i]);
        continue;
      }
      const bool left_is_near = boxes_[box.left].squared_distance(start) <= boxes_[box.right].squared_distance(start);
      stack[size++] = left_is_near ? box.right : box.left;
      stack[size++] = left_is_near ? box.left : box.right;
    }
  }

private:
  static constexpr Index leaf_size = 8;

  Index build(const std::vector<Vector_3d>& points, const std::vector<double>& values, std::vector<Index>& order,
              Index first, Index last) {
    const Index result = Index(boxes_.size());
    boxes_.push_back(box_of(points, values, order, first, last));
    if (last - first <= leaf_size)
      return result;
    const Vector_3d extent = boxes_[result].high - boxes_[result].low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const Index middle = (first + last) / 2;
    std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last, [&](Index a, Index b) {
      return std::make_pair(points[a][axis], a) < std::make_pair(points[b][axis], b);
    });
    const Index left = build(points, values, order, first, middle);
    const Index right = build(points, values, order, middle, last);
    boxes_[result].left = left;
    boxes_[result].right = right;
    return result;
  }

  static Box box_of(const std::vector<Vector_3d>& points, const std::vector<double>& values,
                    const std::vector<Index>& order, Index first, Index last) {
    const double infinity = (std::numeric_limits<double>::infinity)();
    Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}, 0, infinity, first, last};
    for (Index i = first; i < last; ++i) {
      const Vector_3d& p = points[order[i]];
      box.low = {(std::min)(box.low.x, p.x), (std::min)(box.low.y, p.y), (std::min)(box.low.z, p.z)};
      box.high = {(std::max)(box.high.x, p.x), (std::max)(box.high.y, p.y), (std::max)(box.high.z, p.z)};
      box.smallest_value = (std::min)(box.smallest_value, values[order[i]]);
    }
    box.half_diagonal = 0.5 * (1 + 1e-12) * norm(box.high - box.low); // no less, whatever was rounded
    return box;
  }

  std::vector<Box> boxes_;
  std::vector<Vector_3d> points_; // in the tree's order
  std::vector<double> values_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_POINT_BOXES_H

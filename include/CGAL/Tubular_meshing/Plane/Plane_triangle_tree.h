// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_PLANE_TRIANGLE_TREE_H
#define CGAL_TUBULAR_MESHING_PLANE_PLANE_TRIANGLE_TREE_H

#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The point of a triangle of the plane that is nearest to a query. */
struct Nearest_in_triangle {
  std::array<double, 3> barycentric{{1, 0, 0}};
  double squared_distance = (std::numeric_limits<double>::infinity)();
};

inline double plane_cross_product(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/* Twice the areas of the triangles that p makes with the sides, each opposite to its corner. */
inline std::array<double, 3> side_areas(const std::array<Eigen::Vector2d, 3>& c, const Eigen::Vector2d& p) {
  return {{plane_cross_product(c[1] - p, c[2] - p), plane_cross_product(c[2] - p, c[0] - p),
           plane_cross_product(c[0] - p, c[1] - p)}};
}

inline Nearest_in_triangle nearest_in_triangle(const std::array<Eigen::Vector2d, 3>& c, const Eigen::Vector2d& p) {
  Nearest_in_triangle best;
  const std::array<double, 3> area = side_areas(c, p);
  const double sum = area[0] + area[1] + area[2];
  if (area[0] >= 0 && area[1] >= 0 && area[2] >= 0 && sum > 0) {
    best.barycentric = {{area[0] / sum, area[1] / sum, area[2] / sum}};
    best.squared_distance = 0;
    return best;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Eigen::Vector2d e = c[j] - c[i];
    const double length = e.squaredNorm();
    const double t = length > 0 ? (std::min)(1., (std::max)(0., e.dot(p - c[i]) / length)) : 0;
    const double d = (c[i] + t * e - p).squaredNorm();
    if (d < best.squared_distance) {
      best.squared_distance = d;
      best.barycentric[i] = 1 - t;
      best.barycentric[j] = t;
      best.barycentric[3 - i - j] = 0;
    }
  }
  return best;
}

/* A tree of boxes over triangles of the plane, whose sizes may be of very different orders. Building it is O(n log n),
 * a query about O(log n). It keeps no coordinates but the boxes'. */
class Plane_triangle_tree {
public:
  typedef std::vector<Eigen::Vector2d> Points;
  typedef std::vector<Patch_triangle> Triangles;

  Plane_triangle_tree() = default;
  Plane_triangle_tree(const Points& uv, const Triangles& triangles)
      : order_(triangles.size()) {
    std::vector<Eigen::Vector2d> centers(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      order_[t] = int(t);
      centers[t] = corners(uv, triangles[t])[0] + corners(uv, triangles[t])[1] + corners(uv, triangles[t])[2];
    }
    nodes_.reserve(triangles.size());
    build(uv, triangles, centers, 0, int(triangles.size()));
  }

  // The triangle with the point nearest to p.
  int nearest(const Points& uv, const Triangles& triangles, const Eigen::Vector2d& p, Nearest_in_triangle& best) const {
    best = Nearest_in_triangle();
    int triangle = order_[0];
    visit(0, uv, triangles, p, best, triangle);
    return triangle;
  }

  static std::array<Eigen::Vector2d, 3> corners(const Points& uv, const Patch_triangle& t) {
    return {{uv[std::size_t(t[0])], uv[std::size_t(t[1])], uv[std::size_t(t[2])]}};
  }

private:
  struct Node {
    Eigen::Array2d low, high;
    int first, last; // in order_, of a leaf
    int right;       // child; the left one is next. 0 for a leaf

    double squared_distance(const Eigen::Vector2d& p) const {
      return (low - p.array()).max(p.array() - high).max(0.).matrix().squaredNorm();
    }
  };

  int build(const Points& uv, const Triangles& triangles, const std::vector<Eigen::Vector2d>& centers, int first,
            int last) {
    const int leaf_size = 4, index = int(nodes_.size());
    const double infinity = (std::numeric_limits<double>::infinity)();
    Node node{Eigen::Array2d::Constant(infinity), Eigen::Array2d::Constant(-infinity), first, last, 0};
    Eigen::Array2d low = node.low, high = node.high; // of centers
    for (int i = first; i < last; ++i) {
      const std::size_t t = std::size_t(order_[std::size_t(i)]);
      for (int v : triangles[t]) {
        node.low = node.low.min(uv[std::size_t(v)].array());
        node.high = node.high.max(uv[std::size_t(v)].array());
      }
      low = low.min(centers[t].array());
      high = high.max(centers[t].array());
    }
    nodes_.push_back(node);
    if (last - first <= leaf_size)
      return index;
    const int axis = high[0] - low[0] >= high[1] - low[1] ? 0 : 1, middle = (first + last) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](int a, int b) {
      const double ca = centers[std::size_t(a)][axis], cb = centers[std::size_t(b)][axis];
      return ca != cb ? ca < cb : a < b;
    });
    build(uv, triangles, centers, first, middle);
    const int right = build(uv, triangles, centers, middle, last);
    nodes_[std::size_t(index)].right = right;
    return index;
  }

  void visit(int index, const Points& uv, const Triangles& triangles, const Eigen::Vector2d& p,
             Nearest_in_triangle& best, int& triangle) const {
    const Node& node = nodes_[std::size_t(index)];
    if (node.right == 0) {
      for (int i = node.first; i < node.last && best.squared_distance > 0; ++i) {
        const int t = order_[std::size_t(i)];
        const Nearest_in_triangle found = nearest_in_triangle(corners(uv, triangles[std::size_t(t)]), p);
        if (found.squared_distance < best.squared_distance) {
          best = found;
          triangle = t;
        }
      }
      return;
    }
    int near = index + 1, far = node.right;
    double to_near = nodes_[std::size_t(near)].squared_distance(p),
           to_far = nodes_[std::size_t(far)].squared_distance(p);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    if (to_near < best.squared_distance)
      visit(near, uv, triangles, p, best, triangle);
    if (to_far < best.squared_distance)
      visit(far, uv, triangles, p, best, triangle);
  }

  std::vector<int> order_;
  std::vector<Node> nodes_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_PLANE_TRIANGLE_TREE_H

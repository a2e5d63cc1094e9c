// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_PLANE_TRIANGLE_TREE_H
#define CGAL_TUBULAR_MESHING_PLANE_PLANE_TRIANGLE_TREE_H

#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>
#include <CGAL/Tubular_meshing/base/Box_tree.h>

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
  Plane_triangle_tree(const Points& uv, const Triangles& triangles) {
    std::vector<Tree::Box> boxes(triangles.size());
    std::vector<Tree::Place> centers(triangles.size()); // three times them
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const std::array<Eigen::Vector2d, 3> c = corners(uv, triangles[t]);
      for (const Eigen::Vector2d& p : c)
        boxes[t].add(place(p));
      centers[t] = place(c[0] + c[1] + c[2]);
    }
    tree_ = Tree(std::move(boxes), centers);
  }

  // The triangle with the point nearest to p.
  int nearest(const Points& uv, const Triangles& triangles, const Eigen::Vector2d& p, Nearest_in_triangle& best) const {
    best = Nearest_in_triangle();
    int triangle = 0;
    tree_.visit_near(place(p), best.squared_distance, [&](Tree::Index t) {
      const Nearest_in_triangle found = nearest_in_triangle(corners(uv, triangles[t]), p);
      if (found.squared_distance < best.squared_distance) {
        best = found;
        triangle = int(t);
      }
    });
    return triangle;
  }

  static std::array<Eigen::Vector2d, 3> corners(const Points& uv, const Patch_triangle& t) {
    return {{uv[std::size_t(t[0])], uv[std::size_t(t[1])], uv[std::size_t(t[2])]}};
  }

private:
  typedef Box_tree<2> Tree;

  static Tree::Place place(const Eigen::Vector2d& p) { return {{p.x(), p.y()}}; }

  Tree tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_PLANE_TRIANGLE_TREE_H

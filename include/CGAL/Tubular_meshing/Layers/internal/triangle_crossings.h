// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_TRIANGLE_CROSSINGS_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_TRIANGLE_CROSSINGS_H

#include <CGAL/Tubular_meshing/Layers/internal/Layer_surface.h>
#include <CGAL/Tubular_meshing/base/Box_tree.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/intersections.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline Box_tree<3> tree_of_triangles(const std::vector<Vector_3d>& points,
                                     const std::vector<Layer_surface::Triangle>& triangles) {
  std::vector<Box_tree<3>::Box> boxes(triangles.size());
  std::vector<Box_tree<3>::Place> centers; // of the boxes, twice them
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Box_tree<3>::Box& b = boxes[t];
    for (Layer_surface::Index v : triangles[t])
      b.add({points[v].x, points[v].y, points[v].z});
    centers.push_back({b.low[0] + b.high[0], b.low[1] + b.high[1], b.low[2] + b.high[2]});
  }
  return Box_tree<3>(std::move(boxes), centers);
}

/* Whether two triangles of a surface, given by the indices of their vertices, meet in more than the vertices and the
 * edge that they share. Exact. */
class Triangle_meeting {
public:
  typedef Layer_surface::Triangle Triangle;

  explicit Triangle_meeting(const std::vector<Vector_3d>& points) {
    points_.reserve(points.size());
    for (const Vector_3d& p : points)
      points_.emplace_back(p.x, p.y, p.z);
  }

  bool operator()(const Triangle& s, const Triangle& t) const {
    int shared = 0, in_s = 0, in_t = 0; // the last shared vertex, and the sum of the places of all
    std::size_t place_s = 0, place_t = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (s[i] == t[j]) {
          ++shared;
          in_s += i;
          in_t += j;
          place_s = std::size_t(i);
          place_t = std::size_t(j);
        }
    if (shared == 0)
      return CGAL::do_intersect(triangle(s), triangle(t));
    if (shared == 1)
      return meet_at_vertex(s, place_s, t, place_t);
    return shared == 3 || folded(s, std::size_t(3 - in_s), t[std::size_t(3 - in_t)]);
  }

private:
  Kernel::Triangle_3 triangle(const Triangle& t) const {
    return Kernel::Triangle_3(points_[t[0]], points_[t[1]], points_[t[2]]);
  }
  CGAL::Orientation side(const Triangle& t, Layer_surface::Index v) const {
    return CGAL::orientation(points_[t[0]], points_[t[1]], points_[t[2]], points_[v]);
  }

  // Each triangle is the fan from the vertex to its opposite edge: they meet if one's edge meets the other.
  bool meet_at_vertex(const Triangle& s, std::size_t i, const Triangle& t, std::size_t j) const {
    const Layer_surface::Index s1 = s[(i + 1) % 3], s2 = s[(i + 2) % 3], t1 = t[(j + 1) % 3], t2 = t[(j + 2) % 3];
    const CGAL::Orientation of_t1 = side(s, t1);
    if (of_t1 != CGAL::COPLANAR && of_t1 == side(s, t2))
      return false;
    const CGAL::Orientation of_s1 = side(t, s1);
    if (of_s1 != CGAL::COPLANAR && of_s1 == side(t, s2))
      return false;
    return CGAL::do_intersect(Kernel::Segment_3(points_[t1], points_[t2]), triangle(s)) ||
           CGAL::do_intersect(Kernel::Segment_3(points_[s1], points_[s2]), triangle(t));
  }

  // Two triangles on one edge: in one plane, on one side of the edge.
  bool folded(const Triangle& s, std::size_t apex, Layer_surface::Index v) const {
    return side(s, v) == CGAL::COPLANAR &&
           CGAL::coplanar_orientation(points_[s[(apex + 1) % 3]], points_[s[(apex + 2) % 3]], points_[s[apex]],
                                      points_[v]) == CGAL::POSITIVE;
  }

  std::vector<Point_3> points_;
};

/* The pairs of triangles that cross each other. About O(n log n) for surfaces. */
inline std::vector<std::array<std::size_t, 2>>
triangle_crossings(const std::vector<Vector_3d>& points, const std::vector<Layer_surface::Triangle>& triangles) {
  const Box_tree<3> tree = tree_of_triangles(points, triangles);
  const Triangle_meeting meet(points);
  std::vector<std::array<std::size_t, 2>> crossings;
  tree.for_each_overlap([&](Layer_surface::Index s, Layer_surface::Index t) {
    if (meet(triangles[s], triangles[t]))
      crossings.push_back({{s, t}});
  });
  return crossings;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_TRIANGLE_CROSSINGS_H

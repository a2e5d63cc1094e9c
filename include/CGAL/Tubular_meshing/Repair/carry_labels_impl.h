// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_CARRY_LABELS_IMPL_H
#define CGAL_TUBULAR_MESHING_REPAIR_CARRY_LABELS_IMPL_H

#include <CGAL/Tubular_meshing/Repair/carry_labels.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Triangle_soup.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {
namespace internal {

// Numbers points by their coordinates, and triangles by the numbers of their corners, whatever their order.
class Triangle_numbers {
public:
  Triangle_numbers(std::size_t most_points, std::size_t most_triangles)
      : points_(most_points)
      , triangles_(most_triangles) {}

  std::size_t number_of(const Point_3& a, const Point_3& b, const Point_3& c) {
    Index_triangle t = {number_of(a), number_of(b), number_of(c)};
    std::sort(t.begin(), t.end());
    return triangles_.number_of(t);
  }

private:
  std::size_t number_of(const Point_3& p) { return points_.number_of({p.x(), p.y(), p.z()}); }

  Numbering<Coordinates, Hash_of_coordinates> points_;
  Numbering<Index_triangle, Hash_of_triangle> triangles_;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void carry_labels(const std::vector<Point_3>& points,
                                              const std::vector<std::array<std::size_t, 3>>& triangles,
                                              const std::vector<int>& labels, const Surface& surface,
                                              Face_patch_map label) {
  typedef internal::Double_kernel::Triangle_3 Triangle;
  internal::Triangle_numbers numbers(points.size() + surface.number_of_vertices(),
                                     triangles.size() + surface.number_of_faces());
  std::vector<int> label_of; // by number: of repeated triangles the first is kept
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    if (numbers.number_of(points[t[0]], points[t[1]], points[t[2]]) == label_of.size())
      label_of.push_back(labels[i]);
  }
  std::vector<Surface::Face_index> fresh;
  for (auto f : surface.faces()) {
    std::vector<Point_3> corners;
    for (auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      corners.push_back(surface.point(v));
    const std::size_t number = numbers.number_of(corners[0], corners[1], corners[2]);
    if (number < label_of.size())
      label[f] = label_of[number];
    else
      fresh.push_back(f);
  }
  if (fresh.empty())
    return;
  std::vector<Triangle> shapes;
  for (const auto& t : triangles)
    shapes.emplace_back(internal::to_double_point(points[t[0]]), internal::to_double_point(points[t[1]]),
                        internal::to_double_point(points[t[2]]));
  const internal::Nearest_tree<Triangle> tree(std::move(shapes));
  for (auto f : fresh) {
    std::vector<Point_3> corners;
    for (auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      corners.push_back(surface.point(v));
    label[f] =
        labels[tree.nearest(internal::to_double_point(CGAL::centroid(corners[0], corners[1], corners[2]))).index];
  }
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_REPAIR_CARRY_LABELS_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_CARRY_LABELS_IMPL_H
#define CGAL_TUBULAR_MESHING_REPAIR_CARRY_LABELS_IMPL_H

#include <CGAL/Tubular_meshing/Repair/carry_labels.h>
#include <CGAL/Tubular_meshing/Repair/internal/Label_fragments.h>
#include <CGAL/Tubular_meshing/Repair/internal/Soup_edges.h>
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

// By triangle, the area of the triangles of its label that are connected with it by edges.
inline std::vector<double> region_areas(const std::vector<Point_3>& points,
                                        const std::vector<std::array<std::size_t, 3>>& triangles,
                                        const std::vector<int>& labels) {
  Triangle_soup soup;
  for (const Point_3& p : points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  soup.triangles = triangles;
  merge_points(soup.points, soup.triangles);
  std::vector<std::vector<std::size_t>> beside(triangles.size());
  Soup_edges(soup).for_each([&](const Soup_edges::Edge& e) {
    for (const Soup_edges::Side* s = e.first; s + 1 < e.last; ++s) {
      const std::size_t t = s->side / 3, u = s[1].side / 3;
      if (labels[t] == labels[u]) {
        beside[t].push_back(u);
        beside[u].push_back(t);
      }
    }
  });
  std::vector<double> result(triangles.size(), -1);
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (result[first] >= 0)
      continue;
    double area = 0;
    std::vector<std::size_t> region = {first};
    result[first] = 0;
    for (std::size_t i = 0; i < region.size(); ++i) {
      area += triangle_area(soup, soup.triangles[region[i]]);
      for (std::size_t t : beside[region[i]])
        if (result[t] < 0) {
          result[t] = 0;
          region.push_back(t);
        }
    }
    for (std::size_t t : region)
      result[t] = area;
  }
  return result;
}

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
  const std::vector<double> area_of = internal::region_areas(points, triangles, labels);
  std::vector<double> region_area(surface.num_faces(), 0);
  std::vector<Triangle> shapes;
  for (const auto& t : triangles)
    shapes.emplace_back(internal::to_double_point(points[t[0]]), internal::to_double_point(points[t[1]]),
                        internal::to_double_point(points[t[2]]));
  const internal::Nearest_tree<Triangle> tree(std::move(shapes));
  for (auto f : fresh) {
    std::vector<Point_3> corners;
    for (auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      corners.push_back(surface.point(v));
    const std::size_t nearest =
        tree.nearest(internal::to_double_point(CGAL::centroid(corners[0], corners[1], corners[2]))).index;
    label[f] = labels[nearest];
    region_area[std::size_t(f)] = area_of[nearest];
  }
  internal::Label_fragments(surface, label, region_area).relabel();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_REPAIR_CARRY_LABELS_IMPL_H

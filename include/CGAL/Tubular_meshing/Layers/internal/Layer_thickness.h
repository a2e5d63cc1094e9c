// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_THICKNESS_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_THICKNESS_H

#include <CGAL/Tubular_meshing/Layers/internal/triangle_crossings.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Lowers a thickness, one a vertex, until it changes along no edge by more than `slope` times its length. O(n log n),
 * and less where little is to be lowered. */
inline void limit_slope(const Layer_surface& surface, double slope, std::vector<double>& thickness) {
  typedef Layer_surface::Index Index;
  typedef std::pair<double, Index> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto bound = [&](Index v, Index w) {
    return thickness[v] + slope * norm(surface.points[v] - surface.points[w]);
  };
  const auto lower_neighbors = [&](Index v, const auto& lowered) {
    for (const Index* w = surface.neighbors_begin(v); w != surface.neighbors_end(v); ++w)
      if (bound(v, *w) < thickness[*w]) {
        lowered(*w, bound(v, *w));
      }
  };
  for (Index v = 0; v < thickness.size(); ++v) {
    bool first = true;
    lower_neighbors(v, [&](Index, double) {
      if (first)
        queue.push({thickness[v], v});
      first = false;
    });
  }
  while (!queue.empty()) {
    const Entry e = queue.top();
    queue.pop();
    if (e.first > thickness[e.second])
      continue;
    lower_neighbors(e.second, [&](Index w, double t) {
      thickness[w] = t;
      queue.push({t, w});
    });
  }
}

/* Lowers the thickness to a part of the radius of the largest ball that touches the surface at the vertex, on the side
 * of the layers, and meets none of it that faces the vertex: opposite walls share the gap between them, whether they
 * belong to two vessels, or to the two sides of a crotch. Balls shrink to what they meet (J. Ma, S. W. Bae, S. Choi, 3D
 * medial axis point approximation using nearest neighbors and the normal field, 2012). O(log n) each.
 *
 * \param obstacles further triangles, of which none of the layers may grow into; by indices of points
 */
inline void share_gaps(const Layer_surface& surface, const std::vector<Vector_3d>& points,
                       const std::vector<Layer_surface::Triangle>& obstacles, const std::vector<Vector_3d>& directions,
                       double part, int threads, std::vector<double>& thickness) {
  typedef Layer_surface::Index Index;
  std::vector<Layer_surface::Triangle> triangles = surface.triangles();
  triangles.insert(triangles.end(), obstacles.begin(), obstacles.end());
  const Box_tree<3> tree = tree_of_triangles(points, triangles);
  std::vector<Vector_3d> normals;
  for (const Layer_surface::Triangle& t : triangles)
    normals.push_back(normalized(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])));

  const double facing = 0.5; // faces turned by less are the vertex's own neighbourhood
  for_each_range(surface.number_of_vertices(), threads, [&](std::size_t begin, std::size_t end) {
    for (Index v = Index(begin); v < end; ++v) {
      const Vector_3d &x = points[v], &d = directions[v];
      double radius = thickness[v] / part;
      for (int round = 0; round < 20; ++round) {
        const Double_kernel::Point_3 center = to_double_point(x + radius * d);
        const Box_tree<3>::Place place = {center.x(), center.y(), center.z()};
        double distance2 = radius * radius * (1 - 1e-9);
        Vector_3d to;
        tree.visit_near(place, distance2, [&](Index t) {
          const Layer_surface::Triangle& c = triangles[t];
          if (tree.box(t).squared_distance(place) >= distance2 || !(dot(normals[t], d) < facing) || c[0] == v ||
              c[1] == v || c[2] == v)
            return;
          const Double_kernel::Triangle_3 triangle(to_double_point(points[c[0]]), to_double_point(points[c[1]]),
                                                   to_double_point(points[c[2]]));
          const Double_kernel::Point_3 nearest = projection(triangle, center);
          const double d2 = CGAL::squared_distance(nearest, center);
          if (d2 < distance2) {
            distance2 = d2;
            to = Vector_3d(nearest) - x;
          }
        });
        if (!(dot(to, d) > 0)) // where there is none, too
          break;
        const double smaller = squared_norm(to) / (2 * dot(to, d));
        const bool done = !(smaller < 0.99 * radius);
        radius = (std::min)(radius, smaller);
        if (done)
          break;
      }
      thickness[v] = (std::min)(thickness[v], part * radius);
    }
  });
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_THICKNESS_H

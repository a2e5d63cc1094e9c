// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_WALL_DIRECTION_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_WALL_DIRECTION_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The vertices within `reach` of the rim along edges of the wall, with their distances. O(k log k) in their number. */
inline std::unordered_map<Surface::Vertex_index, double> depths_behind_rim(const Opening_site& site, double reach,
                                                                           const Surface& mesh) {
  typedef Surface::Vertex_index Vertex;
  typedef std::pair<double, Vertex> Entry;
  std::unordered_map<Vertex, double> depth;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (auto h : site.rim) {
    depth[mesh.target(h)] = 0;
    queue.emplace(0., mesh.target(h));
  }
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > depth[v])
      continue;
    for (auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh)) {
      const Vertex w = mesh.source(h);
      const double further = d + point_distance(mesh.point(v), mesh.point(w));
      const auto known = depth.find(w);
      if (further > reach || (known != depth.end() && known->second <= further))
        continue;
      depth[w] = further;
      queue.emplace(further, w);
    }
  }
  return depth;
}

/* Where the vessel goes at an opening: the direction to which the faces within a radius behind the rim are parallel
 * (the least eigenvector of their normals' spread; the nearer the rim, the more a face weighs). An oblique cut does not
 * tilt it, as it does the normal of the rim. Where the wall has no direction, as at a hole in a dome, or is too short
 * to tell, it is the rim's normal. `outwards` is that normal. */
inline Vector_3 wall_direction(const Opening_site& site, const Vector_3& outwards, const Surface& mesh) {
  const double clear = 0.25, vague = 0.75; // ratios of the two smaller eigenvalues
  const double reach = site.shape.radius;
  const auto depth = depths_behind_rim(site, reach, mesh);
  auto depth_of = [&](auto v) {
    const auto known = depth.find(v);
    return known == depth.end() ? reach : known->second;
  };

  std::unordered_set<Surface::Face_index> visited;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (auto rim : site.rim) // from the rim on, so that the order, and with it the rounding, is that of the mesh
    for (auto g : CGAL::halfedges_around_target(rim, mesh)) {
      std::vector<Surface::Halfedge_index> stack = {g};
      while (!stack.empty()) {
        const auto h = stack.back();
        stack.pop_back();
        if (mesh.is_border(h) || !visited.insert(mesh.face(h)).second)
          continue;
        double mean_depth = 0;
        for (auto v : CGAL::vertices_around_face(h, mesh))
          mean_depth += depth_of(v) / 3;
        if (mean_depth >= reach)
          continue;
        const auto a = area_vector(h, mesh);
        const double area = std::sqrt(a.squared_length());
        if (area > 0) {
          const Eigen::Vector3d n(a.x() / area, a.y() / area, a.z() / area);
          spread += (area / (reach * reach)) * (1 - mean_depth / reach) * n * n.transpose();
        }
        for (auto e : CGAL::halfedges_around_face(h, mesh))
          stack.push_back(mesh.opposite(e));
      }
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const double ratio = solver.eigenvalues()[1] > 0 ? solver.eigenvalues()[0] / solver.eigenvalues()[1] : 1;
  const double trust = (std::min)(1., (std::max)(0., (vague - ratio) / (vague - clear)));
  const Eigen::Vector3d d = solver.eigenvectors().col(0);
  Vector_3 direction(d.x(), d.y(), d.z());
  if (direction * outwards < 0)
    direction = -direction;
  direction = trust * direction + (1 - trust) * outwards;
  return direction / std::sqrt(direction.squared_length());
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_WALL_DIRECTION_H

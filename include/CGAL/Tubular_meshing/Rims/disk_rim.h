// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_DISK_RIM_H
#define CGAL_TUBULAR_MESHING_RIMS_DISK_RIM_H

#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The rim of a set of faces that is a disk: its boundary in order, halfedges of the faces. Empty if the faces are no
 * disk bounded by one simple loop. Linear in their number (expected, as it hashes). */
inline std::vector<Surface::Halfedge_index> rim_of_disk(const std::vector<Surface::Face_index>& disk,
                                                        const Surface& mesh) {
  typedef Surface::Halfedge_index Halfedge;
  typedef Surface::Vertex_index Vertex;
  const std::unordered_set<Surface::Face_index> faces(disk.begin(), disk.end());
  std::unordered_map<Vertex, Halfedge> rim_from;
  std::unordered_set<Vertex> vertices;
  Halfedge first = Surface::null_halfedge();
  for (auto f : disk)
    for (Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
      vertices.insert(mesh.target(h));
      if (faces.count(mesh.face(mesh.opposite(h))))
        continue;
      if (first == Surface::null_halfedge())
        first = h;
      if (!rim_from.emplace(mesh.source(h), h).second)
        return {};
    }
  if (first == Surface::null_halfedge())
    return {};
  std::vector<Halfedge> rim;
  Halfedge h = first;
  do {
    rim.push_back(h);
    h = rim_from.at(mesh.target(h));
  } while (h != first);
  const std::size_t edges = (3 * disk.size() + rim_from.size()) / 2;
  if (rim.size() != rim_from.size() || vertices.size() + disk.size() != edges + 1)
    rim.clear();
  return rim;
}

/* How a disk of faces lies over its rim: an end of a vessel, flat, domed or dished, is no wider than its rim, as a sac
 * is, and does not reach far out of it, as a blind vessel does. */
struct Bulge {
  double width = 0; ///< the largest distance from the rim's axis but one, which may be a needle's, over the rim's own
  double area = 0;  ///< over the area that the rim bounds: 1 if flat, 2 for a half ball, 4.2 for a dome 2.5 radii high

  bool is_wide() const { return width > 1.25; }
  bool is_long() const { return area > 8; }
};

inline Bulge measure_bulge(const std::vector<Surface::Face_index>& disk, const Rim_shape& shape, const Surface& mesh,
                           const std::vector<Surface::Halfedge_index>& rim) {
  const auto from_axis = [&](Surface::Vertex_index v) {
    const Vector_3 d = mesh.point(v) - shape.center;
    return std::sqrt((d - (d * shape.plane.normal()) * shape.plane.normal()).squared_length());
  };
  double of_rim = 0, area = 0;
  std::pair<double, Surface::Vertex_index> farthest(0, Surface::null_vertex()), next = farthest;
  for (auto h : rim)
    of_rim = (std::max)(of_rim, from_axis(mesh.target(h)));
  for (auto f : disk) {
    area += std::sqrt(area_vector(mesh.halfedge(f), mesh).squared_length());
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      const double d = from_axis(v);
      if (d > farthest.first) {
        if (v != farthest.second)
          next = farthest;
        farthest = {d, v};
      } else if (d > next.first && v != farthest.second)
        next = {d, v};
    }
  }
  return {next.first / of_rim, area / shape.area};
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_DISK_RIM_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_DISK_RIM_H
#define CGAL_TUBULAR_MESHING_RIMS_DISK_RIM_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <unordered_map>
#include <unordered_set>
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

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_DISK_RIM_H

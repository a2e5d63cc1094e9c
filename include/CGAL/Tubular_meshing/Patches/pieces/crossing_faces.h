// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_CROSSING_FACES_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_CROSSING_FACES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::vector<std::pair<Face, Face>> Face_pairs;

inline Face_pairs crossing_triangles(const Surface& triangles) {
  Face_pairs pairs;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Parallel_if_available_tag>(triangles,
                                                                                     std::back_inserter(pairs));
  return pairs;
}

// With the diagonals from the first, or the second corners of the quads.
inline void add_crossing_halves(const Surface& surface, std::size_t corner, Face_pairs& pairs) {
  Surface triangles;
  std::vector<Face> origin; // of each triangle
  for (Vertex v : surface.vertices())
    triangles.add_vertex(surface.point(v));
  const auto add = [&](Face f, Vertex a, Vertex b, Vertex c) {
    if (triangles.add_face(a, b, c) == Surface::null_face())
      pairs.emplace_back(f, f);
    else
      origin.push_back(f);
  };
  for (Face f : surface.faces()) {
    std::vector<Vertex> v;
    for (Vertex w : surface.vertices_around_face(surface.halfedge(f)))
      v.push_back(w);
    add(f, v[0], v[1], v[v.size() == 3 ? 2 : 2 + corner]);
    if (v.size() == 4)
      add(f, v[corner], v[2], v[3]);
  }
  for (const auto& p : crossing_triangles(triangles))
    pairs.emplace_back(origin[std::size_t(p.first)], origin[std::size_t(p.second)]);
}

/* Pairs of faces of a surface of triangles and quads that meet each other. A quad is two triangles, in both ways: a
 * face meets itself if these overlap, or if its diagonal is an edge already. O(n log n). */
inline Face_pairs crossing_faces(const Surface& surface) {
  if (CGAL::is_triangle_mesh(surface))
    return crossing_triangles(surface);
  Face_pairs pairs;
  add_crossing_halves(surface, 0, pairs);
  add_crossing_halves(surface, 1, pairs);
  return pairs;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_CROSSING_FACES_H

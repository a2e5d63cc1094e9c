// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_CROSSING_FACES_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_CROSSING_FACES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/crossing_pairs.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// Of some faces, with the diagonals from the first, or the second corners of the quads.
inline void add_crossing_halves(const std::vector<Face>& faces, const Surface& surface, std::size_t corner,
                                Face_pairs& pairs) {
  Surface triangles;
  std::vector<Face> origin; // of each triangle
  std::vector<Vertex> copy(surface.num_vertices(), Surface::null_vertex());
  const auto add = [&](Face f, Vertex a, Vertex b, Vertex c) {
    if (triangles.add_face(a, b, c) == Surface::null_face())
      pairs.emplace_back(f, f);
    else
      origin.push_back(f);
  };
  for (Face f : faces) {
    boost::container::static_vector<Vertex, 4> v;
    for (Vertex w : surface.vertices_around_face(surface.halfedge(f))) {
      if (copy[w] == Surface::null_vertex())
        copy[w] = triangles.add_vertex(surface.point(w));
      v.push_back(copy[w]);
    }
    add(f, v[0], v[1], v[v.size() == 3 ? 2 : 2 + corner]);
    if (v.size() == 4)
      add(f, v[corner], v[2], v[3]);
  }
  for (const auto& p : crossing_pairs(triangles))
    pairs.emplace_back(origin[std::size_t(p.first)], origin[std::size_t(p.second)]);
}

/* Pairs of some faces of a surface of triangles and quads that meet each other. A quad is two triangles, in both ways: a
 * face meets itself if these overlap, or if its diagonal is an edge already. O(n log n). */
inline Face_pairs crossing_faces(const std::vector<Face>& faces, const Surface& surface) {
  if (std::all_of(faces.begin(), faces.end(), [&](Face f) { return surface.degree(f) == 3; }))
    return crossing_pairs(faces, surface);
  Face_pairs pairs;
  add_crossing_halves(faces, surface, 0, pairs);
  add_crossing_halves(faces, surface, 1, pairs);
  return pairs;
}

// The same of all of its faces.
inline Face_pairs crossing_faces(const Surface& surface) {
  return crossing_faces({surface.faces_begin(), surface.faces_end()}, surface);
}

/* The faces that one with a corner for which is_moved(vertex) might meet, those included. O(n log n) with a small
 * constant: by their boxes. */
template <class IsMoved> std::vector<Face> faces_near(const Surface& surface, const IsMoved& is_moved) {
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, Face> Box;
  std::vector<Box> all, moved;
  for (Face f : surface.faces()) {
    Bbox_3 box;
    bool any = false;
    for (Vertex v : surface.vertices_around_face(surface.halfedge(f))) {
      box += surface.point(v).bbox();
      any = any || is_moved(v);
    }
    all.emplace_back(box, f);
    if (any)
      moved.emplace_back(box, f);
  }
  std::vector<bool> is_near(surface.num_faces(), false);
  CGAL::box_intersection_d(moved.begin(), moved.end(), all.begin(), all.end(),
                           [&](const Box&, const Box& b) { is_near[std::size_t(b.info())] = true; });
  std::vector<Face> result;
  for (Face f : surface.faces())
    if (is_near[std::size_t(f)])
      result.push_back(f);
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_CROSSING_FACES_H

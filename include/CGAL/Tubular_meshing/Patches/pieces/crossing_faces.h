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

/* Pairs of faces of a surface of triangles and quads that meet each other. A quad is two triangles, in both ways: a
 * face meets itself if these overlap, or if its diagonal is an edge already. O(n log n). */
class Crossing_faces {
public:
  typedef Surface::Face_index Face;
  typedef Surface::Vertex_index Vertex;
  typedef std::vector<std::pair<Face, Face>> Pairs;

  explicit Crossing_faces(const Surface& surface)
      : surface_(surface) {}

  Pairs find() const {
    Pairs pairs;
    if (CGAL::is_triangle_mesh(surface_)) {
      collect(surface_, pairs);
    } else {
      find_split(0, pairs);
      find_split(1, pairs);
    }
    return pairs;
  }

private:
  static void collect(const Surface& triangles, Pairs& pairs) {
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Parallel_if_available_tag>(triangles,
                                                                                       std::back_inserter(pairs));
  }

  // With the diagonals from the first, or the second corners of the quads.
  void find_split(std::size_t corner, Pairs& pairs) const {
    Surface triangles;
    std::vector<Face> origin; // of each triangle
    for (Vertex v : surface_.vertices())
      triangles.add_vertex(surface_.point(v));
    const auto add = [&](Face f, Vertex a, Vertex b, Vertex c) {
      if (triangles.add_face(a, b, c) == Surface::null_face())
        pairs.emplace_back(f, f);
      else
        origin.push_back(f);
    };
    for (Face f : surface_.faces()) {
      std::vector<Vertex> v;
      for (Vertex w : surface_.vertices_around_face(surface_.halfedge(f)))
        v.push_back(w);
      add(f, v[0], v[1], v[v.size() == 3 ? 2 : 2 + corner]);
      if (v.size() == 4)
        add(f, v[corner], v[2], v[3]);
    }
    Pairs met;
    collect(triangles, met);
    for (const auto& p : met)
      pairs.emplace_back(origin[std::size_t(p.first)], origin[std::size_t(p.second)]);
  }

  const Surface& surface_;
};

inline Crossing_faces::Pairs crossing_faces(const Surface& s) {
  return Crossing_faces(s).find();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_CROSSING_FACES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_FILL_WALL_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_FILL_WALL_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>

#include <CGAL/Origin.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The mean of a vertex' neighbours, relative to the vertex: the umbrella vector. */
inline Vector_3 umbrella(Surface::Vertex_index v, const Surface& mesh) {
  Vector_3 sum(0, 0, 0);
  double n = 0;
  for (auto w : CGAL::vertices_around_target(mesh.halfedge(v), mesh)) {
    sum = sum + (mesh.point(w) - mesh.point(v));
    ++n;
  }
  return n > 0 ? sum / n : sum;
}

/* Pulls vertices to the means of their neighbours, one after the other: towards a membrane. */
inline void relax(Surface& mesh, const std::vector<Surface::Vertex_index>& vertices, int sweeps) {
  for (int i = 0; i < sweeps; ++i)
    for (auto v : vertices)
      mesh.point(v) = mesh.point(v) + umbrella(v, mesh);
}

/* Bends a patch so that it continues the surface around it: descent along the umbrella of the umbrella vectors (Kobbelt
 * et al., Interactive multi-resolution modeling on arbitrary meshes, 1998), in a fixed number of sweeps. */
inline void bend(Surface& mesh, const std::vector<Surface::Vertex_index>& vertices, int sweeps) {
  typedef Surface::Vertex_index Vertex;
  std::unordered_map<Vertex, Vector_3> first;
  for (int i = 0; i < sweeps; ++i) {
    for (Vertex v : vertices) {
      first[v] = umbrella(v, mesh);
      for (Vertex w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
        first[w] = umbrella(w, mesh);
    }
    for (Vertex v : vertices) {
      Vector_3 second(0, 0, 0);
      double n = 0, weight = 0;
      for (Vertex w : CGAL::vertices_around_target(mesh.halfedge(v), mesh)) {
        second = second + (first[w] - first[v]);
        weight += 1. / double(mesh.degree(w));
        ++n;
      }
      mesh.point(v) = mesh.point(v) - second / (n * (1 + weight / n));
    }
  }
}

/* Fills a hole of the wall by triangles of the size of those around it, as a membrane, or bent like the wall around.
 * False, with the mesh as it was, if there is no triangulation. */
inline bool fill_wall(Surface& mesh, Surface::Halfedge_index border, bool bent) {
  std::vector<Surface::Face_index> faces;
  std::vector<Surface::Vertex_index> vertices;
  Polygon_mesh_processing::triangulate_and_refine_hole(mesh, border, std::back_inserter(faces),
                                                       std::back_inserter(vertices));
  if (faces.empty())
    return false;
  relax(mesh, vertices, 20);
  if (bent)
    bend(mesh, vertices, 60);
  return true;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_FILL_WALL_H

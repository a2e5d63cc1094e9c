// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces as meshes of other types have them.

#ifndef CGAL_TUBULAR_MESHING_TEST_OTHER_GRAPHS_H
#define CGAL_TUBULAR_MESHING_TEST_OTHER_GRAPHS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <map>
#include <type_traits>
#include <vector>

namespace other_graphs {

typedef CGAL::Tubular_meshing::Surface Surface;

// A coordinate below 256 as a float has it. (GCC 12 drops casts to float and back with -O3 -frounding-math.)
inline double rounded(double x) {
  return std::round(65536 * x) / 65536;
}

// Gives an empty mesh the same vertices and faces in the same order, each face from the same corner. Returns the copies
// of the faces.
template <class Mesh>
std::map<Surface::Face_index, typename boost::graph_traits<Mesh>::face_descriptor> copy_in_order(const Surface& surface,
                                                                                                 Mesh& mesh) {
  typedef boost::graph_traits<Mesh> Traits;
  const auto points = get(CGAL::vertex_point, mesh);
  typedef typename boost::property_traits<std::decay_t<decltype(points)>>::value_type Point;
  std::map<Surface::Vertex_index, typename Traits::vertex_descriptor> vertex;
  for (auto v : surface.vertices()) {
    const auto& p = surface.point(v);
    put(points, vertex[v] = add_vertex(mesh), Point(p.x(), p.y(), p.z()));
  }
  std::map<Surface::Face_index, typename Traits::face_descriptor> face;
  for (auto f : surface.faces()) {
    std::vector<typename Traits::vertex_descriptor> corners;
    for (auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      corners.push_back(vertex.at(v));
    face[f] = CGAL::Euler::add_face(corners, mesh);
  }
  return face;
}

// A surface whose edges are in the order that its faces give them, as they are in a copy.
inline Surface in_order(const Surface& surface) {
  Surface copy;
  copy_in_order(surface, copy);
  return copy;
}
inline CGAL::Tubular_meshing::Labelled_surface in_order(const CGAL::Tubular_meshing::Labelled_surface& labelled) {
  CGAL::Tubular_meshing::Labelled_surface copy;
  for (const auto& f : copy_in_order(labelled.surface, copy.surface))
    copy.patch[f.second] = labelled.patch[f.first];
  return copy;
}

} // namespace other_graphs

#endif // CGAL_TUBULAR_MESHING_TEST_OTHER_GRAPHS_H

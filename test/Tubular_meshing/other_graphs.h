// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces as meshes of other types have them.

#ifndef CGAL_TUBULAR_MESHING_TEST_OTHER_GRAPHS_H
#define CGAL_TUBULAR_MESHING_TEST_OTHER_GRAPHS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <map>
#include <type_traits>
#include <vector>

namespace other_graphs {

typedef CGAL::Tubular_meshing::Surface Surface;

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

} // namespace other_graphs

#endif // CGAL_TUBULAR_MESHING_TEST_OTHER_GRAPHS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETGEN_SURFACE_TO_MIXED_MESH_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETGEN_SURFACE_TO_MIXED_MESH_H

#include <CGAL/Tubular_meshing/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/exceptions.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstdint>
#include <unordered_map>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* A closed labelled surface as the beginning of a mesh: its points and triangles, in the surface's own order. */
template <class Point, class TriangleMesh, class FacePatchMap>
void surface_to_mixed_mesh(const TriangleMesh& surface, FacePatchMap patch, Mixed_mesh<Point>& mesh) {
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor Vertex;
  if (!is_closed(surface) || !is_triangle_mesh(surface) || is_empty(surface))
    throw Meshing_error("Only a closed surface of triangles can be filled with tetrahedra: close its openings first.");
  mesh = Mixed_mesh<Point>();
  std::unordered_map<Vertex, std::uint32_t> number;
  mesh.points.reserve(num_vertices(surface));
  mesh.triangles.reserve(num_faces(surface));
  for (Vertex v : vertices(surface)) {
    number[v] = std::uint32_t(mesh.points.size());
    const auto& p = get(CGAL::vertex_point, surface, v);
    mesh.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (auto f : faces(surface)) {
    Element_block<3>::Element corners;
    auto corner = corners.begin();
    for (Vertex v : vertices_around_face(halfedge(f, surface), surface))
      *corner++ = number.at(v);
    mesh.triangles.push_back(corners, get(patch, f));
  }
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETGEN_SURFACE_TO_MIXED_MESH_H

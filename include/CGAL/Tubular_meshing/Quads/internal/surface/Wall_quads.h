// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_WALL_QUADS_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_WALL_QUADS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_patch.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Sheet.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The wall of a surface of quads as a whole. Its first vertices are those on rims, which stay; normals are the means of
 * the quads' own. */
struct Wall_quads {
  Quad_patch mesh;
  std::vector<Vertex> vertices;           // of the surface, for each of the mesh's
  std::vector<std::size_t> patch_of_quad; // of the cut

  explicit Wall_quads(const Remeshed_surface& result)
      : number_(std::size_t(result.surface.number_of_vertices()), -1) {
    const Surface& surface = result.surface;
    for (auto f : surface.faces())
      if (result.patch_of_face[f] < 0)
        for (Vertex v : surface.vertices_around_face(surface.halfedge(f)))
          number_of(v, surface);
    mesh.on_loops = mesh.places.size();
    for (auto f : surface.faces())
      if (result.patch_of_face[f] >= 0) {
        add_quad(surface, f);
        patch_of_quad.push_back(std::size_t(result.patch_of_face[f]));
      }
    for (Sheet_place& p : mesh.places)
      p.normal = normalized(p.normal);
  }

private:
  int number_of(Vertex v, const Surface& surface) {
    int& n = number_[std::size_t(v)];
    if (n < 0) {
      Sheet_place place;
      place.point = Vector_3d(surface.point(v));
      n = mesh.add_vertex(place);
      vertices.push_back(v);
    }
    return n;
  }

  void add_quad(const Surface& surface, Face f) {
    Quad_patch::Quad q;
    std::size_t i = 0;
    for (Vertex v : surface.vertices_around_face(surface.halfedge(f)))
      q[i++] = number_of(v, surface);
    mesh.add_quad(q);
    const Vector_3d n = cross(mesh.point(q[2]) - mesh.point(q[0]), mesh.point(q[3]) - mesh.point(q[1]));
    for (int v : q)
      mesh.places[std::size_t(v)].normal += n;
  }

  std::vector<int> number_; // of the surface's vertices
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_WALL_QUADS_H

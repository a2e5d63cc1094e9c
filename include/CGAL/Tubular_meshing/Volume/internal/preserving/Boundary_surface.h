// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_BOUNDARY_SURFACE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_BOUNDARY_SURFACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The boundary of a mesh as a surface of its own. */
struct Boundary_surface : Labelled_surface {
  std::vector<std::uint32_t> point_of; // the mesh's point of each vertex

  explicit Boundary_surface(const Mixed_mesh& mesh) {
    std::vector<Surface::Vertex_index> vertex_of(mesh.points.size(), Surface::null_vertex());
    add_facets(mesh, mesh.triangles, vertex_of);
    add_facets(mesh, mesh.quads, vertex_of);
  }

  /* Brings the vertices to where the mesh has its points. */
  void follow(const Mixed_mesh& mesh) {
    for (auto v : surface.vertices())
      surface.point(v) = mesh.points[point_of[std::size_t(v)]];
  }

private:
  template <std::size_t N>
  void add_facets(const Mixed_mesh& mesh, const Element_block<N>& facets,
                  std::vector<Surface::Vertex_index>& vertex_of) {
    for (std::size_t i = 0; i < facets.size(); ++i) {
      std::array<Surface::Vertex_index, N> corners;
      for (std::size_t k = 0; k < N; ++k) {
        const std::uint32_t p = facets.vertices[i][k];
        if (vertex_of[p] == Surface::null_vertex()) {
          vertex_of[p] = surface.add_vertex(mesh.points[p]);
          point_of.push_back(p);
        }
        corners[k] = vertex_of[p];
      }
      const auto f = surface.add_face(corners);
      if (f == Surface::null_face())
        throw Meshing_error("The boundary of the mesh is no surface: it cannot be matched to the input's.");
      patch[f] = facets.label[i];
    }
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_BOUNDARY_SURFACE_H

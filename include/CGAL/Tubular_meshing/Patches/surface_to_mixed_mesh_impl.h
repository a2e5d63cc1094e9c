// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_SURFACE_TO_MIXED_MESH_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_SURFACE_TO_MIXED_MESH_IMPL_H

#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

CGAL_TUBULAR_MESHING_INLINE void surface_to_mixed_mesh(const Surface& surface, Face_patch_map patch, Mixed_mesh& mesh) {
  if (!CGAL::is_closed(surface) || surface.is_empty())
    throw Meshing_error("Only a closed surface can be the boundary of a mesh: close its openings first.");
  mesh = Mixed_mesh();
  std::vector<std::uint32_t> number(surface.num_vertices());
  mesh.points.reserve(surface.number_of_vertices());
  mesh.triangles.reserve(surface.number_of_faces());
  for (Vertex v : surface.vertices()) {
    number[v] = std::uint32_t(mesh.points.size());
    const Point_3& p = surface.point(v);
    mesh.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (auto f : surface.faces()) {
    Element_block<4>::Element c = {};
    std::size_t n = 0;
    for (Vertex v : surface.vertices_around_face(surface.halfedge(f))) {
      if (n == c.size())
        throw Meshing_error("A face of the surface has more than four edges: only triangles and quads can be meshed.");
      c[n++] = number[v];
    }
    if (n == c.size())
      mesh.quads.push_back(c, patch[f]);
    else
      mesh.triangles.push_back({c[0], c[1], c[2]}, patch[f]);
  }
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void surface_to_mixed_mesh(const Remeshed_surface& remeshed, Mixed_mesh& mesh) {
  internal::surface_to_mixed_mesh(remeshed.surface, remeshed.patch, mesh);
  if (remeshed.metrics.empty())
    return;
  Point_array array{metric_array_name, 6, {}};
  for (const Metric_tensor_3& m : remeshed.metrics)
    for (double component : m.components())
      array.values.push_back(component);
  mesh.point_arrays.push_back(std::move(array));
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_SURFACE_TO_MIXED_MESH_IMPL_H

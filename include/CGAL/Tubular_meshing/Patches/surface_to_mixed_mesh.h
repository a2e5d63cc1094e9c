// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_SURFACE_TO_MIXED_MESH_H
#define CGAL_TUBULAR_MESHING_PATCHES_SURFACE_TO_MIXED_MESH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * A closed labelled surface as a mesh without cells: its points, triangles and quads, in the surface's own order.
 * Linear.
 *
 * \param surface closed, of triangles and quads
 * \param patch a readable property map from its faces to `int`: their labels
 * \param mesh is replaced
 *
 * \throws Meshing_error if the surface is empty, not closed, or has faces of more than four edges
 */
inline void surface_to_mixed_mesh(const Surface& surface, Face_patch_map patch, Mixed_mesh& mesh) {
  typedef typename boost::graph_traits<Surface>::vertex_descriptor Vertex;
  if (!is_closed(surface) || is_empty(surface))
    throw Meshing_error("Only a closed surface can be the boundary of a mesh: close its openings first.");
  mesh = Mixed_mesh();
  std::unordered_map<Vertex, std::uint32_t> number;
  mesh.points.reserve(num_vertices(surface));
  mesh.triangles.reserve(num_faces(surface));
  for (Vertex v : vertices(surface)) {
    number[v] = std::uint32_t(mesh.points.size());
    const auto& p = get(CGAL::vertex_point, surface, v);
    mesh.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (auto f : faces(surface)) {
    Element_block<4>::Element c = {};
    std::size_t n = 0;
    for (Vertex v : vertices_around_face(halfedge(f, surface), surface)) {
      if (n == c.size())
        throw Meshing_error("A face of the surface has more than four edges: only triangles and quads can be meshed.");
      c[n++] = number.at(v);
    }
    if (n == c.size())
      mesh.quads.push_back(c, get(patch, f));
    else
      mesh.triangles.push_back({c[0], c[1], c[2]}, get(patch, f));
  }
}

/*! \ingroup PkgTubularMeshingRef
 *
 * The same, with the point array `metric` (xx, xy, xz, yy, yz, zz) of a surface that was made by a metric.
 *
 * \throws Meshing_error as above
 */
inline void surface_to_mixed_mesh(const Remeshed_surface& remeshed, Mixed_mesh& mesh) {
  surface_to_mixed_mesh(remeshed.surface, remeshed.patch, mesh);
  if (remeshed.metrics.empty())
    return;
  Point_array array{metric_array_name, 6, {}};
  for (const Metric_tensor_3& m : remeshed.metrics)
    for (double component : m.components())
      array.values.push_back(component);
  mesh.point_arrays.push_back(std::move(array));
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_SURFACE_TO_MIXED_MESH_H

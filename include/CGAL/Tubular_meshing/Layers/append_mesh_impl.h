// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_APPEND_MESH_IMPL_H
#define CGAL_TUBULAR_MESHING_LAYERS_APPEND_MESH_IMPL_H

#include <CGAL/Tubular_meshing/Layers/append_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <array>
#include <cstddef>
#include <string>

namespace CGAL::Tubular_meshing {

namespace internal {

template <std::size_t N, class Keep>
void append_elements(const Element_block<N>& added, const std::vector<std::uint32_t>& point, const Keep& keep,
                     Element_block<N>& elements) {
  elements.reserve(elements.size() + added.size());
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (!keep(added.label[i]))
      continue;
    std::array<std::uint32_t, N> e = added.vertices[i];
    for (std::uint32_t& v : e)
      v = point[v];
    elements.push_back(e, added.label[i]);
  }
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void append_mesh(Mixed_mesh& mesh, const Mixed_mesh& filling,
                                             const std::vector<std::uint32_t>& known_points, int interface) {
  if (known_points.size() > filling.points.size())
    throw Input_error("There are " + std::to_string(known_points.size()) + " known points of a filling with " +
                      std::to_string(filling.points.size()) + " points.");
  for (std::uint32_t p : known_points)
    if (p != no_point && p >= mesh.points.size())
      throw Input_error("Point " + std::to_string(p) + " is known of the filling, but the mesh has " +
                        std::to_string(mesh.points.size()) + " points.");
  std::vector<std::uint32_t> point = known_points;
  point.resize(filling.points.size(), no_point);
  for (std::size_t i = 0; i < point.size(); ++i)
    if (point[i] == no_point) {
      point[i] = std::uint32_t(mesh.points.size());
      mesh.points.push_back(filling.points[i]);
      mesh.point_arrays.clear();
    }
  const auto all = [](int) { return true; };
  internal::append_elements(filling.tetrahedra, point, all, mesh.tetrahedra);
  internal::append_elements(filling.pyramids, point, all, mesh.pyramids);
  internal::append_elements(filling.prisms, point, all, mesh.prisms);
  internal::append_elements(filling.hexahedra, point, all, mesh.hexahedra);
  const auto not_shared = [interface](int label) { return label != interface; };
  internal::append_elements(filling.triangles, point, not_shared, mesh.triangles);
  internal::append_elements(filling.quads, point, not_shared, mesh.quads);
  mesh.region_names.insert(filling.region_names.begin(), filling.region_names.end());
  mesh.patch_names.insert(filling.patch_names.begin(), filling.patch_names.end());
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_LAYERS_APPEND_MESH_IMPL_H

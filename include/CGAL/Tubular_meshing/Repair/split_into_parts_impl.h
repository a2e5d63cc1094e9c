// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_SPLIT_INTO_PARTS_IMPL_H
#define CGAL_TUBULAR_MESHING_REPAIR_SPLIT_INTO_PARTS_IMPL_H

#include <CGAL/Tubular_meshing/Repair/internal/turn_parts_outward.h>
#include <CGAL/Tubular_meshing/Repair/split_into_parts.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The faces of each component, in their order; the components by decreasing area. */
inline std::vector<std::vector<Surface::Face_index>> components_by_area(const Surface& surface) {
  std::vector<std::pair<double, std::vector<Surface::Face_index>>> components;
  for (auto& faces : components_of(surface)) {
    double area = 0;
    for (auto f : faces)
      area += std::sqrt(area_vector(surface.halfedge(f), surface).squared_length());
    std::sort(faces.begin(), faces.end());
    components.emplace_back(area, std::move(faces));
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::vector<Surface::Face_index>> result;
  for (auto& c : components)
    result.push_back(std::move(c.second));
  return result;
}

/* The faces by themselves, their vertices in the order of the whole. */
inline Surface part_of_surface(const Surface& surface, const std::vector<Surface::Face_index>& faces) {
  std::vector<Surface::Vertex_index> vertices;
  for (auto f : faces)
    for (auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  Surface part;
  for (auto v : vertices)
    part.add_vertex(surface.point(v));
  const auto number_of = [&](Surface::Vertex_index v) {
    const auto i = std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin();
    return Surface::Vertex_index(Surface::size_type(i));
  };
  for (auto f : faces) {
    const auto h = surface.halfedge(f);
    part.add_face(number_of(surface.source(h)), number_of(surface.target(h)),
                  number_of(surface.target(surface.next(h))));
  }
  return part;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Surface> split_into_parts(const Surface& surface) {
  const auto components = components_by_area(surface);
  if (components.size() < 2)
    return {surface};
  std::vector<Surface> parts;
  for (const auto& faces : components)
    parts.push_back(part_of_surface(surface, faces));
  return parts;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_SPLIT_INTO_PARTS_IMPL_H

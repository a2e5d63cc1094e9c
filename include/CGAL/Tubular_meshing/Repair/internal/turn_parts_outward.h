// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_TURN_PARTS_OUTWARD_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_TURN_PARTS_OUTWARD_H

#include <CGAL/Tubular_meshing/Repair/internal/Component_shape.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The faces of each component. */
inline std::vector<std::vector<Surface::Face_index>> components_of(const Surface& mesh) {
  std::vector<bool> seen(mesh.num_faces(), false);
  std::vector<std::vector<Surface::Face_index>> components;
  for (auto first : mesh.faces()) {
    if (seen[std::size_t(first)])
      continue;
    seen[std::size_t(first)] = true;
    std::vector<Surface::Face_index> faces(1, first);
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (auto h : CGAL::halfedges_around_face(mesh.halfedge(faces[i]), mesh)) {
        const auto g = mesh.face(mesh.opposite(h));
        if (g != Surface::null_face() && !seen[std::size_t(g)]) {
          seen[std::size_t(g)] = true;
          faces.push_back(g);
        }
      }
    components.push_back(faces);
  }
  return components;
}

inline std::size_t number_of_components(const Surface& mesh) {
  std::vector<bool> seen(mesh.num_faces(), false);
  std::vector<Surface::Face_index> stack;
  std::size_t number = 0;
  for (auto first : mesh.faces()) {
    if (seen[std::size_t(first)])
      continue;
    ++number;
    seen[std::size_t(first)] = true;
    stack.push_back(first);
    while (!stack.empty()) {
      const auto h = mesh.halfedge(stack.back());
      stack.pop_back();
      for (auto k : CGAL::halfedges_around_face(h, mesh)) {
        const auto g = mesh.face(mesh.opposite(k));
        if (g != Surface::null_face() && !seen[std::size_t(g)]) {
          seen[std::size_t(g)] = true;
          stack.push_back(g);
        }
      }
    }
  }
  return number;
}

/* Turns each component outward by itself; false if all were. O(n). */
inline bool turn_parts_outward(Surface& mesh) {
  const auto components = components_of(mesh);
  std::vector<std::size_t> component(mesh.num_faces(), 0);
  for (std::size_t c = 0; c < components.size(); ++c)
    for (auto f : components[c])
      component[std::size_t(f)] = c;
  bool has_turned = false;
  const std::vector<Component_shape> shapes = measure_open_components(mesh, component, components.size());
  for (std::size_t c = 0; c < components.size(); ++c)
    if (shapes[c].volume < 0) {
      Polygon_mesh_processing::reverse_face_orientations(components[c], mesh);
      has_turned = true;
    }
  return has_turned;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_TURN_PARTS_OUTWARD_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LABELLED_FACETS_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LABELLED_FACETS_H

#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A surface, open or closed, as a mesh of nothing but facets that layers can grow on. Vertices keep their order. */
inline Mixed_mesh labelled_facets(const Surface& surface, Face_patch_map patch) {
  std::optional<Mixed_mesh> mesh = facets_of(surface, patch);
  if (!mesh)
    throw Input_error("A face of the surface has more than four edges: layers grow on triangles and quads only.");
  return *std::move(mesh);
}

template <std::size_t N, class Keep> void keep_elements(Element_block<N>& elements, const Keep& keep) {
  Element_block<N> kept;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (keep(elements.label[i]))
      kept.push_back(elements.vertices[i], elements.label[i]);
  elements = std::move(kept);
}

/* Takes away the points that no element has; the others keep their order. */
inline void remove_unused_points(Mixed_mesh& mesh) {
  const std::uint32_t none = std::uint32_t(-1);
  std::vector<std::uint32_t> number(mesh.points.size(), none);
  const auto for_each_vertex = [&](const auto& visit) {
    const auto of = [&](auto& elements) {
      for (auto& e : elements.vertices)
        for (std::uint32_t& v : e)
          visit(v);
    };
    of(mesh.tetrahedra);
    of(mesh.pyramids);
    of(mesh.prisms);
    of(mesh.hexahedra);
    of(mesh.triangles);
    of(mesh.quads);
  };
  for_each_vertex([&](std::uint32_t v) { number[v] = 0; });
  std::uint32_t used = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != none) {
      mesh.points[used] = mesh.points[v];
      number[v] = used++;
    }
  mesh.points.resize(used);
  for_each_vertex([&](std::uint32_t& v) { v = number[v]; });
}

/* Of a surface with a wall, leaves the wall. */
inline void remove_openings(Mixed_mesh& mesh) {
  int largest = 0; // of the lumen's own patches: the first name of the wall's ends them
  for (const auto& name : mesh.patch_names)
    if (name.second == "outer_wall")
      largest = name.first;
  const auto keep = [&](int label) { return label == labels::wall || label >= largest; };
  keep_elements(mesh.triangles, keep);
  keep_elements(mesh.quads, keep);
  for (auto name = mesh.patch_names.begin(); name != mesh.patch_names.end();)
    name = keep(name->first) ? std::next(name) : mesh.patch_names.erase(name);
  remove_unused_points(mesh);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LABELLED_FACETS_H

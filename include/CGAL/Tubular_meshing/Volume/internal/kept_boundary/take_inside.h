// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_TAKE_INSIDE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_TAKE_INSIDE_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/order_in_space.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// Which tetrahedra can be reached from outside without crossing a labelled facet.
inline std::vector<char> reached_from_outside(const Tetrahedron_store& store) {
  typedef Tetrahedron_store::Index Index;
  std::vector<char> is_reached(store.number_of_slots(), 0);
  std::vector<Index> reached;
  const auto reach = [&](Index t) {
    if (!is_reached[t])
      reached.push_back(t);
    is_reached[t] = 1;
  };
  for (Index t = 0; t < store.number_of_slots(); ++t)
    for (int i = 0; i < 4; ++i)
      if (store[t].label[i] == 0 && store[t].neighbor[i] == Tetrahedron_store::none)
        reach(t);
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (int i = 0; i < 4; ++i) {
      const Tetrahedron_store::Tetrahedron& t = store[reached[k]];
      if (t.label[i] == 0 && t.neighbor[i] != Tetrahedron_store::none)
        reach(Tetrahedron_store::tetrahedron_of(t.neighbor[i]));
    }
  return is_reached;
}

/* The tetrahedra of a mesh that are inside of its triangles, in a store, sorted in space; vertices keep their numbers,
 * and triangles their labels. None, unless each triangle is a facet of one of them, and of no other. The mesh is as it
 * was afterwards. Linear, but for the sorting. */
inline std::optional<Tetrahedron_store> take_inside(Mixed_mesh& mesh, int threads) {
  typedef Tetrahedron_store::Index Index;
  std::vector<int> labels(mesh.triangles.size()); // by which triangles that are no facet are found
  std::iota(labels.begin(), labels.end(), 1);
  labels.swap(mesh.triangles.label);
  Tetrahedron_store store(mesh, threads);
  labels.swap(mesh.triangles.label);
  if (store.has_overlaps())
    return std::nullopt;
  const std::vector<char> is_outside = reached_from_outside(store);
  std::vector<Index> inside = store.tetrahedra([&](Index t) { return !is_outside[t]; });
  std::vector<std::uint8_t> facets(mesh.triangles.size() + 1, 0);
  for (Index t : inside)
    for (std::int32_t label : store[t].label)
      facets[std::size_t(label)] += label != 0;
  if (std::any_of(facets.begin() + 1, facets.end(), [](std::uint8_t n) { return n != 1; }))
    return std::nullopt;
  store.relabel([&](std::int32_t triangle) { return mesh.triangles.label[std::size_t(triangle) - 1]; }, threads);
  put_in_order(order_by_centers(store, inside, threads), inside);
  std::vector<Index> vertices(store.number_of_vertices());
  std::iota(vertices.begin(), vertices.end(), Index(0));
  store.renumber(vertices, inside, threads);
  return store;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_TAKE_INSIDE_H

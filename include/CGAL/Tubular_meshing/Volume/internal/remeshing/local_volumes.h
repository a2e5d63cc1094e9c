// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_LOCAL_VOLUMES_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_LOCAL_VOLUMES_H

#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* For each vertex, the mean volume in the metric of the tetrahedra around it, over that of the regular one, smoothed
 * once over the neighbors: whether vertices are too many there (below one) or too few. Linear. */
inline std::vector<float> local_volumes(const Metric_mesh& mesh) {
  typedef Tetrahedron_store::Index Index;
  const Tetrahedron_store& store = mesh.store;
  std::vector<float> of_vertex(store.number_of_vertices()), number(store.number_of_vertices());
  std::vector<float> of_tetrahedron(store.number_of_slots());
  for (Index t = 0; t < store.number_of_slots(); ++t)
    if (store.is_alive(t))
      of_tetrahedron[t] = float(mesh.shape(store[t].v).volume);
  for (int round = 0; round < 2; ++round) {
    std::fill(of_vertex.begin(), of_vertex.end(), 0.f);
    std::fill(number.begin(), number.end(), 0.f);
    for (Index t = 0; t < store.number_of_slots(); ++t)
      if (store.is_alive(t))
        for (Index v : store[t].v) {
          of_vertex[v] += of_tetrahedron[t];
          number[v] += 1;
        }
    for (std::size_t v = 0; v < of_vertex.size(); ++v)
      of_vertex[v] /= (std::max)(number[v], 1.f);
    for (Index t = 0; t < store.number_of_slots(); ++t)
      if (store.is_alive(t)) {
        const auto& v = store[t].v;
        of_tetrahedron[t] = (of_vertex[v[0]] + of_vertex[v[1]] + of_vertex[v[2]] + of_vertex[v[3]]) / 4;
      }
  }
  return of_vertex;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_LOCAL_VOLUMES_H

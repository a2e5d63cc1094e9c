// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_EDGE_LIST_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_EDGE_LIST_H

#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* An edge, its length in the metric, and a tetrahedron where it was found. */
struct Listed_edge {
  typedef Tetrahedron_store::Index Index;
  float length;
  Index t, a, b; // a < b

  // The corners of the edge in its tetrahedron; false if it is no longer there.
  bool find(const Tetrahedron_store& store, int& i, int& j) const {
    if (!store.is_alive(t))
      return false;
    i = store.corner(t, a);
    j = store.corner(t, b);
    return store[t].v[i] == a && store[t].v[j] == b;
  }
};
typedef std::vector<Listed_edge> Edge_list;

// By their ends, each once.
inline void sort_and_unite(Edge_list& edges) {
  const auto ends = [](const Listed_edge& e) { return (std::uint64_t(e.a) << 32) | e.b; };
  std::sort(edges.begin(), edges.end(), [&](const Listed_edge& x, const Listed_edge& y) { return ends(x) < ends(y); });
  edges.erase(std::unique(edges.begin(), edges.end(),
                          [&](const Listed_edge& x, const Listed_edge& y) { return ends(x) == ends(y); }),
              edges.end());
}

/* The edges of the tetrahedra listed (some may be gone) that have a length of interest, each once, the longest first.
 * O(n log n) in the number of tetrahedra. */
template <class IsOfInterest>
Edge_list list_edges(const Metric_mesh& mesh, const std::vector<Tetrahedron_store::Index>& tetrahedra,
                     const IsOfInterest& is_of_interest) {
  // by pieces: what is near in the list is mostly near in space, so that few edges are left that are in two of them
  const std::size_t piece = 4096, pieces = (tetrahedra.size() + piece - 1) / piece;
  std::vector<Edge_list> lists(pieces);
  for_each_task(pieces, mesh.threads, [&](std::size_t p) {
    Edge_list edges;
    for (std::size_t k = p * piece; k < (std::min)((p + 1) * piece, tetrahedra.size()); ++k) {
      const Listed_edge::Index t = tetrahedra[k];
      if (!mesh.store.is_alive(t))
        continue;
      const auto& v = mesh.store[t].v;
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
          edges.push_back({0, t, (std::min)(v[i], v[j]), (std::max)(v[i], v[j])});
    }
    sort_and_unite(edges);
    for (Listed_edge& e : edges)
      e.length = float(mesh.length(e.a, e.b));
    edges.erase(std::remove_if(edges.begin(), edges.end(),
                               [&](const Listed_edge& e) { return !is_of_interest(double(e.length)); }),
                edges.end());
    lists[p].assign(edges.begin(), edges.end()); // no larger than need be
  });
  Edge_list edges;
  for (Edge_list& list : lists) {
    edges.insert(edges.end(), list.begin(), list.end());
    Edge_list().swap(list);
  }
  sort_and_unite(edges);
  std::sort(edges.begin(), edges.end(), [](const Listed_edge& x, const Listed_edge& y) {
    return std::make_tuple(-x.length, x.a, x.b) < std::make_tuple(-y.length, y.a, y.b);
  });
  return edges;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_EDGE_LIST_H

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

inline bool is_longer(const Listed_edge& x, const Listed_edge& y) {
  return std::make_tuple(-x.length, x.a, x.b, x.t) < std::make_tuple(-y.length, y.a, y.b, y.t);
}

inline bool have_same_ends(const Listed_edge& x, const Listed_edge& y) {
  return x.a == y.a && x.b == y.b;
}

// Edges that are known by their ends, in a hash table.
class Known_edges {
public:
  // Room for `most` edges.
  explicit Known_edges(std::size_t most) {
    std::size_t size = 16;
    while (size < 2 * most)
      size *= 2;
    table_.assign(size, none);
  }

  // Whether the edge was not known yet.
  bool insert(Listed_edge::Index a, Listed_edge::Index b) {
    const std::uint64_t key = std::uint64_t(a) << 32 | b;
    std::size_t place = (key * 0x9e3779b97f4a7c15u >> 20) & (table_.size() - 1);
    while (table_[place] != none && table_[place] != key)
      place = (place + 1) & (table_.size() - 1);
    const bool is_new = table_[place] == none;
    table_[place] = key;
    return is_new;
  }

private:
  static constexpr std::uint64_t none = std::uint64_t(-1);
  std::vector<std::uint64_t> table_;
};

/* The edges of the tetrahedra listed (some may be gone) that are of interest, each once, the longest first:
 * is_of_interest(length, a, b). O(n + m log m) for n tetrahedra and m edges of interest. */
template <class IsOfInterest>
Edge_list list_edges(const Metric_mesh& mesh, const std::vector<Tetrahedron_store::Index>& tetrahedra,
                     const IsOfInterest& is_of_interest) {
  // by pieces: what is near in the list is mostly near in space, so that few edges are left that are in two of them
  const std::size_t piece = 1024, pieces = (tetrahedra.size() + piece - 1) / piece;
  std::vector<Edge_list> lists(pieces);
  for_each_task(pieces, mesh.threads, [&](std::size_t p) {
    const std::size_t end = (std::min)((p + 1) * piece, tetrahedra.size());
    Known_edges known(6 * (end - p * piece));
    for (std::size_t k = p * piece; k < end; ++k) {
      const Listed_edge::Index t = tetrahedra[k];
      if (!mesh.store.is_alive(t))
        continue;
      const auto& v = mesh.store[t].v;
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j) {
          const auto ends = std::minmax(v[i], v[j]);
          if (!known.insert(ends.first, ends.second))
            continue;
          const float length = float(mesh.length(ends.first, ends.second));
          if (is_of_interest(double(length), ends.first, ends.second))
            lists[p].push_back({length, t, ends.first, ends.second});
        }
    }
  });
  Edge_list edges;
  for (Edge_list& list : lists) {
    edges.insert(edges.end(), list.begin(), list.end());
    Edge_list().swap(list);
  }
  std::sort(edges.begin(), edges.end(), is_longer);
  edges.erase(std::unique(edges.begin(), edges.end(), have_same_ends), edges.end());
  return edges;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_EDGE_LIST_H

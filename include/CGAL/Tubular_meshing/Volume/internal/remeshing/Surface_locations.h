// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_SURFACE_LOCATIONS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_SURFACE_LOCATIONS_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where a vertex or an edge lies: inside the volume, on a patch, on a rim, or (vertices only) at a corner. */
struct Surface_location {
  std::int32_t dimension = 3; // of the space in which it may move
  std::int32_t id = 0;        // 2: the patch; 1: the number of the rim

  friend bool operator==(const Surface_location& a, const Surface_location& b) {
    return a.dimension == b.dimension && a.id == b.id;
  }
};

/* The rims of a labelled mesh, numbered. A rim is the set of edges at which the same patches meet; a corner is a vertex
 * at which rims meet or end, or where a rim turns sharply. */
class Surface_locations {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;
  typedef std::vector<std::int32_t> Patches; // sorted

  const Patches& patches_of_rim(std::int32_t rim) const { return rims_[std::size_t(rim)]; }

  // The location of an edge by its ring; its two ends need not share it.
  Surface_location of_edge(const Store& store, const Store::Ring& ring) const {
    Patches patches;
    for (Index t : ring.tetrahedra)
      for (int i = 0; i < 4; ++i)
        if (store[t].v[i] != ring.a && store[t].v[i] != ring.b && store[t].label[i] != 0)
          add(store[t].label[i], patches);
    if (patches.empty())
      return {};
    if (patches.size() == 1)
      return {2, patches[0]};
    const auto rim = number_.find(patches); // no operation makes a new one
    return rim == number_.end() ? Surface_location{0, 0} : Surface_location{1, rim->second};
  }

  // The locations of all vertices; `is_corner(v)` is asked of vertices on rims.
  template <class IsCorner> std::vector<Surface_location> of_vertices(const Store& store, const IsCorner& is_corner) {
    std::vector<Surface_location> locations(store.number_of_vertices());
    std::vector<std::pair<std::pair<Index, Index>, std::int32_t>> edges; // of labelled facets, with their labels
    for (Index t = 0; t < store.number_of_slots(); ++t)
      for (int i = 0; i < 4; ++i) {
        if (!store.is_alive(t) || store[t].label[i] == 0)
          continue;
        const auto& c = Store::facet_corners(i);
        for (int k = 0; k < 3; ++k) {
          const Index a = store[t].v[c[k]], b = store[t].v[c[(k + 1) % 3]];
          edges.push_back({std::minmax(a, b), store[t].label[i]});
          locations[a] = {2, store[t].label[i]};
        }
      }
    Patches patches;
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<std::uint8_t> rim_edges(store.number_of_vertices(), 0);
    for (std::size_t k = 0; k < edges.size();) {
      patches.clear();
      const auto edge = edges[k].first;
      for (; k < edges.size() && edges[k].first == edge; ++k)
        patches.push_back(edges[k].second);
      if (patches.size() < 2)
        continue;
      const std::int32_t rim = number_of(patches);
      for (Index v : {edge.first, edge.second}) {
        const bool fits = rim_edges[v] == 0 || (rim_edges[v] == 1 && locations[v] == Surface_location{1, rim});
        locations[v] = fits ? Surface_location{1, rim} : Surface_location{0, 0};
        rim_edges[v] = std::uint8_t((std::min)(rim_edges[v] + 1, 3));
      }
    }
    for (Index v = 0; v < store.number_of_vertices(); ++v)
      if (locations[v].dimension == 1 && (rim_edges[v] != 2 || is_corner(v)))
        locations[v] = {0, 0};
    return locations;
  }

private:
  static void add(std::int32_t patch, Patches& patches) {
    const auto at = std::lower_bound(patches.begin(), patches.end(), patch);
    if (at == patches.end() || *at != patch)
      patches.insert(at, patch);
  }
  std::int32_t number_of(const Patches& patches) {
    const auto found = number_.insert({patches, std::int32_t(rims_.size())});
    if (found.second)
      rims_.push_back(patches);
    return found.first->second;
  }

  std::map<Patches, std::int32_t> number_;
  std::vector<Patches> rims_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_SURFACE_LOCATIONS_H

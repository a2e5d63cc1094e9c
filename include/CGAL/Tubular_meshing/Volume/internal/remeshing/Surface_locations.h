// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_SURFACE_LOCATIONS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_SURFACE_LOCATIONS_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>

#include <algorithm>
#include <cstdint>
#include <map>
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
    return of_patches(patches);
  }

  // The location of an edge at which facets of these patches meet, sorted.
  Surface_location of_patches(const Patches& patches) const {
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
    std::vector<std::uint8_t> rim_edges(store.number_of_vertices(), 0);
    store.for_each_labelled_edge([&](const auto& ends, const Patches& patches) {
      const bool is_rim = patches.size() > 1;
      const Surface_location place = is_rim ? Surface_location{1, number_of(patches)} : Surface_location{2, patches[0]};
      for (Index v : {ends.first, ends.second}) {
        if (!is_rim && rim_edges[v] > 0)
          continue;
        const bool fits = rim_edges[v] == 0 || (rim_edges[v] == 1 && locations[v] == place);
        locations[v] = fits ? place : Surface_location{0, 0};
        rim_edges[v] = std::uint8_t((std::min)(rim_edges[v] + int(is_rim), 3));
      }
    });
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

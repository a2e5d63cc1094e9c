// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_VERTEX_REMOVAL_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_VERTEX_REMOVAL_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Takes an inner vertex of a bad tetrahedron away, by drawing an edge at it together into its other end, if the worst
 * tetrahedron of what was around the vertex gets better by it. Vertices on facets with a label stay. */
class Vertex_removal {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  explicit Vertex_removal(Store& store)
      : store_(store) {}

  // Whether t is gone; `come` are the new tetrahedra then.
  bool operator()(Index t, Store::Index_list& come) {
    const Store::Vertices corners = store_[t].v;
    for (Index v : corners)
      if (remove(v, come))
        return true;
    return false;
  }

private:
  static constexpr double least_gain = 1e-2; // in quality

  bool remove(Index v, Store::Index_list& come) {
    store_.star(v, star_);
    double worst = 1;
    std::vector<Index> neighbors;
    for (Index s : star_) {
      const auto& tet = store_[s];
      for (int i = 0; i < 4; ++i) {
        if (tet.v[i] == v)
          continue;
        if (tet.label[i] != 0 || tet.region != store_.region(star_[0]))
          return false;
        neighbors.push_back(tet.v[i]);
      }
      worst = (std::min)(worst, gamma_of(store_, tet.v));
    }
    std::sort(neighbors.begin(), neighbors.end());
    neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
    double best = worst + least_gain;
    Index target = Store::none;
    for (Index u : neighbors) {
      const double q = worst_after(v, u, best);
      if (q > best) {
        best = q;
        target = u;
      }
    }
    if (target == Store::none)
      return false;
    std::vector<Store::Vertices> cells;
    for (Index s : star_)
      if (!has(store_[s].v, target))
        cells.push_back(moved(store_[s].v, v, target));
    store_.replace(star_, cells, std::array<Store::Labelled_facet, 0>(), come);
    return true;
  }

  // The worst tetrahedron when v has gone into u; given up once it is below `least`.
  double worst_after(Index v, Index u, double least) const {
    double worst = 1;
    for (Index s : star_) {
      if (has(store_[s].v, u))
        continue;
      worst = (std::min)(worst, gamma_of(store_, moved(store_[s].v, v, u)));
      if (worst <= least)
        break;
    }
    return worst;
  }

  static bool has(const Store::Vertices& w, Index u) { return std::find(w.begin(), w.end(), u) != w.end(); }
  static Store::Vertices moved(Store::Vertices w, Index v, Index u) {
    std::replace(w.begin(), w.end(), v, u);
    return w;
  }

  Store& store_;
  std::vector<Index> star_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_VERTEX_REMOVAL_H

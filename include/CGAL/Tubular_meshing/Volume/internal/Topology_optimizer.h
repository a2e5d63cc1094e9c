// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TOPOLOGY_OPTIMIZER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TOPOLOGY_OPTIMIZER_H

#include <CGAL/Tubular_meshing/Quality/internal/element_measures.h>
#include <CGAL/Tubular_meshing/Volume/internal/Flip_search.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/internal/parallel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* The measure of isotropic meshes: eq. (13), and eq. (12) of triangles, which count with the tetrahedra, scaled to a
 * like range. */
struct Isotropic_measure {
  typedef Tetrahedron_store::Index Index;
  const Tetrahedron_store& store;

  double tetrahedron(Index a, Index b, Index c, Index d) const {
    return tetrahedron_gamma(store.point(a), store.point(b), store.point(c), store.point(d));
  }
  double triangle(Index a, Index b, Index c) const {
    return 0.6 * triangle_gamma(store.point(a), store.point(b), store.point(c));
  }
};

/* Flips, of edges and of facets, that raise the quality of the worst tetrahedron of the cavity they change, as long as
 * there are any: see Flip_search. */
template <class Surface_guard, class Measure = Isotropic_measure> class Topology_optimizer {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  Topology_optimizer(Store& store, const Surface_guard& guard)
      : Topology_optimizer(store, guard, Measure{store}, 1) {}
  Topology_optimizer(Store& store, const Surface_guard& guard, const Measure& measure, int threads)
      : store_(store)
      , guard_(guard)
      , measure_(measure)
      , threads_(threads)
      , search_(store_, guard_, measure_, quality_) {
    update_all();
  }
  Topology_optimizer(const Topology_optimizer&) = delete;
  Topology_optimizer& operator=(const Topology_optimizer&) = delete;

  // Tries to improve every tetrahedron below `threshold`, new ones included; returns the number of flips done.
  std::size_t improve_below(double threshold) {
    std::vector<Index> todo;
    for (Index t = 0; t < store_.number_of_slots(); ++t)
      if (store_.is_alive(t) && quality_[t] < threshold)
        todo.push_back(t);
    return improve_these(todo, threshold);
  }

  /* The same for those of which `is_of_interest(t)` holds. Where few can be improved, as in a mesh that is good
   * already, it is quicker to find them first, with all threads. */
  template <class IsOfInterest> std::size_t improve_few_below(double threshold, const IsOfInterest& is_of_interest) {
    std::vector<char> has_flip(store_.number_of_slots(), 0);
    for_each_range(has_flip.size(), threads_, [&](std::size_t first, std::size_t last) {
      Flip_search<Surface_guard, Measure> search(store_, guard_, measure_, quality_);
      for (std::size_t t = first; t < last; ++t)
        has_flip[t] = store_.is_alive(Index(t)) && quality_[t] < threshold && is_of_interest(Index(t)) &&
                      search.find(Index(t));
    });
    std::vector<Index> todo;
    for (Index t = 0; t < has_flip.size(); ++t)
      if (has_flip[t])
        todo.push_back(t);
    return improve_these(todo, threshold);
  }

  // The same for the tetrahedra listed, and what comes of them; new ones are added to the list.
  std::size_t improve_these(std::vector<Index>& todo, double threshold) {
    std::size_t flips = 0;
    // each flip raises the worst quality of a cavity, so this ends; the bound is against rounding
    const std::size_t most = 20 * todo.size() + 100;
    for (std::size_t k = 0; k < todo.size() && k < most; ++k) {
      const Index t = todo[k];
      if (!store_.is_alive(t) || quality_[t] >= threshold || !search_.find(t))
        continue;
      store_.replace(search_.old_cells(), search_.new_cells(), search_.new_facets(), new_tetrahedra_);
      update_new(new_tetrahedra_);
      ++flips;
      for (Index n : new_tetrahedra_)
        if (quality_[n] < threshold)
          todo.push_back(n);
    }
    return flips;
  }

  // Where others change the store as well, they keep the qualities up to date.
  double quality(Index t) const { return quality_[t]; }
  void update_all() {
    quality_.resize(store_.number_of_slots());
    is_new_.resize(store_.number_of_slots(), 0);
    for_each_range(quality_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        update(Index(t));
    });
  }
  template <class List> void update_new(const List& tetrahedra) {
    if (quality_.size() < store_.number_of_slots()) {
      quality_.resize(store_.number_of_slots());
      is_new_.resize(store_.number_of_slots(), 0);
    }
    for (Index t : tetrahedra) {
      update(t);
      is_new_[t] = 1;
    }
  }

  // visit(t) for each tetrahedron that has come since this was called last.
  template <class Visit> void for_each_new(const Visit& visit) {
    for (Index t = 0; t < is_new_.size(); ++t)
      if (is_new_[t]) {
        is_new_[t] = 0;
        if (store_.is_alive(t))
          visit(t);
      }
  }

private:
  void update(Index t) {
    if (store_.is_alive(t)) {
      const auto& v = store_[t].v;
      quality_[t] = float(measure_.tetrahedron(v[0], v[1], v[2], v[3]));
    }
  }

  Store& store_;
  const Surface_guard guard_;
  const Measure measure_;
  const int threads_;
  std::vector<float> quality_;
  std::vector<char> is_new_;
  Flip_search<Surface_guard, Measure> search_;
  Store::Index_list new_tetrahedra_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TOPOLOGY_OPTIMIZER_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TOPOLOGY_OPTIMIZER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TOPOLOGY_OPTIMIZER_H

#include <CGAL/Tubular_meshing/Volume/internal/Flip_search.h>
#include <CGAL/Tubular_meshing/Volume/internal/Speculation.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/interruption.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The measure of isotropic meshes: eq. (13), and eq. (12) of triangles, which count with the tetrahedra, scaled to a
 * like range. */
struct Isotropic_measure {
  typedef Tetrahedron_store::Index Index;
  const Tetrahedron_store& store;

  double tetrahedron(Index a, Index b, Index c, Index d) const { return gamma_of(store, {a, b, c, d}); }
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

  // Candidates are looked at in batches, see Speculation.
  static constexpr std::size_t default_batch = Speculation<Flip_search<Surface_guard, Measure>>::default_batch;
  Topology_optimizer(Store& store, const Surface_guard& guard, const Measure& measure, int threads,
                     std::size_t batch = 1)
      : store_(store)
      , guard_(guard)
      , measure_(measure)
      , threads_(threads)
      , searches_(threads, batch, store_, guard_, measure_, quality_) {
    update_all();
  }
  Topology_optimizer(const Topology_optimizer&) = delete;
  Topology_optimizer& operator=(const Topology_optimizer&) = delete;

  // Tries to improve every tetrahedron below `threshold`, new ones included; returns the number of flips done.
  std::size_t improve_below(double threshold) {
    return improve_below(threshold, [](Index) { return true; });
  }

  // The same for those of which `is_of_interest(t)` holds.
  template <class IsOfInterest> std::size_t improve_below(double threshold, const IsOfInterest& is_of_interest) {
    std::vector<Index> candidates =
        store_.tetrahedra([&](Index t) { return quality_[t] < threshold && is_of_interest(t); });
    return improve_these(candidates, threshold);
  }

  // The same for the tetrahedra listed, and what comes of them; new ones are added to the list.
  std::size_t improve_these(std::vector<Index>& candidates, double threshold) {
    std::size_t flips = 0;
    // each flip raises the worst quality of a cavity, so this ends; the bound is against rounding
    const std::size_t most = 20 * candidates.size() + 100;
    searches_.run([&] { return (std::min)(candidates.size(), most); }, [&] { return now(); },
                  [&](Search& search, std::size_t k) {
                    return store_.is_alive(candidates[k]) && quality_[candidates[k]] < threshold &&
                           search.find(candidates[k]);
                  },
                  [&](const Search& search, std::size_t, Time since) {
                    return search.is_fresh([&](Index t) { return is_newer(t, since); });
                  },
                  [&](const Search& search, std::size_t) {
                    store_.replace(search.old_cells(), search.new_cells(), search.new_facets(), new_tetrahedra_);
                    update_new(new_tetrahedra_);
                    ++flips;
                    for (Index n : new_tetrahedra_)
                      if (quality_[n] < threshold)
                        candidates.push_back(n);
                  });
    return flips;
  }

  // Where others change the store as well, they keep the qualities up to date.
  double quality(Index t) const { return quality_[t]; }
  void update_all() {
    grow();
    for_each_range(quality_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        update(Index(t));
    });
  }
  template <class List> void update_new(const List& tetrahedra) {
    grow();
    ++now_;
    for (Index t : tetrahedra) {
      update(t);
      made_[t] = now_;
    }
  }

  // Each change is one step of time.
  typedef std::uint32_t Time;
  Time now() const { return now_; }
  bool is_newer(Index t, Time time) const { return made_[t] > time; }

  // visit(t) for each tetrahedron that has come since.
  template <class Visit> void for_each_newer(Time time, const Visit& visit) const {
    for (Index t = 0; t < made_.size(); ++t)
      if (made_[t] > time && store_.is_alive(t))
        visit(t);
  }

private:
  typedef Flip_search<Surface_guard, Measure> Search;

  void grow() {
    quality_.resize(store_.number_of_slots());
    made_.resize(store_.number_of_slots(), 0);
  }
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
  std::vector<Time> made_;
  Time now_ = 0;
  Speculation<Search> searches_;
  Store::Index_list new_tetrahedra_;
};

/* Flips in turn with moves of vertices, move_vertices(pass), each of which ends with finish_pass(). */
template <class Guard, class Move, class Finish>
void optimize_in_passes(Tetrahedron_store& store, const Guard& guard, int passes, int threads,
                        const Move& move_vertices, const Finish& finish_pass) {
  // slivers first, then whatever is clearly below the mean that comes out
  const double first_flips_below = 0.5, later_flips_below = 0.6;
  typedef Topology_optimizer<Guard> Flips;
  Flips flips(store, guard, Isotropic_measure{store}, threads, Flips::default_batch);
  flips.improve_below(first_flips_below);
  for (int pass = 0; pass < passes; ++pass) {
    check_interruption();
    move_vertices(pass);
    flips.update_all();
    flips.improve_below(later_flips_below);
    finish_pass();
  }
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TOPOLOGY_OPTIMIZER_H

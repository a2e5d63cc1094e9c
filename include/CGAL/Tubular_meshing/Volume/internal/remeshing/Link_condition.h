// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_LINK_CONDITION_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_LINK_CONDITION_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Whether a vertex on labelled facets may be pulled onto another one: what the links of both have in common must be the
 * link of the edge between them. That is asked of the tetrahedra, of the labelled facets, and of the rims where facets
 * of different labels meet: were two sheets of the surface, or two rims, to touch afterwards, one of the three would
 * be broken. */
class Link_condition {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  explicit Link_condition(const Store& store)
      : store_(store) {}

  // Of an edge from v to w, with its ring and the tetrahedra around v.
  bool holds(Index v, Index w, const Store::Ring& ring, const std::vector<Index>& star) {
    store_.star(w, other_star_);
    return holds_for_tetrahedra(v, w, ring, star) && holds_for_facets(v, w, star);
  }

  // The tetrahedra around w.
  const std::vector<Index>& other_star() const { return other_star_; }

private:
  // No vertex but those around the edge may be joined to both its ends, and no facet of both.
  bool holds_for_tetrahedra(Index v, Index w, const Store::Ring& ring, const std::vector<Index>& star) {
    const auto in_link = [&](Index u) { return std::find(ring.link.begin(), ring.link.end(), u) != ring.link.end(); };
    neighbors_.clear();
    for (Index t : star)
      for (Index u : store_[t].v)
        if (u != v && u != w)
          neighbors_.push_back(u);
    std::sort(neighbors_.begin(), neighbors_.end());
    for (Index t : other_star_) {
      const auto& x = store_[t].v;
      if (std::find(x.begin(), x.end(), v) != x.end())
        continue;
      int shared = 0;
      for (Index u : x) {
        if (u == w || !std::binary_search(neighbors_.begin(), neighbors_.end(), u))
          continue;
        if (!in_link(u))
          return false;
        ++shared;
      }
      if (shared > 2)
        return false;
      if (shared == 2 && !follows_in_link(ring, x) && is_facet_of_star(v, ring, star, x))
        return false;
    }
    return true;
  }
  // Whether the two vertices that the tetrahedron x shares with the link are next to each other there.
  static bool follows_in_link(const Store::Ring& ring, const Store::Vertices& x) {
    const auto& link = ring.link;
    const auto in_x = [&](Index u) { return std::find(x.begin(), x.end(), u) != x.end(); };
    for (std::size_t k = 0; k + 1 < link.size(); ++k)
      if (in_x(link[k]) && in_x(link[k + 1]))
        return true;
    return ring.closed && in_x(link.front()) && in_x(link.back());
  }
  bool is_facet_of_star(Index v, const Store::Ring& ring, const std::vector<Index>& star,
                        const Store::Vertices& x) const {
    return std::any_of(star.begin(), star.end(), [&](Index t) {
      int shared = 0;
      for (Index u : store_[t].v)
        shared += u != v && std::find(ring.link.begin(), ring.link.end(), u) != ring.link.end() &&
                  std::find(x.begin(), x.end(), u) != x.end();
      return shared == 2;
    });
  }

  // The labelled facets at a vertex, each by its edge opposite to it, a < b; an interface's come from either side.
  struct Opposite_edge {
    Index a, b;
    std::int32_t label;
  };
  typedef std::vector<Opposite_edge> Opposite_edges;

  template <class Star> void collect(Index v, const Star& star, Opposite_edges& edges) const {
    edges.clear();
    for (Index t : star)
      store_.for_each_labelled_facet(Store::facet(t, store_.corner(t, v)), [&](Index facet, Index a, Index b) {
        edges.push_back({(std::min)(a, b), (std::max)(a, b), store_.label(facet)});
      });
  }

  // Vertices joined to the one by labelled facets, and by rims.
  struct Neighbors {
    std::vector<Index> on_facets, on_rims; // sorted
  };
  void collect(const Opposite_edges& edges, Neighbors& neighbors) {
    ends_.clear();
    for (const Opposite_edge& e : edges) {
      ends_.emplace_back(e.a, e.label);
      ends_.emplace_back(e.b, e.label);
    }
    std::sort(ends_.begin(), ends_.end());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    neighbors.on_facets.clear();
    neighbors.on_rims.clear();
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      const bool again = k > 0 && ends_[k].first == ends_[k - 1].first;
      auto& list = again ? neighbors.on_rims : neighbors.on_facets;
      if (list.empty() || list.back() != ends_[k].first)
        list.push_back(ends_[k].first);
    }
  }

  bool holds_for_facets(Index v, Index w, const std::vector<Index>& star) {
    collect(v, star, of_v_);
    collect(w, other_star_, of_w_);
    collect(of_v_, by_v_);
    collect(of_w_, by_w_);
    const auto contains = [](const std::vector<Index>& list, Index u) {
      return std::binary_search(list.begin(), list.end(), u);
    };
    const auto same = [](const Opposite_edge& e, Index a, Index b) {
      return e.a == (std::min)(a, b) && e.b == (std::max)(a, b);
    };
    for (Index u : by_v_.on_facets)
      if (u != w && contains(by_w_.on_facets, u) &&
          std::none_of(of_v_.begin(), of_v_.end(), [&](const Opposite_edge& e) { return same(e, u, w); }))
        return false;
    for (const Opposite_edge& e : of_v_)
      if (std::any_of(of_w_.begin(), of_w_.end(), [&](const Opposite_edge& f) { return same(f, e.a, e.b); }))
        return false;
    return std::none_of(by_v_.on_rims.begin(), by_v_.on_rims.end(),
                        [&](Index u) { return u != w && contains(by_w_.on_rims, u); });
  }

  const Store& store_;
  std::vector<Index> other_star_, neighbors_;
  Opposite_edges of_v_, of_w_;
  Neighbors by_v_, by_w_;
  std::vector<std::pair<Index, std::int32_t>> ends_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_LINK_CONDITION_H

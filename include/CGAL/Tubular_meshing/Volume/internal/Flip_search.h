// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_FLIP_SEARCH_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_FLIP_SEARCH_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Looks for a flip that raises the quality of the worst tetrahedron of the cavity it changes: an edge is removed (the
 * ring around it is filled by the best of all triangulations of its link, found by dynamic programming [Klincsek 1980];
 * 3-2, 4-4 and 2-2 flips on the surface are cases of it), or a facet is (2-3 flips).
 *
 * On the surface a flip must in addition keep labels, rims and shape: `Surface_guard` is asked
 *   bool operator()(a, b, c, d, patch): may the edge ab between the facets abc and abd become the edge cd?
 * `Measure` gives the quality, at most one and positive for what is not inverted, of tetrahedra and of triangles, which
 * are compared with each other: see Isotropic_measure.
 *
 * The mesh is read only: several searches may run at the same time.
 */
template <class Surface_guard, class Measure> class Flip_search {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  // `quality`: of the tetrahedra, by their numbers
  Flip_search(const Store& store, const Surface_guard& guard, const Measure& measure, const std::vector<float>& quality)
      : store_(store)
      , guard_(guard)
      , measure_(measure)
      , quality_(quality) {}

  /* Whether there is one for tetrahedron t; what it replaces by what is then known. With `where_worst`, only cavities of
   * which t is the worst are looked at: enough where those that are worse are asked about as well, and a third of the
   * work. */
  bool find(Index t, bool where_worst = false) {
    where_worst_ = where_worst;
    std::array<bool, 4> is_better; // than what is behind the facet
    for (int i = 0; i < 4; ++i)
      is_better[i] = where_worst && is_worse_behind(t, i);
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        const auto kl = Store::other_corners(i, j);
        if (!is_better[kl.first] && !is_better[kl.second] && can_remove_edge(t, i, j))
          return true;
      }
    for (int i = 0; i < 4; ++i)
      if (!is_better[i] && can_remove_facet(t, i))
        return true;
    return false;
  }

  typedef boost::container::small_vector<Store::Vertices, 16> Cells;
  typedef boost::container::small_vector<Store::Labelled_facet, 2> Facets;
  const Store::Index_list& old_cells() const { return old_cells_; }
  const Cells& new_cells() const { return new_cells_; }
  const Facets& new_facets() const { return facets_; } // on the surface

  /* Whether it is still possible if all that has come since are those of which `is_new(t)` holds. A flip on the surface
   * depends on what is around. */
  template <class IsNew> bool is_fresh(const IsNew& is_new) const {
    return facets_.empty() && std::none_of(old_cells_.begin(), old_cells_.end(),
                                           [&](Index t) { return !store_.is_alive(t) || is_new(t); });
  }

private:
  static constexpr int most_link_vertices = 8;
  static constexpr double peelable = 0.3;    // worse than this, a tetrahedron on the surface is flat
  static constexpr double least_gain = 1e-3; // in quality: smaller ones invite endless exchanges between near ties

  bool is_worse_behind(Index t, int i) const {
    const Index n = store_[t].neighbor[i];
    return n != Store::none && quality_[Store::tetrahedron_of(n)] < quality_[t];
  }

  bool can_remove_edge(Index t, int i, int j) {
    int number = 0;
    double worst = 1;
    const bool is_found = store_.ring(t, i, j, ring_, [&](Index r) {
      worst = (std::min)(worst, double(quality_[r]));
      return ++number <= most_link_vertices && store_.region(r) == store_.region(t) &&
             !(where_worst_ && quality_[r] < quality_[t]);
    });
    const int m = int(ring_.link.size());
    if (!is_found || m > most_link_vertices)
      return false;
    if (m == 2)
      return can_peel(t, i, j);
    if (has_labelled_facet_inside())
      return false;
    double required = worst + least_gain;
    facets_.clear();
    if (!ring_.closed && !surface_flip_improves(required))
      return false;
    if (!best_triangulation(m, required))
      return false;
    // asked last, as they may be costly
    if (!ring_.closed && (are_joined(ring_.link.front(), ring_.link.back()) ||
                          !guard_(ring_.a, ring_.b, ring_.link.front(), ring_.link.back(), facets_.front().label)))
      return false;
    old_cells_.assign(ring_.tetrahedra.begin(), ring_.tetrahedra.end());
    new_cells_.clear();
    collect(0, m - 1);
    return true;
  }

  // A flat tetrahedron that lies on the surface with two facets: without it, the surface's edge is flipped.
  bool can_peel(Index t, int i, int j) {
    const Index c = ring_.link[0], d = ring_.link[1];
    const auto kl = Store::other_corners(i, j);
    const std::int32_t label = store_[t].label[kl.first];
    if (quality_[t] > peelable || label == 0 || label != store_[t].label[kl.second] ||
        store_[t].neighbor[i] == Store::none || store_[t].neighbor[j] == Store::none || store_[t].label[i] != 0 ||
        store_[t].label[j] != 0 || !guard_(ring_.a, ring_.b, c, d, label))
      return false;
    store_.ring(t, kl.first, kl.second, ring_);
    if (!ring_.closed) // the edge cd is on the surface already
      return false;
    const Index a = store_[t].v[i], b = store_[t].v[j];
    old_cells_.assign(1, t);
    new_cells_.clear();
    facets_ = {{{a, c, d}, label}, {{b, c, d}, label}};
    return true;
  }

  bool has_labelled_facet_inside() const {
    const std::size_t n = ring_.tetrahedra.size();
    for (std::size_t k = 0; k + (ring_.closed ? 0 : 1) < n; ++k) {
      const auto& tet = store_[ring_.tetrahedra[k]];
      if (tet.label[store_.corner(ring_.tetrahedra[k], ring_.link[k])] != 0)
        return true;
    }
    return false;
  }

  // The two boundary facets of an open ring; `required` sinks where they are the worst of the cavity.
  bool surface_flip_improves(double& required) {
    const Index a = ring_.a, b = ring_.b, c = ring_.link.front(), d = ring_.link.back();
    const Index first = ring_.tetrahedra.front(), last = ring_.tetrahedra.back();
    const std::size_t m = ring_.link.size();
    const std::int32_t label = store_[first].label[store_.corner(first, ring_.link[1])];
    if (label == 0 || label != store_[last].label[store_.corner(last, ring_.link[m - 2])])
      return false;
    // triangles count with the tetrahedra: one measure that only ever rises
    const double before = (std::min)(measure_.triangle(a, b, c), measure_.triangle(a, b, d));
    const double after = (std::min)(measure_.triangle(a, c, d), measure_.triangle(b, c, d));
    required = (std::min)(required, before + least_gain);
    if (after < required)
      return false;
    facets_.push_back({{a, c, d}, label});
    facets_.push_back({{b, c, d}, label});
    return true;
  }

  /* Whether two vertices are joined by an edge. If those of a flip on the surface are, outside of the cavity, the new
   * facets would come to lie on others: a dimple would be closed by the flip. */
  bool are_joined(Index c, Index d) {
    star_.assign(1, store_.tetrahedron_at(c));
    for (std::size_t k = 0; k < star_.size(); ++k) {
      const auto& tet = store_[star_[k]];
      for (int i = 0; i < 4; ++i) {
        if (tet.v[i] == d)
          return true;
        if (tet.v[i] == c || tet.neighbor[i] == Store::none)
          continue;
        const Index n = Store::tetrahedron_of(tet.neighbor[i]);
        if (std::find(star_.begin(), star_.end(), n) == star_.end())
          star_.push_back(n);
      }
    }
    return false;
  }

  // Klincsek's recurrence over the link polygon 0 … m-1: the worst quality of the best triangulation of i … j.
  bool best_triangulation(int m, double required) {
    const auto& r = ring_.link;
    for (int i = 0; i + 1 < m; ++i)
      best_[i][i + 1] = 1;
    for (int length = 2; length < m; ++length)
      for (int i = 0; i + length < m; ++i) {
        const int k = i + length;
        double best = -1;
        for (int j = i + 1; j < k; ++j) {
          double q = (std::min)(best_[i][j], best_[j][k]);
          if (q <= best || q < required)
            continue;
          q = (std::min)(q, measure_.tetrahedron(r[i], r[j], r[k], ring_.b));
          if (q <= best || q < required)
            continue;
          q = (std::min)(q, measure_.tetrahedron(r[i], r[k], r[j], ring_.a));
          if (q > best && q >= required) {
            best = q;
            apex_[i][k] = j;
          }
        }
        best_[i][k] = best;
      }
    return best_[0][m - 1] >= required;
  }

  void collect(int i, int k) {
    if (k < i + 2)
      return;
    const int j = apex_[i][k];
    const auto& r = ring_.link;
    new_cells_.push_back({r[i], r[j], r[k], ring_.b});
    new_cells_.push_back({r[i], r[k], r[j], ring_.a});
    collect(i, j);
    collect(j, k);
  }

  bool can_remove_facet(Index t, int i) {
    const auto& tet = store_[t];
    if (tet.neighbor[i] == Store::none || tet.label[i] != 0)
      return false;
    const Index s = Store::tetrahedron_of(tet.neighbor[i]);
    const Index p = tet.v[i], q = store_[s].v[Store::opposite_of(tet.neighbor[i])];
    const auto& c = Store::facet_corners(i);
    const double worst = (std::min)(quality_[t], quality_[s]) + least_gain;
    new_cells_.clear();
    for (int k = 0; k < 3; ++k) {
      const Index u = tet.v[c[k]], v = tet.v[c[(k + 1) % 3]];
      if (measure_.tetrahedron(p, q, u, v) < worst)
        return false;
      new_cells_.push_back({p, q, u, v});
    }
    old_cells_ = {t, s};
    facets_.clear();
    return true;
  }

  const Store& store_;
  const Surface_guard& guard_;
  const Measure& measure_;
  const std::vector<float>& quality_;

  bool where_worst_ = false;

  // the cavity at hand
  Store::Ring ring_;
  std::array<std::array<double, most_link_vertices>, most_link_vertices> best_;
  std::array<std::array<int, most_link_vertices>, most_link_vertices> apex_;
  Store::Index_list old_cells_, star_;
  Cells new_cells_;
  Facets facets_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_FLIP_SEARCH_H

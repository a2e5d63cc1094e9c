// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_REMESH_WORST_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_REMESH_WORST_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

/* Replaces a bad tetrahedron and some of those around it by the tetrahedra between a new vertex and the facets of the
 * cavity, if the worst of them is better: what helps where all vertices of a bad tetrahedron are fixed [Klingner and
 * Shewchuk 2007]. The cavity starts as the ring of an edge of the tetrahedron, and grows through the facets that the
 * worst new tetrahedra stand on; the vertex goes where the worst is best. Facets with a label are never crossed, so
 * that the boundary stays; inner vertices that the cavity swallows are gone. */
class Vertex_insertion {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  explicit Vertex_insertion(Store& store)
      : store_(store) {}

  // Whether t is gone; `come` are the new tetrahedra then.
  bool operator()(Index t, Store::Index_list& come) {
    Candidate best;
    best.worst = -1;
    double required = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        Candidate c;
        if (!start(t, i, j, c))
          continue;
        for (int round = 0; round < rounds; ++round) {
          place(c);
          grow(c);
        }
        place(c);
        const double before = worst_of(c.tetrahedra);
        if (c.worst > before + least_gain && c.worst > best.worst) {
          best = c;
          required = before;
        }
      }
    if (!(best.worst > required + least_gain))
      return false;
    Store::Star_links links;
    store_.match_star(best.facets, links);
    store_.replace_by_star(best.tetrahedra, best.facets, links, best.vertex, come);
    return true;
  }

private:
  struct Candidate {
    std::vector<Index> tetrahedra;
    std::vector<Index> facets; // of the cavity, each with its tetrahedron inside
    Vector_3d vertex;
    double worst = -1; // of the new tetrahedra
  };

  static constexpr int rounds = 3;
  static constexpr std::size_t most_tetrahedra = 60;
  static constexpr double least_gain = 1e-2; // in quality
  static constexpr int most_searches = 50;   // in all directions; ten are usual

  bool start(Index t, int i, int j, Candidate& c) {
    store_.ring(t, i, j, ring_);
    for (Index r : ring_.tetrahedra) {
      if (store_.region(r) != store_.region(t))
        return false;
      c.tetrahedra.push_back(r);
    }
    for (Index r : c.tetrahedra)
      for (int k = 0; k < 4; ++k)
        if (!leads_into(c, Store::facet(r, k)))
          c.facets.push_back(Store::facet(r, k));
        else if (store_[r].label[k] != 0)
          return false;
    for (Index r : c.tetrahedra)
      for (Index v : store_[r].v)
        c.vertex += (0.25 / double(c.tetrahedra.size())) * store_.point(v);
    return true;
  }

  bool leads_into(const Candidate& c, Index facet) const {
    const Index n = store_.other_side(facet);
    return n != Store::none &&
           std::find(c.tetrahedra.begin(), c.tetrahedra.end(), Store::tetrahedron_of(n)) != c.tetrahedra.end();
  }

  // Of the tetrahedron between a facet and a point on the side of its tetrahedron.
  double quality(Index facet, const Vector_3d& p) const {
    const auto v = store_.vertices(facet);
    return tetrahedron_gamma(p, store_.point(v[0]), store_.point(v[1]), store_.point(v[2]));
  }
  // The worst over all facets; given up once it is below `least`.
  double worst_with(const Candidate& c, const Vector_3d& p, double least) const {
    double worst = 1;
    for (Index f : c.facets) {
      worst = (std::min)(worst, quality(f, p));
      if (worst <= least)
        break;
    }
    return worst;
  }
  double worst_of(const std::vector<Index>& tetrahedra) const {
    double worst = 1;
    for (Index t : tetrahedra)
      worst = (std::min)(worst, gamma_of(store_, store_[t].v));
    return worst;
  }

  // Pattern search: along axes that turn with the steps, which get shorter where none of them helps. Where new
  // tetrahedra are inverted wherever the vertex is, they look the better the farther away it goes: that must end.
  void place(Candidate& c) const {
    double size = 0;
    for (Index f : c.facets)
      size = (std::max)(size, norm(store_.point(store_[Store::tetrahedron_of(f)].v[0]) - c.vertex));
    c.worst = worst_with(c, c.vertex, -2);
    int searches = 0;
    for (double step = 0.4 * size; step > 0.01 * size && searches < most_searches; ++searches) {
      bool moved = false;
      for (const Vector_3d& d : directions()) {
        const Vector_3d p = c.vertex + step * d;
        const double w = worst_with(c, p, c.worst);
        if (w > c.worst) {
          c.worst = w;
          c.vertex = p;
          moved = true;
        }
      }
      if (!moved)
        step *= 0.5;
    }
  }

  // The axes and the diagonals of a cube.
  static const std::array<Vector_3d, 14>& directions() {
    static const double d = std::sqrt(1 / 3.);
    static const std::array<Vector_3d, 14> all = {{{1, 0, 0},
                                                   {-1, 0, 0},
                                                   {0, 1, 0},
                                                   {0, -1, 0},
                                                   {0, 0, 1},
                                                   {0, 0, -1},
                                                   {d, d, d},
                                                   {d, d, -d},
                                                   {d, -d, d},
                                                   {d, -d, -d},
                                                   {-d, d, d},
                                                   {-d, d, -d},
                                                   {-d, -d, d},
                                                   {-d, -d, -d}}};
    return all;
  }

  // Through the facet under the worst new tetrahedron, as long as that makes the worst better.
  void grow(Candidate& c) const {
    while (c.tetrahedra.size() < most_tetrahedra) {
      Index facet = Store::none;
      double worst = 2;
      for (Index f : c.facets)
        if (quality(f, c.vertex) < worst) {
          worst = quality(f, c.vertex);
          facet = f;
        }
      if (!grow_through(facet, worst, c))
        return;
    }
  }

  bool grow_through(Index facet, double worst, Candidate& c) const {
    const Index n = store_.other_side(facet);
    if (n == Store::none || store_.label(facet) != 0)
      return false;
    const Index t = Store::tetrahedron_of(n);
    if (store_.region(t) != store_.region(Store::tetrahedron_of(facet)))
      return false;
    std::array<Index, 3> opened, closed;
    std::size_t number_opened = 0, number_closed = 0;
    for (int k = 0; k < 4; ++k) {
      const Index f = Store::facet(t, k);
      if (f == n)
        continue;
      if (leads_into(c, f)) {
        if (store_[t].label[k] != 0)
          return false;
        closed[number_closed++] = store_[t].neighbor[k];
      } else {
        if (quality(f, c.vertex) <= worst + least_gain)
          return false;
        opened[number_opened++] = f;
      }
    }
    const auto is_gone = [&](Index f) {
      return f == facet ||
             std::find(closed.begin(), closed.begin() + number_closed, f) != closed.begin() + number_closed;
    };
    c.facets.erase(std::remove_if(c.facets.begin(), c.facets.end(), is_gone), c.facets.end());
    c.facets.insert(c.facets.end(), opened.begin(), opened.begin() + number_opened);
    c.tetrahedra.push_back(t);
    return true;
  }

  Store& store_;
  Store::Ring ring_;
};

/* Takes inner vertices away from the tetrahedra below `threshold`, or adds some, where that makes the worst of those
 * around better: for the few that flips and moves cannot improve. The boundary stays as it is. */
inline void remesh_worst(Tetrahedron_store& store, double threshold, int threads) {
  typedef Tetrahedron_store::Index Index;
  const auto is_bad = [&](Index t) { return store.is_alive(t) && gamma_of(store, store[t].v) < threshold; };
  std::vector<Index> todo = store.tetrahedra(is_bad, threads);
  Vertex_removal remove(store);
  Vertex_insertion insert(store);
  Tetrahedron_store::Index_list come;
  // each change raises the worst quality of a cavity by a step, so this ends; the bound is against rounding
  const std::size_t most = 20 * todo.size();
  for (std::size_t k = 0; k < todo.size() && k < most; ++k)
    if (is_bad(todo[k]) && (remove(todo[k], come) || insert(todo[k], come)))
      for (Index t : come)
        if (is_bad(t))
          todo.push_back(t);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_REMESH_WORST_H

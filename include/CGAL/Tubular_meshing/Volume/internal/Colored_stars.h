// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_COLORED_STARS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_COLORED_STARS_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The stars of all vertices of a mesh whose topology stays as it is, and the vertices in colors, no two of a color
 * sharing a tetrahedron: those of one color may be moved at the same time, so that the result is the same for any
 * number of threads. Linear. */
class Colored_stars {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  struct Range {
    const Index *first, *last;
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
    bool empty() const { return first == last; }
    std::size_t size() const { return std::size_t(last - first); }
  };

  // `is_movable(v)`: only these are given colors.
  template <class IsMovable> void build(const Store& store, const IsMovable& is_movable) {
    collect(store);
    color(is_movable);
  }

  // The facets opposite to v in the tetrahedra around it.
  Range facets(Index v) const { return {star_.data() + star_begin_[v], star_.data() + star_begin_[v + 1]}; }

  // Their vertices, in this order: who needs no more of the tetrahedra reads them from one place.
  const Store::Facet_vertices* vertices_of_facets(Index v) const { return vertices_.data() + star_begin_[v]; }

  /* visit(v) for each movable vertex, color by color, those of a color on `threads` threads, each piece of them by a copy
   * of `visit`, which may have memory of its own; before_color() is called once before each color. */
  template <class Visit, class Before_color>
  void for_each_movable(int threads, const Visit& visit, const Before_color& before_color) const {
    for (std::size_t c = 0; c + 1 < color_begin_.size(); ++c) {
      before_color();
      const std::size_t begin = color_begin_[c];
      for_each_range(color_begin_[c + 1] - begin, threads, [&](std::size_t first, std::size_t last) {
        Visit visit_one = visit;
        for (std::size_t k = first; k < last; ++k)
          visit_one(by_color_[begin + k]);
      });
    }
  }

private:
  void collect(const Store& store) {
    const Index n = store.number_of_vertices();
    star_begin_.assign(n + 1, 0);
    for (Index t = 0; t < store.number_of_slots(); ++t)
      if (store.is_alive(t))
        for (Index v : store[t].v)
          ++star_begin_[v + 1];
    for (Index v = 0; v < n; ++v)
      star_begin_[v + 1] += star_begin_[v];
    star_.resize(star_begin_[n]);
    vertices_.resize(star_begin_[n]);
    std::vector<Index> next(star_begin_.begin(), star_begin_.end() - 1);
    for (Index t = 0; t < store.number_of_slots(); ++t)
      if (store.is_alive(t))
        for (int i = 0; i < 4; ++i) {
          const std::size_t place = next[store[t].v[i]]++;
          star_[place] = Store::facet(t, i);
          vertices_[place] = store.vertices(Store::facet(t, i));
        }
  }

  // Greedy, in the order of the vertices.
  template <class IsMovable> void color(const IsMovable& is_movable) {
    const Index n = Index(star_begin_.size() - 1);
    std::vector<std::uint8_t> color_of(n, 255);
    std::size_t colors = 0;
    std::vector<Index> used(256, Store::none);
    for (Index v = 0; v < n; ++v) {
      if (facets(v).empty() || !is_movable(v))
        continue;
      for (std::size_t k = star_begin_[v]; k < star_begin_[v + 1]; ++k)
        for (Index w : vertices_[k])
          if (color_of[w] != 255)
            used[color_of[w]] = v;
      std::size_t c = 0;
      while (c < 254 && used[c] == v)
        ++c;
      color_of[v] = std::uint8_t(c);
      colors = (std::max)(colors, c + 1);
    }
    color_begin_.assign(colors + 1, 0);
    for (Index v = 0; v < n; ++v)
      if (color_of[v] != 255)
        ++color_begin_[color_of[v] + 1];
    for (std::size_t c = 0; c < colors; ++c)
      color_begin_[c + 1] += color_begin_[c];
    by_color_.resize(color_begin_[colors]);
    std::vector<std::size_t> next(color_begin_.begin(), color_begin_.end());
    for (Index v = 0; v < n; ++v)
      if (color_of[v] != 255)
        by_color_[next[color_of[v]]++] = v;
  }

  std::vector<Index> star_begin_, star_;
  std::vector<Store::Facet_vertices> vertices_; // of the facets in star_
  std::vector<std::size_t> color_begin_;
  std::vector<Index> by_color_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_COLORED_STARS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_COLORED_STARS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_COLORED_STARS_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The stars of all vertices of a mesh whose topology stays as it is, and the vertices in blocks of consecutive numbers, the
 * blocks in colors, no two of a color with vertices that share a tetrahedron: those of one color may be moved at the same
 * time, so that the result is the same for any number of threads. Blocks of one vertex suit any numbering. Where vertices
 * are numbered along a space-filling curve, larger blocks are compact, and what one of their vertices has brought into the
 * cache is there for the next. Linear. */
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

  // `is_movable(v)`: only these are visited. `block`: how many vertices are one, at most.
  template <class IsMovable> void build(const Store& store, const IsMovable& is_movable, int threads, Index block = 1) {
    build(
        store, is_movable, [](Index) { return true; }, threads, block);
  }
  /* The same where only vertices of which has_star(v) holds are asked about, the movable ones among them: the others have
   * no stars. */
  template <class IsMovable, class HasStar>
  void build(const Store& store, const IsMovable& is_movable, const HasStar& has_star, int threads, Index block) {
    collect(store, has_star, threads);
    color(collect_blocks(is_movable, block));
    grain_ = (std::max)(std::size_t(1), std::size_t(128 / block));
  }

  // The facets opposite to v in the tetrahedra around it.
  Range facets(Index v) const { return {star_.get() + star_begin_[v], star_.get() + star_begin_[v + 1]}; }

  // Their vertices, in this order: who needs no more of the tetrahedra reads them from one place.
  const Store::Facet_vertices* vertices_of_facets(Index v) const { return vertices_.get() + star_begin_[v]; }

  /* visit(v) for each movable vertex, color by color, those of a color on `threads` threads, each piece of them by a copy
   * of `visit`, which may have memory of its own, those of a block in their order; before_color() is called once before
   * each color. */
  template <class Visit, class Before_color>
  void for_each_movable(int threads, const Visit& visit, const Before_color& before_color) const {
    for (std::size_t c = 0; c + 1 < color_begin_.size(); ++c) {
      before_color();
      const std::size_t begin = color_begin_[c];
      for_each_range(
          color_begin_[c + 1] - begin, threads,
          [&](std::size_t first, std::size_t last) {
            Visit visit_one = visit;
            for (std::size_t k = begin + first; k < begin + last; ++k)
              for (Index v : by_color_[k])
                visit_one(v);
          },
          grain_);
    }
  }

private:
  /* Tetrahedra in a few parts, one after the other, of each of which it is known how many facets it has at each vertex:
   * they can be put in their places side by side, in the same order on any number of threads. */
  template <class HasStar> void collect(const Store& store, const HasStar& has_star, int threads) {
    const std::size_t parts = 4;
    const Index n = store.number_of_vertices(), slots = store.number_of_slots();
    std::array<std::vector<Index>, parts> place; // where the next facet of a part at each vertex goes
    const auto for_each_of = [&](std::size_t part, const auto& visit) {
      for (Index t = Index(part * slots / parts); t < Index((part + 1) * slots / parts); ++t)
        if (store.is_alive(t))
          visit(t);
    };
    for_each_task(parts, threads, [&](std::size_t part) {
      place[part].assign(n, 0);
      for_each_of(part, [&](Index t) {
        for (Index v : store[t].v)
          place[part][v] += has_star(v);
      });
    });
    star_begin_.assign(n + 1, 0);
    for (Index v = 0; v < n; ++v) {
      Index next = star_begin_[v];
      for (std::vector<Index>& of_part : place)
        next += std::exchange(of_part[v], next);
      star_begin_[v + 1] = next;
    }
    star_.reset(new Index[star_begin_[n]]); // not set to zero, which would be the work of one thread
    vertices_.reset(new Store::Facet_vertices[star_begin_[n]]);
    for_each_task(parts, threads, [&](std::size_t part) {
      for_each_of(part, [&](Index t) {
        for (int i = 0; i < 4; ++i) {
          if (!has_star(store[t].v[i]))
            continue;
          const Index k = place[part][store[t].v[i]]++;
          star_[k] = Store::facet(t, i);
          vertices_[k] = store.vertices(star_[k]);
        }
      });
    });
  }

  // The movable vertices, block by block, and where they are in movable_.
  template <class IsMovable> std::vector<Range> collect_blocks(const IsMovable& is_movable, Index block) {
    const Index n = Index(star_begin_.size() - 1);
    block_of_.assign(n, Store::none);
    movable_.clear();
    std::vector<std::size_t> begin;
    for (Index v = 0, last = Store::none; v < n; ++v) {
      if (facets(v).empty() || !is_movable(v))
        continue;
      if (v / block != last)
        begin.push_back(movable_.size());
      last = v / block;
      block_of_[v] = Index(begin.size() - 1);
      movable_.push_back(v);
    }
    begin.push_back(movable_.size());
    std::vector<Range> blocks;
    for (std::size_t b = 0; b + 1 < begin.size(); ++b)
      blocks.push_back({movable_.data() + begin[b], movable_.data() + begin[b + 1]});
    return blocks;
  }

  // Greedy, in the order of the blocks.
  void color(const std::vector<Range>& blocks) {
    std::vector<Index> color_of(blocks.size(), Store::none), used; // colors, by the last block that could not have them
    for (Index b = 0; b < blocks.size(); ++b) {
      for (Index v : blocks[b])
        for (std::size_t k = star_begin_[v]; k < star_begin_[v + 1]; ++k)
          for (Index w : vertices_[k])
            if (block_of_[w] < b)
              used[color_of[block_of_[w]]] = b;
      const auto free = std::find_if(used.begin(), used.end(), [=](Index last) { return last != b; });
      color_of[b] = Index(free - used.begin());
      if (free == used.end())
        used.push_back(Store::none);
    }
    color_begin_.assign(used.size() + 1, 0);
    for (Index c : color_of)
      ++color_begin_[c + 1];
    std::partial_sum(color_begin_.begin(), color_begin_.end(), color_begin_.begin());
    by_color_.resize(blocks.size());
    std::vector<std::size_t> next(color_begin_.begin(), color_begin_.end());
    for (Index b = 0; b < blocks.size(); ++b)
      by_color_[next[color_of[b]]++] = blocks[b];
  }

  std::vector<Index> star_begin_;                     // of each vertex in the next two
  std::unique_ptr<Index[]> star_;                     // facets
  std::unique_ptr<Store::Facet_vertices[]> vertices_; // of these
  std::vector<Index> movable_, block_of_;             // the latter by vertex
  std::vector<std::size_t> color_begin_;
  std::vector<Range> by_color_; // blocks
  std::size_t grain_ = 1;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_COLORED_STARS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REMOVE_FINS_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REMOVE_FINS_H

#include <CGAL/Tubular_meshing/Repair/internal/Soup_edges.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

class Index_union {
public:
  explicit Index_union(std::size_t n)
      : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    parent_[(std::max)(i, j)] = (std::min)(i, j); // the smallest index names the set
  }

private:
  std::vector<std::size_t> parent_;
};

struct Removed_fins {
  std::size_t edges = 0, triangles = 0;
  Coordinates place = {0, 0, 0}; ///< an end of the first such edge
};

/* Removes what makes edges have more than two triangles: the soup is cut into patches along these edges; a patch goes
 * if all of its edges keep at least two triangles without it, membranes (bounded by such edges only) before fins (with
 * free borders), small ones first, and never a tenth of the whole. Where two sheets cross in an edge, nothing can go:
 * such edges are left. O(n log n). */
class Fin_remover {
public:
  explicit Fin_remover(Triangle_soup& soup)
      : soup_(soup)
      , patch_of_(soup.triangles.size()) {}

  Removed_fins remove() {
    Removed_fins removed;
    find_patches();
    removed.edges = edges_.size();
    if (edges_.empty())
      return removed;
    removed.place = soup_.points[edges_.front().a];
    double total = 0;
    std::vector<Patch*> order;
    for (auto& p : patches_) {
      total += p.second.area;
      order.push_back(&p.second);
    }
    std::sort(order.begin(), order.end(), [](const Patch* p, const Patch* q) {
      return std::make_tuple(p->free_edges > 0, p->area, p->first) <
             std::make_tuple(q->free_edges > 0, q->area, q->first);
    });
    for (Patch* p : order)
      if (p->area < 0.1 * total && is_superfluous(*p))
        take_out(*p);
    std::vector<Index_triangle> kept;
    for (std::size_t f = 0; f < patch_of_.size(); ++f)
      if (!patches_.at(patch_of_[f]).removed)
        kept.push_back(soup_.triangles[f]);
    removed.triangles = soup_.triangles.size() - kept.size();
    soup_.triangles.swap(kept);
    return removed;
  }

private:
  struct Crowded_edge {
    std::size_t a, count;
  };
  struct Patch {
    std::size_t first = 0, free_edges = 0;
    double area = 0;
    std::map<std::size_t, std::size_t> sides; ///< by crowded edge: how many triangles of the patch are there
    bool removed = false;
  };

  void find_patches() {
    const Soup_edges edges(soup_);
    Index_union sets(soup_.triangles.size());
    std::vector<std::pair<std::size_t, std::size_t>> free_sides, crowded_sides; // (triangle, edge)
    edges.for_each([&](const Soup_edges::Edge& e) {
      if (e.count() == 2)
        sets.join(e.first[0].side / 3, e.first[1].side / 3);
      else if (e.count() == 1)
        free_sides.emplace_back(e.first->side / 3, 0);
      else {
        for (auto s = e.first; s != e.last; ++s)
          crowded_sides.emplace_back(s->side / 3, edges_.size());
        edges_.push_back(Crowded_edge{e.a, e.count()});
      }
    });
    if (edges_.empty())
      return;
    for (std::size_t f = 0; f < patch_of_.size(); ++f) {
      patch_of_[f] = sets.find(f);
      Patch& p = patches_[patch_of_[f]];
      p.first = patch_of_[f];
      p.area += triangle_area(soup_, soup_.triangles[f]);
    }
    for (const auto& s : free_sides)
      ++patches_[patch_of_[s.first]].free_edges;
    for (const auto& s : crowded_sides)
      ++patches_[patch_of_[s.first]].sides[s.second];
  }

  bool is_superfluous(const Patch& p) const {
    if (p.sides.empty())
      return false;
    return std::all_of(p.sides.begin(), p.sides.end(), [&](const auto& s) {
      const std::size_t left = edges_[s.first].count - s.second;
      return left == 0 || left >= 2;
    });
  }

  void take_out(Patch& p) {
    p.removed = true;
    for (const auto& s : p.sides)
      edges_[s.first].count -= s.second;
  }

  Triangle_soup& soup_;
  std::vector<std::size_t> patch_of_;
  std::vector<Crowded_edge> edges_;
  std::map<std::size_t, Patch> patches_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REMOVE_FINS_H

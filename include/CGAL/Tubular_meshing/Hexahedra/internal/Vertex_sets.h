// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VERTEX_SETS_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VERTEX_SETS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The distinct sets of K vertices among many: the edges of a mesh (K = 2), its triangles (3), its quads (4), numbered
 * from 0 by their least vertex. Linear, but for the sorting of those that share their least vertex, which are few. */
template <std::size_t K> class Vertex_sets {
public:
  typedef std::array<std::uint32_t, K> Set;

  Vertex_sets() = default;

  /* `for_each(visit)` calls visit(set) for every set, in any order of its vertices, as often as it occurs. It is called
   * twice, and must do the same then. */
  template <class For_each> Vertex_sets(std::size_t number_of_vertices, const For_each& for_each) {
    first_.assign(number_of_vertices + 1, 0);
    for_each([&](const Set& s) { ++first_[*std::min_element(s.begin(), s.end()) + 1]; });
    for (std::size_t v = 0; v < number_of_vertices; ++v)
      first_[v + 1] += first_[v];
    sets_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for_each([&](const Set& s) {
      const Set ordered = in_order(s);
      sets_[next[ordered[0]]++] = ordered;
    });
    keep_one_of_each();
  }

  std::size_t size() const { return sets_.size(); }
  const Set& operator[](std::size_t i) const { return sets_[i]; }

  /* The number of a set that is there. */
  std::size_t number(const Set& s) const {
    const Set ordered = in_order(s);
    const auto begin = sets_.begin() + std::ptrdiff_t(first_[ordered[0]]);
    const auto end = sets_.begin() + std::ptrdiff_t(first_[ordered[0] + 1]);
    return std::size_t(std::lower_bound(begin, end, ordered) - sets_.begin());
  }

private:
  static Set in_order(Set s) {
    std::sort(s.begin(), s.end());
    return s;
  }

  void keep_one_of_each() {
    std::size_t kept = 0, begin = 0;
    for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
      const std::size_t end = first_[v + 1];
      const auto from = sets_.begin() + std::ptrdiff_t(begin), to = sets_.begin() + std::ptrdiff_t(end);
      std::sort(from, to);
      first_[v] = kept;
      for (auto s = from; s != to; ++s)
        if (s == from || *s != *(s - 1))
          sets_[kept++] = *s; // never past s, so that its neighbour is there to be compared with
      begin = end;
    }
    if (!first_.empty())
      first_.back() = kept;
    sets_.resize(kept);
    sets_.shrink_to_fit();
  }

  std::vector<std::size_t> first_; // of each vertex's, and one more
  std::vector<Set> sets_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VERTEX_SETS_H

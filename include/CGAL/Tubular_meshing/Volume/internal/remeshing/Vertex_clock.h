// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_VERTEX_CLOCK_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_VERTEX_CLOCK_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/order_in_space.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* When vertices moved last, and when each was looked at last: most of a mesh is at rest soon, and need not be looked at
 * again before something near it has changed.
 *
 * Time goes on by tick(), and in between by the vertices of a block, one after the other, see Colored_stars. Threads may
 * write at the same time for vertices of blocks that are no neighbors.
 */
class Vertex_clock {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;
  typedef std::uint32_t Time;

  void resize(std::size_t n) {
    moved_.resize(n, 0);
    renewed_.resize(n, 0);
    visited_.resize(n, 0);
  }
  void renumber(const std::vector<std::size_t>& order) {
    for (std::vector<Time>* times : {&moved_, &renewed_, &visited_})
      put_in_order(order, *times);
  }

  static constexpr Index block = 128;

  Time now() const { return now_; }
  void tick() { now_ += block; }

  // Another neighborhood than before.
  void wake(Index v) {
    visited_[v] = 0;
    renewed_[v] = now_;
  }
  void wake_all() { std::fill(visited_.begin(), visited_.end(), Time(0)); }
  void set_visited(Index v) { visited_[v] = now_ + v % block; }
  void set_moved(Index v) { moved_[v] = now_ + v % block; }

  template <class Vertices> bool any_stirred_since(const Vertices& vertices, Time t) const {
    return std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return moved_[v] > t || renewed_[v] > t; });
  }

  // Whether something has moved among v and its neighbors since it was visited; these are the vertices of facets.
  bool is_awake(Index v, const Store::Facet_vertices* first, const Store::Facet_vertices* last_facet) const {
    const Time last = visited_[v];
    if (last == 0 || moved_[v] >= last) // its own move at that time may have been a first step only
      return true;
    return std::any_of(first, last_facet, [&](const Store::Facet_vertices& w) {
      return (std::max)((std::max)(moved_[w[0]], moved_[w[1]]), moved_[w[2]]) > last;
    });
  }

private:
  Time now_ = 1;
  std::vector<Time> moved_, renewed_, visited_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_VERTEX_CLOCK_H

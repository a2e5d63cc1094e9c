// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_PLANE_FLIPS_H
#define CGAL_TUBULAR_MESHING_PLANE_PLANE_FLIPS_H

#include <CGAL/Tubular_meshing/Plane/Metric_plane.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Edge flips over the whole triangulation, or around what has changed. */
class Plane_flips {
public:
  typedef Plane_store::Index Index;

  explicit Plane_flips(Metric_plane& plane)
      : plane_(plane)
      , store_(plane.store) {}

  // Until all edges are Delaunay in the metric. In a constant metric that takes at most a number of flips quadratic in
  // the edges; in a varying one it need not end: hence the bounds.
  void make_delaunay() {
    push_all();
    const std::size_t n = stack_.size();
    run(100 * n + (std::min)(n * n, std::size_t(4000000)), [&](Index h) { return !plane_.is_locally_delaunay(h); });
  }

  // Until no flip raises the worse quality of its two triangles. Ends: sorted qualities only ever rise.
  void improve() {
    push_all();
    run(20 * stack_.size() + 100, [&](Index h) { return raises_quality(h); });
  }
  void improve_around(Index v) {
    store_.for_each_outgoing(v, [&](Index h) {
      stack_.push_back(h);
      stack_.push_back(Plane_store::next(h));
    });
    run(20 * stack_.size() + 100, [&](Index h) { return raises_quality(h); });
  }

private:
  static constexpr double least_gain = 1e-4; // smaller gains invite endless exchanges between near ties

  void push_all() {
    for (Index h = 0; h < 3 * store_.number_of_triangles(); ++h)
      if (store_.is_alive(h / 3) && store_.twin(h) != Plane_store::none && h < store_.twin(h))
        stack_.push_back(h);
  }

  template <class Criterion> void run(std::size_t most, const Criterion& wanted) {
    while (!stack_.empty() && most-- > 0) {
      const Index h = stack_.back(), g = store_.twin(h);
      stack_.pop_back();
      if (!plane_.is_flippable(h) || !wanted(h))
        continue;
      store_.flip(h);
      for (Index k : {Plane_store::next(h), Plane_store::prev(h), Plane_store::next(g), Plane_store::prev(g)})
        stack_.push_back(k);
    }
    stack_.clear();
  }

  bool raises_quality(Index h) const {
    const Index g = store_.twin(h);
    const Plane_node &a = plane_.origin(h), &b = plane_.target(h), &c = plane_.apex(h), &d = plane_.apex(g);
    const double required = (std::min)(plane_.quality(a, b, c), plane_.quality(b, a, d)) + least_gain;
    return plane_.quality(a, d, c) >= required && plane_.quality(d, b, c) >= required;
  }

  Metric_plane& plane_;
  Plane_store& store_;
  std::vector<Index> stack_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_PLANE_FLIPS_H

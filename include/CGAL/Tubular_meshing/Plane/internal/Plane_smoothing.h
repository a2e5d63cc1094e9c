// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_INTERNAL_PLANE_SMOOTHING_H
#define CGAL_TUBULAR_MESHING_PLANE_INTERNAL_PLANE_SMOOTHING_H

#include <CGAL/Tubular_meshing/Plane/Metric_plane.h>
#include <CGAL/Tubular_meshing/base/constants.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Moves vertices inside the domain towards the mean of the apexes of the equilateral triangles, in the metric, on the
 * edges around them. A move is taken if all triangles around stay positive, the worst does not get worse, and the sum
 * of qualities rises. */
class Plane_smoothing {
public:
  typedef Plane_store::Index Index;
  typedef Plane_node Node;

  explicit Plane_smoothing(Metric_plane& plane)
      : plane_(plane)
      , store_(plane.store)
      , changed_(plane.store.number_of_vertices(), 0) {}

  // Vertices around which nothing has moved since the sweep before are left alone. Returns the number of moves.
  std::size_t sweep() {
    ++sweep_;
    std::size_t moves = 0;
    for (Index v = store_.boundary_size(); v < store_.number_of_vertices(); ++v)
      if (store_.is_vertex_alive(v) && is_awake(v) && move(v)) {
        changed_[v] = sweep_;
        ++moves;
      }
    return moves;
  }

private:
  static constexpr double least_step = 0.01; // of the unit length
  static constexpr double least_gain = 1e-5;

  bool is_awake(Index v) const {
    if (sweep_ == 1)
      return true;
    bool awake = changed_[v] + 1 >= sweep_;
    store_.for_each_outgoing(v, [&](Index h) { awake = awake || changed_[store_.target(h)] + 1 >= sweep_; });
    return awake;
  }

  bool move(Index v) {
    const Node old = plane_.nodes[v];
    const Plane_vector step = step_to_target(v);
    const double length = old.metric.length(step.x, step.y);
    if (!(length > least_step))
      return false;
    const Star before = star(v, old);
    for (double s = (std::min)(1., 0.5 / length); s * length > least_step; s /= 3) {
      const Plane_point p(old.point.x() + s * step.x, old.point.y() + s * step.y);
      if (!is_inside_star(v, p))
        continue;
      if (!is_promising(v, p, before))
        continue;
      const Node moved = plane_.node_at(p, old.scale);
      if (star(v, moved).is_better_than(before)) {
        plane_.nodes[v] = moved;
        return true;
      }
    }
    return false;
  }

  Plane_vector step_to_target(Index v) const {
    const Node& x = plane_.nodes[v];
    Plane_vector sum = {0, 0};
    std::size_t n = 0;
    store_.for_each_outgoing(v, [&](Index h) {
      const Plane_vector step = step_to_apex(plane_.target(h), plane_.apex(h), x);
      sum.x += step.x;
      sum.y += step.y;
      ++n;
    });
    return {sum.x / double(n), sum.y / double(n)};
  }

  static Plane_vector step_to_apex(const Node& a, const Node& b, const Node& x) {
    Plane_vector step;
    if (Metric_plane::step_to_apex(a, b, x, Metric_plane::length(a, b), step))
      return step;
    const Plane_vector e = b.point - a.point, to_a = a.point - x.point;
    const auto turn = (a.shape + b.shape + x.shape).quarter_turn(e.x, e.y);
    return {to_a.x + e.x / 2 + root_of_3 / 2 * turn[0], to_a.y + e.y / 2 + root_of_3 / 2 * turn[1]};
  }

  struct Star {
    double worst = 1, sum = 0;
    bool is_better_than(const Star& other) const { return worst >= other.worst && sum > other.sum + least_gain; }
  };
  Star star(Index v, const Node& x) const {
    Star s;
    store_.for_each_outgoing(v, [&](Index h) {
      const double q = plane_.quality(x, plane_.target(h), plane_.apex(h));
      s.worst = (std::min)(s.worst, q);
      s.sum += q;
    });
    return s;
  }

  // The field may be slow: it is asked at places only that would be better if it were constant around the vertex.
  bool is_promising(Index v, const Plane_point& p, const Star& before) const {
    if (plane_.is_embedded())
      return true;
    Node moved = plane_.nodes[v];
    moved.point = p;
    return star(v, moved).is_better_than(before);
  }

  bool is_inside_star(Index v, const Plane_point& p) const {
    bool inside = true;
    store_.for_each_outgoing(v, [&](Index h) {
      inside = inside && CGAL::orientation(plane_.target(h).point, plane_.apex(h).point, p) == CGAL::LEFT_TURN;
    });
    return inside;
  }

  Metric_plane& plane_;
  Plane_store& store_;
  std::vector<std::uint32_t> changed_; // the sweep in which a vertex last moved
  std::uint32_t sweep_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_INTERNAL_PLANE_SMOOTHING_H

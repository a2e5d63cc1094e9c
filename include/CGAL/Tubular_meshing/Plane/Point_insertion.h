// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_POINT_INSERTION_H
#define CGAL_TUBULAR_MESHING_PLANE_POINT_INSERTION_H

#include <CGAL/Tubular_meshing/Plane/Metric_plane.h>

#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Insertion into a triangulation that is Delaunay in a varying metric. A point's conflict region is a matter of taste
 * there, and need not be star-shaped; so the point splits the triangle it lies in, and edges opposite to it are flipped
 * while the metric's Delaunay criterion says so and the exact predicates allow it. The triangulation is valid after
 * each flip whatever the metric does, and as each flip gives the point one more neighbour, flipping ends. */
class Point_insertion {
public:
  typedef Plane_store::Index Index;
  typedef Plane_node Node;

  explicit Point_insertion(Metric_plane& plane)
      : plane_(plane)
      , store_(plane.store) {}

  // Where a point lies: in the triangle of `half_edge`, or on that very edge; `none` if it cannot be reached.
  struct Place {
    Index half_edge = Plane_store::none;
    bool is_on_edge = false;
  };

  // Walks from the middle of h to x, on the left of h, straight on: not past the boundary, hence outside is `none`.
  Place locate(Index h, const Plane_point& x) const {
    const Plane_point start = CGAL::midpoint(plane_.origin(h).point, plane_.target(h).point);
    if (CGAL::orientation(start, x, plane_.origin(h).point) != CGAL::LEFT_TURN ||
        CGAL::orientation(start, x, plane_.target(h).point) != CGAL::RIGHT_TURN)
      return {}; // edges of a few units in the last place: the way would not be straight
    for (;;) {
      // the line enters across h, leaving its origin on the left
      const bool apex_on_right = CGAL::orientation(start, x, plane_.apex(h).point) == CGAL::RIGHT_TURN;
      const Index exit = apex_on_right ? Plane_store::prev(h) : Plane_store::next(h);
      const auto side = CGAL::orientation(plane_.origin(exit).point, plane_.target(exit).point, x);
      if (side == CGAL::LEFT_TURN)
        return {h, false};
      if (store_.twin(exit) == Plane_store::none)
        return {};
      if (side == CGAL::COLLINEAR)
        return {exit, true};
      h = store_.twin(exit);
    }
  }

  // The same without a hint, by a look at every triangle.
  Place find(const Plane_point& x) const {
    for (Index t = 0; t < store_.number_of_triangles(); ++t) {
      if (!store_.is_alive(t))
        continue;
      int sides_left = 0;
      Place on_edge;
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        const auto side = CGAL::orientation(plane_.origin(h).point, plane_.target(h).point, x);
        sides_left += side == CGAL::LEFT_TURN;
        if (side == CGAL::COLLINEAR)
          on_edge = {h, true};
      }
      if (sides_left == 3)
        return {3 * t, false};
      if (sides_left == 2 && on_edge.is_on_edge && store_.twin(on_edge.half_edge) != Plane_store::none)
        return on_edge;
    }
    return {};
  }

  Index insert(const Place& place, const Node& node) {
    const Index x =
        place.is_on_edge ? store_.insert_on_edge(place.half_edge) : store_.insert_in_triangle(place.half_edge / 3);
    plane_.nodes.push_back(node);
    store_.for_each_outgoing(x, [&](Index h) { stack_.push_back(Plane_store::next(h)); });
    while (!stack_.empty()) {
      const Index h = stack_.back();
      stack_.pop_back();
      if (!plane_.is_flippable(h) || plane_.is_locally_delaunay(h))
        continue;
      const Index g = store_.twin(h);
      store_.flip(h);
      stack_.push_back(Plane_store::prev(h));
      stack_.push_back(Plane_store::next(g));
    }
    return x;
  }

  // Whether what x, in `place`, would see as its neighbours are vertices no nearer to it than `least_distance` and, if
  // these matter, edges of the boundary under good angles.
  bool has_room(const Place& place, const Node& x, double least_distance, bool angles_matter = true) {
    const auto is_far = [&](Index v) { return Metric_plane::length(x, plane_.nodes[v]) >= least_distance; };
    const Index t = place.half_edge / 3;
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      if (!is_far(store_.origin(h)))
        return false;
      stack_.push_back(h);
    }
    bool all = true;
    std::size_t steps = 0;
    while (all && !stack_.empty() && ++steps < most_steps) {
      const Index h = stack_.back(), g = store_.twin(h);
      stack_.pop_back();
      if (g == Plane_store::none) {
        all = !angles_matter || plane_.sees_at_good_angle(x, h);
      } else if (Metric_plane::is_in_circle(plane_.origin(g), plane_.target(g), plane_.apex(g), x)) {
        all = is_far(store_.apex(g));
        stack_.push_back(Plane_store::next(g));
        stack_.push_back(Plane_store::prev(g));
      }
    }
    stack_.clear();
    return all;
  }

private:
  static constexpr std::size_t most_steps = 200; // in a wild metric regions may overlap themselves

  Metric_plane& plane_;
  Plane_store& store_;
  std::vector<Index> stack_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_POINT_INSERTION_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_INTERNAL_PLANE_SIZE_CONTROL_H
#define CGAL_TUBULAR_MESHING_PLANE_INTERNAL_PLANE_SIZE_CONTROL_H

#include <CGAL/Tubular_meshing/Plane/Plane_flips.h>
#include <CGAL/Tubular_meshing/Plane/Point_insertion.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Tubular_meshing::internal {

/* Splits edges that are too long in the metric, and removes vertices with edges that are too short. */
class Plane_size_control {
public:
  typedef Plane_store::Index Index;
  typedef Plane_node Node;

  explicit Plane_size_control(Metric_plane& plane)
      : plane_(plane)
      , store_(plane.store)
      , insertion_(plane)
      , flips_(plane) {}

  // One look at every edge inside, with the metric in its middle: what vertices alone have missed, a layer thinner than
  // the sizes beside it, shows here. Returns the number of new vertices.
  std::size_t split_long_edges() {
    const std::size_t before = store_.number_of_vertices(), n = store_.number_of_triangles();
    for (Index h = 0; h < 3 * n; ++h)
      if (store_.is_alive(h / 3) && store_.twin(h) != Plane_store::none && h < store_.twin(h))
        split_if_long(h);
    return store_.number_of_vertices() - before;
  }

  // Removes vertices inside that are too near to another, or have too few neighbours for good angles.
  std::size_t remove_crowded_vertices() {
    std::size_t removed = 0;
    for (Index v = store_.boundary_size(); v < store_.number_of_vertices(); ++v)
      removed += store_.is_vertex_alive(v) && remove_if_crowded(v);
    return removed;
  }

private:
  static constexpr double longest = 1.5;
  static constexpr double shortest = 0.65;
  static constexpr double least_distance = 0.55; // of a new vertex from others
  static constexpr double good_quality = 0.7;
  static constexpr std::size_t few_neighbors = 4;

  void split_if_long(Index h) {
    const Node &a = plane_.origin(h), &b = plane_.target(h);
    const Node middle = plane_.node_at(CGAL::midpoint(a.point, b.point), std::sqrt(a.scale * b.scale));
    if (plane_.length_through(a, middle, b) < longest)
      return;
    const auto place = place_beside(h, middle.point);
    if (place.half_edge == Plane_store::none)
      return;
    if (insertion_.has_room(place, middle, least_distance))
      insertion_.insert(place, middle);
  }

  // The middle of an edge, rounded, lies on it or in one of its triangles, if these are not too flat.
  Point_insertion::Place place_beside(Index h, const Plane_point& p) const {
    const auto side = CGAL::orientation(plane_.origin(h).point, plane_.target(h).point, p);
    if (side == CGAL::COLLINEAR)
      return {h, true};
    const Index k = side == CGAL::LEFT_TURN ? h : store_.twin(h);
    for (Index g : {Plane_store::next(k), Plane_store::prev(k)})
      if (CGAL::orientation(plane_.origin(g).point, plane_.target(g).point, p) != CGAL::LEFT_TURN)
        return {};
    return {k, false};
  }

  bool remove_if_crowded(Index v) {
    double nearest = longest, worst = 1;
    std::size_t degree = 0;
    store_.for_each_outgoing(v, [&](Index h) {
      nearest = (std::min)(nearest, plane_.length(h));
      worst = (std::min)(worst, plane_.quality(h / 3));
      ++degree;
    });
    const bool is_near = nearest < shortest;
    if (!is_near && degree > few_neighbors)
      return false;
    // removal costs no quality that matters; for its own sake it must gain some
    const Index h = best_collapse(v, is_near ? (std::min)(worst, good_quality) : worst + 0.01);
    if (h == Plane_store::none)
      return false;
    const Index w = store_.target(h);
    store_.collapse(h);
    flips_.improve_around(w);
    return true;
  }

  Index best_collapse(Index v, double required) const {
    Index best = Plane_store::none;
    store_.for_each_outgoing(v, [&](Index h) {
      const double q = store_.is_collapsible(h) ? quality_after_collapse(h, required) : -1;
      if (q >= required) {
        required = q;
        best = h;
      }
    });
    return best;
  }

  // The worst quality around; negative where a triangle would be inverted, or an edge too long.
  double quality_after_collapse(Index collapsed, double required) const {
    const Node& b = plane_.target(collapsed);
    const Index first = store_.twin(collapsed) / 3, second = collapsed / 3;
    double worst = 1;
    store_.for_each_outgoing(store_.origin(collapsed), [&](Index h) {
      if (worst < required || h / 3 == first || h / 3 == second)
        return;
      const Node &c = plane_.target(h), &d = plane_.apex(h);
      if (!Metric_plane::is_positive(b, c, d) || Metric_plane::length(b, c) > longest ||
          Metric_plane::length(b, d) > longest)
        worst = -1;
      else
        worst = (std::min)(worst, plane_.quality(b, c, d));
    });
    return worst;
  }

  Metric_plane& plane_;
  Plane_store& store_;
  Point_insertion insertion_;
  Plane_flips flips_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_INTERNAL_PLANE_SIZE_CONTROL_H

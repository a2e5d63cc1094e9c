// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_SQUARE_PACKER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_SQUARE_PACKER_H

#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Cross_field.h>
#include <CGAL/Tubular_meshing/Plane/Metric_plane.h>
#include <CGAL/Tubular_meshing/Plane/Plane_flips.h>
#include <CGAL/Tubular_meshing/Plane/Plane_store.h>
#include <CGAL/Tubular_meshing/Plane/Point_insertion.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Fills a triangulated domain with points at the corners of squares, so that right triangles arise, of which two make a
 * square: the frontal Delaunay method of J.-F. Remacle et al. (*A frontal Delaunay quad mesh generator using the L∞
 * norm*, Int. J. Numer. Meth. Engng. 94, 2013), where the front moves from all points, in the order in which they came,
 * along the four directions of a cross field, by one in the metric. A point is left out where it has no room.
 *
 * Sizes are the field's, as far as the metric does not want quite others. O(n log n). */
class Square_packer {
public:
  typedef Plane_store::Index Index;
  typedef Plane_node Node;
  typedef Point_insertion Insertion;

  Square_packer(Metric_plane& plane, const Cross_field& field)
      : plane_(plane)
      , field_(field)
      , insertion_(plane) {}

  void run() {
    const std::size_t most = plane_.nodes.size() + std::size_t(most_points);
    for (Index v = 0; v < plane_.nodes.size() && plane_.nodes.size() < most; ++v) {
      const double angle = field_(vector(plane_.nodes[v].point)).angle;
      for (int k = 0; k < 4; ++k)
        go(v, angle + k * quarter);
    }
  }

private:
  static constexpr double quarter = CGAL_PI / 2; // of a turn
  static constexpr double least_distance = 0.7;  // of points
  static constexpr double most_points = 1e8;
  static constexpr double smallest = 0.5, largest = 1.6; // of the sizes, relative to the metric's

  static Eigen::Vector2d vector(const Plane_point& p) { return Eigen::Vector2d(p.x(), p.y()); }
  static Plane_point point(const Eigen::Vector2d& p) { return Plane_point(p.x(), p.y()); }

  static double size_in_metric(const Cross_field::Cross& cross, const Metric_tensor_2& metric) {
    return (std::min)((std::max)(cross.size * std::sqrt(std::sqrt(metric.determinant())), smallest), largest);
  }

  // A step from v in a direction of its cross, with the metric and the cross halfway.
  void go(Index v, double angle) {
    const Eigen::Vector2d start = vector(plane_.nodes[v].point);
    const auto step = [&](const Eigen::Vector2d& at, double direction) {
      const Metric_tensor_2 m = plane_.metric_at(point(at));
      const Eigen::Vector2d w(std::cos(direction), std::sin(direction));
      return Eigen::Vector2d(size_in_metric(field_(at), m) * Metric_root(m).from_metric(w));
    };
    const Eigen::Vector2d half = start + step(start, angle) / 2;
    if (find(v, point(half)).half_edge == Plane_store::none)
      return;
    const double turn = field_(half).angle - angle;
    const Eigen::Vector2d end = start + step(half, angle + turn - quarter * std::round(turn / quarter));
    const Insertion::Place place = find(v, point(end));
    if (place.half_edge == Plane_store::none)
      return;
    const Node node = plane_.node_at(point(end));
    const double room = least_distance * size_in_metric(field_(end), node.metric);
    if (insertion_.has_room(place, node, room, false))
      insertion_.insert(place, node);
  }

  // Where a point lies that can be seen from v.
  Insertion::Place find(Index v, const Plane_point& p) {
    star_.clear();
    plane_.store.for_each_outgoing(v, [&](Index h) { star_.push_back(h); });
    for (Index h : star_) {
      if (CGAL::orientation(plane_.origin(h).point, plane_.target(h).point, p) != CGAL::LEFT_TURN)
        continue;
      const Insertion::Place place = insertion_.locate(h, p);
      if (place.half_edge != Plane_store::none)
        return place;
    }
    return {};
  }

  Metric_plane& plane_;
  const Cross_field& field_;
  Insertion insertion_;
  std::vector<Index> star_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_SQUARE_PACKER_H

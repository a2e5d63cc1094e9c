// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_INTERNAL_FRONTAL_DELAUNAY_H
#define CGAL_TUBULAR_MESHING_PLANE_INTERNAL_FRONTAL_DELAUNAY_H

#include <CGAL/Tubular_meshing/Plane/Point_insertion.h>
#include <CGAL/Tubular_meshing/base/constants.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <sstream>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Rebay's frontal Delaunay method in a metric. Triangles whose circumradius is small enough are accepted; the front is
 * what parts them, and the boundary, from the others. The largest triangle on the front gets a point at the apex of the
 * equilateral triangle on its front edge, or at its circumcentre where that is nearer, so that nothing is too close. */
class Frontal_delaunay {
public:
  typedef Plane_store::Index Index;
  typedef Plane_node Node;
  typedef Point_insertion Insertion;

  explicit Frontal_delaunay(Metric_plane& plane)
      : plane_(plane)
      , store_(plane.store)
      , insertion_(plane) {}

  void run() {
    const std::size_t n = store_.number_of_triangles();
    grow();
    for (Index t = 0; t < n; ++t)
      measure(t);
    for (Index t = 0; t < n; ++t)
      enqueue(t);
    raise_budget();
    while (!queue_.empty() && (store_.number_of_vertices() < budget_ || raise_budget())) {
      const Entry e = queue_.top();
      queue_.pop();
      if (e.stamp == stamp_[e.triangle] && !is_done(e.triangle) && !refine(e.triangle))
        give_up(e.triangle);
    }
  }

private:
  static constexpr double largest_radius = 0.78; // of accepted triangles; the equilateral one has 0.577
  static constexpr double smallest_distance = 0.6;
  static constexpr double smallest_height = 0.4; // of a point over its front edge
  static constexpr double growth = 1.3;          // of sizes, a row, from a boundary that is finer than the metric

  static constexpr double least_correction = 0.02; // of a point's place, in the metric
  static constexpr double most_correction = 0.4;
  static constexpr double most_area = 1e8;
  static constexpr double unit_triangle_area = root_of_3 / 4;

  struct Entry {
    float size;
    Index triangle;
    std::uint32_t stamp;
    bool operator<(const Entry& e) const { return size != e.size ? size < e.size : triangle > e.triangle; }
  };

  bool is_done(Index t) const { return radius_[t] <= largest_radius; }
  void give_up(Index t) {
    radius_[t] = 0;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
      if (store_.twin(h) != Plane_store::none)
        enqueue(store_.twin(h) / 3);
  }
  bool is_front(Index h) const { return store_.twin(h) == Plane_store::none || is_done(store_.twin(h) / 3); }

  void grow() {
    radius_.resize(store_.number_of_triangles());
    stamp_.resize(store_.number_of_triangles());
  }
  void measure(Index t) {
    const double r = std::sqrt(plane_.squared_circumradius(t));
    radius_[t] = float(std::isfinite(r) ? (std::min)(r, 1e30) : 1e30);
    ++stamp_[t];
  }
  void enqueue(Index t) {
    if (!is_done(t) && (is_front(3 * t) || is_front(3 * t + 1) || is_front(3 * t + 2)))
      queue_.push({radius_[t], t, stamp_[t]});
  }

  // Points are at most as many as the metric's area asks for, as the triangulation sees it so far, with much to spare.
  // Asked for again when they are used up: false if the area has not grown with them. So the method ends in any metric.
  bool raise_budget() {
    double area = 0;
    for (Index t = 0; t < store_.number_of_triangles(); ++t)
      area += plane_.least_area(t);
    if (!(area < most_area)) {
      std::ostringstream sentence;
      sentence << "The metric asks for about " << area / unit_triangle_area
               << " triangles, which is more than fit into memory; give larger sizes.";
      throw Parameter_error(sentence.str());
    }
    const std::size_t before = budget_;
    budget_ = store_.boundary_size() + 100 + std::size_t(8 * area);
    return budget_ > before + before / 4;
  }

  bool refine(Index t) {
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
      if (is_front(h) && insert_ahead_of(h))
        return true;
    return false;
  }

  bool insert_ahead_of(Index h) {
    Plane_point p;
    if (!first_guess(h, p))
      return false;
    Insertion::Place place = insertion_.locate(h, p);
    if (place.half_edge == Plane_store::none)
      return false;
    const double scale = (std::min)(1., growth * (plane_.origin(h).scale + plane_.target(h).scale) / 2);
    Node node = plane_.node_at(p, scale);
    if (correct(h, node, p)) {
      place = insertion_.locate(h, p);
      if (place.half_edge == Plane_store::none)
        return false;
      node = plane_.node_at(p, scale);
    }
    if (!insertion_.has_room(place, node, smallest_distance))
      return false;
    commit(insertion_.insert(place, node));
    return true;
  }

  // The apex in the mean metric of the edge's ends.
  bool first_guess(Index h, Plane_point& p) {
    const Node &a = plane_.origin(h), &b = plane_.target(h), &c = plane_.apex(h);
    const Metric_tensor_2 m = 0.5 * (a.metric + b.metric);
    const Plane_vector e = b.point - a.point;
    const auto normal = m.quarter_turn(e.x, e.y);
    const double length = m.length(e.x, e.y);
    const auto circle = Metric_plane::circumcircle(m, a, b, c);
    const double to_center =
        m.dot(circle.to_center.x - e.x / 2, circle.to_center.y - e.y / 2, normal[0], normal[1]) / length;
    if (!(to_center > smallest_height))
      return false;
    const double half = length / 2;
    double height = std::sqrt((std::max)(1 - half * half, 0.25 * half * half));
    height = (std::min)(height, to_center);
    side_ = std::sqrt(half * half + height * height);
    const double s = height / length;
    p = Plane_point(a.point.x() + e.x / 2 + s * normal[0], a.point.y() + e.y / 2 + s * normal[1]);
    return std::isfinite(p.x()) && std::isfinite(p.y());
  }

  // One step of Newton's method towards equal lengths of the new edges, in the metrics of both their ends.
  bool correct(Index h, const Node& x, Plane_point& p) const {
    const Node &a = plane_.origin(h), &b = plane_.target(h);
    Plane_vector step;
    if (!Metric_plane::step_to_apex(a, b, x, side_, step))
      return false;
    const double size = x.metric.length(step.x, step.y);
    if (!(size > least_correction && std::isfinite(size)))
      return false;
    const double s = (std::min)(1., most_correction / size);
    p = Plane_point(x.point.x() + s * step.x, x.point.y() + s * step.y);
    return CGAL::orientation(a.point, b.point, p) == CGAL::LEFT_TURN;
  }

  void commit(Index x) {
    grow();
    store_.for_each_outgoing(x, [&](Index h) { measure(h / 3); });
    store_.for_each_outgoing(x, [&](Index h) {
      enqueue(h / 3);
      const Index g = store_.twin(Plane_store::next(h));
      if (g != Plane_store::none)
        enqueue(g / 3);
    });
  }

  Metric_plane& plane_;
  Plane_store& store_;
  Insertion insertion_;
  std::vector<float> radius_;
  std::vector<std::uint32_t> stamp_;
  std::priority_queue<Entry> queue_;
  std::size_t budget_ = 0;
  double side_ = 1;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_INTERNAL_FRONTAL_DELAUNAY_H

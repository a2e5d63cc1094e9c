// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_LEVEL_CURVES_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_LEVEL_CURVES_H

#include <CGAL/Tubular_meshing/Patches/internal/cut/Circular_function.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Plane_section.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Wall_region.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A closed curve over the faces of a region, along which a function has one value. */
struct Level_curve {
  std::vector<Plane_section::Crossing> crossings; // heights are lengths along the edges
  double length = 0;
  double clearance = (std::numeric_limits<double>::infinity)(); // about: how near it comes to the region's boundaries

  double mean_radius() const { return length / (2 * CGAL_PI); }
  /// Its length; more, where it leaves a strip beside a boundary that is narrow for the curve.
  double cost() const { return length * (std::max)(1., 0.5 * mean_radius() / clearance); }
};

/* Follows the level curves of a circular function, of some levels, from triangle to triangle. O(n) in the size of the
 * region, O(n log n) for its distances from the boundaries, and O(length) for the curves. */
class Level_curves {
public:
  Level_curves(const Wall_region& region, const Circular_function& function)
      : region_(region)
      , mesh_(region.mesh())
      , function_(function) {
    measure_distances();
  }

  /* Those of `levels` values, the best ones first. */
  std::vector<Level_curve> find(std::size_t levels) {
    std::vector<std::vector<Halfedge>> starts(levels);
    const double step = 1. / double(levels);
    for (Halfedge h : region_.edges()) {
      const double a = function_.at_source(h), b = a + function_.growth(h);
      if (std::abs(b - a) > 1)
        continue; // such triangles are crossed twice by a level
      for (double k = std::ceil((std::min)(a, b) / step - 0.5); (k + 0.5) * step <= (std::max)(a, b); ++k)
        starts[std::size_t(k - double(levels) * std::floor(k / double(levels)))].push_back(h);
    }
    std::vector<Level_curve> curves;
    for (std::size_t i = 0; i < levels; ++i)
      add_curves((double(i) + 0.5) * step, starts[i], curves);
    std::stable_sort(curves.begin(), curves.end(),
                     [](const Level_curve& a, const Level_curve& b) { return a.cost() < b.cost(); });
    return curves;
  }

private:
  void add_curves(double level, const std::vector<Halfedge>& starts, std::vector<Level_curve>& curves) {
    round_ = ++rounds_;
    seen_.resize(region_.faces().size(), 0);
    for (Halfedge h : starts)
      for (Halfedge start : {h, mesh_.opposite(h)}) {
        const double low = function_.at_source(start), high = low + function_.growth(start);
        const double here = level + std::floor(low - level) + 1; // the first of the level's values above the source's
        if (low < high && here > low && here <= high && seen_[region_.number(mesh_.face(start))] != round_) {
          Level_curve curve;
          if (follow(start, here, curve))
            curves.push_back(std::move(curve));
        }
      }
  }

  /* From an edge at whose source the function is less. False if a face comes twice, or a boundary is met. */
  bool follow(Halfedge start, double level, Level_curve& curve) {
    Halfedge in = start; // of the face that the curve enters
    Vector_3d first, last;
    do {
      std::size_t& seen = seen_[region_.number(mesh_.face(in))];
      if (seen == round_)
        return false;
      seen = round_;
      const Halfedge out = exit(in, level);
      if (region_.is_boundary(out))
        return false;
      const Vector_3d p = add_crossing(out, level, curve);
      if (curve.crossings.size() == 1)
        first = p;
      else
        curve.length += norm(p - last);
      last = p;
      in = mesh_.opposite(out);
      level += function_.at_source(in) - (function_.at_source(out) + function_.growth(out));
    } while (in != start);
    curve.length += norm(first - last);
    return curve.crossings.size() >= 3;
  }

  /* Of the two other edges of a face. The level is one of the values on the edge `in`, and is then one on the edge
   * out. */
  Halfedge exit(Halfedge in, double& level) const {
    const double source = function_.at_source(in), target = source + function_.growth(in);
    const Halfedge next = mesh_.next(in);
    const double third = target + function_.growth(next);
    if ((third >= level) == (source >= level)) { // it goes between the target and the third corner
      level += function_.at_source(next) - target;
      return next;
    }
    level += function_.at_source(mesh_.prev(in)) - third;
    return mesh_.prev(in);
  }

  Vector_3d add_crossing(Halfedge h, double level, Level_curve& curve) const {
    const double t = (std::min)((std::max)((level - function_.at_source(h)) / function_.growth(h), 0.), 1.);
    const Vertex a = mesh_.source(h), b = mesh_.target(h);
    const double length = norm(region_.point(b) - region_.point(a));
    curve.crossings.push_back(Plane_section::Crossing{h, t, t * length, (t - 1) * length});
    curve.clearance = (std::min)(curve.clearance, (1 - t) * distance_at(h, false) + t * distance_at(h, true));
    return region_.point(a) + t * (region_.point(b) - region_.point(a));
  }

  double distance_at(Halfedge h, bool at_target) const {
    return distance_[std::size_t(at_target ? region_.target(h) : region_.source(h))];
  }

  // Of each node from the boundaries, along edges.
  void measure_distances() {
    typedef std::pair<double, Halfedge> Entry; // a halfedge to the node
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    distance_.assign(region_.number_of_nodes(), (std::numeric_limits<double>::infinity)());
    for (Face f : region_.faces())
      for (Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
        if (region_.is_on_boundary(mesh_.target(h))) {
          distance_[std::size_t(region_.target(h))] = 0;
          reach_from(h, 0, queue);
        }
    while (!queue.empty()) {
      const Entry e = queue.top();
      queue.pop();
      if (e.first > distance_[std::size_t(region_.target(e.second))])
        continue;
      for (Halfedge h : mesh_.halfedges_around_target(e.second))
        reach_from(h, e.first, queue);
    }
  }

  // Along the edge of the target that is next in its face.
  template <class Queue> void reach_from(Halfedge h, double distance, Queue& queue) {
    const Halfedge out = mesh_.next(h);
    double& there = distance_[std::size_t(region_.target(out))];
    const double d = distance + norm(region_.point(mesh_.target(out)) - region_.point(mesh_.source(out)));
    if (d < there) {
      there = d;
      queue.emplace(d, out);
    }
  }

  const Wall_region& region_;
  const Surface& mesh_;
  const Circular_function& function_;
  std::vector<double> distance_;  // of nodes
  std::vector<std::size_t> seen_; // of faces: the last round that has come there
  std::size_t round_ = 0, rounds_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_LEVEL_CURVES_H

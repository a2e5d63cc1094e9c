// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_BALLS_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_BALLS_H

#include <CGAL/Tubular_meshing/Fields/curvature.h>
#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/base/Point_boxes.h>
#include <CGAL/Tubular_meshing/Fields/internal/find_spikes.h>
#include <CGAL/Tubular_meshing/base/opposite_ball.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The largest balls inside of a wall that touch it at its vertices: see Shape_radius, of which this is the work. */
class Wall_balls {
public:
  typedef Indexed_wall::Index Index;

  /* `resolved`, at each vertex: the length below which nothing is a shape, that of its shortest edge, or of those of the
   * surface that was divided. `orientation` is 1 if the triangles are turned outward, else -1. */
  Wall_balls(const Indexed_wall& wall, const std::vector<double>& resolved, double orientation, int threads)
      : wall_(wall)
      , resolved_(resolved)
      , orientation_(orientation)
      , threads_(threads)
      , is_spike_(find_spikes(wall)) {
    measure_edges();
    make_normals();
    // once at some vertices, for an idea of the radius; then at all, against as many obstacles as the radius needs
    chosen_.assign(size(), 1);
    collect_obstacles(false);
    choose_apart([&](Index v) { return reach(v); });
    shrink(chosen_, std::vector<double>(size(), 0.));
    spread_to_neighbours();
    filter(touching_at_first);
    raise_to_medians();
    average_normals();
    choose_apart([&](Index v) { return spacing * radii_[v]; });
    collect_obstacles(true);
    shrink(std::vector<char>(size(), 1), radii_);
    filter(touching);
    give_mouths_to_necks();
    smooth();
    for (Index v = 0; v < size(); ++v)
      if (radii_[v] > 0 && !is_spike_[v])
        radii_[v] = (std::max)(radii_[v], resolved_[v]);
  }

  /* 0 where nothing lies opposite. */
  const std::vector<double>& radii() const { return radii_; }
  /* Unit vectors into the lumen. */
  const std::vector<Vector_3d>& directions() const { return directions_; }

private:
  // what is as far as something else but for rounding is so in any place, unit and direction
  static constexpr double as_far = 1 + 1e-9;
  static constexpr double window = 0.5;  // of the radius
  static constexpr double spacing = 0.2; // of obstacles, of the radius
  // how far from its surface a ball touches a vertex, of its radius or that of the fourth largest ball beside the vertex
  static constexpr double touch = 0.12;
  // the cosine of the angle between a ball's radius and the normal there; less, as long as normals are not averaged
  static constexpr double touching = 0.5, touching_at_first = 0.25;
  static constexpr std::size_t most_near = 96; // vertices of a window
  static constexpr std::size_t witnesses = 4;  // that many balls are to be as large, where there are as many at all

  std::size_t size() const { return wall_.number_of_vertices(); }

  // Inward; triangles at spikes count only where there are no others.
  void make_normals() {
    directions_.assign(size(), Vector_3d());
    std::vector<Vector_3d> all(size());
    for (const auto& t : wall_.triangles()) {
      const Vector_3d n = -orientation_ * normalized(wall_.doubled_area(t));
      const bool at_spike = is_spike_[t[0]] || is_spike_[t[1]] || is_spike_[t[2]];
      for (int k = 0; k < 3; ++k) { // by the angle, so that it matters little how the wall is triangulated
        const Vector_3d u = wall_.point(t[(k + 1) % 3]) - wall_.point(t[k]);
        const Vector_3d v = wall_.point(t[(k + 2) % 3]) - wall_.point(t[k]);
        const Vector_3d weighted = std::atan2(norm(cross(u, v)), dot(u, v)) * n;
        all[t[k]] += weighted;
        if (!at_spike)
          directions_[t[k]] += weighted;
      }
    }
    for (Index v = 0; v < size(); ++v)
      directions_[v] = normalized(squared_norm(directions_[v]) > 0 ? directions_[v] : all[v]);
  }

  /* On the steps of an image there are vertices whose own normal lies along the wall: no ball but a small one of their own
   * touches them, and it would have their normal averaged over next to nothing. What half of the vertices say counts. */
  void raise_to_medians() {
    const std::vector<double> before = radii_;
    const auto distance = [&](Index v) { return 2 * reach(v); };
    for_each_window(distance, [&](Index v, Wall_neighborhood& near, double reach) {
      std::array<double, most_near> radii{};
      std::size_t n = 0;
      near.for_each(v, reach, [&](Index w, double) { radii[n++] = before[w]; });
      const auto middle = radii.begin() + std::ptrdiff_t(n / 2);
      std::nth_element(radii.begin(), middle, radii.begin() + std::ptrdiff_t(n));
      radii_[v] = (std::max)(before[v], *middle);
    });
  }

  void average_normals() {
    const std::vector<Vector_3d> before = directions_;
    for_each_window([&](Index v, Wall_neighborhood& near, double radius) {
      Vector_3d sum;
      near.for_each(v, radius, [&](Index w, double weight) { sum += (is_spike_[w] ? 0. : weight) * before[w]; });
      if (squared_norm(sum) > 0)
        directions_[v] = normalized(sum);
    });
  }

  /* Chooses vertices so that each other one is within this distance of one of them, along edges. */
  template <class Distance> void choose_apart(const Distance& distance) {
    chosen_.assign(size(), 0);
    std::vector<char> covered(size(), 0);
    Wall_neighborhood near(wall_, most_near);
    for (Index v = 0; v < size(); ++v)
      if (!covered[v]) {
        chosen_[v] = 1;
        near.for_each(v, as_far * distance(v), [&](Index w, double) { covered[w] = 1; });
      }
  }

  // To the vertices that are not chosen, the mean of their neighbours that are.
  void spread_to_neighbours() {
    for (Index v = 0; v < size(); ++v) {
      if (chosen_[v])
        continue;
      double sum = 0, count = 0;
      for (const Index* w = wall_.neighbors_begin(v); w != wall_.neighbors_end(v); ++w)
        if (chosen_[*w] && radii_[*w] > 0) {
          sum += std::log(radii_[*w]);
          ++count;
        }
      if (count > 0)
        radii_[v] = std::exp(sum / count);
    }
  }

  /* Of the chosen vertices, and, where facets are large against the lumen, of points on them: they may have no vertex
   * where it matters. */
  void collect_obstacles(bool on_facets) {
    std::vector<Vector_3d> points;
    for (Index v = 0; v < size(); ++v)
      if (chosen_[v] && !is_spike_[v])
        points.push_back(wall_.point(v));
    const std::size_t most = 8 * size() + 1000;
    if (on_facets)
      for (const auto& t : wall_.triangles())
        if (!is_spike_[t[0]] && !is_spike_[t[1]] && !is_spike_[t[2]] && points.size() < most)
          add_inner_points(t, (std::min)({radii_[t[0]], radii_[t[1]], radii_[t[2]]}), points);
    obstacles_ = Point_boxes(points, std::vector<double>(points.size(), 0.));
  }

  // In rows parallel to the shortest side, half a radius apart, where a side is longer than the radius.
  void add_inner_points(const std::array<Index, 3>& t, double radius, std::vector<Vector_3d>& points) const {
    std::array<double, 3> length; // of the side opposite to each corner
    for (int k = 0; k < 3; ++k)
      length[k] = norm(wall_.point(t[(k + 1) % 3]) - wall_.point(t[(k + 2) % 3]));
    const double longest = *std::max_element(length.begin(), length.end());
    if (!(radius > 0) || longest <= as_far * radius)
      return;
    const double shortest = *std::min_element(length.begin(), length.end());
    const int apex = int(std::find_if(length.begin(), length.end(), [&](double l) { return l <= as_far * shortest; }) -
                         length.begin());
    const Vector_3d &p = wall_.point(t[apex]), &q = wall_.point(t[(apex + 1) % 3]), &r = wall_.point(t[(apex + 2) % 3]);
    const auto parts = [&](double l) {
      return (std::max)(1, int((std::min)(64., std::ceil(2 * l / (as_far * radius)))));
    };
    const int rows = parts(longest);
    for (int i = 1; i <= rows; ++i) {
      const double s = double(i) / rows;
      const int columns = parts(s * length[apex]);
      for (int j = 0; j < columns + (i < rows); ++j)
        points.push_back(p + s * (q - p) + (s * j / columns) * (r - q));
    }
  }

  // `about`: what radius to expect, which has no influence; 0 if unknown; a copy, as it may be that of radii_.
  void shrink(const std::vector<char>& wanted, const std::vector<double> about) {
    radii_.assign(size(), 0);
    const double extent = extent_of(wall_.points());
    for_each_range(size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Index v = Index(i);
        if (wanted[v]) {
          const double bound = about[v] > 0 ? 1.25 * about[v] : 8 * longest_edge_[v];
          radii_[v] = opposite_ball(obstacles_, wall_.point(v), directions_[v], bound, extent);
        }
      }
    });
  }

  /* The largest radii at a vertex, whichever thread meets them when. Each goes down from the first place on, takes that of
   * a smaller one, which goes down from there, and is dropped where there are as many larger ones: values only rise. */
  class Largest_of_all_threads {
  public:
    bool is_below(double radius) const { return largest_.back().load(std::memory_order_relaxed) < radius; }
    void insert(double radius) {
      for (std::atomic<double>& place : largest_) {
        double there = place.load(std::memory_order_relaxed);
        while (there < radius)
          if (place.compare_exchange_weak(there, radius, std::memory_order_relaxed)) {
            std::swap(there, radius);
            break;
          }
      }
    }
    std::array<double, witnesses> values() const {
      std::array<double, witnesses> result;
      for (std::size_t k = 0; k < witnesses; ++k)
        result[k] = largest_[k].load(std::memory_order_relaxed);
      return result;
    }

  private:
    std::array<std::atomic<double>, witnesses> largest_{}; // descending
  };

  /* Each ball counts at all vertices nearby that it touches, about: of those at a vertex the fourth largest remains.
   * What noise, or the steps of an image, make of a ball does not matter where others that touch are larger; and a few
   * that are too large do not either. */
  void filter(double least_cosine) {
    const std::vector<double> nearby = large_nearby();
    std::vector<Largest_of_all_threads> largest(size());
    for_each_window([&](Index v, Wall_neighborhood& near, double reach) {
      const double r = radii_[v];
      if (is_spike_[v] || !(r > 0))
        return;
      const Vector_3d center = wall_.point(v) + r * directions_[v];
      near.for_each(v, reach, [&](Index w, double) {
        if (!largest[w].is_below(r))
          return;
        const Vector_3d to_center = center - wall_.point(w);
        const double distance = norm(to_center);
        // where the wall turns away, as into the neck of a sac, the ball does not touch it, however near it is
        const bool touches =
            distance < r + touch * (std::min)(r, nearby[w]) && dot(to_center, directions_[w]) > least_cosine * distance;
        if (w == v || is_spike_[w] || touches)
          largest[w].insert(r);
      });
    });
    for (Index v = 0; v < size(); ++v)
      radii_[v] = last_of(largest[v].values());
  }

  /* The fourth largest radius among the nearest vertices, as far as neighbours' neighbours: more than what noise makes
   * of single balls, but not what the balls of a sac, which pass by the vertices of its neck, are. */
  std::vector<double> large_nearby() const {
    std::vector<double> result(size(), 0.);
    const auto distance = [&](Index v) { return (std::max)(window * radii_[v], 2 * reach(v)); };
    for_each_window(distance, [&](Index v, Wall_neighborhood& near, double reach) {
      std::array<double, witnesses> largest{};
      near.for_each(v, reach, [&](Index w, double) { insert(radii_[w], largest); });
      result[v] = last_of(largest);
    });
    return result;
  }

  static double last_of(const std::array<double, witnesses>& descending) {
    std::size_t k = witnesses - 1;
    while (k > 0 && descending[k] == 0)
      --k;
    return descending[k];
  }

  static void insert(double radius, std::array<double, witnesses>& descending) {
    if (radius > descending.back())
      for (double& r : descending)
        if (radius > r)
          std::swap(radius, r);
  }

  void measure_edges() {
    longest_edge_.assign(size(), 0);
    for_each_range(size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        for (const Index* w = wall_.neighbors_begin(Index(v)); w != wall_.neighbors_end(Index(v)); ++w)
          longest_edge_[v] = (std::max)(longest_edge_[v], norm(wall_.point(*w) - wall_.point(Index(v))));
    });
  }

  /* Where a neck opens into a sac, balls of either touch the wall, and all sizes between. What is a neck's by half of an
   * edge is the neck's. */
  void give_mouths_to_necks() {
    const std::vector<double> before = radii_;
    for (Index w = 0; w < size(); ++w) {
      const Index *begin = wall_.neighbors_begin(w), *end = wall_.neighbors_end(w);
      const double r = before[w];
      const auto alike = [&](Index v) { return before[v] > 0.87 * r && before[v] < 1.15 * r; };
      if (!(r > 0) || std::count_if(begin, end, alike) + 2 < end - begin)
        continue;
      for (const Index* v = begin; v != end; ++v)
        if (!alike(*v) && before[*v] > r / 0.7)
          radii_[*v] = (std::min)(radii_[*v], r);
    }
  }

  // Smoothed radii are not larger than they were: the mouth of a neck does not widen it.
  void smooth() {
    std::vector<double> smoothed = radii_;
    for_each_window([&](Index v, Wall_neighborhood& near, double radius) {
      double sum = 0, weights = 0;
      near.for_each(v, radius, [&](Index w, double weight) {
        if (radii_[w] > 0) {
          sum += weight * std::log(radii_[w]);
          weights += weight;
        }
      });
      if (weights > 0)
        smoothed[v] = (std::min)(std::exp(sum / weights), radii_[v]);
    });
    radii_ = std::move(smoothed);
  }

  // Calls visit(v, neighborhood, distance(v)) for all vertices.
  template <class Distance, class Visit> void for_each_window(const Distance& distance, const Visit& visit) const {
    for_each_range(
        size(), threads_,
        [&](std::size_t first, std::size_t last) {
          Wall_neighborhood near(wall_, most_near);
          for (std::size_t i = first; i < last; ++i)
            visit(Index(i), near, as_far * distance(Index(i)));
        },
        1024);
  }

  template <class Visit> void for_each_window(const Visit& visit) const {
    for_each_window([&](Index v) { return window_of(v); }, visit);
  }

  // As far as the neighbours at least.
  double window_of(Index v) const { return (std::max)(window * radii_[v], reach(v)); }
  double reach(Index v) const { return 1.01 * (std::max)(longest_edge_[v], resolved_[v]); }

  const Indexed_wall& wall_;
  const std::vector<double>& resolved_;
  double orientation_;
  int threads_;
  std::vector<char> is_spike_, chosen_;
  std::vector<Vector_3d> directions_;
  std::vector<double> longest_edge_; // at each vertex
  std::vector<double> radii_;
  Point_boxes obstacles_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_BALLS_H

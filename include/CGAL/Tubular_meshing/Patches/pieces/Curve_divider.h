// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_CURVE_DIVIDER_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_CURVE_DIVIDER_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/Rims/rim_corners.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A point of a closed polyline: on edge `edge`, which it divides as t : 1 − t. */
struct Curve_position {
  std::size_t edge;
  double t;
  Point_3 point;
};

/* The points of a curve on a loop of a patch, in the order of the loop. */
inline std::vector<Patch_location> on_loop(const Patch_parameterization& map, std::size_t l, const Patch_loop& loop,
                                           std::size_t edges, const std::vector<Curve_position>& points) {
  std::vector<Patch_location> result;
  for (const auto& p : points)
    result.push_back(loop.forward ? map.on_loop_edge(l, p.edge, p.t)
                                  : map.on_loop_edge(l, edges - 1 - p.edge, 1 - p.t));
  if (!loop.forward)
    std::reverse(result.begin(), result.end());
  return result;
}

/* Divides a closed polyline into edges as long as a size field asks for, all of the same length in it. */
class Curve_divider {
public:
  typedef std::vector<Curve_position> Points;

  typedef Function_view<double(const Curve_position&)> Size;

  /* size(position) is the wanted length there, along the polyline; corners, as is_rim_corner() sees them, are kept if
   * `keep_corners`. */
  Curve_divider(const std::vector<Point_3>& polyline, Size size, bool keep_corners) {
    set_stations(polyline, size);
    limit_growth(polyline);
    measure(polyline);
    if (keep_corners)
      find_corners(polyline, size);
    if (corners_.size() < 2) // one corner is where it starts
      corners_.resize(1, 0);
  }

  /* At least `fewest` points; an even number of them, if wanted. O(n log n) in the vertices of the polyline. */
  Points divide(const std::vector<Point_3>& polyline, std::size_t fewest, bool even) const {
    std::vector<std::size_t> edges;
    std::size_t sum = 0;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      edges.push_back((std::max)(std::size_t(1), std::size_t(std::lround(piece_length(k)))));
      sum += edges.back();
    }
    while (sum < fewest || (even && sum % 2 == 1)) {
      ++edges[piece_in_need(edges)];
      ++sum;
    }
    Points points;
    for (std::size_t k = 0; k < corners_.size(); ++k)
      for (std::size_t i = 0; i < edges[k]; ++i)
        points.push_back(point_at(polyline, start_of(k) + piece_length(k) * double(i) / double(edges[k])));
    return points;
  }

  /* The whole length, in units of the size. */
  double total() const { return stations_.back().length; }

  /* A number of points, all at the same distance in units of the size, the first one at a part of that distance. */
  Points divide_equally(const std::vector<Point_3>& polyline, std::size_t number, double start) const {
    Points points;
    for (std::size_t i = 0; i < number; ++i)
      points.push_back(point_at(polyline, total() * (double(i) + start) / double(number)));
    return points;
  }

private:
  // A place on the polyline, the size there, and the length up to it in units of the size.
  struct Station {
    std::size_t edge;
    double t, size, length;
  };

  static Vector_3d on_edge(const std::vector<Point_3>& polyline, std::size_t edge, double t) {
    const Vector_3d a(polyline[edge]), b(polyline[(edge + 1) % polyline.size()]);
    return a + t * (b - a);
  }
  static Curve_position at(const std::vector<Point_3>& polyline, std::size_t edge, double t) {
    return {edge, t, t == 0 ? polyline[edge] : as<Point_3>(on_edge(polyline, edge, t))};
  }

  // Stations at the vertices, and between them where the size is small compared to an edge.
  void set_stations(const std::vector<Point_3>& polyline, Size size) {
    const double steps_per_size = 2, most_steps = 1e5;
    double h = size(at(polyline, 0, 0));
    for (std::size_t i = 0; i < polyline.size(); ++i) {
      const double next = size(at(polyline, (i + 1) % polyline.size(), 0));
      const double steps_wanted = steps_per_size * norm(on_edge(polyline, i, 1) - on_edge(polyline, i, 0));
      const std::size_t steps = 1 + std::size_t((std::min)(steps_wanted / (std::min)(h, next), most_steps));
      stations_.push_back({i, 0, h, 0});
      for (std::size_t k = 1; k < steps; ++k) {
        const double t = double(k) / double(steps);
        stations_.push_back({i, t, size(at(polyline, i, t)), 0});
      }
      h = next;
    }
    stations_.push_back({polyline.size() - 1, 1, h, 0});
  }

  // The limit of a size that is small in one place grows along the curve, in both directions.
  void limit_growth(const std::vector<Point_3>& polyline) {
    const double slope = 0.5;
    const std::size_t n = stations_.size();
    const auto relax = [&](std::size_t from, std::size_t to) {
      Station& s = stations_[to];
      s.size = (std::min)(s.size, stations_[from].size + slope * norm(place(polyline, from) - place(polyline, to)));
    };
    for (int round = 0; round < 2; ++round) { // the second carries on past the start
      for (std::size_t i = 1; i < n; ++i)
        relax(i - 1, i);
      for (std::size_t i = n - 1; i > 0; --i)
        relax(i, i - 1);
      stations_.front().size = stations_.back().size = (std::min)(stations_.front().size, stations_.back().size);
    }
  }

  void measure(const std::vector<Point_3>& polyline) {
    for (std::size_t i = 1; i < stations_.size(); ++i) {
      const double step = norm(place(polyline, i) - place(polyline, i - 1));
      stations_[i].length = stations_[i - 1].length + step * 2 / (stations_[i - 1].size + stations_[i].size);
    }
  }

  Vector_3d place(const std::vector<Point_3>& polyline, std::size_t i) const {
    return on_edge(polyline, stations_[i].edge, stations_[i].t);
  }

  void find_corners(const std::vector<Point_3>& polyline, Size size) {
    const auto spacing = [&](std::size_t i) { return 0.5 * size(at(polyline, i, 0)); };
    std::size_t s = 0;
    for (std::size_t i : rim_corners(polyline, spacing)) {
      while (stations_[s].edge < i)
        ++s;
      corners_.push_back(s);
    }
  }

  double start_of(std::size_t k) const { return stations_[corners_[k]].length; }
  double piece_length(std::size_t k) const {
    if (k + 1 < corners_.size())
      return start_of(k + 1) - start_of(k);
    return total() - start_of(k) + start_of(0);
  }

  // The piece whose edges are the longest.
  std::size_t piece_in_need(const std::vector<std::size_t>& edges) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < edges.size(); ++k)
      if (piece_length(k) * double(edges[best]) > piece_length(best) * double(edges[k]))
        best = k;
    return best;
  }

  Curve_position point_at(const std::vector<Point_3>& polyline, double length) const {
    if (length >= total())
      length -= total();
    const auto after = std::upper_bound(stations_.begin() + 1, stations_.end() - 1, length,
                                        [](double l, const Station& s) { return l < s.length; });
    const Station &a = *(after - 1), &b = *after;
    const double end = b.edge == a.edge ? b.t : 1;
    const double part = b.length > a.length ? (std::max)(length - a.length, 0.) / (b.length - a.length) : 0;
    const double t = a.t + (std::min)(part, 1.) * (end - a.t);
    return at(polyline, a.edge, t);
  }

  std::vector<Station> stations_;
  std::vector<std::size_t> corners_; // stations at which points must be
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_CURVE_DIVIDER_H

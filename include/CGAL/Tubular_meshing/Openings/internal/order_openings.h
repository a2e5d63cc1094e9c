// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ORDER_OPENINGS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ORDER_OPENINGS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The rank of each value, equal for values that differ by no more than rounding: what is equal stays so when the model
 * is moved, turned or scaled. */
inline std::vector<std::size_t> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size()), rank(values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  double largest = 0;
  for (double v : values)
    largest = (std::max)(largest, std::abs(v));
  std::size_t r = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && values[order[i]] - values[order[i - 1]] > 1e-6 * largest)
      ++r;
    rank[order[i]] = r;
  }
  return rank;
}

// Ranks by decreasing area, then by the distance from a point (increasing if sign > 0), then, for symmetric models
// only, by coordinates.
class Opening_order {
public:
  Opening_order(const std::vector<Opening>& openings, const Point_3& from, double sign)
      : openings_(openings) {
    std::vector<double> areas, distances;
    for (const Opening& o : openings) {
      areas.push_back(-o.area);
      distances.push_back(sign * point_distance(o.center, from));
    }
    area_rank_ = ranks(areas);
    distance_rank_ = ranks(distances);
  }

  bool operator()(std::size_t a, std::size_t b) const { return key(a) < key(b); }

private:
  std::tuple<std::size_t, std::size_t, std::size_t, double, double, double> key(std::size_t i) const {
    const Opening& o = openings_[i];
    return {o.node, area_rank_[i], distance_rank_[i], o.center.x(), o.center.y(), o.center.z()};
  }

  const std::vector<Opening>& openings_;
  std::vector<std::size_t> area_rank_, distance_rank_;
};

/* Of the largest openings the one that is farthest from the others: `first` without regard to nodes. */
inline std::size_t largest_opening(std::vector<Opening> openings) {
  Vector_3 sum(0, 0, 0);
  std::vector<std::size_t> indices(openings.size());
  for (std::size_t i = 0; i < openings.size(); ++i) {
    sum = sum + (openings[i].center - openings[0].center);
    openings[i].node = 0;
    indices[i] = i;
  }
  const Opening_order before(openings, openings[0].center + sum / double(openings.size()), -1);
  return *std::min_element(indices.begin(), indices.end(), before);
}

inline std::size_t nearest_opening(const std::vector<Opening>& openings, const Point_3& p) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < openings.size(); ++i)
    if (CGAL::squared_distance(openings[i].center, p) < CGAL::squared_distance(openings[nearest].center, p))
      nearest = i;
  return nearest;
}

/* The inlet first, then those with a node of the centerline graph in the order of these, then the others by decreasing
 * area; and labels them. */
inline void order_openings(std::vector<Opening>& openings, std::size_t inlet) {
  std::vector<std::size_t> indices(openings.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  std::swap(indices[0], indices[inlet]);
  std::sort(indices.begin() + 1, indices.end(), Opening_order(openings, openings[inlet].center, 1));
  std::vector<Opening> ordered;
  for (std::size_t i : indices) {
    ordered.push_back(openings[i]);
    ordered.back().patch = labels::of_opening(static_cast<int>(ordered.size()) - 1);
  }
  openings.swap(ordered);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ORDER_OPENINGS_H

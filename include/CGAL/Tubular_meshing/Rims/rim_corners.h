// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_RIM_CORNERS_H
#define CGAL_TUBULAR_MESHING_RIMS_RIM_CORNERS_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Whether a rim turns by more than 30 degrees at a vertex: a mesh whose edges are as long as the rim's would cut such a
 * corner off, so that it keeps a vertex there. */
inline bool is_rim_corner(const Vector_3d& before, const Vector_3d& at, const Vector_3d& after) {
  const Vector_3d u = at - before, v = after - at;
  return dot(u, v) < 0.866 * norm(u) * norm(v);
}

/* The corners of a closed polyline (its first point does not come again), but for those closer than `spacing(index)` to
 * the one before. O(n). */
inline std::vector<std::size_t> rim_corners(const std::vector<Point_3>& rim,
                                            Function_view<double(std::size_t)> spacing) {
  const std::size_t n = rim.size();
  std::vector<std::size_t> corners;
  const auto position = [&](std::size_t i) { return Vector_3d(rim[i % n]); };
  const auto far_enough = [&](std::size_t i, std::size_t j) {
    return norm(position(i) - position(j)) > spacing(i % n);
  };
  for (std::size_t i = 0; i < n; ++i)
    if (is_rim_corner(position(i + n - 1), position(i), position(i + 1)) &&
        (corners.empty() || (far_enough(i, corners.back()) && far_enough(i, corners.front()))))
      corners.push_back(i);
  return corners;
}

/* The corners of closed curves given by their segments, in any order. O(n log n). */
inline std::set<Double_kernel::Point_3> rim_corners(const std::vector<Double_kernel::Segment_3>& rim) {
  std::map<Double_kernel::Point_3, std::vector<Double_kernel::Point_3>> neighbors;
  for (const Double_kernel::Segment_3& s : rim) {
    neighbors[s.source()].push_back(s.target());
    neighbors[s.target()].push_back(s.source());
  }
  std::set<Double_kernel::Point_3> corners;
  for (const auto& n : neighbors)
    if (n.second.size() == 2 && is_rim_corner(Vector_3d(n.second[0]), Vector_3d(n.first), Vector_3d(n.second[1])))
      corners.insert(n.first);
  return corners;
}

/* Splits a closed polyline (its first point comes again at the end) at its corners, closer than `spacing(point)` to
 * each other only once. Left in one piece where there are fewer than two. */
inline std::vector<std::vector<Point_3>> split_at_corners(std::vector<Point_3> rim, Length_function spacing) {
  const Point_3 first = rim.front();
  rim.pop_back();
  const std::vector<std::size_t> corners = rim_corners(rim, [&](std::size_t i) { return spacing(rim[i]); });
  if (corners.size() < 2) {
    rim.push_back(first);
    return {rim};
  }
  const std::size_t n = rim.size();
  std::vector<std::vector<Point_3>> pieces;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t end = k + 1 < corners.size() ? corners[k + 1] : corners[0] + n;
    std::vector<Point_3> piece;
    for (std::size_t i = corners[k]; i <= end; ++i)
      piece.push_back(rim[i % n]);
    pieces.push_back(piece);
  }
  return pieces;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_RIM_CORNERS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SMOOTH_LINE_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SMOOTH_LINE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_line.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The line with points at equal steps of about `step` local radii. O(n) in points, old and new. */
inline Sampled_line resampled(const Sampled_line& line, double step) {
  std::vector<double> at(line.size(), 0); // length over radius, up to each point
  for (std::size_t i = 1; i < line.size(); ++i)
    at[i] = at[i - 1] + 2 * distance(line[i - 1].point, line[i].point) / (line[i - 1].radius + line[i].radius);
  const std::size_t n = (std::max)(std::size_t(2), std::size_t(std::ceil(at.back() / step)));
  Sampled_line result(1, line.front());
  std::size_t i = 0;
  for (std::size_t k = 1; k < n; ++k) {
    const double s = at.back() * double(k) / double(n);
    while (i + 2 < line.size() && at[i + 1] < s)
      ++i;
    const double t = at[i + 1] > at[i] ? (std::min)(1., (s - at[i]) / (at[i + 1] - at[i])) : 0;
    const Line_point &a = line[i], &b = line[i + 1];
    result.push_back(Line_point{a.point + t * (b.point - a.point), (1 - t) * a.radius + t * b.radius});
  }
  result.push_back(line.back());
  return result;
}

/* One point of the line, moved onto the parabola that fits its neighbours best, near ones most (W. Cleveland, Robust
 * locally weighted regression, 1979). Unlike an average, this does not cut bends short. */
inline Double_kernel::Point_3 fitted_point(const Sampled_line& line, std::size_t i, std::size_t reach) {
  const std::size_t begin = i > reach ? i - reach : 0, end = (std::min)(line.size(), i + reach + 1);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
  const Double_kernel::Point_3& origin = line[i].point;
  for (std::size_t j = begin; j < end; ++j) {
    const double u = (double(j) - double(i)) / double(reach + 1), a = std::abs(u);
    const double weight = std::pow(1 - a * a * a, 3);
    const Eigen::Vector3d powers(1, u, u * u);
    const Double_kernel::Vector_3 d = line[j].point - origin;
    normal += weight * powers * powers.transpose();
    right += weight * powers * Eigen::RowVector3d(d.x(), d.y(), d.z());
  }
  const Eigen::RowVector3d shift = normal.ldlt().solve(right).row(0);
  return origin + Double_kernel::Vector_3(shift[0], shift[1], shift[2]);
}

/* A line that was traced through a Voronoi diagram, freed of the diagram's irregularities, which are smaller than the
 * radius: fitted over a window of `width` radii to either side. Its ends stay. O(n width / step). */
inline Sampled_line smoothed(const Sampled_line& line, double width, int passes) {
  const double step = 0.1; // radii
  const std::size_t reach = (std::max)(std::size_t(1), std::size_t(std::lround(width / step)));
  Sampled_line current = line;
  for (int pass = 0; pass < passes; ++pass) {
    current = resampled(current, step);
    Sampled_line next = current;
    for (std::size_t i = 0; i < current.size(); ++i)
      // towards the ends the window shrinks, so that it stays symmetric and the ends where they are
      if (const std::size_t room = (std::min)({reach, i, current.size() - 1 - i}))
        next[i].point = room < 2 ? current[i].point : fitted_point(current, i, room);
    current.swap(next);
  }
  return current;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SMOOTH_LINE_H

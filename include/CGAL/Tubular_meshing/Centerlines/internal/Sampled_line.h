// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLED_LINE_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLED_LINE_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

struct Line_point {
  Double_kernel::Point_3 point;
  double radius;
};

typedef std::vector<Line_point> Sampled_line;

inline double distance(const Double_kernel::Point_3& p, const Double_kernel::Point_3& q) {
  return std::sqrt(CGAL::squared_distance(p, q));
}

inline double length(const Sampled_line& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += distance(line[i - 1].point, line[i].point);
  return sum;
}

// Leaves out points closer than 0.01 r to the one before; the line's two ends stay. A closed line stays closed.
inline Sampled_line without_short_steps(const Sampled_line& line) {
  const double shortest = 0.01; // of the radius: centerlines carry no detail below this, only rounding
  Sampled_line result;
  for (const Line_point& p : line)
    if (result.empty() || distance(result.back().point, p.point) > shortest * p.radius)
      result.push_back(p);
  if (result.size() > 1)
    result.back() = line.back();
  else if (distance(line.front().point, line.back().point) > 0)
    result.push_back(line.back());
  return result;
}

// Leaves out points at which the line turns back on itself within a fraction of the radius.
inline Sampled_line without_zigzags(const Sampled_line& line) {
  const double longest = 0.25;  // of the radius: longer is a real turn
  const double sharpest = -0.5; // cosine of the turn
  Sampled_line result;
  for (const Line_point& p : line) {
    while (result.size() > 1) {
      const Double_kernel::Vector_3 in = result.back().point - result[result.size() - 2].point;
      const Double_kernel::Vector_3 out = p.point - result.back().point;
      const double lin = std::sqrt(in.squared_length()), lout = std::sqrt(out.squared_length());
      if ((std::min)(lin, lout) > longest * result.back().radius || in * out > sharpest * lin * lout)
        break;
      result.pop_back();
    }
    result.push_back(p);
  }
  return result;
}

/* The radius at a new point, where interpolation gives the second argument. */
typedef Function_view<double(const Double_kernel::Point_3&, double)> Radius_at_new_point;

// Appends b, and points between a and b so that steps are at most half a radius.
inline void append_refined(Sampled_line& line, const Line_point& a, const Line_point& b, Radius_at_new_point radius,
                           int depth) {
  const double longest = 0.5; // of the radius
  if (depth > 0 && distance(a.point, b.point) > longest * (std::min)(a.radius, b.radius)) {
    const Double_kernel::Point_3 middle = CGAL::midpoint(a.point, b.point);
    const Line_point m = {middle, radius(middle, 0.5 * (a.radius + b.radius))};
    append_refined(line, a, m, radius, depth - 1);
    append_refined(line, m, b, radius, depth - 1);
  } else
    line.push_back(b);
}

// With points between those further apart than half a radius.
inline Sampled_line with_short_steps(const Sampled_line& line, Radius_at_new_point radius) {
  const int deepest = 8; // at most 256 steps for one, however small the radius
  Sampled_line result;
  for (const Line_point& p : line)
    if (result.empty())
      result.push_back(p);
    else
      append_refined(result, Line_point(result.back()), p, radius, deepest);
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLED_LINE_H

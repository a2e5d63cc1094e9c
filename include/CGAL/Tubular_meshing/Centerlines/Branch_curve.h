// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_BRANCH_CURVE_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_BRANCH_CURVE_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A branch as a curve: position, direction and radius by abscissa. */
class Branch_curve {
public:
  Branch_curve(const Centerline_graph& graph, std::size_t branch)
      : graph_(graph)
      , branch_(graph.branches()[branch]) {}

  double length() const { return branch_.length; }

  Vector_3d point(double s) const {
    const Place p = place(s);
    return (1 - p.t) * at(p.segment) + p.t * at(p.segment + 1);
  }

  double radius(double s) const {
    const Place p = place(s);
    return (1 - p.t) * radius_at(p.segment) + p.t * radius_at(p.segment + 1);
  }

  /* The chord over half a radius to each side: centerlines bend little over such lengths, but their segments are noisy.
   */
  Vector_3d tangent(double s) const {
    const double reach = 0.5 * radius(s);
    const Vector_3d chord = point((std::min)(length(), s + reach)) - point((std::max)(0., s - reach));
    if (squared_norm(chord) > 0)
      return normalized(chord);
    const Place p = place(s);
    const Vector_3d segment = at(p.segment + 1) - at(p.segment);
    return normalized(squared_norm(segment) > 0 ? segment : point(length()) - point(0));
  }

  // The least and the greatest radius between two abscissae.
  std::pair<double, double> radius_range(double from, double to) const {
    const double a = radius(from), b = radius(to);
    std::pair<double, double> range = std::minmax(a, b);
    for (std::size_t i = place(from).segment; i < branch_.points.size() && branch_.abscissa[i] < to; ++i)
      if (branch_.abscissa[i] > from) {
        range.first = (std::min)(range.first, radius_at(i));
        range.second = (std::max)(range.second, radius_at(i));
      }
    return range;
  }

  // η of a part of the branch: length / (min radius + max radius).
  double aspect_ratio(double from, double to) const {
    const std::pair<double, double> r = radius_range(from, to);
    return (to - from) / (r.first + r.second);
  }

  /* Where a part is divided into two that have `fraction` and the rest of its length, measured in local radii: narrow
   * stretches count for more. */
  double division(double from, double to, double fraction) const {
    const int samples = 64;
    std::vector<double> sum(samples + 1, 0.);
    const double step = (to - from) / samples;
    for (int i = 0; i < samples; ++i)
      sum[i + 1] = sum[i] + step / radius(from + (i + 0.5) * step);
    const double wanted = fraction * sum.back();
    const int i = int(std::upper_bound(sum.begin(), sum.end() - 1, wanted) - sum.begin()) - 1;
    return from + step * (i + (wanted - sum[i]) / (sum[i + 1] - sum[i]));
  }

  /* How far from one of its ends a branch leaves the ball of the given radius about the end; its length, if never. */
  double exit(bool from_source, double ball) const {
    const Vector_3d center = from_source ? at(0) : at(branch_.points.size() - 1);
    const double step = 0.05 * ball, least = (1 - 1e-9) * ball; // a straight line leaves right at a step
    for (double s = 0; step > 0 && s < length(); s += step)
      if (norm(point(from_source ? s : length() - s) - center) >= least)
        return s;
    return length();
  }

private:
  struct Place {
    std::size_t segment;
    double t; // along the segment, 0 to 1
  };

  Place place(double s) const {
    const std::vector<double>& a = branch_.abscissa;
    const std::size_t i = std::size_t(std::upper_bound(a.begin() + 1, a.end() - 1, s) - a.begin()) - 1;
    const double l = a[i + 1] - a[i];
    return Place{i, l > 0 ? (std::min)(1., (std::max)(0., (s - a[i]) / l)) : 0};
  }

  Vector_3d at(std::size_t i) const { return Vector_3d(graph_.points()[branch_.points[i]]); }
  double radius_at(std::size_t i) const { return graph_.radii()[branch_.points[i]]; }

  const Centerline_graph& graph_;
  const Centerline_graph::Branch& branch_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_BRANCH_CURVE_H

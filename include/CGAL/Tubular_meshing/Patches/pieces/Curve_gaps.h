// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_CURVE_GAPS_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_CURVE_GAPS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* How near the curves that bound a patch come to each other: where two junction loops nearly touch, edges much longer
 * than the gap between them would give flat triangles. O(n log n) to build, O(log n) a query and neighbour. */
class Curve_gaps {
public:
  typedef std::vector<std::vector<Point_3>> Polylines;

  Curve_gaps(const Surface_cut& cut, const Polylines& polylines)
      : neighbours_(polylines.size()) {
    for (const std::vector<Point_3>& polyline : polylines) {
      std::vector<Segment> segments;
      for (std::size_t i = 0; i < polyline.size(); ++i)
        segments.emplace_back(to_double_point(polyline[i]), to_double_point(polyline[(i + 1) % polyline.size()]));
      trees_.emplace_back(std::move(segments));
    }
    for (const auto& patch : cut.patches)
      for (const Patch_loop& a : patch.loops)
        for (const Patch_loop& b : patch.loops)
          if (a.curve != b.curve)
            neighbours_[a.curve].push_back(b.curve);
  }

  /* The distance from a point of a curve to the nearest other curve of its patches; `most`, if that is farther. */
  double gap(std::size_t curve, const Point_3& point, double most) const {
    const Double_kernel::Point_3 p = to_double_point(point);
    double squared = most * most;
    for (std::size_t c : neighbours_[curve])
      squared = (std::min)(squared, trees_[c].nearest(p, squared).squared_distance);
    return std::sqrt(squared);
  }

private:
  typedef Double_kernel::Segment_3 Segment;

  std::vector<Nearest_tree<Segment>> trees_;
  std::vector<std::vector<std::size_t>> neighbours_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_CURVE_GAPS_H

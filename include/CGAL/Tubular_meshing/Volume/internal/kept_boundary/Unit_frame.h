// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_UNIT_FRAME_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_UNIT_FRAME_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* The frame of unit extent around the middle of a set of points. Tolerances that are relative, but to numbers
 * that are squared and multiplied, mean the same there for a model in micrometres, far from the origin.
 * The scale is a power of two, so that nothing is rounded by it. */
class Unit_frame {
public:
  typedef std::array<double, 3> Coordinates;

  explicit Unit_frame(const std::vector<Point_3>& points) {
    Bbox_3 box;
    for (const Point_3& p : points)
      box += p.bbox();
    double extent = 0;
    for (int k = 0; k < 3; ++k) {
      middle_[k] = box.min(k) + (box.max(k) - box.min(k)) / 2;
      extent = (std::max)(extent, box.max(k) - box.min(k));
    }
    scale_ = extent > 0 ? std::exp2(std::ceil(std::log2(extent))) : 1;
  }

  double scale() const { return scale_; } // the length of the frame's unit

  Coordinates to_frame(const Point_3& p) const {
    return {(CGAL::to_double(p.x()) - middle_[0]) / scale_, (CGAL::to_double(p.y()) - middle_[1]) / scale_,
            (CGAL::to_double(p.z()) - middle_[2]) / scale_};
  }
  Point_3 from_frame(const Coordinates& x) const {
    return Point_3(middle_[0] + scale_ * x[0], middle_[1] + scale_ * x[1], middle_[2] + scale_ * x[2]);
  }

private:
  Coordinates middle_;
  double scale_ = 1;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_UNIT_FRAME_H

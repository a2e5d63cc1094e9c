// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_UNIT_FRAME_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_UNIT_FRAME_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The frame of unit extent around the middle of a set of points. Tolerances that are relative, but to numbers
 * that are squared and multiplied, mean the same there for a model in micrometres, far from the origin.
 * The scale is a power of two, so that nothing is rounded by it. */
class Unit_frame {
public:
  explicit Unit_frame(const std::vector<Point_3>& points) {
    Bbox_3 box;
    for (const Point_3& p : points)
      box += p.bbox();
    const Vector_3d low(box.xmin(), box.ymin(), box.zmin()), size = Vector_3d(box.xmax(), box.ymax(), box.zmax()) - low;
    middle_ = low + 0.5 * size;
    const double extent = (std::max)({0., size.x, size.y, size.z});
    scale_ = extent > 0 ? std::exp2(std::ceil(std::log2(extent))) : 1;
  }

  double scale() const { return scale_; } // the length of the frame's unit

  Vector_3d to_frame(const Point_3& p) const { return (1 / scale_) * (Vector_3d(p) - middle_); }
  Point_3 from_frame(const Vector_3d& x) const {
    const Vector_3d p = middle_ + scale_ * x;
    return Point_3(p.x, p.y, p.z);
  }

private:
  Vector_3d middle_;
  double scale_ = 1;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_UNIT_FRAME_H

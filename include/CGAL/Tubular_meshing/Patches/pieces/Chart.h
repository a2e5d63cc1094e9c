// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Plane/Plane_triangulation.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* What the mesher of the plane asks of a part of the surface. */
class Chart {
public:
  typedef Plane_point Point_2;

  virtual ~Chart() = default;
  virtual Metric_tensor_2 metric(const Point_2& uv) const = 0;
  virtual Point_3 point(const Point_2& uv) const = 0; // of the surface
  // Places that the plane's edges may step over, though the metric asks for several triangles there.
  virtual std::vector<Point_2> hidden_places() const { return {}; }
};

/* A patch: the metric (11), which `metric(location)` gives. Not for several threads: it remembers the place last asked
 * for. The functions of both charts must outlive them. */
class Patch_chart final : public Chart {
public:
  typedef Function_view<Plane_metric(const Patch_location&)> Metric;

  Patch_chart(const Patch_parameterization& map, Metric metric)
      : map_(map)
      , metric_(metric) {}

  Metric_tensor_2 metric(const Point_2& uv) const override {
    const Plane_metric m = metric_(location(uv));
    return {m.xx, m.xy, m.yy};
  }
  Point_3 point(const Point_2& uv) const override { return map_.point(location(uv)); }
  // O(n log n) in the old triangles.
  std::vector<Point_2> hidden_places() const override;

private:
  const Patch_location& location(const Point_2& uv) const {
    if (!(uv == last_)) {
      at_ = map_.locate(uv, at_.triangle);
      last_ = uv;
    }
    return at_;
  }

  const Patch_parameterization& map_;
  const Metric metric_;
  mutable Point_2 last_ = Point_2(HUGE_VAL, HUGE_VAL);
  mutable Patch_location at_;
};

/* A cap, which is planar: `metric(point, first, second)` is that of the plane along these two directions. */
class Cap_chart final : public Chart {
public:
  typedef Function_view<Metric_tensor_2(const Point_3&, const Vector_3d&, const Vector_3d&)> Metric;

  Cap_chart(const std::vector<Point_3>& rim, Metric metric);

  Point_2 uv(const Point_3& p) const {
    const Vector_3d d = Vector_3d(p) - origin_;
    return Point_2(dot(d, first_), dot(d, second_));
  }
  Point_3 point(const Point_2& uv) const override {
    const Vector_3d p = origin_ + uv.x() * first_ + uv.y() * second_;
    return Point_3(p.x, p.y, p.z);
  }
  Metric_tensor_2 metric(const Point_2& uv) const override { return metric_(point(uv), first_, second_); }

private:
  const Metric metric_;
  Vector_3d origin_, first_, second_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/pieces/Chart_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_H

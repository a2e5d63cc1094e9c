// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Peak_finder.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* What the mesher of the plane asks of a part of the surface: the metric (11) at a place of the plane, which
 * `metric(location)` gives as a Plane_metric, and the point of the surface there. Not for several threads: it remembers
 * the place last asked for. */
template <class Metric> class Patch_chart {
public:
  typedef Patch_parameterization Map;
  typedef typename Map::Point_2 Point_2;

  Patch_chart(const Map& map, const Metric& metric)
      : map_(map)
      , metric_(metric) {}

  Metric_tensor_2 metric(const Point_2& uv) const {
    const Plane_metric m = metric_(location(uv));
    return {m.xx, m.xy, m.yy};
  }
  Point_3 point(const Point_2& uv) const { return map_.point(location(uv)); }

  /* Places that the plane's edges may step over, though the metric asks for several triangles there. O(n log n) in the
   * old triangles. */
  std::vector<Point_2> hidden_places() const {
    const double prominence = 16; // of an area: there, sizes are a quarter of those on the way
    std::vector<double> density(map_.number_of_vertices(), -1);
    for (int t = 0; t < int(map_.number_of_triangles()); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        double& d = density[std::size_t(map_.patch().triangles[std::size_t(t)][i])];
        if (d >= 0)
          continue;
        Patch_location at;
        at.triangle = t;
        at.barycentric = {{0, 0, 0}};
        at.barycentric[i] = 1;
        d = std::sqrt((std::max)(metric_(at).determinant(), 0.));
      }
    std::vector<Point_2> places;
    for (int v : Peak_finder(density, map_.patch().triangles, map_.patch().loops).find(prominence))
      places.push_back(map_.uv(v));
    return places;
  }

private:
  const Patch_location& location(const Point_2& uv) const {
    if (!(uv == last_)) {
      at_ = map_.locate(uv, at_.triangle);
      last_ = uv;
    }
    return at_;
  }

  const Map& map_;
  const Metric& metric_;
  mutable Point_2 last_ = Point_2(HUGE_VAL, HUGE_VAL);
  mutable Patch_location at_;
};

/* The same for a cap, which is planar: `metric(point, first, second)` is a Metric_tensor_2 of the plane along these two
 * directions. */
template <class Point_2, class Metric> class Cap_chart {
public:
  Cap_chart(const std::vector<Point_3>& rim, const Metric& metric)
      : metric_(metric)
      , origin_(rim.front()) {
    Vector_3d normal, reach;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Vector_3d a = Vector_3d(rim[i]) - origin_, b = Vector_3d(rim[(i + 1) % rim.size()]) - origin_;
      normal += cross(a, b);
      if (squared_norm(a) > squared_norm(reach))
        reach = a;
    }
    normal = normalized(normal);
    first_ = normalized(reach - dot(reach, normal) * normal);
    second_ = cross(normal, first_);
  }

  Point_2 uv(const Point_3& p) const {
    const Vector_3d d = Vector_3d(p) - origin_;
    return Point_2(dot(d, first_), dot(d, second_));
  }
  Point_3 point(const Point_2& uv) const {
    const Vector_3d p = origin_ + uv.x() * first_ + uv.y() * second_;
    return Point_3(p.x, p.y, p.z);
  }
  Metric_tensor_2 metric(const Point_2& uv) const { return metric_(point(uv), first_, second_); }
  std::vector<Point_2> hidden_places() const { return {}; }

private:
  const Metric& metric_;
  Vector_3d origin_, first_, second_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_H

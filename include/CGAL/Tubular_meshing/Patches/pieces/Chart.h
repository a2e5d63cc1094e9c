// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Plane/Plane_triangulation.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_in_metric.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Peak_finder.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* What the mesher of the plane asks of a part of the surface. */
class Chart {
public:
  typedef Plane_point Point_2;

  virtual ~Chart() = default;
  virtual Metric_tensor_2 metric(const Point_2& uv) const = 0;
  virtual Point_3 point(const Point_2& uv) const = 0; // of the surface
  // Places that the plane's edges may step over, though the metric asks for several triangles there.
  virtual std::vector<Point_2> hidden_places() const { return {}; }

  /* Triangles between polygons, which are judged in space, or in the metric, whose squares of lengths are multiplied by
   * `scale`. None if the polygons do not bound a domain, as they touch each other. */
  std::optional<Plane_triangulation<Point_2>> mesh(const Plane_polygons& polygons, bool judged_in_space,
                                                   double scale = 1) const {
    const auto scaled_metric = [&](const Point_2& uv) { return scale * metric(uv); };
    const auto image = [&](const Point_2& uv) { return point(uv); };
    const Plane_embedding embedding(image);
    std::string problem;
    return mesh_plane(polygons, scaled_metric, judged_in_space ? &embedding : nullptr, hidden_places(),
                      Triangulate_in_metric_options(), problem);
  }
};

/* A patch: the metric (11), which `metric(location)` gives. Not for several threads: it remembers the place last asked
 * for. The functions of both charts must outlive them. */
class Patch_chart final : public Chart {
public:
  typedef Function_view<Metric_tensor_2(const Patch_location&)> Metric;

  Patch_chart(const Patch_parameterization& map, Metric metric)
      : map_(map)
      , metric_(metric) {}

  Metric_tensor_2 metric(const Point_2& uv) const override { return metric_(location(uv)); }
  Point_3 point(const Point_2& uv) const override { return map_.point(location(uv)); }
  // O(n log n) in the old triangles.
  std::vector<Point_2> hidden_places() const override {
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

  const Patch_parameterization& map_;
  const Metric metric_;
  mutable Point_2 last_ = Point_2(HUGE_VAL, HUGE_VAL);
  mutable Patch_location at_;
};

/* A cap, which is planar: `metric(point, first, second)` is that of the plane along these two directions. */
class Cap_chart final : public Chart {
public:
  typedef Function_view<Metric_tensor_2(const Point_3&, const Vector_3d&, const Vector_3d&)> Metric;

  Cap_chart(const std::vector<Point_3>& rim, Metric metric)
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
  Point_3 point(const Point_2& uv) const override { return as<Point_3>(origin_ + uv.x() * first_ + uv.y() * second_); }
  Metric_tensor_2 metric(const Point_2& uv) const override { return metric_(point(uv), first_, second_); }

private:
  const Metric metric_;
  Vector_3d origin_, first_, second_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_H

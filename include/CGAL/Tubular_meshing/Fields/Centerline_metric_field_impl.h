// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_METRIC_FIELD_IMPL_H
#define CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_METRIC_FIELD_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/internal/Boundary_layer_sizes.h>
#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/Fields/internal/Layer_octree.h>
#include <CGAL/Tubular_meshing/Fields/internal/Wall_frames.h>
#include <CGAL/Tubular_meshing/base/Corner_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Tubular_meshing {

class Centerline_metric_field::Impl {
public:
  Impl(const internal::Indexed_triangles& faces, const Centerline_graph& centerlines,
       const Centerline_metric_field_options& options)
      : sizes_(options) {
    const double points = options.points_per_circumference;
    const int threads = options.number_of_threads;
    const Centerline_field lines(centerlines);
    std::vector<std::array<Point_3, 3>> corners;
    for (const auto& t : faces.triangles)
      corners.push_back({faces.points[t[2]], faces.points[t[0]], faces.points[t[1]]});
    Centerline_sizing_field_options core;
    core.points_per_circumference = points;
    core.gradation = options.gradation;
    core.number_of_threads = threads;
    const Centerline_sizing_field size(lines, Wall_distance(corners), core);
    const auto radius = [&](const Point_3& p) { return size(p) * points / (2 * CGAL_PI); };

    const internal::Wall_frames frames(
        internal::Indexed_wall(faces), [&](internal::Indexed_wall::Index v) { return radius(faces.points[v]); },
        [&](internal::Indexed_wall::Index v) { return internal::Vector_3d(lines.frame(faces.points[v]).e_t); },
        options.smoothing_radius, threads);
    octree_ = internal::Layer_octree(frames, radius, threads);
    wall_ = frames.tree();
  }

  Metric_tensor_3 operator()(const Point_3& p) const {
    const internal::Double_kernel::Point_3 q = internal::to_double_point(p);
    const internal::Layer_octree::State s = octree_(q.x(), q.y(), q.z());
    const auto h = sizes_(s, distance(q, s));
    // the exponential of -2 (ln h_n e_n e_nᵀ + ln h_t e_t e_tᵀ + ln h_bn e_bn e_bnᵀ), the three dyads of sum one
    const Metric_tensor_3 log_sizes = h.log_across * Metric_tensor_3() + (h.log_normal - h.log_across) * s.across_wall +
                                      (h.log_along - h.log_across) * s.along;
    return (-2 * log_sizes).exp();
  }

  double radius(const Point_3& p) const { return octree_(p.x(), p.y(), p.z()).radius; }

  double distance_to_wall(const Point_3& p) const {
    return std::sqrt(wall_.nearest(internal::to_double_point(p)).squared_distance);
  }

  std::size_t number_of_leaves() const { return octree_.number_of_leaves(); }

private:
  /* Within the layer to the last digit, for the first layer is a hundredth of the radius high; where nothing depends
   * much on it, by interpolation; in between a mixture. */
  double distance(const internal::Double_kernel::Point_3& q, const internal::Layer_octree::State& s) const {
    const double layer = sizes_.options().boundary_layer_thickness * s.radius, blend = 0.15 * s.radius;
    const double x = (s.distance - layer) / blend;
    if (x >= 1)
      return s.distance;
    // a face nearby gives the search a bound, which is seldom far from the result
    const double d =
        std::sqrt(wall_.nearest_from(s.near_face, q, std::numeric_limits<double>::infinity()).squared_distance);
    return x <= 0 ? d : d + x * x * (3 - 2 * x) * (s.distance - d);
  }

  internal::Boundary_layer_sizes sizes_;
  internal::Layer_octree octree_;
  internal::Corner_tree<internal::Double_kernel::Triangle_3> wall_;
};

CGAL_TUBULAR_MESHING_INLINE void Centerline_metric_field::build(const internal::Indexed_triangles& wall,
                                                                const Centerline_graph& centerlines,
                                                                const Centerline_metric_field_options& options) {
  internal::check(options);
  impl_ = std::make_shared<const Impl>(wall, centerlines, options);
}

CGAL_TUBULAR_MESHING_INLINE Metric_tensor_3 Centerline_metric_field::operator()(const Point_3& p) const {
  return (*impl_)(p);
}

CGAL_TUBULAR_MESHING_INLINE double Centerline_metric_field::radius(const Point_3& p) const {
  return impl_->radius(p);
}

CGAL_TUBULAR_MESHING_INLINE double Centerline_metric_field::distance_to_wall(const Point_3& p) const {
  return impl_->distance_to_wall(p);
}

CGAL_TUBULAR_MESHING_INLINE std::size_t Centerline_metric_field::number_of_leaves() const {
  return impl_->number_of_leaves();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_METRIC_FIELD_IMPL_H

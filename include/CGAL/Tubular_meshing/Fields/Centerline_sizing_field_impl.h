// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_SIZING_FIELD_IMPL_H
#define CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_SIZING_FIELD_IMPL_H

#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/Fields/internal/Size_octree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL::Tubular_meshing {

namespace internal {

inline void check(const Centerline_sizing_field_options& o) {
  if (!(o.points_per_circumference >= 3 && o.points_per_circumference <= 1e6))
    throw Parameter_error("The number of points per circumference is " + std::to_string(o.points_per_circumference) +
                          ": give at least 3; 20 is usual.");
  if (!(o.min_size >= 0) || !(o.max_size > 0) || !(o.min_size <= o.max_size))
    throw Parameter_error("The limits of the mesh size, " + std::to_string(o.min_size) + " to " +
                          std::to_string(o.max_size) + ", are no interval of positive lengths.");
  if (!(o.gradation >= 1 && o.gradation <= 1e6))
    throw Parameter_error("The gradation is " + std::to_string(o.gradation) +
                          ": give the largest ratio of the sizes of neighboring elements, at least 1; 1.3 is usual.");
}

inline Shape_radius_options on_threads(int number_of_threads) {
  Shape_radius_options options;
  options.number_of_threads = number_of_threads;
  return options;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE
Centerline_sizing_field::Centerline_sizing_field(const Centerline_field& centerlines, const Wall_distance& wall,
                                                 const Centerline_sizing_field_options& options)
    : Centerline_sizing_field(
          (internal::check(options), Local_radius(centerlines, wall, internal::on_threads(options.number_of_threads))),
          options) {}

CGAL_TUBULAR_MESHING_INLINE
Centerline_sizing_field::Centerline_sizing_field(const Local_radius& local,
                                                 const Centerline_sizing_field_options& options) {
  internal::check(options);
  const double leaf_per_radius = 0.8, leaf_off_tubes = 0.25; // there the radius changes within less
  const internal::Requested_sizes requested(options.size_requests);
  typedef internal::Size_octree::Position Position;
  struct Sized {
    double radius, size;
  };
  const auto sized = [&](const Point_3& p, const Local_radius::Radii& r) {
    const auto& d = r.of_centerline;
    const double radius = r.combined((std::max)(d.radius, d.distance));
    const double wanted = requested(p, r.on_wall, d.branch, 2 * CGAL_PI * radius / options.points_per_circumference);
    return Sized{radius, (std::min)((std::max)(wanted, options.min_size), options.max_size)};
  };
  const auto need = [&](const Position& x, double reach) {
    const Point_3 p(x[0], x[1], x[2]);
    const Local_radius::Radii r = local.radii(p, reach);
    if (r.distance_outside > reach)
      return internal::Corner_octree::Need{r.distance_outside, 0};
    const Sized here = sized(p, r);
    const double width = local.largest_width(p, leaf_off_tubes, leaf_per_radius * here.radius);
    return internal::Corner_octree::Need{r.distance_outside, requested.width(p, width, here.size)};
  };
  const auto size = [&](const Position& x) {
    const Point_3 p(x[0], x[1], x[2]);
    return sized(p, local.radii(p)).size;
  };
  octree_ = std::make_shared<const internal::Size_octree>(local.bbox(), need, size, options.max_size,
                                                          options.gradation - 1, options.number_of_threads);
}

CGAL_TUBULAR_MESHING_INLINE double Centerline_sizing_field::size(double x, double y, double z) const {
  return (*octree_)(x, y, z);
}

CGAL_TUBULAR_MESHING_INLINE double Centerline_sizing_field::estimated_number_of_tetrahedra() const {
  return 7 * octree_->number_of_cubes();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_SIZING_FIELD_IMPL_H

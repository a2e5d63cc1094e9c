// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_BOUNDARY_LAYER_SIZES_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_BOUNDARY_LAYER_SIZES_H

#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/internal/Layer_octree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace CGAL::Tubular_meshing::internal {

inline void require(bool condition, const char* name, double value, const char* advice) {
  if (!condition)
    throw Parameter_error("The " + std::string(name) + " is " + std::to_string(value) + ": " + advice + ".");
}

/* \throws Parameter_error if one of the options is out of its range */
inline void check(const Centerline_metric_field_options& o) {
  require(o.boundary_layer_thickness > 0 && o.boundary_layer_thickness <= 1, "thickness of the boundary layer",
          o.boundary_layer_thickness, "give a part of the local radius, above 0 and at most 1; 0.3 is usual");
  require(o.first_height > 0 && o.first_height <= 1, "height of the first layer", o.first_height,
          "give a part of the local radius, above 0 and at most 1; 0.015 is usual");
  require(o.growth >= 1 && o.growth <= 100, "growth of the boundary layer", o.growth,
          "give the ratio of two successive heights, at least 1; 1.3 is usual");
  require(o.smoothing_ratio >= 1 && o.smoothing_ratio <= 1e6, "smoothing ratio", o.smoothing_ratio,
          "give the largest ratio of adjacent edges, at least 1; 1.5 is usual");
  for (double n : {o.curvature_points, o.points_per_circumference})
    require(n >= 3 && n <= 1e6, "number of points per circumference", n, "give at least 3; 20 is usual");
  require(o.max_anisotropy >= 1 && o.max_anisotropy <= 1e6, "largest anisotropy", o.max_anisotropy,
          "give the largest ratio of two sizes at a point, from 1 to a million; 100 is usual");
  require(o.min_size >= 0 && o.min_size <= o.max_size, "smallest size", o.min_size,
          "give a length that is not above the largest size");
  require(o.max_size > 0, "largest size", o.max_size, "give a length above 0");
  require(o.smoothing_radius >= 0 && o.smoothing_radius <= 1e6, "smoothing radius of curvatures", o.smoothing_radius,
          "give a part of the local radius, at least 0; 0.4 is usual");
}

/* The bound (9) on a tangential size, as 1/h², for the curvature κ = 1/ρ: the solution of
 * ρ² (β² - 1) u² + u - 1/h_n² = 0, in the form in which nothing cancels and both limits come out: β = 1 gives 1/h_n²,
 * κ = 0 gives 0, no bound. */
inline double smoothing_bound(double curvature, double normal_size, double smoothing_ratio) {
  const double x = curvature * normal_size, a = 4 * (smoothing_ratio - 1) * (smoothing_ratio + 1);
  if (a <= 0)
    return 1 / (normal_size * normal_size);
  return 2 * x / (normal_size * normal_size * (x + std::sqrt(x * x + a)));
}

/* The sizes of section 2.4 from the state of the layer at a point and the distance to the wall. */
class Boundary_layer_sizes {
public:
  struct Log_sizes {
    double log_normal, log_along, log_across;
  };

  explicit Boundary_layer_sizes(const Centerline_metric_field_options& p)
      : p_(p)
      , log_beta_(std::log(p.smoothing_ratio))
      , log_max_anisotropy_(std::log(p.max_anisotropy)) {}

  const Centerline_metric_field_options& options() const { return p_; }

  Log_sizes operator()(const Layer_octree::State& s, double d) const {
    const double core = limited(2 * CGAL_PI * s.radius / p_.points_per_circumference);
    const double normal = limited((std::min)(normal_size(s.radius, d), core));
    const double thickness = p_.boundary_layer_thickness * s.radius;
    const double x = s.radius > thickness ? (std::min)((std::max)((d - thickness) / (s.radius - thickness), 0.), 1.)
                                          : (d > thickness ? 1. : 0.);
    const Passage passage{std::log(core), x * x * (3 - 2 * x),
                          std::log(core) + log_beta_ * elements_to_core(s.radius, d, core)};
    const auto tangential = [&](double bend, double curvature) {
      const double bound = tangential_bound(bend, curvature, (std::min)(d, thickness), normal);
      // where curvature is noise, no finer than the first layer
      const double finest = (std::min)((std::max)(p_.first_height * s.radius, p_.min_size), normal);
      return passage(-0.5 * std::log((std::min)(bound, 1 / (finest * finest))));
    };
    const Log_sizes h = {std::log(normal), tangential(s.bend_along, s.curvature_along),
                         tangential(s.bend_across, s.curvature_across)};
    const double largest = (std::min)({h.log_normal, h.log_along, h.log_across}) + log_max_anisotropy_;
    return {(std::min)(h.log_normal, largest), (std::min)(h.log_along, largest), (std::min)(h.log_across, largest)};
  }

private:
  // From the layer to the core, between which tangential sizes (their logarithms) are interpolated.
  struct Passage {
    double log_core, core_share, log_bound;
    double operator()(double log_size) const {
      return (std::min)((1 - core_share) * log_size + core_share * log_core, log_bound);
    }
  };

  double limited(double h) const { return (std::min)((std::max)(h, p_.min_size), p_.max_size); }

  // (4)
  double normal_size(double radius, double d) const { return p_.first_height * radius + (p_.growth - 1) * d; }

  // How many elements lie between the distance d and where the core begins: ∫ dx / h_n(x).
  double elements_to_core(double radius, double d, double core) const {
    if (d >= radius)
      return 0;
    const double here = (std::min)(normal_size(radius, d), core);
    const double there = (std::min)(normal_size(radius, radius), core);
    if (p_.growth - 1 > 1e-6)
      return std::log(there / here) / (p_.growth - 1) +
             (there < core ? 0 : (std::max)(0., radius - (std::max)(d, distance_of(core, radius))) / core);
    return (radius - d) / here;
  }
  // where (4) reaches a size
  double distance_of(double size, double radius) const { return (size - p_.first_height * radius) / (p_.growth - 1); }

  // The largest 1/h² of all criteria: the smallest size.
  double tangential_bound(double bend, double curvature, double depth, double normal) const {
    const double change = (std::min)((std::max)(1 - curvature * depth, 0.5), 2.); // (6): σ = -1 where convex
    const double by_points = bend * p_.curvature_points / (2 * CGAL_PI * change); // (5)
    const double by_smoothing = smoothing_bound(bend, normal, p_.smoothing_ratio);
    const double largest = (std::min)(p_.max_anisotropy * normal, p_.max_size);
    return (std::max)({by_points * by_points, by_smoothing, 1 / (largest * largest)});
  }

  Centerline_metric_field_options p_;
  double log_beta_, log_max_anisotropy_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_BOUNDARY_LAYER_SIZES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_IMPL_H
#define CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_IMPL_H

#include <CGAL/Tubular_meshing/Fields/Sampled_metric.h>
#include <CGAL/Tubular_meshing/Pipelines/Sampled_estimator.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Element_counts.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/lumen_columns.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE Sampled_estimator::Sampled_estimator(const Tubular_model& model,
                                                                 const Mesher_options& options)
    : model_(model)
    , options_(options)
    , given_(options)
    , volume_(std::abs(CGAL::to_double(CGAL::Polygon_mesh_processing::volume(model.surface)))) {
  const std::size_t most = 8192; // the sums are within a hundredth then
  for (const Wall_sample& s : wall_samples(model.surface, model.patch, most, options.size.number_of_threads))
    if (s.radius > 0)
      samples_.push_back(s);
  if (samples_.empty())
    throw Input_error("Nothing of the surface's wall lies opposite to any of it: it is no lumen.");
}

CGAL_TUBULAR_MESHING_INLINE std::vector<double> Sampled_estimator::sizes(double least, double largest) const {
  const Centerline_sizing_field_options& o = options_.size;
  std::vector<double> wanted;
  for (const Wall_sample& s : samples_)
    wanted.push_back((std::min)((std::max)(2 * CGAL_PI * s.radius / o.points_per_circumference, least), largest));
  // Smaller sizes nearby limit larger ones; the smallest first, so that most are not looked at.
  std::vector<std::size_t> order(samples_.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return wanted[a] != wanted[b] ? wanted[a] < wanted[b] : a < b; });
  std::vector<double> limited = wanted;
  internal::for_each_range(samples_.size(), o.number_of_threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t j : order) {
        if (wanted[j] >= limited[i])
          break;
        const double room = (limited[i] - wanted[j]) / (std::max)(o.gradation - 1, 1e-12);
        const double squared = CGAL::squared_distance(samples_[i].point, samples_[j].point);
        if (squared < room * room)
          limited[i] = wanted[j] + (o.gradation - 1) * std::sqrt(squared);
      }
  });
  return limited;
}

template <class Column> double Sampled_estimator::over_lumen(const Column& column) const {
  double sum = 0, volume = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    sum += samples_[i].area * column(i);
    volume += samples_[i].area * samples_[i].radius / 2; // what is between the wall and the middle of a tube
  }
  return volume_ / volume * sum;
}

CGAL_TUBULAR_MESHING_INLINE std::size_t Sampled_estimator::nearest_sample(const Point_3& p) const {
  std::size_t result = 0;
  double nearest = (std::numeric_limits<double>::infinity)();
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const double d = CGAL::squared_distance(samples_[i].point, p);
    if (d < nearest) {
      nearest = d;
      result = i;
    }
  }
  return result;
}

CGAL_TUBULAR_MESHING_INLINE Lumen_integrals Sampled_estimator::integrals(const std::vector<double>& sizes,
                                                                         double layer_thickness) const {
  Lumen_integrals n;
  n.layer_thickness = layer_thickness;
  n.cubes = over_lumen([&](std::size_t i) { return samples_[i].radius / 2 / std::pow(sizes[i], 3); });
  n.inner_cubes = n.cubes * (1 - layer_thickness) * (1 - layer_thickness);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Wall_sample& s = samples_[i];
    n.wall_squares += s.area / (sizes[i] * sizes[i]);
    n.rows_of_blocks += s.area / (2 * CGAL_PI * s.radius) / sizes[i];
  }
  // Blocks have points of their own round a vessel; and rows begin in the middle of junctions, where there is no wall.
  const double points = points_per_circumference(), of_blocks = internal::blocks_points(points);
  const double junctions = (std::max)(double(model_.openings.size()) - 2, 0.);
  n.rows_of_blocks = n.rows_of_blocks * of_blocks / points + junctions * of_blocks / (2 * CGAL_PI);
  for (const Opening& o : model_.openings) {
    const double size = sizes[nearest_sample(o.center)];
    n.cap_squares += o.area / (size * size);
    n.rims += o.perimeter / size;
  }
  return n;
}

CGAL_TUBULAR_MESHING_INLINE void Sampled_estimator::add_metric(Lumen_integrals& n) const {
  std::vector<double> radii; // that the core's sizes go with, whatever limits there are
  for (double h : sizes(0, (std::numeric_limits<double>::infinity)()))
    radii.push_back(h * points_per_circumference() / (2 * CGAL_PI));
  const Sampled_metric metric(model_.surface, model_.patch, samples_, radii, options_.metric);
  const std::vector<double> ends = internal::pieces_of_radius(0);
  /* Between places the directions turn, and cells lie in two metrics: a mesh has more of them, and on the wall, where a facet
   * is not in the plane that its metric is for, many more. By as much, on a Y, smooth, rough and decimated; on vessels from
   * images the estimate along centerlines, which has the turning in it, differs by the same. */
  constexpr double turning = 1.09, turning_on_wall = 1.75;
  n.metric_cubes = turning * over_lumen([&](std::size_t i) {
                     return internal::over_column(ends, samples_[i].radius, [&](double distance) {
                       const Sampled_metric::Sizes h = metric(i, distance);
                       return 1 / (h.normal * h.along * h.across);
                     });
                   });
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sampled_metric::Sizes h = metric(i, 0);
    const double ratio = (std::max)(h.along, h.across) / (std::min)(h.along, h.across);
    n.metric_wall += turning_on_wall * samples_[i].area / (h.along * h.across) * internal::realized_share(ratio);
  }
  for (const Opening& o : model_.openings) { // across the vessel
    const std::size_t i = nearest_sample(o.center);
    const double radius = samples_[i].radius;
    n.metric_caps += o.area / (radius / 2) * internal::over_column(ends, radius, [&](double distance) {
                       const Sampled_metric::Sizes h = metric(i, distance);
                       return 1 / (h.normal * h.across);
                     });
  }
}

// Whether the wall has so few vertices that balls at these say little of a vessel.
CGAL_TUBULAR_MESHING_INLINE bool Sampled_estimator::is_coarse() const {
  const double fewest = 1.5; // on a square of the radius; ten round a vessel, and as far apart along it, are three
  double squares = 0;
  for (const Wall_sample& s : samples_)
    squares += s.area / (s.radius * s.radius);
  return double(model_.surface.number_of_vertices()) < fewest * squares;
}

CGAL_TUBULAR_MESHING_INLINE Mesh_estimate Sampled_estimator::estimate(Mesh_type type, Surface_elements elements) const {
  if (!can_estimate(options_))
    throw Parameter_error("Sizes that are asked for at places cannot be estimated without centerlines.");
  const internal::Layers_in_lumen layers(options_);
  const std::vector<double> sizes = this->sizes(options_.size.min_size, options_.size.max_size);
  Mesh_estimate result;
  if (is_coarse())
    result.fallbacks.push_back(
        "The surface has few vertices round its vessels: the number of cells by samples of its wall "
        "may be far too small. Along the centerlines it is not.");
  result.integrals = integrals(sizes, layers.thickness);
  if (internal::has_metric(type, elements))
    add_metric(result.integrals);
  result.smallest_size = *std::min_element(sizes.begin(), sizes.end());
  result.largest_size = *std::max_element(sizes.begin(), sizes.end());
  std::vector<double> radii;
  for (const Wall_sample& s : samples_) {
    result.vessel_length += s.area / (2 * CGAL_PI * s.radius);
    radii.push_back(s.radius);
  }
  std::sort(radii.begin(), radii.end());
  const std::size_t strays = radii.size() / 100; // balls at rims and creases
  result.smallest_radius = radii[strays];
  result.largest_radius = radii[radii.size() - 1 - strays];
  if (type == Mesh_type::hexahedral && options_.hexahedral_method == Hexahedral_method::subdivision)
    result.method = Hexahedral_method::subdivision;
  const double openings = double(model_.openings.size()), points = points_per_circumference();
  if (type == Mesh_type::surface)
    internal::count_facets(result, elements, points, openings);
  else
    internal::count_cells(result, type, layers.number, points, internal::coarsening_for_subdivision(points), openings);
  internal::estimate_cost(result, type, double(model_.surface.number_of_faces()));
  return result;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_IMPL_H

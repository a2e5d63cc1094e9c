// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_IMPL_H
#define CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_IMPL_H

#include <CGAL/Tubular_meshing/Layers/boundary_layer_heights.h>
#include <CGAL/Tubular_meshing/Pipelines/Sampled_estimator.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Element_counts.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE bool Sampled_estimator::can_estimate(Mesh_type type, Surface_elements elements,
                                                                 const Mesher_options& options) {
  const bool in_blocks = type == Mesh_type::hexahedral && options.hexahedral_method == Hexahedral_method::blocks;
  const bool follows_lines = type == Mesh_type::surface && (elements == Surface_elements::anisotropic_triangles ||
                                                            elements == Surface_elements::structured_quads);
  return type != Mesh_type::anisotropic && !in_blocks && !follows_lines && options.size.size_requests.empty();
}

CGAL_TUBULAR_MESHING_INLINE Sampled_estimator::Sampled_estimator(const Tubular_model& model,
                                                                 const Mesher_options& options)
    : model_(model)
    , options_(options)
    , volume_(std::abs(CGAL::to_double(CGAL::Polygon_mesh_processing::volume(model.surface)))) {
  const std::size_t most = 8192; // the sums are within a hundredth then
  for (const Wall_sample& s : wall_samples(model.surface, model.patch, most, options.size.number_of_threads))
    if (s.radius > 0)
      samples_.push_back(s);
  if (samples_.empty())
    throw Input_error("Nothing of the surface's wall lies opposite to any of it: it is no lumen.");
}

CGAL_TUBULAR_MESHING_INLINE std::vector<double> Sampled_estimator::sizes() const {
  const Centerline_sizing_field_options& o = options_.size;
  std::vector<double> wanted;
  for (const Wall_sample& s : samples_)
    wanted.push_back(
        (std::min)((std::max)(2 * CGAL_PI * s.radius / o.points_per_circumference, o.min_size), o.max_size));
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

CGAL_TUBULAR_MESHING_INLINE Lumen_integrals Sampled_estimator::integrals(const std::vector<double>& sizes,
                                                                         double layer_thickness) const {
  Lumen_integrals n;
  n.layer_thickness = layer_thickness;
  double volume = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Wall_sample& s = samples_[i];
    const double column = s.area * s.radius / 2; // what is between the wall and the middle of a tube
    volume += column;
    n.cubes += column / std::pow(sizes[i], 3);
    n.wall_squares += s.area / (sizes[i] * sizes[i]);
  }
  n.cubes *= volume_ / volume;
  n.inner_cubes = n.cubes * (1 - layer_thickness) * (1 - layer_thickness);

  // an opening has the size of the samples near it
  std::map<int, double> size_of_cap;
  for (const Opening& o : model_.openings) {
    double nearest = (std::numeric_limits<double>::infinity)(), &size = size_of_cap[o.patch];
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const double d = CGAL::squared_distance(samples_[i].point, o.center);
      if (d < nearest) {
        nearest = d;
        size = sizes[i];
      }
    }
    n.cap_squares += o.area / (size * size);
    n.rims += o.perimeter / size;
  }
  return n;
}

CGAL_TUBULAR_MESHING_INLINE Mesh_estimate Sampled_estimator::estimate(Mesh_type type, Surface_elements elements) const {
  if (!can_estimate(type, elements, options_))
    throw Parameter_error("Meshes that follow centerlines cannot be estimated without these.");
  int layers = 0;
  double thickness = 0;
  if (options_.has_boundary_layer()) {
    const internal::Boundary_layer_heights heights(options_.boundary_layer);
    layers = heights.layers;
    thickness = (std::min)(heights.total(), 0.95);
  }
  const std::vector<double> sizes = this->sizes();
  Mesh_estimate result;
  result.integrals = integrals(sizes, thickness);
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
  if (type == Mesh_type::hexahedral)
    result.method = Hexahedral_method::subdivision;
  const double openings = double(model_.openings.size()), points = points_per_circumference();
  if (type == Mesh_type::surface)
    internal::count_facets(result, elements, points, openings);
  else
    internal::count_cells(result, type, layers, points, internal::coarsening_for_subdivision(points), openings);
  internal::estimate_cost(result, type, double(model_.surface.number_of_faces()));
  return result;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_IMPL_H

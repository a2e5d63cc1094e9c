// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_SAMPLED_METRIC_IMPL_H
#define CGAL_TUBULAR_MESHING_FIELDS_SAMPLED_METRIC_IMPL_H

#include <CGAL/Tubular_meshing/Fields/Sampled_metric.h>
#include <CGAL/Tubular_meshing/Fields/curvature.h>
#include <CGAL/Tubular_meshing/Fields/internal/Boundary_layer_sizes.h>
#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/Fields/internal/Layer_octree.h>
#include <CGAL/Tubular_meshing/Fields/internal/Wall_frame.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

class Sampled_metric::Impl {
public:
  Impl(const Surface& surface, const Face_patch_map& patch, const std::vector<Wall_sample>& samples,
       const std::vector<double>& radii, const Centerline_metric_field_options& options)
      : sizes_(options) {
    std::vector<Surface::Vertex_index> vertices;
    const internal::Indexed_wall wall(internal::indexed_triangles(
        surface, [&](Surface::Face_index f) { return patch[f] == labels::wall; }, CGAL::parameters::default_values(),
        vertices));
    std::vector<Index> number(surface.num_vertices());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      number[vertices[i]] = Index(i);
    // what is averaged at no other vertex takes no time there
    std::vector<double> reach(vertices.size(), 0.);
    for (std::size_t i = 0; i < samples.size(); ++i)
      reach[number[samples[i].vertex]] = options.smoothing_radius * radii[i];
    const internal::Wall_frame_measurer measurer(wall, std::move(reach), options.number_of_threads);
    states_.resize(samples.size());
    internal::for_each_range(samples.size(), options.number_of_threads, [&](std::size_t first, std::size_t last) {
      internal::Wall_neighborhood near(wall);
      for (std::size_t i = first; i < last; ++i)
        states_[i] = state(measurer, number[samples[i].vertex], radii[i], near);
    });
  }

  Sizes at(std::size_t sample, double distance) const {
    const auto h = sizes_(states_[sample], distance);
    return {std::exp(h.log_normal), std::exp(h.log_along), std::exp(h.log_across)};
  }

private:
  typedef internal::Indexed_wall::Index Index;
  typedef internal::Layer_octree::State State;

  static State state(const internal::Wall_frame_measurer& measurer, Index v, double radius,
                     internal::Wall_neighborhood& near) {
    const internal::Vector_3d along = measurer.direction_of_tube(v, near, radius);
    const internal::Wall_frame f = measurer.measured(v, internal::Direction_tensor::dyad(along), near);
    State s = State();
    s.bend_along = f.bend_along;
    s.bend_across = f.bend_across;
    s.curvature_along = f.curvature_along;
    s.curvature_across = f.curvature_across;
    s.radius = radius;
    return s;
  }

  internal::Boundary_layer_sizes sizes_;
  std::vector<State> states_; // their directions are of no use: sizes do not depend on them
};

CGAL_TUBULAR_MESHING_INLINE Sampled_metric::Sampled_metric(const Surface& surface, const Face_patch_map& patch,
                                                           const std::vector<Wall_sample>& samples,
                                                           const std::vector<double>& radii,
                                                           const Centerline_metric_field_options& options) {
  internal::check(options);
  impl_ = std::make_shared<const Impl>(surface, patch, samples, radii, options);
}

CGAL_TUBULAR_MESHING_INLINE Sampled_metric::Sizes Sampled_metric::operator()(std::size_t sample,
                                                                             double distance) const {
  return impl_->at(sample, distance);
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_FIELDS_SAMPLED_METRIC_IMPL_H

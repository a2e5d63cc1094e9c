// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_CURVATURE_IMPL_H
#define CGAL_TUBULAR_MESHING_FIELDS_CURVATURE_IMPL_H

#include <CGAL/Tubular_meshing/Fields/curvature.h>
#include <CGAL/Tubular_meshing/Fields/internal/Curvature_estimator.h>
#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <cmath>
#include <string>

namespace CGAL::Tubular_meshing::internal {

inline Vertex_curvature<Vector_3> principal(const Shape_tensor& k, const Tangent_frame& f) {
  const double mean = (k.uu + k.vv) / 2, d = (k.uu - k.vv) / 2, radius = std::hypot(d, k.uv);
  const double angle = radius > 0 ? std::atan2(k.uv, d) / 2 : 0; // of the direction of larger curvature
  const double c = std::cos(angle), s = std::sin(angle);
  const auto vector = [](const Vector_3d& v) { return Vector_3(v.x, v.y, v.z); };
  return {vector(f.n), mean - radius, mean + radius, vector(c * f.v + (-s) * f.u), vector(c * f.u + s * f.v)};
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Vertex_curvature<Vector_3>>
compute_curvatures(const Indexed_triangles& faces, const Compute_curvatures_options& options) {
  const double smoothing = options.smoothing_radius;
  if (!(smoothing >= 0 && smoothing <= 1e6))
    throw Parameter_error("The smoothing radius of curvatures is " + std::to_string(smoothing) +
                          ": give a part of the vessel's radius, at least 0; 0.4 is usual.");

  const Indexed_wall wall(faces);
  std::vector<double> reach;
  if (options.local_radius && smoothing > 0) {
    reach.resize(faces.points.size());
    for_each_range(reach.size(), options.number_of_threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        reach[v] = smoothing * options.local_radius(faces.points[v]);
    });
  }
  const Curvature_estimator estimator(wall, reach, options.number_of_threads);
  std::vector<Vertex_curvature<Vector_3>> result;
  result.reserve(faces.points.size());
  for (std::size_t v = 0; v < faces.points.size(); ++v)
    result.push_back(principal(estimator.tensors()[v], estimator.frames()[v]));
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_CURVATURE_IMPL_H

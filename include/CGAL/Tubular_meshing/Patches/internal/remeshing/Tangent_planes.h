// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TANGENT_PLANES_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TANGENT_PLANES_H

#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A plane in space, by two unit vectors perpendicular to each other. */
struct Plane_axes {
  Vector_3d first{1, 0, 0}, second{0, 1, 0};
};

/* The axes nearest to two vectors, symmetric in them: the rotation in the polar decomposition of the matrix whose
 * columns they are. False if they are parallel: then there is none. */
inline bool nearest_axes(const Vector_3d& a, const Vector_3d& b, Plane_axes& axes) {
  const double least = 1e-12; // squared ratio of the singular values
  bool exists = true;
  const Metric_tensor_2 products(dot(a, a), dot(a, b), dot(b, b));
  const Metric_tensor_2 s = products.with_eigenvalues([&](double& larger, double& smaller) {
    exists = smaller > least * larger;
    larger = exists ? 1 / std::sqrt(larger) : 0;
    smaller = exists ? 1 / std::sqrt(smaller) : 0;
  });
  if (exists)
    axes = {s.xx * a + s.xy * b, s.xy * a + s.yy * b};
  return exists;
}

/* The rotation part R of the derivative x,u = R U of a parameterization, continuous: its stretch U, interpolated
 * likewise, is in Patch_parameterization::induced_metric().
 *
 * Directions are a matter of an anisotropic metric alone. On an old triangle the derivative is constant, and jumps to
 * the next one by the angle between their planes: a metric taken from it would have jumps, and its thin direction would
 * poke through coarse facets. So vertices get the mean rotation of their triangles, weighted by area, and points in
 * between the mean of their triangle's vertices, each time the nearest rotation to the mean of matrices. */
class Tangent_planes {
public:
  // O(n) in the triangles.
  explicit Tangent_planes(const Patch_parameterization& map)
      : map_(map)
      , axes_(map.number_of_vertices()) {
    std::vector<Plane_axes> sum(axes_.size(), Plane_axes{Vector_3d(), Vector_3d()});
    for (int t = 0; t < int(map.number_of_triangles()); ++t) {
      Plane_axes axes;
      double area = 0;
      if (!axes_of_triangle(t, axes, area))
        continue;
      for (int corner : map.patch().triangles[std::size_t(t)]) {
        const std::size_t v = std::size_t(corner);
        sum[v].first += area * axes.first;
        sum[v].second += area * axes.second;
        axes_[v] = axes; // any, for vertices whose triangles turn in circles
      }
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
      nearest_axes(sum[v].first, sum[v].second, axes_[v]);
  }

  Plane_axes at(const Patch_location& location) const {
    const auto& corners = map_.patch().triangles[std::size_t(location.triangle)];
    const auto& weight = location.barycentric;
    const std::size_t heaviest = std::size_t(std::max_element(weight.begin(), weight.end()) - weight.begin());
    Plane_axes axes = axes_[std::size_t(corners[heaviest])];
    Vector_3d a, b;
    for (std::size_t i = 0; i < 3; ++i) {
      a += weight[i] * axes_[std::size_t(corners[i])].first;
      b += weight[i] * axes_[std::size_t(corners[i])].second;
    }
    nearest_axes(a, b, axes);
    return axes;
  }

private:
  bool axes_of_triangle(int t, Plane_axes& axes, double& area) const {
    const auto& corners = map_.patch().triangles[std::size_t(t)];
    const auto point = [&](std::size_t i) { return Vector_3d(map_.patch().points[std::size_t(corners[i])]); };
    area = norm(cross(point(1) - point(0), point(2) - point(0))) / 2;
    const auto x = map_.derivatives(t);
    return nearest_axes({x(0, 0), x(1, 0), x(2, 0)}, {x(0, 1), x(1, 1), x(2, 1)}, axes);
  }

  const Patch_parameterization& map_;
  std::vector<Plane_axes> axes_; // of the vertices
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TANGENT_PLANES_H

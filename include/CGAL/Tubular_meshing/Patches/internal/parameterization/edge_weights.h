// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_EDGE_WEIGHTS_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_EDGE_WEIGHTS_H

#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Filled_patch.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The pull of each end of an edge on the other one: `of_b` is that of b on a. */
struct Weighted_edge {
  int a, b;
  double of_b, of_a;
};

enum class Edge_weights {
  cotangent,         ///< of the Laplacian of finite elements: symmetric, negative where angles are obtuse
  clamped_cotangent, ///< these, none of them less than a hundredth or more than a hundred
  mean_value,        ///< Floater's mean value coordinates: positive, not symmetric
  uniform,           ///< Tutte's
  shortened          ///< inverse squared lengths, where depth from the outer loop counts less: see Edge_weigher
};

/* Of the angle at the source of a halfedge. Where it is almost 0 or π, bounded: there is no telling such cotangents
 * from rounding, and they would drown all others. */
inline double cotangent_at(const Filled_patch& patch, int h) {
  const Vector_3d& o = patch.points[std::size_t(source_of(patch.triangles, h))];
  const Vector_3d a = patch.points[std::size_t(target_of(patch.triangles, h))] - o;
  const Vector_3d b = patch.points[std::size_t(source_of(patch.triangles, previous_halfedge(h)))] - o;
  const double bound = 1e5, c = dot(a, b), s = norm(cross(a, b));
  return std::abs(c) < bound * s ? c / s : c > 0 ? bound : c < 0 ? -bound : 0.;
}

/* tan(α / 2) of that angle, bounded likewise. */
inline double half_tangent_at(const Filled_patch& patch, int h) {
  const Vector_3d& o = patch.points[std::size_t(source_of(patch.triangles, h))];
  const Vector_3d a = patch.points[std::size_t(target_of(patch.triangles, h))] - o;
  const Vector_3d b = patch.points[std::size_t(source_of(patch.triangles, previous_halfedge(h)))] - o;
  const double product = norm(a) * norm(b), s = norm(cross(a, b)), t = product + dot(a, b);
  const double bound = 1e5;
  return (std::max)(1 / bound, s < bound * t ? s / t : bound);
}

/* Weighs edges. For `shortened` weights, the surface is taken as one that is less deep by the given factor: a blind
 * branch, whose image shrinks exponentially with its depth over its radius, then fits into floating point numbers. */
class Edge_weigher {
public:
  Edge_weigher(const Filled_patch& patch, Edge_weights kind, double shortening = 1)
      : patch_(patch)
      , kind_(kind)
      , flattening_(1 - 1 / (shortening * shortening)) {
    if (kind == Edge_weights::shortened)
      depth_ = patch.distances_from_outer();
    const double mean = patch.length(patch.outer_loop()) / double(patch.outer_loop().size());
    shortest_ = (kind == Edge_weights::shortened ? 1e-4 : 1e-9) * mean;
  }

  // Halfedge h, from a to b, with the triangle beyond it, if there is one.
  Weighted_edge weigh(int h) const {
    const int a = source_of(patch_.triangles, h), b = target_of(patch_.triangles, h);
    if (kind_ == Edge_weights::uniform)
      return {a, b, 1, 1};
    if (kind_ == Edge_weights::shortened) {
      const double l = (std::max)(patch_.length(a, b), shortest_);
      const double deep = (std::min)(std::abs(depth_[std::size_t(a)] - depth_[std::size_t(b)]), l);
      const double w = 1 / (l * l - flattening_ * deep * deep);
      return {a, b, w, w};
    }
    const int o = patch_.opposite[std::size_t(h)];
    if (kind_ == Edge_weights::mean_value) {
      const double l = (std::max)(patch_.length(a, b), shortest_);
      const double at_a = half_tangent(h) + (o < 0 ? 0 : half_tangent(next_halfedge(o)));
      const double at_b = half_tangent(next_halfedge(h)) + (o < 0 ? 0 : half_tangent(o));
      return {a, b, at_a / l, at_b / l};
    }
    const double sum = cotangent(h) + (o < 0 ? 0. : cotangent(o));
    const double w = kind_ == Edge_weights::cotangent ? sum / 2 : (std::min)((std::max)(sum / 2, 0.01), 100.);
    return {a, b, w, w};
  }

private:
  double cotangent(int h) const { return cotangent_at(patch_, previous_halfedge(h)); }
  double half_tangent(int h) const { return half_tangent_at(patch_, h); }

  const Filled_patch& patch_;
  const Edge_weights kind_;
  const double flattening_;
  std::vector<double> depth_;
  double shortest_; // edges count as no shorter than this
};

/* Of all edges. */
inline std::vector<Weighted_edge> edge_weights(const Filled_patch& patch, Edge_weights kind, double shortening = 1) {
  const Edge_weigher weigher(patch, kind, shortening);
  std::vector<Weighted_edge> edges;
  edges.reserve(patch.opposite.size() / 2 + patch.outer_loop().size());
  for (int h = 0; h < int(patch.opposite.size()); ++h)
    if (patch.opposite[std::size_t(h)] < h)
      edges.push_back(weigher.weigh(h));
  return edges;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_EDGE_WEIGHTS_H

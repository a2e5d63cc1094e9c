// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_FRAME_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_FRAME_H

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Fields/internal/Curvature_estimator.h>
#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/Fields/internal/Symmetric_eigen_solver_3.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Part of a symmetric tensor: Σ a_i d_i d_iᵀ is what interpolates directions, which have no sign. */
typedef Metric_tensor_3 Direction_tensor;

/* What the metric needs to know of the wall at one of its points: n nᵀ of its normal; how much each tangent direction
 * is that of the centerline (trace one: a dyad in a tube, less sharp where branches meet or the wall faces the line);
 * and the curvatures in it and across it, absolute and signed. */
struct Wall_frame {
  Vector_3d normal;
  Direction_tensor along;
  double bend_along = 0, bend_across = 0;           // of the curvature tensor's absolute value
  double curvature_along = 0, curvature_across = 0; // positive where convex
};

/* The part in the plane across a unit normal, scaled to trace one; where there is little of it, as on the dome of a
 * blind end, no direction of the plane is better than another. */
inline Direction_tensor tangential(const Direction_tensor& d, const Vector_3d& n) {
  const double enough = 0.25; // sin² of 30 degrees
  const Direction_tensor plane = Direction_tensor() - Direction_tensor::dyad(n);
  // (I - n nᵀ) d (I - n nᵀ) = d - n mᵀ - m nᵀ + (nᵀ m) n nᵀ with m = d n
  const Vector_3d m(d.xx * n.x + d.xy * n.y + d.xz * n.z, d.xy * n.x + d.yy * n.y + d.yz * n.z,
                    d.xz * n.x + d.yz * n.y + d.zz * n.z);
  const double c = dot(n, m);
  const Direction_tensor flat(d.xx - 2 * n.x * m.x + c * n.x * n.x, d.xy - n.x * m.y - m.x * n.y + c * n.x * n.y,
                              d.xz - n.x * m.z - m.x * n.z + c * n.x * n.z, d.yy - 2 * n.y * m.y + c * n.y * n.y,
                              d.yz - n.y * m.z - m.y * n.z + c * n.y * n.z, d.zz - 2 * n.z * m.z + c * n.z * n.z);
  const double trace = flat.xx + flat.yy + flat.zz, x = (std::min)((std::max)(trace, 0.) / enough, 1.);
  const double sharpness = x * x * (3 - 2 * x);
  if (!(trace > 1e-12))
    return 0.5 * plane;
  return (0.5 * (1 - sharpness)) * plane + (sharpness / trace) * flat;
}

/* Measures frames of the wall at its vertices, one at a time. */
class Wall_frame_measurer {
public:
  typedef Indexed_wall::Index Index;

  /* `reach[v]`: how far from vertex v curvatures are averaged, and normals a quarter of that: layers lie along the wall as
   * it is, at the scale of their elements. */
  Wall_frame_measurer(const Indexed_wall& wall, std::vector<double> reach, int threads)
      : reach_(std::move(reach))
      , curvatures_(wall, reach_, threads) {}

  /* `along`: of trace one, the directions that are the vessel's; their part in the wall counts. `near` is of the wall. */
  Wall_frame measured(Index v, const Direction_tensor& along, Wall_neighborhood& near) const {
    Wall_frame f;
    f.normal = mean_normal(near, v, reach_[v] / 4);
    f.along = tangential(along, f.normal);
    measure_curvatures(f, v);
    return f;
  }

  /* The direction to which the normals nearby are most nearly perpendicular: in a tube its own. */
  Vector_3d direction_of_tube(Index v, Wall_neighborhood& near, double distance) const {
    Direction_tensor sum(0, 0, 0, 0, 0, 0);
    near.for_each(v, distance, [&](Index w, double weight) { sum += weight * Direction_tensor::dyad(normal(w)); });
    const Symmetric_eigen_solver_3 solver({sum.xx, sum.xy, sum.xz, sum.yy, sum.yz, sum.zz});
    return solver.direction(solver.descending_order()[2]);
  }

private:
  const Vector_3d& normal(Index v) const { return curvatures_.frames()[v].n; }

  Vector_3d mean_normal(Wall_neighborhood& near, Index v, double distance) const {
    Vector_3d sum;
    near.for_each(v, distance, [&](Index w, double weight) { sum += weight * normal(w); });
    return squared_norm(sum) > 0 ? normalized(sum) : normal(v);
  }

  void measure_curvatures(Wall_frame& f, Index v) const {
    const Tangent_frame& axes = curvatures_.frames()[v];
    const Shape_tensor k = curvatures_.tensors()[v], bend = absolute(k);
    // how much u uᵀ, u vᵀ and v vᵀ there are in the directions along the centerline; the rest is across
    const double uu = f.along.dot(axes.u, axes.u), uv = f.along.dot(axes.u, axes.v), vv = f.along.dot(axes.v, axes.v);
    f.curvature_along = k.uu * uu + 2 * k.uv * uv + k.vv * vv;
    f.curvature_across = k.uu + k.vv - f.curvature_along;
    f.bend_along = (std::max)(bend.uu * uu + 2 * bend.uv * uv + bend.vv * vv, 0.);
    f.bend_across = (std::max)(bend.uu + bend.vv - f.bend_along, 0.);
  }

  /* With the same directions, and the absolute values of both curvatures: on a saddle there are directions without
   * curvature, in which a mesh must be fine nevertheless, for they turn. */
  static Shape_tensor absolute(const Shape_tensor& k) {
    const double mean = (k.uu + k.vv) / 2, d = (k.uu - k.vv) / 2, radius = std::hypot(d, k.uv);
    const double larger = std::abs(mean + radius), smaller = std::abs(mean - radius);
    const double half = radius > 0 ? (larger - smaller) / (2 * radius) : 0;
    return {(larger + smaller) / 2 + half * d, half * k.uv, (larger + smaller) / 2 - half * d};
  }

  std::vector<double> reach_;
  Curvature_estimator curvatures_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_FRAME_H

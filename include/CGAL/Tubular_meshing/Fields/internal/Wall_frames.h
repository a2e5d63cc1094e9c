// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_FRAMES_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_FRAMES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Fields/internal/Curvature_estimator.h>
#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

/* The frames of all points of the wall: computed at its vertices, interpolated in its triangles. */
class Wall_frames {
public:
  /* `radius(v)`: the local radius at a vertex; `direction(v)`: the unit vector e_t there; both safe to call from
   * several threads. Curvatures are averaged within `smoothing` radii, directions within half a radius,
   * normals within a quarter of `smoothing` radii: layers lie along the wall as it is, at the scale of their elements.
   * O(n). */
  Wall_frames(Indexed_wall wall, Function_view<double(Indexed_wall::Index)> radius,
              Function_view<Vector_3d(Indexed_wall::Index)> direction, double smoothing, int threads)
      : wall_(std::move(wall))
      , tree_(wall_.make_tree())
      , threads_(threads) {
    const std::size_t n = wall_.number_of_vertices();
    std::vector<double> r(n), reach(n);
    std::vector<Vector_3d> e_t(n);
    for_each_vertex([&](Indexed_wall::Index v, Wall_neighborhood&) {
      r[v] = radius(v);
      reach[v] = smoothing * r[v];
      e_t[v] = direction(v);
    });
    const Curvature_estimator estimator(wall_, reach, threads);
    frames_.resize(n);
    for_each_vertex([&](Indexed_wall::Index v, Wall_neighborhood& near) {
      frames_[v].normal = mean_normal(estimator, near, v, reach[v] / 4);
    });
    for_each_vertex([&](Indexed_wall::Index v, Wall_neighborhood& near) {
      frames_[v].along = mean_direction(e_t, near, v, 0.5 * r[v]);
      measure_curvatures(estimator, v);
    });
  }

  const Nearest_tree<Double_kernel::Triangle_3>& tree() const { return tree_; }

  /* At a point of a triangle, both as the tree has found them. */
  Wall_frame at(std::size_t triangle, const Double_kernel::Point_3& p) const {
    const auto& t = wall_.triangles()[triangle];
    const std::array<double, 3> b = barycentric(t, Vector_3d(p));
    Wall_frame f;
    f.normal = Vector_3d(0, 0, 0);
    f.along = Direction_tensor(0, 0, 0, 0, 0, 0);
    for (int i = 0; i < 3; ++i) {
      const Wall_frame& g = frames_[t[i]];
      f.normal += b[i] * g.normal;
      f.along += b[i] * g.along;
      f.bend_along += b[i] * g.bend_along;
      f.bend_across += b[i] * g.bend_across;
      f.curvature_along += b[i] * g.curvature_along;
      f.curvature_across += b[i] * g.curvature_across;
    }
    f.normal = squared_norm(f.normal) > 0 ? normalized(f.normal) : frames_[t[0]].normal;
    f.along = tangential(f.along, f.normal);
    return f;
  }

private:
  template <class Body> void for_each_vertex(const Body& body) const {
    for_each_range(wall_.number_of_vertices(), threads_, [&](std::size_t first, std::size_t last) {
      Wall_neighborhood near(wall_);
      for (std::size_t v = first; v < last; ++v)
        body(Indexed_wall::Index(v), near);
    });
  }

  static Vector_3d mean_normal(const Curvature_estimator& e, Wall_neighborhood& near, Indexed_wall::Index v, double r) {
    Vector_3d sum;
    near.for_each(v, r, [&](Indexed_wall::Index w, double weight) { sum += weight * e.frames()[w].n; });
    return squared_norm(sum) > 0 ? normalized(sum) : e.frames()[v].n;
  }

  Direction_tensor mean_direction(const std::vector<Vector_3d>& e_t, Wall_neighborhood& near, Indexed_wall::Index v,
                                  double r) const {
    Direction_tensor sum(0, 0, 0, 0, 0, 0);
    double total = 0;
    near.for_each(v, r, [&](Indexed_wall::Index w, double weight) {
      sum += weight * Direction_tensor::dyad(e_t[w]);
      total += weight;
    });
    return tangential((1 / total) * sum, frames_[v].normal);
  }

  /* The part in the plane across a unit normal, scaled to trace one; where there is little of it, as on the dome of a
   * blind end, no direction of the plane is better than another. */
  static Direction_tensor tangential(const Direction_tensor& d, const Vector_3d& n) {
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

  void measure_curvatures(const Curvature_estimator& e, Indexed_wall::Index v) {
    Wall_frame& f = frames_[v];
    const Tangent_frame& axes = e.frames()[v];
    const Shape_tensor k = e.tensors()[v], bend = absolute(k);
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

  std::array<double, 3> barycentric(const std::array<Indexed_wall::Index, 3>& t, const Vector_3d& p) const {
    const Vector_3d n = wall_.doubled_area(t);
    const double n2 = squared_norm(n);
    std::array<double, 3> b;
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const Vector_3d &q = wall_.point(t[(i + 1) % 3]), &r = wall_.point(t[(i + 2) % 3]);
      b[i] = (std::min)((std::max)(dot(cross(q - p, r - p), n) / n2, 0.), 1.);
      sum += b[i];
    }
    for (double& x : b)
      x = sum > 0 ? x / sum : 1. / 3;
    return b;
  }

  Indexed_wall wall_;
  Nearest_tree<Double_kernel::Triangle_3> tree_;
  int threads_;
  std::vector<Wall_frame> frames_; // one a vertex
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_FRAMES_H

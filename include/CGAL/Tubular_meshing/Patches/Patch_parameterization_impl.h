// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PATCH_PARAMETERIZATION_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_PATCH_PARAMETERIZATION_IMPL_H

#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Edge_halver.h>
#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE
Patch_parameterization::Patch_parameterization(internal::Divided_patch divided, std::vector<Eigen::Vector2d> uv,
                                               Parameterization_method method, std::size_t number_of_flips)
    : patch_(std::move(divided.patch))
    , input_triangles_(std::move(divided.origin))
    , loop_positions_(std::move(divided.positions))
    , uv_(std::move(uv))
    , method_(method)
    , number_of_flips_(number_of_flips)
    , opposite_(internal::opposite_halfedges(patch_.triangles))
    , tree_(uv_, patch_.triangles)
    , log_of_shape_(log_vertex_metrics([](const Point_3&) { return Eigen::Matrix3d::Identity(); })) {
  measure_loops();
}

CGAL_TUBULAR_MESHING_INLINE Patch_location Patch_parameterization::locate(const Point_2& uv, int hint) const {
  const Eigen::Vector2d p(uv.x(), uv.y());
  Patch_location location;
  if (hint >= 0 && walk(p, hint, location))
    return location;
  internal::Nearest_in_triangle nearest;
  location.triangle = tree_.nearest(uv_, patch_.triangles, p, nearest);
  location.barycentric = nearest.barycentric;
  location.squared_distance = nearest.squared_distance;
  return location;
}

CGAL_TUBULAR_MESHING_INLINE Patch_parameterization::Point_2 Patch_parameterization::uv(const Patch_location& at) const {
  Eigen::Vector2d sum(0, 0);
  for (std::size_t i = 0; i < 3; ++i)
    sum += at.barycentric[i] * uv_[std::size_t(corner(at.triangle, i))];
  return point_2(sum);
}

CGAL_TUBULAR_MESHING_INLINE Point_3 Patch_parameterization::point(const Patch_location& at) const {
  internal::Vector_3d sum;
  for (std::size_t i = 0; i < 3; ++i)
    sum += at.barycentric[i] * internal::Vector_3d(patch_.points[std::size_t(corner(at.triangle, i))]);
  return internal::as<Point_3>(sum);
}

CGAL_TUBULAR_MESHING_INLINE Patch_parameterization::Derivatives
Patch_parameterization::derivatives(int triangle) const {
  const std::array<Eigen::Vector2d, 3> c = corners(triangle);
  Eigen::Matrix2d e;
  e << c[1] - c[0], c[2] - c[0];
  Derivatives x;
  x << eigen_point(triangle, 1) - eigen_point(triangle, 0), eigen_point(triangle, 2) - eigen_point(triangle, 0);
  Eigen::Matrix2d adjugate;
  adjugate << e(1, 1), -e(0, 1), -e(1, 0), e(0, 0);
  return (1 / internal::plane_cross_product(e.col(0), e.col(1))) * (x * adjugate);
}

CGAL_TUBULAR_MESHING_INLINE double Patch_parameterization::stretch_ratio(int triangle) const {
  double ratio = 1;
  induced_metric(triangle, Eigen::Matrix3d::Identity()).with_eigenvalues([&](double& larger, double& smaller) {
    ratio = smaller > 0 ? std::sqrt(larger / smaller) : (std::numeric_limits<double>::infinity)();
  });
  return ratio;
}

CGAL_TUBULAR_MESHING_INLINE Metric_tensor_2
Patch_parameterization::induced_metric(int triangle, const Eigen::Matrix3d& metric) const {
  const Derivatives x = derivatives(triangle);
  const Eigen::Matrix2d m = x.transpose() * metric * x;
  return {m(0, 0), (m(0, 1) + m(1, 0)) / 2, m(1, 1)};
}

CGAL_TUBULAR_MESHING_INLINE Metric_tensor_2 Patch_parameterization::induced_metric(const Patch_location& at,
                                                                                   double size) const {
  return 1 / (size * size) * interpolate(log_of_shape_, at);
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Metric_tensor_2>
Patch_parameterization::log_vertex_metrics(internal::Function_view<Eigen::Matrix3d(const Point_3&)> metric) const {
  std::vector<Metric_tensor_2> sum(uv_.size(), Metric_tensor_2(0, 0, 0));
  std::vector<double> weight(uv_.size(), 0.);
  for (int t = 0; t < int(patch_.triangles.size()); ++t) {
    const double area = (std::max)(area_of(t), (std::numeric_limits<double>::min)());
    const Derivatives x = derivatives(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = std::size_t(corner(t, i));
      const Eigen::Matrix2d m = x.transpose() * metric(patch_.points[v]) * x;
      sum[v] = sum[v] + area * Metric_tensor_2(m(0, 0), (m(0, 1) + m(1, 0)) / 2, m(1, 1)).log();
      weight[v] += area;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    if (weight[v] > 0)
      sum[v] = 1 / weight[v] * sum[v];
  return sum;
}

CGAL_TUBULAR_MESHING_INLINE Metric_tensor_2
Patch_parameterization::interpolate(const std::vector<Metric_tensor_2>& log_metrics, const Patch_location& at) const {
  Metric_tensor_2 sum(0, 0, 0);
  for (std::size_t i = 0; i < 3; ++i)
    sum = sum + at.barycentric[i] * log_metrics[std::size_t(corner(at.triangle, i))];
  return sum.exp();
}

CGAL_TUBULAR_MESHING_INLINE Patch_location Patch_parameterization::on_loop(std::size_t loop, double arc_length) const {
  const double total = arc_length_[loop].back();
  return on_loop_part(loop, arc_length_[loop], total > 0 ? arc_length - total * std::floor(arc_length / total) : 0);
}

CGAL_TUBULAR_MESHING_INLINE Eigen::Vector3d Patch_parameterization::eigen_point(int triangle, std::size_t i) const {
  const Point_3& p = patch_.points[std::size_t(corner(triangle, i))];
  return Eigen::Vector3d(p.x(), p.y(), p.z());
}

CGAL_TUBULAR_MESHING_INLINE double Patch_parameterization::area_of(int triangle) const {
  const Eigen::Vector3d a = eigen_point(triangle, 0);
  return (eigen_point(triangle, 1) - a).cross(eigen_point(triangle, 2) - a).norm() / 2;
}

// On the edge of a loop over whose ends' values x is.
CGAL_TUBULAR_MESHING_INLINE Patch_location Patch_parameterization::on_loop_part(std::size_t loop,
                                                                                const std::vector<double>& values,
                                                                                double x) const {
  std::size_t i = std::size_t(std::upper_bound(values.begin(), values.end(), x) - values.begin());
  i = (std::min)((std::max)(i, std::size_t(1)), values.size() - 1) - 1;
  const double length = values[i + 1] - values[i];
  const double t = length > 0 ? (std::min)((std::max)((x - values[i]) / length, 0.), 1.) : 0;
  const int h = loop_halfedge_[loop][i];
  Patch_location at;
  at.triangle = internal::triangle_of(h);
  at.barycentric = {{0, 0, 0}};
  at.barycentric[std::size_t(h % 3)] = 1 - t;
  at.barycentric[std::size_t(internal::next_halfedge(h) % 3)] = t;
  return at;
}

// From triangle to triangle, each time over the side that p is farthest beyond. False if it leaves the patch or is
// long: then the tree is faster.
CGAL_TUBULAR_MESHING_INLINE bool Patch_parameterization::walk(const Eigen::Vector2d& p, int triangle,
                                                              Patch_location& location) const {
  const int most_steps = 32;
  for (int step = 0; step < most_steps; ++step) {
    const std::array<double, 3> area = internal::side_areas(corners(triangle), p);
    const std::size_t i = std::size_t(std::min_element(area.begin(), area.end()) - area.begin());
    const double sum = area[0] + area[1] + area[2];
    if (area[i] >= 0 && sum > 0) {
      location.triangle = triangle;
      location.barycentric = {{area[0] / sum, area[1] / sum, area[2] / sum}};
      return true;
    }
    const int beyond = opposite_[std::size_t(internal::next_halfedge(3 * triangle + int(i)))];
    if (beyond < 0)
      return false;
    triangle = internal::triangle_of(beyond);
  }
  return false;
}

CGAL_TUBULAR_MESHING_INLINE void Patch_parameterization::measure_loops() {
  std::vector<int> border(uv_.size(), -1);
  for (int h = 0; h < int(opposite_.size()); ++h)
    if (opposite_[std::size_t(h)] < 0)
      border[std::size_t(internal::source_of(patch_.triangles, h))] = h;
  for (const std::vector<int>& loop : patch_.loops) {
    arc_length_.emplace_back(1, 0.);
    loop_halfedge_.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const internal::Vector_3d a(patch_.points[std::size_t(loop[i])]);
      const internal::Vector_3d b(patch_.points[std::size_t(loop[(i + 1) % loop.size()])]);
      arc_length_.back().push_back(arc_length_.back().back() + internal::norm(b - a));
      loop_halfedge_.back().push_back(border[std::size_t(loop[i])]);
    }
  }
  for (std::size_t i = 0; i < patch_.loops.size(); ++i)
    if (uv_[std::size_t(patch_.loops[i][0])].norm() > uv_[std::size_t(patch_.loops[outer_loop_][0])].norm())
      outer_loop_ = i;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_PATCH_PARAMETERIZATION_IMPL_H

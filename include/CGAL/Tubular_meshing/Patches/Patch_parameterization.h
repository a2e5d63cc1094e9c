// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PATCH_PARAMETERIZATION_H
#define CGAL_TUBULAR_MESHING_PATCHES_PATCH_PARAMETERIZATION_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Indexed_patch.h>
#include <CGAL/Tubular_meshing/Patches/Parameterization_method.h>
#include <CGAL/Tubular_meshing/Plane/Plane_metric.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Edge_halver.h>
#include <CGAL/Tubular_meshing/Plane/Plane_triangle_tree.h>
#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/Kernel_traits.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 * A point of a parameterized patch: on one of its triangles. */
struct Patch_location {
  int triangle = 0;
  std::array<double, 3> barycentric{{1, 0, 0}}; ///< not negative, of sum 1
  double squared_distance = 0; ///< in the plane, to the point that was asked for; 0 if that is in the patch
};

/*! \ingroup PkgTubularMeshingRef
 *
 * A patch with a bijection u(x) onto a domain of the plane, linear on each triangle (equation (1) of the paper); and
 * its inverse x(u), with its derivatives. parameterize_patch() makes it.
 *
 * The domain is inside the unit circle. The longest loop is its outer border, a polygon inscribed in the circle, the
 * other loops are holes. Triangles are counterclockwise. A conformal map shrinks along a tube exponentially: by
 * exp(−2 η) over a length of η diameters.
 *
 * All member functions are const and may be called by several threads at once.
 */
class Patch_parameterization {
public:
  typedef Tubular_meshing::Point_3 Point_3;
  typedef typename CGAL::Kernel_traits<Point_3>::Kernel Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef Eigen::Matrix<double, 3, 2> Derivatives; ///< columns x,u and x,v

  /// An empty one, to be assigned to.
  Patch_parameterization() = default;

  /// Of a patch whose points have the given places in the plane. O(n log n).
  Patch_parameterization(internal::Divided_patch divided, std::vector<Eigen::Vector2d> uv,
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

  /// \name The map
  /// @{

  /// The patch as it was given, but that wide edges may be halved: new points come after the given ones, and are on
  /// loops too.
  const Indexed_patch& patch() const { return patch_; }
  /// The triangle of the given patch that a triangle is part of.
  int input_triangle(int triangle) const { return input_triangles_[std::size_t(triangle)]; }
  std::size_t number_of_vertices() const { return uv_.size(); }
  std::size_t number_of_triangles() const { return patch_.triangles.size(); }
  Point_2 uv(int vertex) const { return point_2(uv_[std::size_t(vertex)]); }

  /// How it was made.
  Parameterization_method method() const { return method_; }
  /// Triangles that the first method, the conformal one, flipped; 0 if that was taken.
  std::size_t number_of_flips() const { return number_of_flips_; }
  /// The index of the loop on the unit circle.
  std::size_t outer_loop() const { return outer_loop_; }

  /// Where a point of the plane is; for one outside of the domain, as on the circle's arcs, the nearest point of it.
  /// O(log n); with a triangle near it as a hint, the time of a walk to it.
  Patch_location locate(const Point_2& uv, int hint = -1) const {
    const Eigen::Vector2d p(CGAL::to_double(uv.x()), CGAL::to_double(uv.y()));
    Patch_location location;
    if (hint >= 0 && walk(p, hint, location))
      return location;
    internal::Nearest_in_triangle nearest;
    location.triangle = tree_.nearest(uv_, patch_.triangles, p, nearest);
    location.barycentric = nearest.barycentric;
    location.squared_distance = nearest.squared_distance;
    return location;
  }

  /// The place of a location in the plane.
  Point_2 uv(const Patch_location& at) const {
    Eigen::Vector2d sum(0, 0);
    for (std::size_t i = 0; i < 3; ++i)
      sum += at.barycentric[i] * uv_[std::size_t(corner(at.triangle, i))];
    return point_2(sum);
  }

  /// x(u): the point of the surface itself.
  Point_3 point(const Patch_location& at) const {
    internal::Vector_3d sum;
    for (std::size_t i = 0; i < 3; ++i)
      sum += at.barycentric[i] * internal::Vector_3d(patch_.points[std::size_t(corner(at.triangle, i))]);
    return Point_3(sum.x, sum.y, sum.z);
  }
  Point_3 point(const Point_2& uv) const { return point(locate(uv)); }

  /// x,u and x,v, constant on a triangle.
  Derivatives derivatives(int triangle) const {
    const std::array<Eigen::Vector2d, 3> c = corners(triangle);
    Eigen::Matrix2d e;
    e << c[1] - c[0], c[2] - c[0];
    Derivatives x;
    x << eigen_point(triangle, 1) - eigen_point(triangle, 0), eigen_point(triangle, 2) - eigen_point(triangle, 0);
    Eigen::Matrix2d adjugate;
    adjugate << e(1, 1), -e(0, 1), -e(1, 0), e(0, 0);
    return (1 / internal::plane_cross_product(e.col(0), e.col(1))) * (x * adjugate);
  }

  /// The ratio of the largest to the smallest stretch of a triangle: 1 where the map is conformal.
  double stretch_ratio(int triangle) const {
    double ratio = 1;
    internal::with_eigenvalues(
        induced_metric(triangle, Eigen::Matrix3d::Identity()), [&](double& larger, double& smaller) {
          ratio = smaller > 0 ? std::sqrt(larger / smaller) : (std::numeric_limits<double>::infinity)();
        });
    return ratio;
  }

  /// @}
  /// \name The induced metric, equation (11)
  /// @{

  /// x,uᵀ M x,u on a triangle, for a 3 x 3 matrix M.
  Plane_metric induced_metric(int triangle, const Eigen::Matrix3d& metric) const {
    const Derivatives x = derivatives(triangle);
    const Eigen::Matrix2d m = x.transpose() * metric * x;
    return {m(0, 0), (m(0, 1) + m(1, 0)) / 2, m(1, 1)};
  }

  /// The same for M = I / size², continuous: interpolated between vertices, which have the means of their triangles.
  Plane_metric induced_metric(const Patch_location& at, double size) const {
    return 1 / (size * size) * interpolate(log_of_shape_, at);
  }

  /// A field of metrics, `metric(Point_3)` a 3 x 3 matrix, induced on the plane: one logarithm a vertex, of the means
  /// of its triangles' induced metrics, weighted by their areas on the surface. For interpolate().
  template <class MetricField> std::vector<Plane_metric> log_vertex_metrics(const MetricField& metric) const {
    std::vector<Plane_metric> sum(uv_.size());
    std::vector<double> weight(uv_.size(), 0.);
    for (int t = 0; t < int(patch_.triangles.size()); ++t) {
      const double area = (std::max)(area_of(t), (std::numeric_limits<double>::min)());
      const Derivatives x = derivatives(t);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t v = std::size_t(corner(t, i));
        const Eigen::Matrix2d m = x.transpose() * Eigen::Matrix3d(metric(patch_.points[v])) * x;
        sum[v] = sum[v] + area * internal::logarithm({m(0, 0), (m(0, 1) + m(1, 0)) / 2, m(1, 1)});
        weight[v] += area;
      }
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
      if (weight[v] > 0)
        sum[v] = 1 / weight[v] * sum[v];
    return sum;
  }

  /// The metric between vertices, from log_vertex_metrics(): continuous.
  Plane_metric interpolate(const std::vector<Plane_metric>& log_metrics, const Patch_location& at) const {
    Plane_metric sum;
    for (std::size_t i = 0; i < 3; ++i)
      sum = sum + at.barycentric[i] * log_metrics[std::size_t(corner(at.triangle, i))];
    return internal::exponential(sum);
  }

  /// @}
  /// \name Loops
  /// @{

  std::size_t number_of_loops() const { return patch_.loops.size(); }

  /// The length of a loop on the surface.
  double loop_length(std::size_t loop) const { return arc_length_[loop].back(); }

  /// The point of edge `edge` of a loop, as it was given, that divides the edge as t : 1 − t, t in [0, 1]. Its place in
  /// the plane is on the chord of the edge, or of a part of it. O(log n).
  Patch_location on_loop_edge(std::size_t loop, std::size_t edge, double t) const {
    return on_loop_part(loop, loop_positions_[loop], double(edge) + t);
  }

  /// The point of a loop at an arc length from its first vertex, on the surface; lengths count modulo loop_length().
  /// O(log n).
  Patch_location on_loop(std::size_t loop, double arc_length) const {
    const double total = arc_length_[loop].back();
    return on_loop_part(loop, arc_length_[loop], total > 0 ? arc_length - total * std::floor(arc_length / total) : 0);
  }

  /// @}

private:
  static Point_2 point_2(const Eigen::Vector2d& p) { return Point_2(p.x(), p.y()); }
  int corner(int triangle, std::size_t i) const { return patch_.triangles[std::size_t(triangle)][i]; }
  std::array<Eigen::Vector2d, 3> corners(int triangle) const {
    return internal::Plane_triangle_tree::corners(uv_, patch_.triangles[std::size_t(triangle)]);
  }
  Eigen::Vector3d eigen_point(int triangle, std::size_t i) const {
    const Point_3& p = patch_.points[std::size_t(corner(triangle, i))];
    return Eigen::Vector3d(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  double area_of(int triangle) const {
    const Eigen::Vector3d a = eigen_point(triangle, 0);
    return (eigen_point(triangle, 1) - a).cross(eigen_point(triangle, 2) - a).norm() / 2;
  }

  // On the edge of a loop over whose ends' values x is.
  Patch_location on_loop_part(std::size_t loop, const std::vector<double>& values, double x) const {
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
  bool walk(const Eigen::Vector2d& p, int triangle, Patch_location& location) const {
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

  void measure_loops() {
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

  Indexed_patch patch_;
  std::vector<int> input_triangles_;
  std::vector<std::vector<double>> loop_positions_; // of the vertices of each loop, on the given one, and its end
  std::vector<Eigen::Vector2d> uv_;
  Parameterization_method method_ = Parameterization_method::conformal;
  std::size_t number_of_flips_ = 0;
  std::size_t outer_loop_ = 0;
  std::vector<int> opposite_;
  internal::Plane_triangle_tree tree_;
  std::vector<Plane_metric> log_of_shape_;      // of the vertices, for M = I
  std::vector<std::vector<double>> arc_length_; // of each loop, at its vertices and at its end
  std::vector<std::vector<int>> loop_halfedge_; // of each edge of each loop
};

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_PATCH_PARAMETERIZATION_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PATCH_PARAMETERIZATION_H
#define CGAL_TUBULAR_MESHING_PATCHES_PATCH_PARAMETERIZATION_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Indexed_patch.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Plane/Plane_triangle_tree.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {
struct Divided_patch;
}

/*! \ingroup PkgTubularMeshingPatches
 *
 * How a patch was mapped onto the plane: each of these is tried when the one before gave no bijection.
 */
enum class Parameterization_method {
  conformal,          ///< keeps angles
  conformal_repaired, ///< conformal, but near triangles that were flipped: there mean value coordinates
  harmonic,           ///< by cotangents, bounded from below, with the outer loop on a circle: mostly near conformal
  mean_value,         ///< Floater's mean value coordinates, with the outer loop on a circle by its lengths
  uniform,            ///< Tutte's map: each vertex in the middle of its neighbours
  shortened           ///< for long blind branches: as if the surface were less deep, as seen from its outer loop
};

/*! \ingroup PkgTubularMeshingPatches
 * Its name, as reports print it. */
inline const char* name_of(Parameterization_method method) {
  switch (method) {
  case Parameterization_method::conformal:
    return "conformal";
  case Parameterization_method::conformal_repaired:
    return "conformal_repaired";
  case Parameterization_method::harmonic:
    return "harmonic";
  case Parameterization_method::mean_value:
    return "mean_value";
  case Parameterization_method::uniform:
    return "uniform";
  default:
    return "shortened";
  }
}

/*! \ingroup PkgTubularMeshingPatches
 * A point of a parameterized patch: on one of its triangles. */
struct Patch_location {
  int triangle = 0;
  std::array<double, 3> barycentric{{1, 0, 0}}; ///< not negative, of sum 1
  double squared_distance = 0; ///< in the plane, to the point that was asked for; 0 if that is in the patch
};

/*! \ingroup PkgTubularMeshingPatches
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
  typedef Kernel::Point_2 Point_2;
  typedef Eigen::Matrix<double, 3, 2> Derivatives; ///< columns x,u and x,v

  /// An empty one, to be assigned to.
  Patch_parameterization() = default;

  /// Of a patch whose points have the given places in the plane. O(n log n).
  Patch_parameterization(internal::Divided_patch divided, std::vector<Eigen::Vector2d> uv,
                         Parameterization_method method, std::size_t number_of_flips);

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
  Patch_location locate(const Point_2& uv, int hint = -1) const;

  /// The place of a location in the plane.
  Point_2 uv(const Patch_location& at) const;

  /// x(u): the point of the surface itself.
  Point_3 point(const Patch_location& at) const;
  Point_3 point(const Point_2& uv) const { return point(locate(uv)); }

  /// x,u and x,v, constant on a triangle.
  Derivatives derivatives(int triangle) const;

  /// The ratio of the largest to the smallest stretch of a triangle: 1 where the map is conformal.
  double stretch_ratio(int triangle) const;

  /// @}
  /// \name The induced metric, equation (11)
  /// @{

  /// x,uᵀ M x,u on a triangle, for a 3 x 3 matrix M.
  Metric_tensor_2 induced_metric(int triangle, const Eigen::Matrix3d& metric) const;

  /// The same for M = I / size², continuous: interpolated between vertices, which have the means of their triangles.
  Metric_tensor_2 induced_metric(const Patch_location& at, double size) const;

  /// A field of metrics, `metric(Point_3)` a 3 x 3 matrix, induced on the plane: one logarithm a vertex, of the means
  /// of its triangles' induced metrics, weighted by their areas on the surface. For interpolate().
  std::vector<Metric_tensor_2>
  log_vertex_metrics(internal::Function_view<Eigen::Matrix3d(const Point_3&)> metric) const;

  /// The metric between vertices, from log_vertex_metrics(): continuous.
  Metric_tensor_2 interpolate(const std::vector<Metric_tensor_2>& log_metrics, const Patch_location& at) const;

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
  Patch_location on_loop(std::size_t loop, double arc_length) const;

  /// @}

private:
  static Point_2 point_2(const Eigen::Vector2d& p) { return Point_2(p.x(), p.y()); }
  int corner(int triangle, std::size_t i) const { return patch_.triangles[std::size_t(triangle)][i]; }
  std::array<Eigen::Vector2d, 3> corners(int triangle) const {
    return internal::Plane_triangle_tree::corners(uv_, patch_.triangles[std::size_t(triangle)]);
  }
  Eigen::Vector3d eigen_point(int triangle, std::size_t i) const;
  double area_of(int triangle) const;
  Patch_location on_loop_part(std::size_t loop, const std::vector<double>& values, double x) const;
  bool walk(const Eigen::Vector2d& p, int triangle, Patch_location& location) const;
  void measure_loops();

  Indexed_patch patch_;
  std::vector<int> input_triangles_;
  std::vector<std::vector<double>> loop_positions_; // of the vertices of each loop, on the given one, and its end
  std::vector<Eigen::Vector2d> uv_;
  Parameterization_method method_ = Parameterization_method::conformal;
  std::size_t number_of_flips_ = 0;
  std::size_t outer_loop_ = 0;
  std::vector<int> opposite_;
  internal::Plane_triangle_tree tree_;
  std::vector<Metric_tensor_2> log_of_shape_;   // of the vertices, for M = I
  std::vector<std::vector<double>> arc_length_; // of each loop, at its vertices and at its end
  std::vector<std::vector<int>> loop_halfedge_; // of each edge of each loop
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_PATCH_PARAMETERIZATION_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_RIM_SHAPE_IMPL_H
#define CGAL_TUBULAR_MESHING_RIMS_RIM_SHAPE_IMPL_H

#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE std::vector<double> rim_weights(const std::vector<Point_3>& rim, double& perimeter) {
  const std::size_t n = rim.size();
  std::vector<double> weights(n, 0.);
  perimeter = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const double length = point_distance(rim[i], rim[next]);
    weights[i] += length / 2;
    weights[next] += length / 2;
    perimeter += length;
  }
  return weights;
}

// The unit vector along which the weighted vertices spread least, up to its sign.
inline Vector_3 least_spread(const std::vector<Point_3>& rim, const std::vector<double>& weights, const Point_3& mean,
                             double scale) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vector_3 v = (rim[i] - mean) / scale;
    const Eigen::Vector3d e(v.x(), v.y(), v.z());
    covariance += (weights[i] / scale) * e * e.transpose();
  }
  const Eigen::Vector3d n = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
  return Vector_3(n.x(), n.y(), n.z());
}

CGAL_TUBULAR_MESHING_INLINE void measure_in_plane(const std::vector<Point_3>& rim, Rim_shape& shape) {
  const std::size_t n = rim.size();
  double twice_area = 0, moment_x = 0, moment_y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto a = shape.plane.in_plane(rim[i]), b = shape.plane.in_plane(rim[(i + 1) % n]);
    const double cross = a[0] * b[1] - a[1] * b[0];
    twice_area += cross;
    moment_x += cross * (a[0] + b[0]);
    moment_y += cross * (a[1] + b[1]);
    shape.sag = (std::max)(shape.sag, std::abs(shape.plane.height(rim[i])));
  }
  shape.area = twice_area / 2;
  if (!(shape.area > 1e-12 * shape.perimeter * shape.perimeter))
    return;
  shape.radius = std::sqrt(shape.area / CGAL_PI);
  shape.center = shape.plane.in_space({moment_x / (3 * twice_area), moment_y / (3 * twice_area)});
  for (const Point_3& p : rim)
    shape.reach = (std::max)(shape.reach, point_distance(p, shape.center));
}

CGAL_TUBULAR_MESHING_INLINE Rim_shape measure_rim(const std::vector<Point_3>& rim) {
  Rim_shape shape;
  const std::vector<double> weights = rim_weights(rim, shape.perimeter);
  shape.center = rim[0];
  if (!(shape.perimeter > 0))
    return shape;
  Vector_3 offset(0, 0, 0), area(0, 0, 0);
  for (std::size_t i = 0; i < rim.size(); ++i)
    offset = offset + (weights[i] / shape.perimeter) * (rim[i] - rim[0]);
  const Point_3 mean = rim[0] + offset;
  for (std::size_t i = 0; i < rim.size(); ++i)
    area = area + CGAL::cross_product(rim[i] - mean, rim[(i + 1) % rim.size()] - mean) / 2;
  const double area_length = std::sqrt(area.squared_length());
  shape.center = mean;
  if (!(area_length > 1e-12 * shape.perimeter * shape.perimeter))
    return shape;
  Vector_3 normal = least_spread(rim, weights, mean, shape.perimeter);
  if (std::abs(normal * area) < 0.5 * area_length)
    normal = area / area_length;
  else if (normal * area < 0)
    normal = -normal;
  std::size_t farthest = 0; // a vertex on the axis would give no direction
  for (std::size_t i = 1; i < rim.size(); ++i)
    if (CGAL::squared_distance(rim[i], mean) > 1.0001 * CGAL::squared_distance(rim[farthest], mean))
      farthest = i;
  shape.plane = Rim_plane(mean, normal, rim[farthest] - mean);
  measure_in_plane(rim, shape);
  return shape;
}

// --- corners ---

// Douglas-Peucker on rim[first..last], indices modulo the size: how many vertices between the two are needed.
inline std::size_t number_of_corners_between(const std::vector<Point_3>& rim, std::size_t first, std::size_t last,
                                             double tolerance) {
  std::vector<std::pair<std::size_t, std::size_t>> stack = {{first, last}};
  std::size_t corners = 0;
  while (!stack.empty()) {
    const auto [a, b] = stack.back();
    stack.pop_back();
    const Point_3 &p = rim[a % rim.size()], &q = rim[b % rim.size()];
    const Vector_3 chord = q - p;
    const double length2 = chord.squared_length();
    double farthest = tolerance;
    std::size_t corner = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const Vector_3 v = rim[i % rim.size()] - p;
      const double t = length2 > 0 ? (std::min)(1., (std::max)(0., (v * chord) / length2)) : 0;
      const double d = std::sqrt((v - t * chord).squared_length());
      if (d > farthest) {
        farthest = d;
        corner = i;
      }
    }
    if (corner == a)
      continue;
    ++corners;
    stack.emplace_back(a, corner);
    stack.emplace_back(corner, b);
  }
  return corners;
}

CGAL_TUBULAR_MESHING_INLINE std::size_t number_of_corners(const std::vector<Point_3>& rim, const Point_3& center,
                                                          double tolerance) {
  auto farthest_from = [&](const Point_3& p) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < rim.size(); ++i)
      if (CGAL::squared_distance(rim[i], p) > CGAL::squared_distance(rim[best], p))
        best = i;
    return best;
  };
  std::size_t first = farthest_from(center), second = farthest_from(rim[first]);
  if (first > second)
    std::swap(first, second);
  return 2 + number_of_corners_between(rim, first, second, tolerance) +
         number_of_corners_between(rim, second, first + rim.size(), tolerance);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_RIM_SHAPE_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_CANONICAL_FRAME_H
#define CGAL_TUBULAR_MESHING_BASE_CANONICAL_FRAME_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A frame that moves, turns and grows with a set of points: their mean, principal axes, and root mean square extent.
 *
 * In it, points are rounded to multiples of 2^-23, which removes what a change of units, a rotation or a translation
 * in double precision does to the last digits. So the same surface, however it lies, gives the very same numbers, and
 * an algorithm that decides by comparing them decides alike. A set with symmetries has several such frames; then any.
 */
class Canonical_frame {
public:
  typedef Double_kernel::Point_3 Point;

  explicit Canonical_frame(const std::vector<Point>& points) {
    Eigen::Vector3d mean(0, 0, 0);
    for (const Point& p : points)
      mean += vector(p) - vector(points.front());
    origin_ = vector(points.front()) + mean / double(points.size());

    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (const Point& p : points) {
      const Eigen::Vector3d d = vector(p) - origin_;
      second += d * d.transpose();
    }
    scale_ = std::sqrt(second.trace() / double(points.size()));
    if (!(scale_ > 0) || !std::isfinite(scale_))
      scale_ = 1;
    axes_ = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(second / (scale_ * scale_)).eigenvectors().transpose();
    orient(points);
  }

  double scale() const { return scale_; }

  Point to_canonical(const Point& p) const {
    const Point x = to_frame(p);
    return Point(rounded(x.x()), rounded(x.y()), rounded(x.z()));
  }

  // The same, not rounded.
  Point to_frame(const Point& p) const {
    const Eigen::Vector3d x = axes_ * ((vector(p) - origin_) / scale_);
    return Point(x[0], x[1], x[2]);
  }

  Point from_canonical(const Point& p) const {
    const Eigen::Vector3d x = origin_ + scale_ * (axes_.transpose() * vector(p));
    return Point(x[0], x[1], x[2]);
  }

  // A metric of the frame as one of space.
  Eigen::Matrix3d metric_from_frame(const Eigen::Matrix3d& metric) const {
    return axes_.transpose() * metric * axes_ / (scale_ * scale_);
  }

private:
  static Eigen::Vector3d vector(const Point& p) { return Eigen::Vector3d(p.x(), p.y(), p.z()); }

  static double rounded(double x) {
    const double grid = 8388608; // 2^23
    return std::round(x * grid) / grid;
  }

  // Each axis points to where the points reach further; the third makes the frame right-handed.
  void orient(const std::vector<Point>& points) {
    Eigen::Array3d third(0, 0, 0);
    for (const Point& p : points)
      third += (axes_ * ((vector(p) - origin_) / scale_)).array().cube();
    for (int k = 0; k < 2; ++k)
      if (third[k] < 0)
        axes_.row(k) *= -1;
    axes_.row(2) = axes_.row(0).cross(axes_.row(1));
  }

  Eigen::Vector3d origin_;
  Eigen::Matrix3d axes_; // rows
  double scale_ = 1;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_CANONICAL_FRAME_H

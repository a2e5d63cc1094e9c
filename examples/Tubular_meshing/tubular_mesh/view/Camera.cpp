// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Camera.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

using CGAL::Tubular_meshing::internal::cross;
using CGAL::Tubular_meshing::internal::dot;
using CGAL::Tubular_meshing::internal::normalized;

// The z axis is upright, unless one looks along it: then y is.
Camera::Camera(const std::vector<Vector>& points, const Vector& from, int width, int height)
    : from_(normalized(from))
    , width_(width)
    , height_(height) {
  const Vector upright = std::abs(from_.z) < 0.9 ? Vector(0, 0, 1) : Vector(0, 1, 0);
  right_ = normalized(cross(upright, from_));
  up_ = cross(from_, right_);
  const double infinity = (std::numeric_limits<double>::infinity)();
  Vector low(infinity, infinity, infinity), high(-infinity, -infinity, -infinity);
  for (const Vector& p : points) {
    const Vector at(dot(p, right_), dot(p, up_), dot(p, from_));
    low = Vector((std::min)(low.x, at.x), (std::min)(low.y, at.y), (std::min)(low.z, at.z));
    high = Vector((std::max)(high.x, at.x), (std::max)(high.y, at.y), (std::max)(high.z, at.z));
  }
  if (!(low.x <= high.x))
    return;
  const double margin = 0.94;
  const double w = high.x - low.x, h = high.y - low.y;
  scale_ = (std::min)(w > 0 ? margin * width / w : infinity, h > 0 ? margin * height / h : infinity);
  if (!std::isfinite(scale_))
    scale_ = 1;
  const Vector middle = 0.5 * (low + high);
  middle_ = middle.x * right_ + middle.y * up_ + middle.z * from_;
}

Camera::Vector Camera::project(const Vector& p) const {
  const Vector d = p - middle_;
  return {width_ / 2 + scale_ * dot(d, right_), height_ / 2 - scale_ * dot(d, up_), scale_ * dot(d, from_)};
}

std::vector<Camera::Vector> points_of(const Shown_mesh& mesh) {
  return {mesh.mesh().points.begin(), mesh.mesh().points.end()};
}

std::vector<Camera::Vector> points_of(const Shown_mesh& mesh, const Seen_faces& seen) {
  std::vector<Camera::Vector> result;
  const auto add = [&](const Shown_mesh::Face& face) {
    for (std::size_t i = 0; i < CGAL::Tubular_meshing::internal::cells::number_of_corners(face); ++i)
      result.push_back(mesh.point(face[i]));
  };
  for (std::size_t f : seen.facets)
    add(mesh.facet(f));
  for (const Seen_faces::Cut_face& c : seen.cut)
    add(c.face);
  return result.empty() ? points_of(mesh) : result;
}

Camera::Vector center_of_extent(const Shown_mesh& mesh) {
  const auto box = mesh.extent();
  return box[0].x <= box[1].x ? 0.5 * (box[0] + box[1]) : Camera::Vector();
}

// Its sign is that of its largest component, so that it does not depend on the order of points.
Camera::Vector Camera::best_direction(const Shown_mesh& mesh) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  const double n = double((std::max)(mesh.mesh().points.size(), std::size_t(1)));
  for (const auto& p : mesh.mesh().points)
    mean += Eigen::Vector3d(p.x(), p.y(), p.z()) / n;
  for (const auto& p : mesh.mesh().points) {
    const Eigen::Vector3d d = Eigen::Vector3d(p.x(), p.y(), p.z()) - mean;
    products += d * d.transpose() / n;
  }
  Eigen::Vector3d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(products).eigenvectors().col(0);
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis[largest] < 0)
    axis = -axis;
  return {axis.x(), axis.y(), axis.z()};
}

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_WALL_DISTANCE_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_WALL_DISTANCE_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/base/Corner_tree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing {

struct Wall_distance::Impl {
  internal::Corner_tree<internal::Double_kernel::Triangle_3> tree;
};

CGAL_TUBULAR_MESHING_INLINE Wall_distance::Wall_distance(const std::vector<std::array<Point_3, 3>>& triangles) {
  typedef internal::Double_kernel::Triangle_3 Triangle;
  std::vector<Triangle> shapes;
  shapes.reserve(triangles.size());
  for (const std::array<Point_3, 3>& corners : triangles) {
    const Triangle t(internal::to_double_point(corners[0]), internal::to_double_point(corners[1]),
                     internal::to_double_point(corners[2]));
    if (CGAL::cross_product(t[1] - t[0], t[2] - t[0]).squared_length() > 0) // its neighbours cover a flat one
      shapes.push_back(t);
  }
  if (shapes.empty())
    throw Input_error("The surface has no wall: none of its faces can be used to measure the radius of the vessel.");
  impl_ = std::make_shared<const Impl>(Impl{internal::Corner_tree<Triangle>(shapes)});
}

CGAL_TUBULAR_MESHING_INLINE double Wall_distance::operator()(const Point_3& x) const {
  return std::sqrt(impl_->tree.nearest(internal::to_double_point(x)).squared_distance);
}

CGAL_TUBULAR_MESHING_INLINE Point_3 Wall_distance::closest_point(const Point_3& x) const {
  const internal::Double_kernel::Point_3 p = impl_->tree.nearest(internal::to_double_point(x)).point;
  return Point_3(p.x(), p.y(), p.z());
}

CGAL_TUBULAR_MESHING_INLINE Wall_distance::Place Wall_distance::closest_place(const Point_3& x) const {
  const auto found = impl_->tree.nearest(internal::to_double_point(x));
  // a point whose coordinates are not numbers has no nearest triangle: any will do
  const std::size_t i = found.index < impl_->tree.size() ? found.index : 0;
  return Place{Point_3(found.point.x(), found.point.y(), found.point.z()), i};
}

CGAL_TUBULAR_MESHING_INLINE std::size_t Wall_distance::number_of_triangles() const {
  return impl_->tree.size();
}

CGAL_TUBULAR_MESHING_INLINE std::array<Point_3, 3> Wall_distance::triangle(std::size_t i) const {
  const auto t = impl_->tree.shape(i);
  const auto point = [&](int k) { return Point_3(t[k].x(), t[k].y(), t[k].z()); };
  return {point(0), point(1), point(2)};
}

CGAL_TUBULAR_MESHING_INLINE std::size_t Wall_distance::number_of_corners() const {
  return impl_->tree.number_of_corners();
}

CGAL_TUBULAR_MESHING_INLINE std::array<std::uint32_t, 3> Wall_distance::corners(std::size_t i) const {
  return impl_->tree.corners(i);
}

CGAL_TUBULAR_MESHING_INLINE CGAL::Bbox_3 Wall_distance::bbox() const {
  return impl_->tree.bbox();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_WALL_DISTANCE_IMPL_H

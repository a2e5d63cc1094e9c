// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_RIM_SHAPE_H
#define CGAL_TUBULAR_MESHING_RIMS_RIM_SHAPE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A plane, and a point's height over it. */
class Oriented_plane {
public:
  Oriented_plane() {}
  /* `normal` is a unit vector. */
  Oriented_plane(const Point_3& origin, const Vector_3& normal)
      : origin_(origin)
      , normal_(normal) {}

  const Point_3& origin() const { return origin_; }
  const Vector_3& normal() const { return normal_; }

  double height(const Point_3& p) const { return (p - origin_) * normal_; }
  // Twice, as the first rounding error is relative to the height, the second to what is left of it.
  Point_3 projection(Point_3 p) const {
    p = p - height(p) * normal_;
    return p - height(p) * normal_;
  }

private:
  Point_3 origin_;
  Vector_3 normal_;
};

/* A plane with coordinates: also a point's position in it. */
class Rim_plane : public Oriented_plane {
public:
  typedef std::array<double, 2> Point_2;

  Rim_plane() {}
  /* `along` is any vector that is not parallel to the normal. */
  Rim_plane(const Point_3& origin, const Vector_3& normal, const Vector_3& along)
      : Oriented_plane(origin, normal)
      , x_axis_(along - (along * normal) * normal) {
    x_axis_ = x_axis_ / std::sqrt(x_axis_.squared_length());
    y_axis_ = CGAL::cross_product(normal, x_axis_);
  }

  Point_2 in_plane(const Point_3& p) const { return {(p - origin()) * x_axis_, (p - origin()) * y_axis_}; }
  Point_3 in_space(const Point_2& p) const { return origin() + p[0] * x_axis_ + p[1] * y_axis_; }

private:
  Vector_3 x_axis_, y_axis_;
};

/* The mean plane of a closed polygon in space, and the shape of the polygon's projection onto it. */
struct Rim_shape {
  Rim_plane plane; ///< with the normal about which the polygon turns left
  Point_3 center;  ///< centroid of the area
  double area = 0, perimeter = 0;
  double radius = 0; ///< of the disk of the same area; 0 if the polygon is degenerate
  double sag = 0;    ///< largest distance of a vertex from the plane
  double reach = 0;  ///< largest distance of a vertex from the centre
};

inline double point_distance(const Point_3& p, const Point_3& q) {
  return std::sqrt((q - p).squared_length());
}

/* Length-weighted principal components. Where the polygon is so crumpled that the plane of least spread stands on edge
 * in the area that it bounds, the plane of that area is taken. */
Rim_shape measure_rim(const std::vector<Point_3>& rim);

/* Each vertex weighs as much as the halves of its two edges, so that crowded vertices do not tilt the plane. */
std::vector<double> rim_weights(const std::vector<Point_3>& rim, double& perimeter);

/* Fills in what depends on the plane, which is given, as is the perimeter. */
void measure_in_plane(const std::vector<Point_3>& rim, Rim_shape& shape);

/* The number of corners of a closed polygon when deviations up to `tolerance` are ignored: 4 for a noisy rectangle,
 * about 8 for a circle at a tolerance of 0.08 radius. */
std::size_t number_of_corners(const std::vector<Point_3>& rim, const Point_3& center, double tolerance);

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Rims/Rim_shape_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_RIMS_RIM_SHAPE_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_PLANE_SECTION_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_PLANE_SECTION_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A plane through a point of the centerlines, with coordinates in it. */
class Section_plane {
public:
  Section_plane(const Vector_3d& origin, const Vector_3d& normal)
      : origin_(origin)
      , normal_(normal) {
    const Vector_3d n = normal;
    const Vector_3d axis = std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z) ? Vector_3d(1, 0, 0)
                           : std::abs(n.y) <= std::abs(n.z)                                 ? Vector_3d(0, 1, 0)
                                                                                            : Vector_3d(0, 0, 1);
    u_ = normalized(cross(n, axis));
    v_ = cross(n, u_);
  }

  const Vector_3d& origin() const { return origin_; }
  const Vector_3d& normal() const { return normal_; }
  double height(const Vector_3d& p) const { return dot(p - origin_, normal_); }
  std::array<double, 2> coordinates(const Vector_3d& p) const { return {dot(p - origin_, u_), dot(p - origin_, v_)}; }
  // A direction in the plane, `angle` from its first axis.
  Vector_3d direction(double angle) const { return std::cos(angle) * u_ + std::sin(angle) * v_; }

private:
  Vector_3d origin_, normal_, u_, v_;
};

/* The curve in which a plane meets a surface: a closed polygon in the plane, whose corners are on edges. */
class Plane_section {
public:
  struct Crossing {
    Halfedge halfedge; // of the face that the curve leaves there; from above the plane to below
    double t;          // along the halfedge
    double source_height, target_height;
  };

  void clear() {
    crossings_.clear();
    corners_.clear();
    perimeter_ = 0;
    box_ = CGAL::Bbox_3();
  }

  void add(const Crossing& c, const Vector_3d& p, const Section_plane& plane) {
    crossings_.push_back(c);
    corners_.push_back(plane.coordinates(p));
    box_ += CGAL::Bbox_3(p.x, p.y, p.z, p.x, p.y, p.z);
  }

  void close() {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const auto &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
      perimeter_ += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
  }

  const std::vector<Crossing>& crossings() const { return crossings_; }
  double perimeter() const { return perimeter_; }
  // Of the circle of the same perimeter.
  double mean_radius() const { return perimeter_ / (2 * CGAL_PI); }
  CGAL::Bbox_3 bbox() const { return box_; }

  /* How often the curve turns round a point of the plane, counterclockwise about the normal. */
  int winding_number(const std::array<double, 2>& p) const {
    int winding = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const auto &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
      const double side = (b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1]);
      if (a[1] <= p[1] && b[1] > p[1] && side > 0)
        ++winding;
      else if (a[1] > p[1] && b[1] <= p[1] && side < 0)
        --winding;
    }
    return winding;
  }

private:
  std::vector<Crossing> crossings_;
  std::vector<std::array<double, 2>> corners_;
  double perimeter_ = 0;
  CGAL::Bbox_3 box_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_PLANE_SECTION_H

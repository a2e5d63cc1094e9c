// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_QUAD_CROWN_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_QUAD_CROWN_H

#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL::Tubular_meshing::internal {

/* The ray on which the apex of a quad's pyramid lies: from the quad's middle inward. The pyramid is positive at all
 * corners of its base where the apex lies beyond the planes of all of them, that is, higher than `lowest`; that is 0
 * for a flat quad, and infinite for one with a corner of about 180 degrees or more, on which no pyramid can stand. */
struct Quad_crown {
  Vector_3d foot, direction;
  double lowest = (std::numeric_limits<double>::infinity)();
  double mean_edge = 0;

  Quad_crown() = default;
  // The quad is given counterclockwise from outside.
  explicit Quad_crown(const std::array<Vector_3d, 4>& quad) {
    std::array<Vector_3d, 4> inward; // of the planes of the corners
    Vector_3d area;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector_3d next = quad[(i + 1) % 4] - quad[i], previous = quad[(i + 3) % 4] - quad[i];
      const Vector_3d normal = cross(previous, next);
      if (norm(normal) > least_sine * norm(previous) * norm(next))
        inward[i] = normalized(normal); // otherwise it stays 0, and cannot be risen above
      area += normal;
      foot += 0.25 * quad[i];
      mean_edge += 0.25 * norm(next);
    }
    direction = normalized(area);
    turn_towards(inward);
    lowest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double rise = dot(direction, inward[i]);
      if (!(rise > least_rise)) {
        lowest = (std::numeric_limits<double>::infinity)();
        return;
      }
      lowest = (std::max)(lowest, dot(quad[i] - foot, inward[i]) / rise);
    }
  }

  Vector_3d apex(double height) const { return foot + height * direction; }

private:
  static constexpr double least_rise = 0.05;
  static constexpr double least_sine = 0.02; // of a corner's angle
  static constexpr double good_rise = 0.5;

  // Where the quad is so warped that its normal is not well inside of all corners, another direction may be.
  void turn_towards(const std::array<Vector_3d, 4>& inward) {
    for (int step = 0; step < 32; ++step) {
      const auto worst = std::min_element(inward.begin(), inward.end(), [this](const Vector_3d& a, const Vector_3d& b) {
        return dot(direction, a) < dot(direction, b);
      });
      const double rise = dot(direction, *worst);
      if (rise >= good_rise)
        return;
      direction = normalized(direction + 0.5 * (good_rise - rise) * *worst);
    }
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_QUAD_CROWN_H

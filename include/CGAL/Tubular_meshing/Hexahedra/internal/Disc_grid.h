// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_DISC_GRID_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_DISC_GRID_H

#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The core of a vessel's cross-section: four squares of s x s quads round a center, in quadrants 0 to 3. Axis q leads
 * from the center to corner q of the section, between quadrants q - 1 and q. Round the core are 8 s vertices: the
 * number 2 s q is the one at the end of axis q.
 *
 *        axis 1
 *      +---+---+
 *      | 1 | 0 |
 *      +---c---+ axis 0
 *      | 2 | 3 |
 *      +---+---+
 */
class Disc_grid {
public:
  // Where a vertex is: x along axis `quadrant`, y along the next one; on an axis, y is 0. The center: x = y = 0.
  struct Place {
    int quadrant, x, y;
  };

  explicit Disc_grid(int s)
      : s_(s) {
    places_.push_back({0, 0, 0});
    for (int q = 0; q < 4; ++q)
      for (int x = 1; x <= s; ++x)
        places_.push_back({q, x, 0});
    for (int q = 0; q < 4; ++q)
      for (int x = 1; x <= s; ++x)
        for (int y = 1; y <= s; ++y)
          places_.push_back({q, x, y});
    for (int q = 0; q < 4; ++q)
      for (int x = 0; x < s; ++x)
        for (int y = 0; y < s; ++y)
          quads_.push_back({vertex(q, x, y), vertex(q, x + 1, y), vertex(q, x + 1, y + 1), vertex(q, x, y + 1)});
    for (int q = 0; q < 4; ++q) {
      for (int y = 0; y < s; ++y)
        boundary_.push_back(vertex(q, s, y));
      for (int x = s; x > 0; --x)
        boundary_.push_back(vertex(q, x, s));
    }
  }

  int subdivision() const { return s_; }
  std::size_t size() const { return places_.size(); }                             // (2 s + 1)^2
  const std::vector<std::array<std::size_t, 4>>& quads() const { return quads_; } // counterclockwise
  const std::vector<std::size_t>& boundary() const { return boundary_; }          // counterclockwise, 8 s
  const Place& place(std::size_t v) const { return places_[v]; }

  std::size_t vertex(int quadrant, int x, int y) const {
    if (x == 0 && y == 0)
      return 0;
    if (y == 0)
      return std::size_t(1 + (quadrant % 4) * s_ + x - 1);
    if (x == 0)
      return std::size_t(1 + ((quadrant + 1) % 4) * s_ + y - 1);
    return std::size_t(1 + 4 * s_ + ((quadrant % 4) * s_ + x - 1) * s_ + y - 1);
  }

  /* The vertex at the place of v, seen from the other side of the disc: axis q is then axis `turns` - q. */
  std::size_t mirrored(std::size_t v, int turns) const {
    const Place& p = places_[v];
    return p.y == 0 ? vertex(turns - p.quadrant + 4, p.x, 0) : vertex(turns - p.quadrant + 3, p.y, p.x);
  }

  /* Where a vertex lies in a section: the angle, counted in steps between the vertices round the core, and the distance
   * from the center, 1 at the wall. The core is a square with round sides, its corners at the distance given. */
  struct Polar {
    double step, distance;
  };
  Polar polar(std::size_t v, double corner_distance) const {
    const Place& p = places_[v];
    if (v == 0)
      return {0, 0};
    // on the square, whose corner lies at 45 degrees between the axes
    const double m = double((std::max)(p.x, p.y)) / s_;
    const double along = p.x >= p.y ? double(p.y) / p.x : 2 - double(p.x) / p.y; // 0 to 2 over the quadrant
    const double side = corner_distance * std::sqrt(0.5);
    const double x = side * double(p.x) / s_, y = side * double(p.y) / s_;
    const double a = along * pi / 4, r = m * corner_distance;
    constexpr double roundness = 0.45;
    const double u = (1 - roundness) * x + roundness * r * std::cos(a),
                 w = (1 - roundness) * y + roundness * r * std::sin(a);
    return {2 * s_ * (p.quadrant + std::atan2(w, u) / (pi / 2)), std::hypot(u, w)};
  }

private:
  int s_;
  std::vector<Place> places_;
  std::vector<std::array<std::size_t, 4>> quads_;
  std::vector<std::size_t> boundary_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_DISC_GRID_H

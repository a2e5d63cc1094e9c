// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_SCHOENHARDT_H
#define TUBULAR_MESHING_TEST_SCHOENHARDT_H

#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Recovered_boundary.h>

#include <cmath>
#include <cstdint>

namespace test_surfaces {

/* A triangular prism, twisted by 30 degrees so that the edges across its sides turn inward: it cannot be filled with
 * tetrahedra of its own points [Schoenhardt 1928]. */
inline CGAL::Tubular_meshing::internal::Boundary_arrays schoenhardt() {
  CGAL::Tubular_meshing::internal::Boundary_arrays result;
  const double pi = std::acos(-1.);
  for (int level : {0, 1})
    for (int i = 0; i < 3; ++i) {
      const double a = 2 * pi / 3 * i + pi / 6 * level;
      result.points.push_back({std::cos(a), std::sin(a), double(level)});
    }
  result.triangles = {{0, 2, 1}, {3, 4, 5}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t next = (i + 1) % 3;
    result.triangles.push_back({i, next, 3 + next});
    result.triangles.push_back({i, 3 + next, 3 + i});
  }
  return result;
}

} // namespace test_surfaces

#endif // TUBULAR_MESHING_TEST_SCHOENHARDT_H

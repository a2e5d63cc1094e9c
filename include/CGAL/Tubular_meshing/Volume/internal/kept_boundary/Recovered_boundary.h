// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVERED_BOUNDARY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVERED_BOUNDARY_H

#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// What goes into an algorithm that fills a surface and keeps it.
struct Boundary_arrays {
  std::vector<Vector_3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// What comes out: tetrahedra of the boundary's points and of as few points inside as it takes.
struct Recovered_boundary {
  std::vector<Vector_3d> inner_points; // numbered on from the boundary's
  std::vector<std::array<std::uint32_t, 4>> tetrahedra;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVERED_BOUNDARY_H

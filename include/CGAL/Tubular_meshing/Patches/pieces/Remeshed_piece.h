// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_REMESHED_PIECE_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_REMESHED_PIECE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Chart.h>
#include <CGAL/Tubular_meshing/Plane/Plane_triangulation.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* A piece of the surface in its new faces. Its points are those of its curves, one curve after another, then those
 * inside. */
struct Remeshed_piece {
  struct Side {
    std::size_t curve;
    bool forward;
  };
  std::vector<Side> sides; // in the order of their points
  std::vector<Point_3> inner_points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::array<std::size_t, 4>> quads;

  bool empty() const { return triangles.empty() && quads.empty(); }
};

/* Fills polygons of the plane with triangles, which are judged in space, or in the metric. A rim runs with the wall on
 * its left: seen along its normal, as the cap's chart is, the cap is turned inwards, which `turn` sets right. False if
 * the polygons do not bound a domain, as they touch each other. */
bool triangulate_piece(const Chart& chart, bool judged_in_space, const Plane_polygons& polygons, bool turn,
                       Remeshed_piece& piece);

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/pieces/Remeshed_piece_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_REMESHED_PIECE_H

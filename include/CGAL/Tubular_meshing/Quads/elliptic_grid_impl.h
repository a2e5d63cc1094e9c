// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_ELLIPTIC_GRID_IMPL_H
#define CGAL_TUBULAR_MESHING_QUADS_ELLIPTIC_GRID_IMPL_H

#include <CGAL/Tubular_meshing/Quads/elliptic_grid.h>
#include <CGAL/Tubular_meshing/Quads/internal/elliptic/Elliptic_grid_maker.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <string>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE Elliptic_grid elliptic_grid(const Patch_parameterization& map,
                                                        const std::array<std::vector<Patch_location>, 2>& loop_points,
                                                        Length_function size, std::size_t number_of_rows) {
  if (map.number_of_loops() != 2)
    throw Input_error("A patch with " + std::to_string(map.number_of_loops()) +
                      " loops is not annular; a grid needs two loops.");
  if (loop_points[0].size() < 3 || loop_points[0].size() != loop_points[1].size())
    throw Input_error("There are " + std::to_string(loop_points[0].size()) + " and " +
                      std::to_string(loop_points[1].size()) +
                      " points on the loops of an annular patch; give as many on both, three at least.");
  Elliptic_grid_maker maker(map, loop_points);
  maker.divide_into_rows(size, number_of_rows);
  maker.smooth();

  Elliptic_grid grid;
  grid.columns = maker.nodes().columns;
  grid.rows = maker.nodes().rows;
  grid.locations = maker.locations();
  for (const Patch_location& at : grid.locations)
    grid.points.push_back(map.point(at));
  for (std::size_t i = 0; i < grid.columns; ++i)
    grid.ends.push_back(maker.point_of_loop_1(i));
  return grid;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_ELLIPTIC_GRID_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_ANNULAR_PATCHES_IMPL_H
#define CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_ANNULAR_PATCHES_IMPL_H

#include <CGAL/Tubular_meshing/Quads/quadrangulate_annular_patches.h>
#include <CGAL/Tubular_meshing/Quads/internal/annular/Curve_chains.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace CGAL::Tubular_meshing::internal {

// The ends of a grid become the points of the curves, bit for bit.
inline void share_points(const std::vector<std::vector<Point_3>>& curve_points, const Surface_patch& patch,
                         Elliptic_grid& grid) {
  for (std::size_t l = 0; l < 2; ++l) {
    std::vector<Point_3> points = curve_points[patch.loops[l].curve];
    if (!patch.loops[l].forward)
      std::reverse(points.begin(), points.end());
    for (std::size_t i = 0; i < grid.columns; ++i)
      grid.points[l * grid.rows * grid.columns + i] = points[l == 0 ? i : grid.ends[i]];
  }
}

CGAL_TUBULAR_MESHING_INLINE Annular_quads quadrangulate_annular_patches(const Surface& surface, const Surface_cut& cut,
                                                                        const std::vector<Patch_parameterization>& maps,
                                                                        Length_function size, int threads) {
  if (maps.size() != cut.patches.size())
    throw Input_error("There are " + std::to_string(maps.size()) + " parameterizations of " +
                      std::to_string(cut.patches.size()) + " patches; pass what parameterize_patches() returns.");
  Curve_chains chains(surface, cut, maps, size);
  const auto positions = chains.divide();

  Annular_quads result;
  for (const auto& curve : positions) {
    result.curve_points.emplace_back();
    for (const auto& p : curve)
      result.curve_points.back().push_back(p.point);
  }
  result.grids.resize(cut.patches.size());
  for_each_task(cut.patches.size(), threads, [&](std::size_t k) {
    if (!chains.is_tube(k))
      return;
    result.grids[k] = internal::elliptic_grid(maps[k], chains.on_loops(k, positions), size, 0);
    share_points(result.curve_points, cut.patches[k], result.grids[k]);
  });
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_ANNULAR_PATCHES_IMPL_H

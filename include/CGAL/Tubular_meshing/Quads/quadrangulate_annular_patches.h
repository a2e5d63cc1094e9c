// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_ANNULAR_PATCHES_H
#define CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_ANNULAR_PATCHES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Quads/elliptic_grid.h>
#include <CGAL/Tubular_meshing/Quads/internal/annular/Curve_chains.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * Grids of quads on the annular patches of a cut surface, and the points of all its curves. */
struct Annular_quads {
  /// Of each curve, its points in its direction: an even number.
  std::vector<std::vector<Point_3>> curve_points;
  /// Of each patch; without rows if it is not annular. The points at its ends are those of the curves, bit for bit.
  std::vector<Elliptic_grid> grids;
};

namespace internal {

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

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * covers the annular patches of a cut surface with structured grids of quads (section 2.5 of the paper), each by
 * elliptic_grid().
 *
 * Curves that annular patches join, all along a branch, get the same even number of points: the mean of what the size
 * wants. The points of each are at equal distances, and opposite those of the curve before, so that grids do not twist.
 * The other curves get even numbers of points too, so that the patches between can be meshed by quads alone.
 *
 * \param surface the surface that was cut
 * \param cut its patches, see cut_by_centerlines()
 * \param maps their parameterizations, see parameterize_patches()
 * \param size a function object: the wanted length of edges at a `Point_3`, such as a Centerline_sizing_field. Several
 *   threads call it at once
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{threads that mesh patches at the same time; 0: as many as
 *     there are cores. The result does not depend on it} \cgalParamDefault{0} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * O(n log n) in the number of quads, and that of vertices on curves.
 *
 * \throws Input_error if there is not one parameterization a patch
 * \throws Meshing_error if a patch has no grid without folded cells
 */
template <class SizingField, class NamedParameters = CGAL::parameters::Default_named_parameters>
Annular_quads quadrangulate_annular_patches(const CGAL::Surface_mesh<Point_3>& surface, const Surface_cut& cut,
                                            const std::vector<Patch_parameterization>& maps, const SizingField& size,
                                            const NamedParameters& np = CGAL::parameters::default_values()) {
  if (maps.size() != cut.patches.size())
    throw Input_error("There are " + std::to_string(maps.size()) + " parameterizations of " +
                      std::to_string(cut.patches.size()) + " patches; pass what parameterize_patches() returns.");
  internal::Curve_chains<SizingField> chains(surface, cut, maps, size);
  const auto positions = chains.divide();

  Annular_quads result;
  for (const auto& curve : positions) {
    result.curve_points.emplace_back();
    for (const auto& p : curve)
      result.curve_points.back().push_back(p.point);
  }
  result.grids.resize(cut.patches.size());
  internal::for_each_task(
      cut.patches.size(), internal::choose(np, internal_np::number_of_threads, 0), [&](std::size_t k) {
        if (!chains.is_tube(k))
          return;
        std::array<std::vector<Patch_location>, 2> ends;
        for (std::size_t l = 0; l < 2; ++l) {
          const Patch_loop& loop = cut.patches[k].loops[l];
          ends[l] = internal::on_loop(maps[k], l, loop, cut.curves[loop.curve].vertices.size(), positions[loop.curve]);
        }
        result.grids[k] = elliptic_grid(maps[k], ends, size);
        internal::share_points(result.curve_points, cut.patches[k], result.grids[k]);
      });
  return result;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_ANNULAR_PATCHES_H

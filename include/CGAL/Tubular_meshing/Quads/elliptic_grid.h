// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_ELLIPTIC_GRID_H
#define CGAL_TUBULAR_MESHING_QUADS_ELLIPTIC_GRID_H

#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuads
 *
 * A grid of quads around an annular patch: (rows + 1) times as many points as there are columns, row after row from
 * loop 0 to loop 1. Those of row 0 are the given ones of loop 0, in their order. */
struct Elliptic_grid {
  std::size_t columns = 0, rows = 0;
  std::vector<Point_3> points;
  std::vector<Patch_location> locations; ///< of the points on the patch
  std::vector<std::size_t> ends;         ///< of each column: the index of its given point of loop 1

  /// The quads by their points, counterclockwise seen from outside, row after row.
  std::vector<std::array<std::size_t, 4>> quads() const {
    std::vector<std::array<std::size_t, 4>> result;
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t a = j * columns + i, b = j * columns + (i + 1) % columns;
        result.push_back({{a, b, b + columns, a + columns}});
      }
    return result;
  }
};

namespace internal {

Elliptic_grid elliptic_grid(const Patch_parameterization& map,
                            const std::array<std::vector<Patch_location>, 2>& loop_points, Length_function size,
                            std::size_t number_of_rows);

} // namespace internal

/*! \ingroup PkgTubularMeshingQuads
 *
 * covers an annular patch with a structured grid of quads, whose lines meet at right angles on the surface as nearly
 * as the points of its loops allow (section 2.5 of the paper, figure 7).
 *
 * The patch is unrolled into coordinates in which its map is conformal: angle and logarithm of the radius. The points
 * of both loops are joined so that the grid turns as little as possible, by straight lines; rows are as high as the
 * size wants on the mean around them. Then an elliptic smoother moves the nodes inside: Winslow's, as
 * \cgalCite{brackbill1982} put it, in the metric that cells have in space, with the proportions of the first grid's
 * cells in place of control functions, so that rows and columns keep their distances. Of all its sweeps, the one with
 * the best sum of least and mean \f$ \eta_q \f$ (14) is returned. No cell is folded: neither in the plane nor on the
 * surface; where one is, smoothing begins again with smaller steps.
 *
 * O(n log n) in the number of quads, with at most 50 sweeps, or three times that where cells fold.
 *
 * \param map of a patch with two loops, see parameterize_patch()
 * \param loop_points points of loop 0, and as many of loop 1, three at least; each in the order of its loop, see
 *   Patch_parameterization::on_loop_edge()
 * \param size a function object: the wanted length of edges at a `Point_3`
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_rows}
 *     \cgalParamDescription{how many rows of quads; they are as high as the size wants, relative to each other}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{0: as many as the size wants}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if the patch has not two loops, or the points of the loops are not as many, or not in order
 * \throws Meshing_error if there is no grid without folded cells
 */
template <class SizingField, class NamedParameters = CGAL::parameters::Default_named_parameters>
Elliptic_grid elliptic_grid(const Patch_parameterization& map,
                            const std::array<std::vector<Patch_location>, 2>& loop_points, const SizingField& size,
                            const NamedParameters& np = CGAL::parameters::default_values()) {
  return internal::elliptic_grid(map, loop_points, internal::Field_at_point<SizingField>(size),
                                 internal::choose(np, internal_np::number_of_rows, std::size_t(0)));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quads/elliptic_grid_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUADS_ELLIPTIC_GRID_H

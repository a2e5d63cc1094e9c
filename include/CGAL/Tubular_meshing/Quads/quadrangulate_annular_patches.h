// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_ANNULAR_PATCHES_H
#define CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_ANNULAR_PATCHES_H

#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Quads/elliptic_grid.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuads
 *
 * Grids of quads on the annular patches of a cut surface, and the points of all its curves. */
struct Annular_quads {
  /// Of each curve, its points in its direction: an even number.
  std::vector<std::vector<Point_3>> curve_points;
  /// Of each patch; without rows if it is not annular. The points at its ends are those of the curves, bit for bit.
  std::vector<Elliptic_grid> grids;
};

namespace internal {

Annular_quads quadrangulate_annular_patches(const Surface& surface, const Surface_cut& cut,
                                            const std::vector<Patch_parameterization>& maps, Length_function size,
                                            int threads);

} // namespace internal

/*! \ingroup PkgTubularMeshingQuads
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
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{threads that mesh patches at the same time; 0: as many as there are cores. The result does
 *       not depend on it}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * O(n log n) in the number of quads, and that of vertices on curves.
 *
 * \throws Input_error if there is not one parameterization a patch
 * \throws Meshing_error if a patch has no grid without folded cells
 */
template <class SizingField, class NamedParameters = CGAL::parameters::Default_named_parameters>
Annular_quads quadrangulate_annular_patches(const Surface& surface, const Surface_cut& cut,
                                            const std::vector<Patch_parameterization>& maps, const SizingField& size,
                                            const NamedParameters& np = CGAL::parameters::default_values()) {
  return internal::quadrangulate_annular_patches(surface, cut, maps, internal::Field_at_point<SizingField>(size),
                                                 internal::choose(np, internal_np::number_of_threads, 0));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quads/quadrangulate_annular_patches_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_ANNULAR_PATCHES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_CCDT_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_CCDT_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060100000
#define CGAL_TUBULAR_MESHING_WITH_CCDT
#include <CGAL/Tubular_meshing/Volume/internal/ccdt/run_ccdt.h>
#endif

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * Whether this version of \cgal has constrained Delaunay triangulations in space: 6.1 and later.
 */
constexpr bool has_ccdt() {
#ifdef CGAL_TUBULAR_MESHING_WITH_CCDT
  return true;
#else
  return false;
#endif
}

/*! \ingroup PkgTubularMeshingRef
 *
 * fills a closed labelled surface with tetrahedra and keeps it as it is, facet for facet, as fill_with_tetgen() does,
 * but by \cgal alone: its `Conforming_constrained_Delaunay_triangulation_3` takes TetGen's place. Where that needs
 * points on the surface they are brought inside again.
 *
 * Parameters, result and exceptions are those of fill_with_tetgen().
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{time_limit} \cgalParamDescription{see fill_with_tetgen()} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Meshing_error also if this version of \cgal is too old (see has_ccdt())
 */
template <class SizingField, class NamedParameters = CGAL::parameters::Default_named_parameters>
void fill_with_ccdt(const Surface& surface, Face_patch_map patch, const SizingField& size, Mixed_mesh& mesh,
                    const NamedParameters& np = CGAL::parameters::default_values()) {
#ifdef CGAL_TUBULAR_MESHING_WITH_CCDT
  const double seconds = internal::choose(np, internal_np::time_limit, 600 + 0.01 * double(num_faces(surface)));
  internal::fill_keeping_boundary(surface, patch, size, internal::run_ccdt, "CGAL", {seconds}, mesh);
#else
  (void)surface, (void)patch, (void)size, (void)mesh, (void)np;
  throw Meshing_error("This program was built with a version of CGAL before 6.1, which has no constrained "
                      "triangulations in space: use fill_with_tetgen() or fill_with_mesh_3().");
#endif
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_CCDT_H

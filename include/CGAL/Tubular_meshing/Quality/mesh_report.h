// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_MESH_REPORT_H
#define CGAL_TUBULAR_MESHING_QUALITY_MESH_REPORT_H

#include <CGAL/Tubular_meshing/Quality/Mesh_check.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuality
 * What mesh_report() tells. */
struct Mesh_report {
  Validity_report validity; ///< as of validity_report()
  Quality_report quality;   ///< as of quality_report()
};

/*! \ingroup PkgTubularMeshingQuality
 *
 * does what validity_report() and quality_report() do, at about two thirds of their cost: faces are matched once for
 * both. O(n log n); O(n) where the mesh has been checked before.
 *
 * \param mesh the mesh
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0: all cores. The result does not depend on it}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{mesh_check}
 *     \cgalParamDescription{what is known of the mesh, see Mesher_report::check; where it is of another mesh, it makes no
 *       difference}
 *     \cgalParamType{`Mesh_check`}
 *     \cgalParamDefault{nothing}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 */
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
Mesh_report mesh_report(const Mixed_mesh& mesh, const CGAL_NP_CLASS& np = CGAL::parameters::default_values()) {
  return internal::mesh_report_on(internal::choose(np, internal_np::number_of_threads, 0), mesh,
                                  internal::choose(np, internal_np::mesh_check, Mesh_check()));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quality/mesh_report_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUALITY_MESH_REPORT_H

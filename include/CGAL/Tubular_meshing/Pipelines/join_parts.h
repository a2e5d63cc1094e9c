// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_JOIN_PARTS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_JOIN_PARTS_H

#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 *
 * \name Several vessels
 *
 * A surface of several vessels is split by split_into_parts(), each is meshed by itself, and what comes out is joined
 * by these functions, in the same order:
 *
 * \code
 * std::vector<Mixed_mesh> meshes;
 * std::vector<std::size_t> openings;
 * for (const auto& part : split_into_parts(surface)) {
 *   Mesher mesher(part);
 *   meshes.push_back(mesher.isotropic());
 *   openings.push_back(mesher.model().openings.size());
 * }
 * const Mixed_mesh mesh = join_parts(std::move(meshes), openings);
 * \endcode
 *
 * Walls and lumens keep their labels. Openings are numbered through: those of the first part first, then those of the
 * second, and so on; the first one of part k > 1 is named `inlet_k`, outlets are numbered through. Labels of a vessel's
 * wall follow those of the openings, see labels::outer_wall_for(). Names that are not the package's own stay as they
 * are. One part comes out unchanged. Linear in the sizes of the parts.
 */
///@{

/// Cells and facets of the parts; point arrays that not all of them have are lost.
/// \param parts the meshes \param openings how many openings each has
/// \throws Input_error if the two are not equally many, or a part has labels of openings that it should not have
Mixed_mesh join_parts(std::vector<Mixed_mesh> parts, const std::vector<std::size_t>& openings);

/// Surfaces, openings, and centerlines, each directed away from its own inlet; the root is that of the first part.
Tubular_model join_parts(std::vector<Tubular_model> parts);

/// Surfaces with their patches, which are numbered through, curves, metrics and reports.
Remeshed_surface join_parts(std::vector<Remeshed_surface> parts, const std::vector<std::size_t>& openings);

///@}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Pipelines/join_parts_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PIPELINES_JOIN_PARTS_H

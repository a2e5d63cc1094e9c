// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_APPEND_MESH_H
#define CGAL_TUBULAR_MESHING_LAYERS_APPEND_MESH_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingLayers
 * In a list of points: this one is not there yet. */
constexpr std::uint32_t no_point = std::uint32_t(-1);

/*! \ingroup PkgTubularMeshingLayers
 *
 * adds a mesh that fills a cavity of another one: boundary layers and what is inside of them become one mesh.
 *
 * \param mesh gets the cells, the facets and the points that it does not have yet
 * \param filling its facets of patch `interface` are those that the two meshes share: they are left out, being inside
 *   of the whole
 * \param known_points for the first points of `filling`, the point of `mesh` that each is, or `no_point`. All others
 *   are new
 * \param interface the patch
 *
 * Point arrays of `mesh` are lost, unless nothing is added: the two have not the same. Linear.
 *
 * \throws Input_error if there are more known points than points, or one that is not in `mesh`; `mesh` is untouched
 * then
 */
void append_mesh(Mixed_mesh& mesh, const Mixed_mesh& filling, const std::vector<std::uint32_t>& known_points,
                 int interface = labels::wall);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Layers/append_mesh_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_LAYERS_APPEND_MESH_H

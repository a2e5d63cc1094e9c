// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_WALL_FIBRES_H
#define CGAL_TUBULAR_MESHING_LAYERS_WALL_FIBRES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Cell_array.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingLayers
 * The names of the arrays of wall_fibres(). */
constexpr const char* circumferential_array_name = "circumferential";
constexpr const char* longitudinal_array_name = "longitudinal";

/*! \ingroup PkgTubularMeshingLayers
 * The directions in a wall, for models of arterial tissue. */
struct Wall_fibres {
  Cell_array circumferential, longitudinal; ///< unit vectors; 0 in cells of the lumen
  std::size_t cells = 0;                    ///< of the wall
  std::size_t undirected = 0; ///< of these, where the wall lies across the centerline, as at tips: any direction

  /// Both, for IO::write_mesh().
  std::vector<Cell_array> arrays() const { return {circumferential, longitudinal}; }
};

/*! \ingroup PkgTubularMeshingLayers
 *
 * finds the directions round the vessel and along it for each cell of a wall: the radial direction is the normal of the
 * lumen's surface next to the cell, interpolated between its vertices; the longitudinal one that of the nearest branch,
 * made perpendicular to it; and the circumferential one perpendicular to both, so that radial, circumferential and
 * longitudinal are a right-handed triad. Families of fibres lie at an angle between the latter two.
 *
 * \param mesh a mesh with a wall, see extrude_wall(): cells of regions labels::wall_region and above
 * \param graph its branches
 * \param number_of_threads 0: all cores. The result does not depend on it
 *
 * O(n log n).
 *
 * \throws Input_error if the mesh has no wall, or no facets of patch labels::wall, or the graph is empty
 */
Wall_fibres wall_fibres(const Mixed_mesh& mesh, const Centerline_graph& graph, int number_of_threads = 0);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Layers/wall_fibres_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_LAYERS_WALL_FIBRES_H

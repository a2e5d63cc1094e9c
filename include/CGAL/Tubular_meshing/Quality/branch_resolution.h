// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_BRANCH_RESOLUTION_H
#define CGAL_TUBULAR_MESHING_QUALITY_BRANCH_RESOLUTION_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuality
 *
 * How finely a mesh resolves each branch: the number of points round its circumference, 2 π times the mean distance of
 * the wall's edges to the centerline over their mean length; 0 for a branch without wall of its own. It is what the
 * parameter `points_per_circumference` asks for.
 *
 * \param mesh a mesh with triangles of patch labels::wall
 * \param centerlines the field of the graph
 * \param number_of_branches of that graph
 * \param number_of_threads 0: all cores. The result does not depend on it
 *
 * O(n log n).
 */
std::vector<double> points_per_circumference(const Mixed_mesh& mesh, const Centerline_field& centerlines,
                                             std::size_t number_of_branches, int number_of_threads = 0);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quality/branch_resolution_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUALITY_BRANCH_RESOLUTION_H

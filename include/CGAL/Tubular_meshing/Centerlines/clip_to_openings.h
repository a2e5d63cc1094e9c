// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CLIP_TO_OPENINGS_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CLIP_TO_OPENINGS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * Lets the centerlines end at the openings: a free end that runs out of the lumen (centerlines of a surface with flow
 * extensions do) is cut where it crosses the opening's plane; one that stops short, within two radii of the opening's
 * centre, is extended to the centre. Other ends stay as they are, and branches keep their numbers. Radii at new points
 * are interpolated; Centerline_graph::set_radii() with Wall_distance measures them again.
 * O(n log n) in the points of the graph and the openings.
 *
 * \returns for each opening the node of the graph that lies there now, or `Opening::no_branch`
 */
std::vector<std::size_t> clip_to_openings(Centerline_graph& graph, const std::vector<Opening>& openings);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Centerlines/clip_to_openings_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CLIP_TO_OPENINGS_H

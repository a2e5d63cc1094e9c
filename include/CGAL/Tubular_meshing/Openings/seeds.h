// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_SEEDS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_SEEDS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// Where centerlines begin and end: at openings, and at points (seeds) that stand for vessels' ends without one.

/* Orders the openings that were found, that nearest to the first seed being the inlet. A surface without any must have
 * seeds. */
void order_openings_or_seeds(std::vector<Opening>& openings, const std::vector<Point_3>& seeds,
                             Find_openings_options options);

/* The ends of the lines, each with the label of the faces around it; the source comes first: the first seed, or what it
 * stands for, else the inlet. One end is an error, unless it will do. */
std::vector<std::pair<Point_3, int>> ends_of_lines(const std::vector<Opening>& openings,
                                                   const std::vector<Point_3>& seeds, bool one_will_do = false);

/* Of a closed surface, the point of the wall to which the way from an opening is longest. O(n log n). */
Point_3 farthest_point(const Surface& surface, const Face_patch_map& patch, int opening);

/* For each opening the free end of the centerlines that lies at its centre, where lines were computed to lead to it. */
std::vector<std::size_t> nodes_at(const Centerline_graph& graph, const std::vector<Opening>& openings);

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Openings/seeds_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_OPENINGS_SEEDS_H

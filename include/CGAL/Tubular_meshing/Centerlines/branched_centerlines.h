// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_BRANCHED_CENTERLINES_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_BRANCHED_CENTERLINES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * Centerlines in the manner of VMTK's branch extractor: each line from the inlet to an outlet is cut into tracts, which
 * run along a branch or through a bifurcation, by turns.
 */
struct Branched_centerlines {
  Centerline_polylines lines;      ///< one a tract
  std::vector<int> centerline_ids; ///< of each tract: the line that it is part of
  std::vector<int> tract_ids;      ///< its number along that line, from 0
  std::vector<int> group_ids;      ///< equal for tracts along the same branch, or through the same bifurcation
  std::vector<int> blanking;       ///< 1 for tracts through a bifurcation, else 0
};

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * The lines from the root of a graph to each of its other ends (and, where branches rejoin, through each branch that
 * these leave out), cut into tracts with the identifiers that VMTK's users feed on. Linear in the result.
 */
Branched_centerlines branched_centerlines(const Centerline_graph& graph);

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * The same lines in one piece each, as VMTK's vmtkcenterlines writes them. Linear in the result.
 */
Centerline_polylines centerlines_from_root(const Centerline_graph& graph);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Centerlines/branched_centerlines_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_BRANCHED_CENTERLINES_H

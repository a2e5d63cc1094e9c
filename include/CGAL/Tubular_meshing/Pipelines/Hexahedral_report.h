// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_HEXAHEDRAL_REPORT_H
#define CGAL_TUBULAR_MESHING_PIPELINES_HEXAHEDRAL_REPORT_H

#include <CGAL/Tubular_meshing/Hexahedra/Optimize_hexahedra_options.h>
#include <CGAL/Tubular_meshing/Volume/move_boundary_to_surface.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 * How a mesh of hexahedra alone is made. */
enum class Hexahedral_method {
  blocks,     ///< blocks along the vessels, joined at junctions
  subdivision ///< tetrahedra and prisms, subdivided: see subdivide_into_hexahedra()
};

/*! \ingroup PkgTubularMeshingPipelines
 * What is done where blocks cannot be had. */
enum class Hexahedral_fallback {
  subdivision, ///< the whole mesh is made by subdivision
  mixed,       ///< junctions without blocks are filled with pyramids and tetrahedra; if that cannot be, as subdivision
  none         ///< there is no mesh
};

/*! \ingroup PkgTubularMeshingPipelines
 * The name of a method, as the tool has it: `blocks`, `subdivision`. */
inline const char* name_of(Hexahedral_method method) {
  return method == Hexahedral_method::blocks ? "blocks" : "subdivision";
}

/*! \ingroup PkgTubularMeshingPipelines
 * A place where there can be no blocks: a junction, as a rule. */
struct Place_without_blocks {
  Point_3 place;
  std::string reason; ///< part of a sentence

  /// That fill it, see Hexahedral_fallback::mixed. Of neighbors that are filled together, the first has them all.
  std::size_t pyramids = 0, tetrahedra = 0;
};

/*! \ingroup PkgTubularMeshingPipelines
 * How Mesher::hexahedral() has made its mesh. */
struct Hexahedral_report {
  Hexahedral_method method = Hexahedral_method::blocks;    ///< that made the mesh
  std::vector<Place_without_blocks> places_without_blocks; ///< where blocks were asked for, and none were made

  std::size_t number_of_junctions = 0; ///< that were tried
  std::size_t number_of_blocks = 0;
  std::size_t points_per_circumference = 0; ///< of the blocks: N, rounded to a multiple of eight
  std::size_t irregular_edges = 0;          ///< of the blocks, inside, round which there are not four
  std::vector<double> twist;                ///< of each branch's blocks from end to end, in radians

  Move_boundary_to_surface_report boundary; ///< how vertices that subdivision has added came to the surface
  Optimize_hexahedra_report optimization;   ///< before and after; the volume is preserved after that
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_HEXAHEDRAL_REPORT_H

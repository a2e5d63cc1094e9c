// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PARTITION_PARTITION_REPORT_H
#define CGAL_TUBULAR_MESHING_PARTITION_PARTITION_REPORT_H

#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPartition
 *
 * What a partition costs a solver: see partition_report(). */
struct Partition_report {
  std::vector<std::size_t> cells;       ///< of each part
  std::vector<std::size_t> ghost_cells; ///< of each part: cells of others that share a point with it
  std::vector<std::size_t> pieces;      ///< of each part: what is connected through faces; 1 where all of it is
  std::size_t cut_faces = 0;            ///< faces between cells of different parts
  double imbalance = 0; ///< by how much the largest part is over its share of the cells: 0.03, 3 percent

  std::size_t number_of_parts() const { return cells.size(); }
};

/*! \ingroup PkgTubularMeshingPartition
 *
 * counts the cells, ghost cells, pieces and cut faces of a partition. O(n log n).
 *
 * \exception Input_error if three cells of the mesh share a face
 */
Partition_report partition_report(const Mixed_mesh& mesh, const Cell_partition& partition);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Partition/partition_report_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PARTITION_PARTITION_REPORT_H

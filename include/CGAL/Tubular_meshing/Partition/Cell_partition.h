// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PARTITION_CELL_PARTITION_H
#define CGAL_TUBULAR_MESHING_PARTITION_CELL_PARTITION_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPartition
 *
 * Which part of a mesh each of its cells belongs to. Cells are counted through the tetrahedra, the pyramids, the prisms
 * and the hexahedra of a `Mixed_mesh`, parts from 0. */
struct Cell_partition {
  std::size_t number_of_parts = 1;
  std::vector<std::uint32_t> part; ///< of each cell
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PARTITION_CELL_PARTITION_H

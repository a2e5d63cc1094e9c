// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PARTITION_PARTITION_CELLS_H
#define CGAL_TUBULAR_MESHING_PARTITION_PARTITION_CELLS_H

#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPartition
 * Whether this package was built with METIS, by which partition_cells() makes several parts. */
bool has_metis();

/*! \ingroup PkgTubularMeshingPartition
 *
 * divides the cells of a mesh, of all kinds and regions, into parts of about equal numbers of cells that share few faces
 * with each other, for solvers that run on several processors.
 *
 * METIS partitions the graph of cells that share a face, each cell and each face counting as one; of several trials the
 * one that cuts fewest faces is taken. No part has more than 3 percent over its share of the cells, or than the next
 * whole number where that is more. Where the mesh is connected through faces, parts are to be, too: pieces that lie
 * apart join the part next to them where that keeps the balance, and METIS is asked for connected parts, which are
 * taken unless they cut a tenth more faces. Where vessels branch they often do: partition_report() says what came of it.
 * Where METIS does not keep the balance, as with a few cells a part, the cells are taken in an order in which neighbours
 * follow each other, and cut into equal pieces.
 *
 * The result depends on the mesh and the number alone, not on the number of threads. O(n log n); memory, 50 to 150
 * bytes a cell while METIS works.
 *
 * \param mesh a mesh of which no three cells share a face
 * \param number_of_parts from 1 to the number of cells
 *
 * \exception Parameter_error if there are fewer cells than parts, or no part; or if there are to be several parts and
 * the package was built without METIS
 * \exception Input_error if three cells share a face, or the mesh is too large for METIS
 */
Cell_partition partition_cells(const Mixed_mesh& mesh, std::size_t number_of_parts);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Partition/partition_cells_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PARTITION_PARTITION_CELLS_H

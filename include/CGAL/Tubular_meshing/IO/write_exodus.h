// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_EXODUS_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_EXODUS_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 * Whether the package was built with the Exodus II library, which write_exodus() needs. */
bool has_exodus();

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh in the format Exodus II into a file that the caller commits. See `write_exodus(const std::string&,
 * const Mixed_mesh&)`.
 */
void write_exodus(Output_file& file, const Mixed_mesh& mesh);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh in the format Exodus II, which MOOSE, Cubit and Nek5000's exo2nek read, after "Exodus: A Finite Element
 * Data Model" of Sandia.
 *
 * - All kinds of cells are written: TETRA4, PYRAMID5, WEDGE6, HEX8, their corners in the order of `Mixed_mesh`. Those
 *   of one kind in a region are an element block with the region's name and label; where a region has several kinds,
 *   the name of each but the first has the kind behind it, and its number is the next one that no region has.
 * - Each patch is a side set with its name and label, of the cells behind its facets and which of their sides they are.
 *   Where it lies between two regions, that is the side of the higher one, the wall.
 * - A name that is there twice gets a number. Names may be longer than the 32 bytes that older programs read.
 * - Coordinates are kept to the last bit. Point arrays are not written, nor are points that no cell has.
 * - The file is a classic one of netCDF, with 64-bit offsets, which all programs read. Where a block's corners, or
 *   the coordinates, take more than 4 GiB, as those of 268 million tetrahedra or of 40 million hexahedra of 27 nodes, which
 *   such a file cannot hold, it is one of netCDF-4. Points and cells are at most 2,147,483,647 each.
 *
 * It is there where the package was built with the Exodus II library, see has_exodus(). O(n log n).
 *
 * \exception Output_error if the file cannot be written, or the mesh is one that the format cannot hold
 */
void write_exodus(const std::string& file, const Mixed_mesh& mesh);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_exodus_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_EXODUS_H

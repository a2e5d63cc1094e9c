// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_CGNS_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_CGNS_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 * Whether the package was built with the CGNS library, which write_cgns() needs. */
bool has_cgns();

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh in the format CGNS into a file that the caller commits. See
 * `write_cgns(const std::string&, const Mixed_mesh&)`.
 */
void write_cgns(Output_file& file, const Mixed_mesh& mesh);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh in the format CGNS, after the "Standard Interface Data Structures" of CGNS: one base, one unstructured
 * zone.
 *
 * - All kinds of cells are written: TETRA_4, PYRA_5, PENTA_6, HEXA_8, their corners in the order of `Mixed_mesh`. Those
 *   of one kind in a region are a section with the region's name; where a region has several kinds, the name of each
 *   but the first has the kind behind it.
 * - The facets of a patch are a section with its name, of TRI_3, QUAD_4 or, where it has both, MIXED, outward from the
 *   cell behind them; that of the lower region where a patch lies between two. Each patch is a boundary condition with
 *   its name, of the elements of that section: BCWall for the vessel's walls and what bounds no lumen, BCInflow for the
 *   inlet, BCOutflow for the outlets.
 * - Names in the format have up to 32 bytes. A longer one is cut off, a slash becomes an underscore, and one that is
 *   there twice gets a number; the whole name is a descriptor `Name` of the condition.
 * - Coordinates are kept to the last bit. Point arrays are not written, nor are points that no cell has.
 *
 * It is there where the package was built with the CGNS library, see has_cgns(); which kind of file it makes, HDF5 or
 * ADF, depends on how that was built. O(n log n).
 *
 * \exception Output_error if the file cannot be written, or the mesh is one that the format cannot hold
 */
void write_cgns(const std::string& file, const Mixed_mesh& mesh);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_cgns_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_CGNS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_FEBIO_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_FEBIO_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for FEBio into a file that the caller commits. See
 * `write_febio(const std::string&, const Mixed_mesh&)`.
 */
void write_febio(Output_file& file, const Mixed_mesh& mesh);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for FEBio, version 4.0 of its format, after "Mesh Section" in the FEBio user manual.
 *
 * - All kinds of cells are written: tet4, pyra5, penta6, hex8, their corners in the order of `Mixed_mesh`. Those of one
 *   kind in a region are an `Elements` block with the region's name; where a region has several kinds, the name of each
 *   but the first has the kind behind it.
 * - Patches are surfaces and node sets with their names. Facets turn counterclockwise seen from outside of the cell
 *   behind them; where a patch lies between two regions, that is the one of the higher label, the wall.
 * - `MeshDomains` gives each block a material of its region's name: define materials of these names, or read the mesh
 *   alone from another file, `<Mesh from="aorta.feb"/>`.
 * - Names are kept, in UTF-8; one that is there twice gets a number.
 * - Coordinates are kept to the last bit. Point arrays are not written.
 *
 * O(n log n).
 *
 * \exception Output_error if the file cannot be written, or the mesh is one that the format cannot hold
 */
void write_febio(const std::string& file, const Mixed_mesh& mesh);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_febio_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_FEBIO_H

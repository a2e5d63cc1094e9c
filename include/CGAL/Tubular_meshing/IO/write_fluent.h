// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_FLUENT_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_FLUENT_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for Ansys Fluent into a file that the caller commits. See
 * `write_fluent(const std::string&, const Mixed_mesh&)`.
 */
void write_fluent(Output_file& file, const Mixed_mesh& mesh);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for Ansys Fluent, as text, after "Mesh File Format" in the Fluent user's guide: the file that it calls
 * .msh, which is not Gmsh's.
 *
 * - All kinds of cells are written; a cell zone a region, of type fluid for the lumen and solid for others.
 * - Faces are listed with the cells on their two sides: the right hand's thumb points to the first one where its
 *   fingers follow the corners. Each patch is a zone with its name, of type wall for the walls of the vessel and the
 *   rings of its ends, velocity-inlet for the inlet and pressure-outlet for the outlets. A patch between regions, as
 *   the wall, has a cell on both sides: Fluent makes it a coupled wall. The other faces between cells are zones of type
 *   interior, one a region and one for those between regions.
 * - Fluent's names have small letters, digits and - _ . : + alone. Capital letters become small, other signs dashes; a
 *   name that is there twice gets a number, but the region of a patch's name gets -cells behind it.
 * - Coordinates are kept to the last bit. Point arrays are not written, nor are points that no cell has.
 *
 * Expected time O(n log n).
 *
 * \exception Output_error if the file cannot be written, or the mesh is one that the format cannot hold
 */
void write_fluent(const std::string& file, const Mixed_mesh& mesh);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_fluent_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_FLUENT_H

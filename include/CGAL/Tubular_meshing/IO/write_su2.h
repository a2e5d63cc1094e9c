// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_SU2_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_SU2_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for SU2 into a file that the caller commits. See `write_su2(const std::string&, const Mixed_mesh&)`.
 */
void write_su2(Output_file& file, const Mixed_mesh& mesh);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for SU2, after "Mesh File" in SU2's documentation: dimension, elements, points and markers, as text.
 *
 * - All kinds of cells are written, their corners in VTK's order, as the documentation says.
 * - Patches are markers with their names. A blank, or a sign that is none of a word, becomes an underscore; a name that
 *   is there twice gets a number.
 * - A mesh of several regions is a file of several zones, one a region in the order of their labels, each with points
 *   of its own. A patch between two of them is a marker of both: in the zone of the higher label, its name has that
 *   region's behind it, as wall_wall between lumen and wall.
 * - Coordinates are kept to the last bit. Point arrays are not written, nor are points that no cell has.
 *
 * A patch inside of a region is refused. O(n log n).
 *
 * \exception Output_error if the file cannot be written, or the mesh is one that the format cannot hold
 */
void write_su2(const std::string& file, const Mixed_mesh& mesh);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_su2_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_SU2_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_READ_MESH_H
#define CGAL_TUBULAR_MESHING_IO_READ_MESH_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * reads a mesh with its labels, names and point arrays. What write_mesh() has written is read back equal: points bit
 * for bit, and all elements in their order. Files of other programs may be in any encoding of VTK's XML format with
 * zlib or without compression (.vtu), of formats 2.2 and 4.1, ASCII or binary (.msh), or in ASCII (.mesh); labels that
 * they lack are 0.
 *
 * \param file the name of the file
 * \param mesh receives the mesh; what it held before is removed
 *
 * Linear in the size of the file, in time and in memory; n log n for .msh files, whose elements may come in any order.
 *
 * \exception Input_error if the file cannot be read, is of no known format, damaged or truncated, has a coordinate that
 * is not finite, an index that is out of range or an element that is not linear (as those of `--order 2`), or contains no
 * element
 */
void read_mesh(const std::string& file, Mixed_mesh& mesh);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/read_mesh_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_READ_MESH_H

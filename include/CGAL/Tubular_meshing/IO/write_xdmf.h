// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_XDMF_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_XDMF_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 * Whether the package was built with HDF5, which write_xdmf() needs. */
bool has_hdf5();

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for FEniCSx into a file that the caller commits. See
 * `write_xdmf(const std::string&, const Mixed_mesh&)`.
 */
void write_xdmf(Output_file& file, const Mixed_mesh& mesh);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for FEniCSx: a file .xdmf and, beside it, a file .h5 of the same name with the numbers, after the
 * format XDMF 3 and what `dolfinx.io.XDMFFile` reads.
 *
 * - The grid `mesh` has the cells, the grid `cell_tags` their regions, the grid `facet_tags` the facets with their
 *   patches: `read_mesh(name="mesh")`, `read_meshtags(mesh, name="facet_tags")`. The names of regions and patches are
 *   `Information` in these grids: the name, and the label as its value.
 * - FEniCSx has meshes of one kind of cells: of tetrahedra, or of hexahedra, with corners in the order of `Mixed_mesh`,
 *   which is VTK's for these. Others are refused.
 * - Coordinates are kept to the last bit. Point arrays are not written, nor are points that no cell has.
 *
 * It is there where the package was built with HDF5, see has_hdf5(). O(n log n).
 *
 * \exception Output_error if the file cannot be written, or the mesh is one that the format cannot hold
 */
void write_xdmf(const std::string& file, const Mixed_mesh& mesh);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_xdmf_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_XDMF_H

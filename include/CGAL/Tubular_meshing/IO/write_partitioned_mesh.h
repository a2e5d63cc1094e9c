// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_PARTITIONED_MESH_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_PARTITIONED_MESH_H

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>
#include <CGAL/Tubular_meshing/base/Cell_array.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 * Whether write_partitioned_mesh() writes a format: VTK's `.pvtu`, Gmsh's `.msh`, and OpenFOAM's folders. */
bool has_parts(Mesh_format format);

/*! \ingroup PkgTubularMeshingIO
 *
 * opens what a mesh in parts is to be written to, files or folders as the format wants them. See
 * `write_partitioned_mesh(const std::string&, const Mixed_mesh&, const Cell_partition&, Mesh_format)`.
 */
std::unique_ptr<Output> open_partitioned_mesh(const std::string& file, std::size_t number_of_parts,
                                              Mesh_format format = Mesh_format::by_name);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh in parts into what open_partitioned_mesh() has opened for as many, and that the caller commits. See
 * `write_partitioned_mesh(const std::string&, const Mixed_mesh&, const Cell_partition&, Mesh_format)`.
 */
void write_partitioned_mesh(Output& output, const Mixed_mesh& mesh, const Cell_partition& partition,
                            Mesh_format format = Mesh_format::by_name);

/*! \ingroup PkgTubularMeshingIO
 * writes values of its cells as well, where the format has a place for them, see why_no_cell_arrays(). */
void write_partitioned_mesh(Output& output, const Mixed_mesh& mesh, const Cell_partition& partition,
                            const std::vector<Cell_array>& cell_arrays, Mesh_format format = Mesh_format::by_name);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh in parts, for programs that run on several processors; partition_cells() makes the parts.
 *
 * - `.pvtu`, VTK: `mesh.pvtu` and a folder `mesh_parts` beside it, with a file `mesh_0.vtu`, … a part. Each has the
 *   cells of the part and a layer of ghost cells around: those of other parts that share a point with it. The arrays
 *   `vtkGhostType` on points and cells are 1 on what belongs to another part: without those, each point, cell and facet
 *   is there once. `GlobalPointIds` and `GlobalCellIds` tell which it is in the `.vtu` file of the whole mesh. Labels,
 *   names and point arrays are as there. A facet belongs to the part of the cell behind it, of the lower region where
 *   there are two.
 * - `.msh`, Gmsh: one file in format 4.1, with partitioned entities and ghost cells as Gmsh writes them. Physical
 *   groups and their names, the order of nodes and elements, and node data are those of the whole mesh.
 * - OpenFOAM: `constant/polyMesh`, as write_openfoam() writes it, and `processor0/constant/polyMesh`, … beside
 *   `constant`, as `decomposePar` makes them of it: with the patches between processors, all zones, and the files
 *   `pointProcAddressing`, `faceProcAddressing`, `cellProcAddressing` and `boundaryProcAddressing`. Folders of more
 *   processors, which the case may have, would be taken for parts: the mesh is not written then.
 *
 * All is written, or nothing is. Parts are made and written one at a time. The same mesh and partition make the same
 * files, byte for byte. O(n log n).
 *
 * \param file the name of the file, or folder
 * \param mesh the mesh, with cells
 * \param partition the part of each of its cells
 * \param format the format, where the name does not tell it
 *
 * \exception Output_error if it cannot be written, or the format has no parts, or cannot hold the mesh
 * \exception Parameter_error if the partition is not one of the mesh
 */
void write_partitioned_mesh(const std::string& file, const Mixed_mesh& mesh, const Cell_partition& partition,
                            Mesh_format format = Mesh_format::by_name);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_PARTITIONED_MESH_H

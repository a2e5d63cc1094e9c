// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_H

#include <CGAL/Tubular_meshing/IO/Output_folder.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <memory>
#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * The folder of a mesh of OpenFOAM: the one that is named, if its name is `polyMesh`, else `constant/polyMesh` in it,
 * as in a case. A `polyMesh` that is there is replaced; one with other files than those of a mesh is not. */
Output_folder openfoam_folder(const std::string& folder);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for OpenFOAM into a folder that the caller commits. See
 * `write_openfoam(const std::string&, const Mixed_mesh&, bool)`.
 */
void write_openfoam(Output_folder& folder, const Mixed_mesh& mesh, bool binary = false);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for OpenFOAM: a folder `polyMesh` with the files `points`, `faces`, `owner`, `neighbour` and
 * `boundary`, and `cellZones` and `faceZones`, after "Mesh description" in the OpenFOAM user guide.
 *
 * - All kinds of cells are written, as polyhedra. Faces between cells are in upper triangular order, those of the
 *   boundary follow by patch.
 * - Patches keep their names; those of the vessel's walls have the type `wall`, all others `patch`. Faces of the
 *   boundary that have no facet are in a last patch, `defaultFaces`.
 * - Regions are cell zones, where there are several or where the only one is not the lumen; `splitMeshRegions
 *   -cellZones` makes each a mesh of its own. A patch between cells, as the wall between lumen and wall region, is a
 *   face zone.
 * - A sign that OpenFOAM takes in no name, as a blank, becomes an underscore; a name that is there twice gets a number.
 * - Coordinates are kept to the last bit. Points that no cell has, and point arrays, are not written.
 *
 * Expected time O(n log n). It takes about as much memory as the mesh.
 *
 * \param folder the case, or its `constant/polyMesh`
 * \param mesh the mesh
 * \param binary whether points, faces, owners and neighbours are written as bytes: labels of 32 bits, scalars of 64
 *
 * \exception Output_error if it cannot be written, or the mesh has no cells, or a facet that bounds no cell
 */
void write_openfoam(const std::string& folder, const Mixed_mesh& mesh, bool binary = false);

/*! \ingroup PkgTubularMeshingIO
 *
 * opens what write_openfoam_regions() writes into a case, as far as that can be done before the regions are known.
 * \exception Output_error if folders cannot be written there */
std::unique_ptr<Output> open_openfoam_regions(const std::string& folder);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for OpenFOAM, a folder a region, into what open_openfoam_regions() has opened and the caller commits. See
 * `write_openfoam_regions(const std::string&, const Mixed_mesh&, bool)`.
 */
void write_openfoam_regions(Output& output, const Mixed_mesh& mesh, bool binary = false);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for solvers of OpenFOAM that couple regions, as `chtMultiRegionFoam` or those of fluid and structure: a
 * `polyMesh` a region in `constant/fluid`, for the lumen, in `constant/solid`, for the wall around it, and in a folder
 * of its name for each further region.
 *
 * - Each is a mesh as write_openfoam() writes one, with points, cells and faces of its own.
 * - Where two regions meet, each has a patch of the type `mappedWall` towards the other, `fluid_to_solid` and
 *   `solid_to_fluid`. Both have the same faces in the same order, of exactly the same points. The patch is in the
 *   groups `wall` and those of the names of the mesh's patches there, by which boundary conditions can be set.
 * - `constant/regionProperties`, the list of regions, is written where there is none; one that is there is the user's.
 *
 * All of it is written or nothing. A `polyMesh` of a region that is there is replaced, as by write_openfoam().
 *
 * Expected time O(n log n). It takes about as much memory as the mesh.
 *
 * \param folder the case
 * \param mesh the mesh
 * \param binary as of write_openfoam()
 *
 * \exception Output_error as of write_openfoam()
 */
void write_openfoam_regions(const std::string& folder, const Mixed_mesh& mesh, bool binary = false);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_openfoam_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_H

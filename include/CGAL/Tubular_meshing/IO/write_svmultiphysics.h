// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_SVMULTIPHYSICS_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_SVMULTIPHYSICS_H

#include <CGAL/Tubular_meshing/IO/Output_folder.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * The folder of a mesh of svMultiPhysics. One that is there is replaced, but not where it has other files than those of
 * such a mesh. */
Output_folder svmultiphysics_folder(const std::string& folder);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for svMultiPhysics into a folder that the caller commits. See `write_svmultiphysics(const std::string&,
 * const Mixed_mesh&)`.
 */
void write_svmultiphysics(Output_folder& folder, const Mixed_mesh& mesh);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh for SimVascular and its solver svMultiPhysics: the folder that SimVascular calls `mesh-complete`, as
 * the solver's `vtk_xml_parser.cpp` and `load_msh.cpp` read it.
 *
 * - `mesh-complete.mesh.vtu` has the cells, with their number from 1 (`GlobalElementID`) and their region
 *   (`ModelRegionID`), and the points, with theirs (`GlobalNodeID`).
 * - `mesh-surfaces/NAME.vtp` has the facets of a patch, outward, each with the number of the cell behind it
 *   (`GlobalElementID`) and of the patch (`ModelFaceID`), and the points with their numbers in the mesh
 *   (`GlobalNodeID`). `mesh-complete.exterior.vtp` has those of all patches, `walls_combined.vtp` those of the walls
 *   without the rings of their ends. All numbers are Int32. The patch's number is that of the input, where it came in a
 *   `ModelFaceID`.
 * - A mesh of several regions is a folder a region: `fluid` for the lumen, `solid` for the wall around it, a further
 *   one by its name. Each has cells and points of its own, numbered from 1; patches between them are in both, with
 *   exactly the same points.
 * - Tetrahedra, prisms and hexahedra are written, of one kind a region, as the solver wants it, and the facets of a
 *   patch have to be of one kind. The solver has no pyramids. Prisms are in the solver's own order, 0,1,2
 *   counterclockwise seen from 3,4,5: what it does with those in VTK's order leaves them twisted.
 * - In the names of files a blank, or a sign that is none of a word, becomes an underscore, and one that is there twice
 *   gets a number. The names as they are, are field data of the files, as those of .vtu files are.
 *
 * Coordinates are kept to the last bit. Point arrays are not written. O(n log n).
 *
 * \exception Output_error if it cannot be written, or the mesh is one that the solver cannot take
 */
void write_svmultiphysics(const std::string& folder, const Mixed_mesh& mesh);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_svmultiphysics_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_SVMULTIPHYSICS_H

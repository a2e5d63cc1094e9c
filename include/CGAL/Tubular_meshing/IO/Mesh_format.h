// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_MESH_FORMAT_H
#define CGAL_TUBULAR_MESHING_IO_MESH_FORMAT_H

#include <CGAL/Tubular_meshing/base/config.h>

#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * The formats in which write_mesh() writes meshes. The names of some files and folders tell the format: see
 * mesh_format_of(). */
enum class Mesh_format {
  by_name,                 ///< the one that the name tells
  vtu,                     ///< VTK, `.vtu`
  pvtu,                    ///< VTK in parts, `.pvtu` with a folder: write_partitioned_mesh()
  gmsh,                    ///< Gmsh, `.msh`
  medit,                   ///< Medit, FreeFEM and Mmg, `.mesh`
  abaqus,                  ///< Abaqus and CalculiX, `.inp`
  openfoam,                ///< OpenFOAM, a folder `polyMesh`, as text: write_openfoam()
  openfoam_binary,         ///< the same, as bytes
  openfoam_regions,        ///< OpenFOAM, a folder a region in a case: write_openfoam_regions()
  openfoam_regions_binary, ///< the same, as bytes
  svmultiphysics,          ///< svMultiPhysics, a folder `mesh-complete`: write_svmultiphysics()
  su2,                     ///< SU2, `.su2`: write_su2()
  febio,                   ///< FEBio, `.feb`: write_febio()
  fluent,                  ///< Ansys Fluent, `.cas`, or its own `.msh`: write_fluent()
  xdmf,                    ///< FEniCSx, `.xdmf` with a `.h5`: write_xdmf()
  cgns,                    ///< CGNS, `.cgns`: write_cgns()
  exodus                   ///< Exodus II, `.exo`, `.ex2` or `.e`: write_exodus()
};

/*! \ingroup PkgTubularMeshingIO
 * The format that a name tells, by its extension or as that of a folder, `polyMesh` or what ends in `mesh-complete`;
 * Mesh_format::by_name if it tells none. */
Mesh_format mesh_format_of(const std::string& file);

/*! \ingroup PkgTubularMeshingIO
 * The names of the formats, as `tubular_mesh --format` takes them: "vtu", …, "openfoam-binary", … */
std::vector<std::string> mesh_format_names();

/*! \ingroup PkgTubularMeshingIO
 * The format of one of these names.
 * \exception Parameter_error if there is none */
Mesh_format mesh_format_named(const std::string& name);

/*! \ingroup PkgTubularMeshingIO
 * Whether meshes of a format are folders. */
bool is_folder(Mesh_format format);

/*! \ingroup PkgTubularMeshingIO
 * Whether a format is one of those of OpenFOAM; of these, whether it is one of a folder a region. */
bool is_openfoam(Mesh_format format);
bool is_openfoam_regions(Mesh_format format);

/*! \ingroup PkgTubularMeshingIO
 * Why meshes of a format cannot be written, as a sentence, where the library for it was not built in; else empty. */
std::string why_not_built_in(Mesh_format format);

/*! \ingroup PkgTubularMeshingIO
 * Why meshes of quadratic elements cannot be written in a format, as a sentence, where it has none; else empty. */
std::string why_not_quadratic(Mesh_format format);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/Mesh_format_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_MESH_FORMAT_H

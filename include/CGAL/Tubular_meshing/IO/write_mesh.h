// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_MESH_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_MESH_H

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/base/Cell_array.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

// What the named parameter `format` can say: a format, or the version of the .msh format.
struct Format_choice {
  Format_choice() = default;
  Format_choice(Mesh_format format)
      : format(format) {}
  Format_choice(double msh_version)
      : msh_version(msh_version) {}

  Mesh_format format = Mesh_format::by_name;
  double msh_version = 4.1;
};

std::unique_ptr<Output> open_mesh(const std::string& file, const Format_choice& choice);
void write_mesh(Output& output, const Mixed_mesh& mesh, const Format_choice& choice);
void write_mesh(Output& output, const Quadratic_mesh& mesh, const Format_choice& choice);
void write_mesh(Output& output, const Mixed_mesh& mesh, const std::vector<Cell_array>& arrays,
                const Format_choice& choice);
void write_mesh(Output& output, const Quadratic_mesh& mesh, const std::vector<Cell_array>& arrays,
                const Format_choice& choice);

} // namespace internal

/*! \ingroup PkgTubularMeshingIO
 * Whether the name of the file, or folder, tells write_mesh() a format: see mesh_format_of(). */
bool is_supported_mesh_format(const std::string& file);

/*! \ingroup PkgTubularMeshingIO
 *
 * The names that the patches of a mesh have in a file of a format, from label to name: spelled as it can hold them, and
 * none twice where it needs that. */
Label_names patch_names_in(const Mixed_mesh& mesh, Mesh_format format);

/*! \ingroup PkgTubularMeshingIO
 *
 * What a format changes of a mesh or leaves out, a sentence each: names that are spelled otherwise, point arrays that
 * are not written. */
std::vector<std::string> changes_in(const Mixed_mesh& mesh, Mesh_format format);

/*! \ingroup PkgTubularMeshingIO
 * Why write_mesh() cannot write values of cells in a format: a sentence; empty if it can. */
std::string why_no_cell_arrays(Mesh_format format);

/*! \ingroup PkgTubularMeshingIO
 *
 * opens what a mesh is to be written to, a file or a folder as the format wants it. See
 * `write_mesh(const std::string&, const Mixed_mesh&, const NamedParameters&)` for the parameters and the exceptions.
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
std::unique_ptr<Output> open_mesh(const std::string& file,
                                  const NamedParameters& np = CGAL::parameters::default_values()) {
  return internal::open_mesh(file,
                             Tubular_meshing::internal::choose(np, internal_np::format, internal::Format_choice()));
}

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh into a file, or what open_mesh() has opened, that the caller commits: use it to write several files all
 * or none. See `write_mesh(const std::string&, const Mixed_mesh&, const NamedParameters&)`.
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_mesh(Output& output, const Mixed_mesh& mesh,
                const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::write_mesh(output, mesh,
                       Tubular_meshing::internal::choose(np, internal_np::format, internal::Format_choice()));
}

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh with its labels, names and point arrays, in the format that the file's name tells, or that is given.
 *
 * - `.vtu`: volume cells and boundary facets in one file, with cell arrays `region` (0 on facets) and `patch` (0 on
 *   cells). Names are field data: for each an array of pairs (label, dimension), the dimension being 3 for regions and
 *   2 for patches. Point arrays are point data.
 * - `.msh`: physical groups with their names, dimension 3 for regions and 2 for patches. Point arrays of 1, 3, 6
 *   (written as 9) or 9 components are node data; others are not written.
 * - `.mesh`: labels are references, names are comments (`# region 1 lumen`, `# patch 2 inlet`). The point array
 *   `metric` of 6 components becomes a `.sol` file of the same name; others are not written.
 * - `.inp`, for Abaqus and CalculiX: nodes and elements (C3D4, C3D6, C3D8), to be included by an input deck. Regions
 * are element sets, `region_lumen`, `region_wall`; each patch is a node set and a surface, `wall`, `inlet`. Where a
 * patch lies between two regions, its surface is the side of the higher one: that of the wall. A pyramid is written as
 * a C3D8 whose last four nodes are its apex, as CalculiX has no element of five nodes. Point arrays are not written,
 * and meshes without cells are refused.
 *
 * The other formats have a function each, which says what is kept: write_openfoam(), write_svmultiphysics(),
 * write_su2(), write_febio(), write_fluent(), write_xdmf(), write_cgns() and write_exodus(). A `.pvtu` file has one part
 * here; write_partitioned_mesh() writes several.
 *
 * .vtu files are compressed with zlib, .msh files binary in format 4.1 and ASCII in format 2.2, others ASCII.
 * Coordinates are kept to the last bit, but in .inp files. The file is written whole or not at all; a file that was
 * there is replaced. The same mesh makes the same file, byte for byte. O(n log l) for n elements with l different
 * labels.
 *
 * \param file the name of the file
 * \param mesh the mesh
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{format}
 *     \cgalParamDescription{the format, where the name does not tell it; or the version of the .msh format, 4.1 or 2.2}
 *     \cgalParamType{`Mesh_format`, or `double`}
 *     \cgalParamDefault{`Mesh_format::by_name`, and 4.1}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \exception Output_error if the file cannot be written, or its format cannot hold the mesh
 * \exception Parameter_error if `format` is neither 4.1 nor 2.2
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_mesh(const std::string& file, const Mixed_mesh& mesh,
                const NamedParameters& np = CGAL::parameters::default_values()) {
  const std::unique_ptr<Output> out = open_mesh(file, np);
  write_mesh(*out, mesh, np);
  out->commit();
}

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh of quadratic elements into what open_mesh() has opened, which the caller commits. See
 * `write_mesh(const std::string&, const Quadratic_mesh&, const NamedParameters&)`.
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_mesh(Output& output, const Quadratic_mesh& mesh,
                const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::write_mesh(output, mesh,
                       Tubular_meshing::internal::choose(np, internal_np::format, internal::Format_choice()));
}

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh of quadratic elements, as `write_mesh(const std::string&, const Mixed_mesh&, const NamedParameters&)`
 * does one of linear ones; each format lists nodes in its own order.
 *
 * | format | cells | complete ones |
 * |---|---|---|
 * | `.vtu` | VTK_QUADRATIC_TETRA, _PYRAMID, _WEDGE, _HEXAHEDRON | VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_TRIQUADRATIC_HEXAHEDRON; no pyramids |
 * | `.msh` | types 11, 19, 18, 17 | 11, 14, 13, 12 |
 * | `.inp` | C3D10, C3D15, C3D20; no pyramids | none, but C3D10 |
 * | `.exo` | TETRA10, PYRAMID13, WEDGE15, HEX20 | TETRA10, PYRAMID14, WEDGE18, HEX27 |
 * | `.feb` | tet10, pyra13, penta15, hex20 | tet10, hex27 |
 * | svMultiPhysics | tetrahedra of 10, hexahedra of 20 nodes | hexahedra of 27 nodes |
 * | `.xdmf` | tetrahedra of 10 nodes | hexahedra of 27 nodes |
 *
 * Point arrays have at other nodes than corners the mean of the corners that these lie between.
 *
 * \exception Output_error if the file cannot be written, or its format has no such elements: it has none of those above,
 *   see why_not_quadratic()
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_mesh(const std::string& file, const Quadratic_mesh& mesh,
                const NamedParameters& np = CGAL::parameters::default_values()) {
  const std::unique_ptr<Output> out = open_mesh(file, np);
  write_mesh(*out, mesh, np);
  out->commit();
}

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh, of linear or quadratic elements, with values of its cells into what open_mesh() has opened, which the
 * caller commits.
 *
 * | format | values of cells are |
 * |---|---|
 * | `.vtu`, `.pvtu` | cell arrays, 0 on facets |
 * | `.msh` | element data, of 1, 3, 6 (written as 9) or 9 components |
 * | `.xdmf` | attributes of the grid `mesh` |
 * | `.exo` | element variables, a name a component: `NAME_x`, `NAME_y`, `NAME_z` |
 * | `.feb` | directions of fibres: `ElementData` of type `mat_axis`, the first axis circumferential, the second longitudinal; others, of 1 or 3 components: maps of their name |
 * | `.inp` | directions of fibres: `*ORIENTATION, NAME=fibres`, by a `*DISTRIBUTION` over the elements of the wall, x' circumferential, y' longitudinal; no others |
 * | svMultiPhysics | those of three components: directions of fibres, in a file each, `fibers-NAME.vtu`, with the cell array `FIB_DIR` |
 *
 * \exception Output_error as write_mesh() does; if the format has no place for them, see why_no_cell_arrays(); or if
 *   an array has not a value for each cell
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_mesh(Output& output, const Mixed_mesh& mesh, const std::vector<Cell_array>& cell_arrays,
                const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::write_mesh(output, mesh, cell_arrays,
                       Tubular_meshing::internal::choose(np, internal_np::format, internal::Format_choice()));
}
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_mesh(Output& output, const Quadratic_mesh& mesh, const std::vector<Cell_array>& cell_arrays,
                const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::write_mesh(output, mesh, cell_arrays,
                       Tubular_meshing::internal::choose(np, internal_np::format, internal::Format_choice()));
}

/*! \ingroup PkgTubularMeshingIO
 * writes a mesh with values of its cells into a file. */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_mesh(const std::string& file, const Mixed_mesh& mesh, const std::vector<Cell_array>& cell_arrays,
                const NamedParameters& np = CGAL::parameters::default_values()) {
  const std::unique_ptr<Output> out = open_mesh(file, np);
  write_mesh(*out, mesh, cell_arrays, np);
  out->commit();
}
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_mesh(const std::string& file, const Quadratic_mesh& mesh, const std::vector<Cell_array>& cell_arrays,
                const NamedParameters& np = CGAL::parameters::default_values()) {
  const std::unique_ptr<Output> out = open_mesh(file, np);
  write_mesh(*out, mesh, cell_arrays, np);
  out->commit();
}

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_mesh_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_MESH_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_MESH_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_MESH_IMPL_H

#include <CGAL/Tubular_meshing/IO/Output_folder.h>
#include <CGAL/Tubular_meshing/IO/internal/Fibre_directions.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/internal/write_inp.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/IO/internal/write_medit.h>
#include <CGAL/Tubular_meshing/IO/internal/write_msh.h>
#include <CGAL/Tubular_meshing/IO/internal/write_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/write_vtu.h>
#include <CGAL/Tubular_meshing/IO/write_cgns.h>
#include <CGAL/Tubular_meshing/IO/write_exodus.h>
#include <CGAL/Tubular_meshing/IO/write_febio.h>
#include <CGAL/Tubular_meshing/IO/write_fluent.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_openfoam.h>
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_su2.h>
#include <CGAL/Tubular_meshing/IO/write_svmultiphysics.h>
#include <CGAL/Tubular_meshing/IO/write_xdmf.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

inline Mesh_format checked_format(const std::string& file, const Format_choice& choice) {
  if (choice.msh_version != 4.1 && choice.msh_version != 2.2)
    throw Parameter_error("The format of .msh files can be 4.1 or 2.2, not " + std::to_string(choice.msh_version) +
                          ".");
  const Mesh_format format = choice.format == Mesh_format::by_name ? mesh_format_of(file) : choice.format;
  if (format == Mesh_format::by_name)
    throw Output_error("The file " + quoted(file) +
                       " cannot be written: its name tells no format of meshes; give it the extension .vtu, .pvtu, "
                       ".msh, .mesh, .inp, .su2, .feb, .cas, .xdmf, .cgns or .exo, or name the format.");
  const std::string why_not = why_not_built_in(format);
  if (!why_not.empty())
    throw Output_error(why_not);
  return format;
}

CGAL_TUBULAR_MESHING_INLINE std::unique_ptr<Output> open_mesh(const std::string& file, const Format_choice& choice) {
  const Mesh_format format = checked_format(file, choice);
  if (format == Mesh_format::pvtu)
    return open_partitioned_mesh(file, 1, format);
  if (format == Mesh_format::svmultiphysics)
    return std::unique_ptr<Output>(new Output_folder(svmultiphysics_folder(file)));
  if (is_openfoam_regions(format))
    return open_openfoam_regions(file);
  if (is_folder(format))
    return std::unique_ptr<Output>(new Output_folder(openfoam_folder(file)));
  return std::make_unique<Output_file>(file);
}

inline void write_mesh_folder(Output_folder& folder, const Mesh_nodes& nodes, Mesh_format format) {
  if (format == Mesh_format::svmultiphysics)
    write_svmultiphysics(folder, nodes);
  else
    write_openfoam(folder, nodes.mesh(), format == Mesh_format::openfoam_binary);
}

inline void write_mesh_file(Output_file& file, const Mesh_nodes& nodes, Mesh_format format, double msh_version) {
  const Mixed_mesh& mesh = nodes.mesh();
  switch (format) {
  case Mesh_format::vtu:
    return write_vtu(file, nodes);
  case Mesh_format::gmsh:
    return msh_version == 4.1 ? Msh_writer(file, nodes).write_4_1() : Msh_writer(file, nodes).write_2_2();
  case Mesh_format::medit:
    return write_medit(file, mesh);
  case Mesh_format::abaqus:
    return Inp_writer(file, nodes).write();
  case Mesh_format::su2:
    return write_su2(file, mesh);
  case Mesh_format::febio:
    return write_febio(file, nodes);
  case Mesh_format::fluent:
    return write_fluent(file, mesh);
  case Mesh_format::xdmf:
    return write_xdmf(file, nodes);
  case Mesh_format::cgns:
    return write_cgns(file, mesh);
  default:
    return write_exodus(file, nodes);
  }
}

inline void write_nodes(Output& output, const Mesh_nodes& nodes, const Format_choice& choice) {
  check_mesh(nodes.mesh(), output.name());
  const Mesh_format format = checked_format(output.name(), choice);
  if (format == Mesh_format::pvtu)
    return write_parts(output, nodes, {1, std::vector<std::uint32_t>(nodes.mesh().number_of_cells(), 0)}, format);
  if (is_openfoam_regions(format))
    return write_openfoam_regions(output, nodes.mesh(), format == Mesh_format::openfoam_regions_binary);
  if (auto* folder = dynamic_cast<Output_folder*>(&output); folder != nullptr && is_folder(format))
    write_mesh_folder(*folder, nodes, format);
  else if (auto* file = dynamic_cast<Output_file*>(&output); file != nullptr && !is_folder(format))
    write_mesh_file(*file, nodes, format, choice.msh_version);
  else
    throw Output_error(quoted(output.name()) + " was not opened for the format that is to be written.");
}

CGAL_TUBULAR_MESHING_INLINE void write_mesh(Output& output, const Mixed_mesh& mesh, const Format_choice& choice) {
  write_nodes(output, mesh, choice);
}

// What a format that has quadratic elements has none of.
inline void check_quadratic(const Quadratic_mesh& mesh, Mesh_format format, const std::string& file) {
  const std::string why_not = why_not_quadratic(format);
  if (!why_not.empty())
    throw Output_error(why_not);
  const Mixed_mesh& cells = mesh.linear;
  if (format == Mesh_format::vtu && mesh.is_complete && !cells.pyramids.empty())
    refuse(file, "VTK has no pyramids of 14 nodes",
           "leave --order-2-complete away, or write a .msh or .exo file, or choose another --type than mixed");
  if (format == Mesh_format::abaqus && !cells.pyramids.empty())
    refuse(file, "CalculiX and Abaqus have no quadratic pyramids",
           "choose --type isotropic, anisotropic or hexahedral, or leave --order 2 away");
  if (format == Mesh_format::abaqus && mesh.is_complete && !(cells.prisms.empty() && cells.hexahedra.empty()))
    refuse(file, "CalculiX has no prisms of 18 and hexahedra of 27 nodes", "leave --order-2-complete away");
}

CGAL_TUBULAR_MESHING_INLINE void write_mesh(Output& output, const Quadratic_mesh& mesh, const Format_choice& choice) {
  check_quadratic(mesh, checked_format(output.name(), choice), output.name());
  write_nodes(output, mesh, choice);
}

// Formats that have a place for some arrays: decks for axes of materials alone, FEBio for numbers and vectors.
inline void check_places(const std::vector<Cell_array>& arrays, Mesh_format format, const std::string& file) {
  const Fibre_directions fibres(arrays);
  for (const Cell_array& a : arrays) {
    if (format == Mesh_format::abaqus && !fibres.contain(a))
      refuse(file,
             "its format has no place for the cell array " + quoted(a.name) +
                 ", but for the arrays circumferential and longitudinal of fibres",
             write_vtu_instead);
    if (format == Mesh_format::febio && a.components != 1 && a.components != 3)
      refuse(file,
             "FEBio has no values of " + std::to_string(a.components) + " components, as the cell array " +
                 quoted(a.name) + " has",
             write_vtu_instead);
  }
}

CGAL_TUBULAR_MESHING_INLINE void check_arrays(const std::vector<Cell_array>& arrays, const Mixed_mesh& mesh,
                                              Mesh_format format, const std::string& file) {
  const std::string why_not = arrays.empty() ? "" : why_no_cell_arrays(format);
  if (!why_not.empty())
    throw Output_error(why_not);
  for (const Cell_array& a : arrays) {
    check_names({{0, a.name}}, file);
    if (a.components < 1 || a.values.size() != std::size_t(a.components) * mesh.number_of_cells())
      throw Output_error("The file " + quoted(file) + " cannot be written: the cell array " + quoted(a.name) + " has " +
                         std::to_string(a.values.size()) + " values, which are not " + std::to_string(a.components) +
                         " for each of the " + std::to_string(mesh.number_of_cells()) + " cells.");
  }
  check_places(arrays, format, file);
}

CGAL_TUBULAR_MESHING_INLINE void write_mesh(Output& output, const Mixed_mesh& mesh,
                                            const std::vector<Cell_array>& arrays, const Format_choice& choice) {
  check_arrays(arrays, mesh, checked_format(output.name(), choice), output.name());
  write_nodes(output, Mesh_nodes(mesh, &arrays), choice);
}

CGAL_TUBULAR_MESHING_INLINE void write_mesh(Output& output, const Quadratic_mesh& mesh,
                                            const std::vector<Cell_array>& arrays, const Format_choice& choice) {
  const Mesh_format format = checked_format(output.name(), choice);
  check_quadratic(mesh, format, output.name());
  check_arrays(arrays, mesh.linear, format, output.name());
  write_nodes(output, Mesh_nodes(mesh, &arrays), choice);
}

inline bool keeps_names(Mesh_format format) {
  return format == Mesh_format::vtu || format == Mesh_format::pvtu || format == Mesh_format::gmsh ||
         format == Mesh_format::medit || format == Mesh_format::xdmf;
}

inline bool keeps_point_array(const Point_array& array, Mesh_format format) {
  return format == Mesh_format::vtu || format == Mesh_format::pvtu || format == Mesh_format::gmsh ||
         (format == Mesh_format::medit && array.is_metric());
}

// ", \"right one\" is right_one"
inline std::string renamed(const Label_names& names, const Label_names& in_file) {
  std::string text;
  for (const auto& n : in_file) {
    const auto name = names.find(n.first);
    if (name != names.end() && !name->second.empty() && name->second != n.second)
      text += (text.empty() ? "" : ", ") + quoted(name->second) + " is " + n.second;
  }
  return text;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Label_names patch_names_in(const Mixed_mesh& mesh, Mesh_format format) {
  return internal::keeps_names(format) ? mesh.patch_names : internal::patch_names_in_file(mesh, format);
}

CGAL_TUBULAR_MESHING_INLINE std::vector<std::string> changes_in(const Mixed_mesh& mesh, Mesh_format format) {
  std::vector<std::string> changes;
  const std::string patches = internal::renamed(mesh.patch_names, patch_names_in(mesh, format));
  if (!patches.empty())
    changes.push_back("The file has other names of patches: " + patches + ".");
  if (!internal::keeps_names(format) && format != Mesh_format::abaqus) {
    const std::string regions = internal::renamed(mesh.region_names, internal::region_names_in_file(mesh, format));
    if (!regions.empty() && format != Mesh_format::svmultiphysics && format != Mesh_format::su2 &&
        !is_openfoam_regions(format))
      changes.push_back("The file has other names of regions: " + regions + ".");
  }
  for (const Point_array& a : mesh.point_arrays)
    if (!internal::keeps_point_array(a, format))
      changes.push_back("The file has no place for the point array " + internal::quoted(a.name) +
                        ", which is not written; a .vtu file has.");
  return changes;
}

CGAL_TUBULAR_MESHING_INLINE std::string why_no_cell_arrays(Mesh_format format) {
  switch (format) {
  case Mesh_format::vtu:
  case Mesh_format::pvtu:
  case Mesh_format::gmsh:
  case Mesh_format::xdmf:
  case Mesh_format::svmultiphysics:
  case Mesh_format::febio:
  case Mesh_format::abaqus:
  case Mesh_format::exodus:
  case Mesh_format::by_name:
    return "";
  default:
    return "Directions of fibres, or other values of cells, are written to .vtu, .pvtu, .msh, .xdmf, .feb, .inp and "
           ".exo files and for svMultiPhysics alone: choose one of these formats.";
  }
}

CGAL_TUBULAR_MESHING_INLINE bool is_supported_mesh_format(const std::string& file) {
  return mesh_format_of(file) != Mesh_format::by_name;
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_MESH_IMPL_H

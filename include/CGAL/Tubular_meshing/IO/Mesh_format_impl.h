// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_MESH_FORMAT_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_MESH_FORMAT_IMPL_H

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/write_cgns.h>
#include <CGAL/Tubular_meshing/IO/write_exodus.h>
#include <CGAL/Tubular_meshing/IO/write_xdmf.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <filesystem>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

struct Named_format {
  Mesh_format format;
  const char* name;
  std::vector<const char*> extensions;
};

inline const std::vector<Named_format>& named_formats() {
  static const std::vector<Named_format> formats = {
      {Mesh_format::vtu, "vtu", {"vtu"}},
      {Mesh_format::pvtu, "pvtu", {"pvtu"}},
      {Mesh_format::gmsh, "gmsh", {"msh"}},
      {Mesh_format::medit, "medit", {"mesh"}},
      {Mesh_format::abaqus, "abaqus", {"inp"}},
      {Mesh_format::openfoam, "openfoam", {}},
      {Mesh_format::openfoam_binary, "openfoam-binary", {}},
      {Mesh_format::openfoam_regions, "openfoam-regions", {}},
      {Mesh_format::openfoam_regions_binary, "openfoam-regions-binary", {}},
      {Mesh_format::svmultiphysics, "svmultiphysics", {}},
      {Mesh_format::su2, "su2", {"su2"}},
      {Mesh_format::febio, "febio", {"feb"}},
      {Mesh_format::fluent, "fluent", {"cas"}},
      {Mesh_format::xdmf, "xdmf", {"xdmf"}},
      {Mesh_format::cgns, "cgns", {"cgns"}},
      {Mesh_format::exodus, "exodus", {"exo", "ex2", "e"}}};
  return formats;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Mesh_format mesh_format_of(const std::string& file) {
  std::filesystem::path path(file);
  if (path.filename().empty()) // behind a slash
    path = path.parent_path();
  const std::string name = path.filename().string(), end = "mesh-complete";
  if (name == "polyMesh")
    return Mesh_format::openfoam;
  if (name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
    return Mesh_format::svmultiphysics;
  const std::string extension = internal::extension_of(file);
  for (const internal::Named_format& f : internal::named_formats())
    for (const char* e : f.extensions)
      if (extension == e)
        return f.format;
  return Mesh_format::by_name;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<std::string> mesh_format_names() {
  std::vector<std::string> names;
  for (const internal::Named_format& f : internal::named_formats())
    names.push_back(f.name);
  return names;
}

CGAL_TUBULAR_MESHING_INLINE Mesh_format mesh_format_named(const std::string& name) {
  std::string all;
  for (const internal::Named_format& f : internal::named_formats()) {
    if (f.name == name)
      return f.format;
    all += (all.empty() ? "" : ", ") + std::string(f.name);
  }
  throw Parameter_error("There is no format of meshes named \"" + name + "\"; the formats are: " + all + ".");
}

CGAL_TUBULAR_MESHING_INLINE bool is_folder(Mesh_format format) {
  return is_openfoam(format) || format == Mesh_format::svmultiphysics;
}

CGAL_TUBULAR_MESHING_INLINE bool is_openfoam(Mesh_format format) {
  return format == Mesh_format::openfoam || format == Mesh_format::openfoam_binary || is_openfoam_regions(format);
}

CGAL_TUBULAR_MESHING_INLINE bool is_openfoam_regions(Mesh_format format) {
  return format == Mesh_format::openfoam_regions || format == Mesh_format::openfoam_regions_binary;
}

CGAL_TUBULAR_MESHING_INLINE std::string why_not_built_in(Mesh_format format) {
  if (format == Mesh_format::xdmf && !has_hdf5())
    return "This program was built without HDF5, which .xdmf files need: build it where that is installed "
           "(libhdf5-dev), or write a .msh file, which FEniCSx reads too.";
  if (format == Mesh_format::cgns && !has_cgns())
    return "This program was built without the CGNS library, which .cgns files need: build it where that is installed "
           "(libcgns-dev), or write a .vtu file.";
  if (format == Mesh_format::exodus && !has_exodus())
    return "This program was built without the Exodus II library, which .exo files need: build it where that is "
           "installed (libexodusii-dev), or write a .vtu file.";
  return "";
}

CGAL_TUBULAR_MESHING_INLINE std::string why_not_quadratic(Mesh_format format) {
  const std::string instead =
      ": leave --order 2 away, or write a .vtu, .msh, .inp, .exo, .feb or .xdmf file, or a folder mesh-complete.";
  if (is_openfoam(format))
    return "OpenFOAM has no quadratic cells" + instead;
  switch (format) {
  case Mesh_format::pvtu:
    return "Meshes in parts are written with linear cells alone" + instead;
  case Mesh_format::su2:
    return "SU2 has no quadratic cells" + instead;
  case Mesh_format::fluent:
    return "Fluent has no quadratic cells" + instead;
  case Mesh_format::medit:
    return "The format .mesh is written with linear cells alone" + instead;
  case Mesh_format::cgns:
    return "The format .cgns is written with linear cells alone" + instead;
  default:
    return "";
  }
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_MESH_FORMAT_IMPL_H

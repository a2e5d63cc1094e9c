// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_MESH_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_MESH_IMPL_H

#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/check_names.h>
#include <CGAL/Tubular_meshing/IO/internal/write_inp.h>
#include <CGAL/Tubular_meshing/IO/internal/write_medit.h>
#include <CGAL/Tubular_meshing/IO/internal/write_msh.h>
#include <CGAL/Tubular_meshing/IO/internal/write_vtu.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

// What every writer relies on.
inline void check_mesh(const Mixed_mesh& mesh, const std::string& file) {
  check_names(mesh.region_names, file);
  check_names(mesh.patch_names, file);
  for (const Point_array& a : mesh.point_arrays)
    if (a.components < 1 || a.values.size() != static_cast<std::size_t>(a.components) * mesh.points.size())
      throw Output_error("The file " + quoted(file) + " cannot be written: the point array '" + a.name +
                         "' does not have a value for each point.");
}

CGAL_TUBULAR_MESHING_INLINE void write_mesh(Output_file& file, const Mixed_mesh& mesh, double format) {
  check_mesh(mesh, file.name());
  const std::string ext = extension_of(file.name());
  if (format != 4.1 && format != 2.2)
    throw Parameter_error("The format of .msh files can be 4.1 or 2.2, not " + std::to_string(format) + ".");
  if (ext == "vtu")
    write_vtu(file, mesh);
  else if (ext == "mesh")
    write_medit(file, mesh);
  else if (ext == "inp")
    Inp_writer(file, mesh).write();
  else if (ext == "msh" && format == 4.1)
    Msh_writer(file, mesh).write_4_1();
  else if (ext == "msh")
    Msh_writer(file, mesh).write_2_2();
  else
    throw Output_error(
        "The file " + quoted(file.name()) +
        " cannot be written: meshes are written as .vtu, .msh, .mesh or .inp; give it one of these extensions.");
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE bool is_supported_mesh_format(const std::string& file) {
  const std::string ext = internal::extension_of(file);
  return ext == "vtu" || ext == "msh" || ext == "mesh" || ext == "inp";
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_MESH_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_READ_MESH_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_READ_MESH_IMPL_H

#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/read_medit.h>
#include <CGAL/Tubular_meshing/IO/internal/read_msh.h>
#include <CGAL/Tubular_meshing/IO/internal/read_vtu.h>

#include <string>
#include <utility>

namespace CGAL::Tubular_meshing::IO {

CGAL_TUBULAR_MESHING_INLINE void read_mesh(const std::string& name, Mixed_mesh& mesh) {
  using namespace internal;
  const Input_file file(name);
  const std::string ext = extension_of(name);
  Mixed_mesh result;
  if (ext == "vtu")
    read_vtu(file, result);
  else if (ext == "msh")
    read_msh(file, result);
  else if (ext == "mesh")
    read_medit(file, result);
  else
    file.fail("is in no known format; meshes are read from .vtu, .msh and .mesh files");
  if (result.number_of_cells() + result.number_of_facets() == 0)
    file.fail("contains no cells; check that it is a mesh, and the right file");
  check_finite(result.points, file);
  mesh = std::move(result);
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_READ_MESH_IMPL_H

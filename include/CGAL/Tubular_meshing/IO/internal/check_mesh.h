// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_CHECK_MESH_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_CHECK_MESH_H

#include <CGAL/Tubular_meshing/IO/internal/check_names.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

// What every writer relies on.
inline void check_mesh(const Mixed_mesh& mesh, const std::string& file) {
  check_names(mesh.region_names, file);
  check_names(mesh.patch_names, file);
  for (const Point_array& a : mesh.point_arrays)
    if (a.components < 1 || a.values.size() != static_cast<std::size_t>(a.components) * mesh.points.size())
      throw Output_error("The file " + quoted(file) + " cannot be written: the point array '" + a.name +
                         "' does not have a value for each point.");
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_CHECK_MESH_H

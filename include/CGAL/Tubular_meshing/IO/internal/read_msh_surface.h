// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_MSH_SURFACE_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_MSH_SURFACE_H

#include <CGAL/Tubular_meshing/IO/internal/Gmsh_file.h>

namespace CGAL {
namespace Tubular_meshing {
namespace IO {
namespace internal {

// Triangles and quads; elements of other types are passed over.
inline Polygon_soup read_msh_surface(const Input_file& file) {
  Gmsh_file msh(file);
  Polygon_soup soup;
  soup.points.swap(msh.points);
  for (const Gmsh_file::Element& e : msh.elements)
    if (e.type == gmsh::triangle || e.type == gmsh::quad) {
      for (std::size_t i = 0; i < number_of_gmsh_nodes(e.type); ++i)
        soup.corners.push_back(msh.element_nodes[e.first_node + i]);
      soup.end_polygon();
    }
  return soup;
}

} // namespace internal
} // namespace IO
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_MSH_SURFACE_H

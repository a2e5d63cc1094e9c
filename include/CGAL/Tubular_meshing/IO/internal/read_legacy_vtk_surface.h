// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_LEGACY_VTK_SURFACE_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_LEGACY_VTK_SURFACE_H

#include <CGAL/Tubular_meshing/IO/internal/Legacy_vtk_file.h>
#include <CGAL/Tubular_meshing/IO/internal/read_vtp.h>

#include <string>

namespace CGAL {
namespace Tubular_meshing {
namespace IO {
namespace internal {

// Polygons and strips of a POLYDATA; triangles, polygons and quads of an UNSTRUCTURED_GRID.
inline Polygon_soup read_legacy_vtk_surface(const Input_file& file) {
  enum { triangle = 5, strip = 6, polygon = 7, quad = 9 };
  Legacy_vtk_file vtk(file);
  Polygon_soup soup;
  soup.points.swap(vtk.points);
  const auto add = [&](const Vtk_cells& c, std::size_t i, int type) {
    const std::size_t begin = i == 0 ? 0 : static_cast<std::size_t>(c.ends[i - 1]);
    const std::size_t end = static_cast<std::size_t>(c.ends[i]);
    if (type == strip)
      add_strip(c.corners, begin, end, 0, soup);
    else if (type == triangle || type == polygon || type == quad) {
      soup.corners.insert(soup.corners.end(), c.corners.begin() + static_cast<std::ptrdiff_t>(begin),
                          c.corners.begin() + static_cast<std::ptrdiff_t>(end));
      soup.end_polygon();
    }
  };
  if (vtk.is_polydata())
    for (const char* section : {"POLYGONS", "TRIANGLE_STRIPS"})
      for (std::size_t i = 0; i < vtk.cells[section].ends.size(); ++i)
        add(vtk.cells[section], i, section == std::string("POLYGONS") ? polygon : strip);
  else
    for (std::size_t i = 0; i < (std::min)(vtk.cell_types.size(), vtk.cells["CELLS"].ends.size()); ++i)
      add(vtk.cells["CELLS"], i, vtk.cell_types[i]);
  return soup;
}

} // namespace internal
} // namespace IO
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_LEGACY_VTK_SURFACE_H

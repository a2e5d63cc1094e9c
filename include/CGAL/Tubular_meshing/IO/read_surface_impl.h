// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_READ_SURFACE_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_READ_SURFACE_IMPL_H

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/internal/Gmsh_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Legacy_vtk_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/read_obj.h>
#include <CGAL/Tubular_meshing/IO/internal/read_off.h>
#include <CGAL/Tubular_meshing/IO/internal/read_ply.h>
#include <CGAL/Tubular_meshing/IO/internal/read_stl.h>
#include <CGAL/Tubular_meshing/IO/internal/read_vtp.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstdint>

namespace CGAL::Tubular_meshing::IO::internal {

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

inline Polygon_soup read_polygon_soup(const Input_file& file) {
  const std::string ext = extension_of(file.name);
  if (ext == "stl")
    return read_stl(file);
  if (ext == "off")
    return read_off(file);
  if (ext == "obj")
    return read_obj(file);
  if (ext == "ply")
    return read_ply(file);
  if (ext == "vtp")
    return read_vtp_surface(file);
  if (ext == "vtk")
    return read_legacy_vtk_surface(file);
  if (ext == "msh")
    return read_msh_surface(file);
  file.fail("is in no known format; surfaces are read from .stl, .off, .obj, .ply, .vtp, .vtk and .msh files");
}

CGAL_TUBULAR_MESHING_INLINE Tubular_meshing::internal::Triangle_soup read_triangle_soup(const std::string& name) {
  const Input_file file(name);
  Polygon_soup polygons = read_polygon_soup(file);
  Tubular_meshing::internal::Triangle_soup soup;
  soup.triangles = triangulate(polygons, file);
  soup.points.swap(polygons.points);
  if (extension_of(name) == "stl") // the only format without indices
    merge_points(soup.points, soup.triangles);
  return soup;
}

CGAL_TUBULAR_MESHING_INLINE void read_surface(const std::string& file, Surface& surface) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  Tubular_meshing::internal::Triangle_soup soup = read_triangle_soup(file);
  merge_points(soup.points, soup.triangles);
  drop_degenerate_and_duplicate(soup.triangles);
  drop_unused_points(soup.points, soup.triangles);
  if (soup.triangles.empty())
    throw Input_error("The file " + quoted(file) +
                      " contains no triangle with three different corners; check the unit and the precision it was "
                      "exported with.");

  std::vector<Point_3> points = to_points(soup.points);
  PMP::orient_polygon_soup(points, soup.triangles);
  clear(surface);
  PMP::polygon_soup_to_polygon_mesh(points, soup.triangles, surface);
  PMP::stitch_borders(surface);
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_READ_SURFACE_IMPL_H

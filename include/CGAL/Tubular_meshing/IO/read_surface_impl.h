// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_READ_SURFACE_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_READ_SURFACE_IMPL_H

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/internal/Gmsh_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Legacy_vtk_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/read_cells_as_surface.h>
#include <CGAL/Tubular_meshing/IO/internal/read_obj.h>
#include <CGAL/Tubular_meshing/IO/internal/read_off.h>
#include <CGAL/Tubular_meshing/IO/internal/read_ply.h>
#include <CGAL/Tubular_meshing/IO/internal/read_stl.h>
#include <CGAL/Tubular_meshing/IO/internal/read_vtp.h>
#include <CGAL/Tubular_meshing/IO/internal/surface_labels.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// Those of one number at each point or cell, and names, which are fields of pairs of a label and a dimension.
inline void keep_legacy_vtk_arrays(Legacy_vtk_file& vtk, Polygon_soup& soup) {
  const std::size_t points = soup.points.size();
  std::size_t cells = 0;
  for (const auto& c : vtk.cells)
    cells += c.second.ends.size();
  for (auto& a : vtk.point_arrays)
    if (a.second.size() == points)
      soup.point_arrays[a.first] = std::move(a.second);
  for (auto& a : vtk.cell_arrays)
    if (a.second.size() == cells)
      soup.cell_arrays[a.first] = std::move(a.second);
  for (const auto& f : vtk.fields)
    for (std::size_t i = 0; i + 1 < f.second.size(); i += 2)
      if ((f.second[i + 1] == 2 || f.second[i + 1] == 3) && std::abs(f.second[i]) < 1e9)
        (f.second[i + 1] == 2 ? soup.names : soup.region_names)[static_cast<int>(f.second[i])] = f.first;
}

// Polygons and strips of a POLYDATA; triangles, polygons and quads of an UNSTRUCTURED_GRID.
inline Polygon_soup read_legacy_vtk_surface(const Input_file& file) {
  const std::int64_t strip = 6, polygon = 7;
  Legacy_vtk_file vtk(file);
  Polygon_soup soup;
  soup.points.swap(vtk.points);
  keep_legacy_vtk_arrays(vtk, soup);
  std::size_t cell = 0;
  const auto add = [&](const Vtk_cells& c, std::size_t i, std::int64_t type) {
    const std::size_t begin = i == 0 ? 0 : static_cast<std::size_t>(c.ends[i - 1]);
    add_vtk_polygon(c.corners, begin, static_cast<std::size_t>(c.ends[i]), 0, type, cell++, soup);
  };
  if (vtk.is_polydata()) {
    // cells are numbered through: vertices, lines, polygons, strips
    for (const char* section : {"VERTICES", "LINES"})
      cell += vtk.cells[section].ends.size();
    for (const char* section : {"POLYGONS", "TRIANGLE_STRIPS"})
      for (std::size_t i = 0; i < vtk.cells[section].ends.size(); ++i)
        add(vtk.cells[section], i, section == std::string("POLYGONS") ? polygon : strip);
  } else
    for (std::size_t i = 0; i < (std::min)(vtk.cell_types.size(), vtk.cells["CELLS"].ends.size()); ++i)
      add(vtk.cells["CELLS"], i, vtk.cell_types[i]);
  return soup;
}

// The corners of triangles and quads, of second order as well; 0 for elements of other types, which are passed over.
inline std::size_t corners_of_gmsh_polygon(std::int64_t type) {
  const std::int64_t triangle_6 = 9, quad_9 = 10, quad_8 = 16;
  return type == gmsh::triangle || type == triangle_6             ? 3
         : type == gmsh::quad || type == quad_9 || type == quad_8 ? 4
                                                                  : 0;
}

inline Polygon_soup read_msh_surface(const Input_file& file) {
  Gmsh_file msh(file);
  Polygon_soup soup;
  soup.points.swap(msh.points);
  soup.group_kind = "physical groups";
  for (const auto& n : msh.names)
    if (n.first.first == 2)
      soup.names[n.first.second] = n.second;
  for (const Gmsh_node_data& d : msh.node_data)
    if (d.components == 1 && d.nodes.size() == soup.points.size()) {
      std::vector<double>& values = soup.point_arrays[d.name];
      values.resize(soup.points.size());
      for (std::size_t i = 0; i < d.nodes.size(); ++i)
        values[static_cast<std::size_t>(d.nodes[i])] = d.values[i];
    }
  for (const Gmsh_file::Element& e : msh.elements)
    if (const std::size_t corners = corners_of_gmsh_polygon(e.type)) {
      for (std::size_t i = 0; i < corners; ++i)
        soup.corners.push_back(msh.element_nodes[e.first_node + i]);
      soup.end_polygon();
      soup.groups.push_back(static_cast<int>(std::abs(e.physical))); // negative where it is turned
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
  if (ext == "vtu")
    return read_vtu_surface(file);
  if (ext == "vtk")
    return read_legacy_vtk_surface(file);
  if (ext == "mesh")
    return read_medit_surface(file);
  if (ext == "msh")
    return read_msh_surface(file);
  file.fail(
      "is in no known format; surfaces are read from .stl, .off, .obj, .ply, .vtp, .vtu, .vtk, .msh and .mesh files");
}

// One a triangle, of one a cell.
inline std::vector<double> values_of_triangles(const Polygon_soup& soup, const std::vector<std::size_t>& polygon,
                                               const std::vector<double>& of_cell) {
  std::vector<double> values;
  for (std::size_t p : polygon)
    values.push_back(soup.cell_of(p) < of_cell.size() ? of_cell[soup.cell_of(p)] : std::nan(""));
  return values;
}

inline std::string note_of_few_corners(const Polygon_soup& polygons) {
  std::size_t few = 0, begin = 0;
  for (std::size_t end : polygons.ends) {
    few += end - begin < 3;
    begin = end;
  }
  return few == 0   ? ""
         : few == 1 ? "A face of the file has fewer than three corners, and was skipped."
                    : std::to_string(few) + " faces of the file have fewer than three corners, and were skipped.";
}

CGAL_TUBULAR_MESHING_INLINE Tubular_meshing::internal::Triangle_soup read_triangle_soup(const std::string& name) {
  const Input_file file(name);
  Polygon_soup polygons = read_polygon_soup(file);
  std::vector<std::size_t> polygon;
  Tubular_meshing::internal::Triangle_soup soup;
  soup.triangles = triangulate(polygons, file, polygon);
  soup.points.swap(polygons.points);
  if (extension_of(name) == "stl") // the only format without indices
    merge_points(soup.points, soup.triangles);
  return soup;
}

CGAL_TUBULAR_MESHING_INLINE Surface_data read_surface_data(const std::string& name, const std::string& label_array) {
  const Input_file file(name);
  Polygon_soup polygons = read_polygon_soup(file);
  std::vector<std::size_t> polygon;
  Tubular_meshing::internal::Triangle_soup soup;
  soup.triangles = triangulate(polygons, file, polygon);
  soup.points.swap(polygons.points);
  if (extension_of(name) == "stl") // which has no arrays at points
    merge_points(soup.points, soup.triangles);

  Surface_data data;
  data.labels = surface_labels(polygons, polygon, label_array, file);
  data.points = to_points(soup.points);
  data.triangles.swap(soup.triangles);
  for (auto& a : polygons.point_arrays)
    if (a.second.size() == data.points.size())
      data.point_arrays[a.first].swap(a.second);
  for (const auto& a : polygons.cell_arrays)
    data.cell_arrays[a.first] = values_of_triangles(polygons, polygon, a.second);
  if (!polygons.groups.empty())
    for (std::size_t p : polygon)
      data.cell_arrays[polygons.group_kind].push_back(polygons.groups[p]);
  data.names = polygons.names;
  data.region_names = polygons.region_names;
  const std::string note = note_of_few_corners(polygons);
  if (!note.empty())
    data.notes.push_back(note);
  return data;
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

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_CELLS_AS_SURFACE_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_CELLS_AS_SURFACE_H

// Surfaces in files that are for meshes of any cells: those of triangles and other polygons are taken, others passed
// over. Of a polygon of higher order its corners count.

#include <CGAL/Tubular_meshing/IO/internal/Legacy_vtk_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_file.h>
#include <CGAL/Tubular_meshing/IO/internal/read_medit.h>
#include <CGAL/Tubular_meshing/IO/internal/read_vtp.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// The corners of a cell of VTK's type with so many points; 0 for types that are no polygons.
inline std::size_t corners_of_vtk_polygon(std::int64_t type, std::size_t points) {
  switch (type) {
  case 7: // polygon
    return points;
  case 5:  // triangle
  case 22: // and its kinds of higher order
  case 34:
  case 69:
  case 76:
    return (std::min<std::size_t>)(points, 3);
  case 8: // pixel
  case 9: // quad
  case 23:
  case 28:
  case 30:
  case 70:
  case 77:
    return (std::min<std::size_t>)(points, 4);
  default:
    return 0;
  }
}

// corners[begin..end) as a cell of VTK's type.
inline void add_vtk_polygon(const std::vector<std::int64_t>& corners, std::size_t begin, std::size_t end,
                            std::int64_t shift, std::int64_t type, std::size_t cell, Polygon_soup& soup) {
  const std::int64_t strip = 6, pixel = 8;
  if (type == strip)
    return add_strip(corners, begin, end, shift, cell, soup);
  const std::size_t n = corners_of_vtk_polygon(type, end - begin);
  if (n == 0)
    return;
  for (std::size_t i = 0; i < n; ++i)
    soup.corners.push_back(corners[begin + i] + shift);
  if (type == pixel && n == 4) // which has its points in rows
    std::swap(soup.corners[soup.corners.size() - 2], soup.corners.back());
  soup.end_polygon(cell);
}

inline Polygon_soup read_vtu_surface(const Input_file& file) {
  Polygon_soup soup;
  const Vtk_xml_file vtu(file, "UnstructuredGrid");
  read_vtp_names(vtu, soup);
  std::size_t first_cell = 0;
  bool is_first = true;
  for (const pugi::xml_node piece : vtu.dataset().children("Piece")) {
    const std::int64_t shift = static_cast<std::int64_t>(soup.points.size());
    const std::vector<Coordinates> points = vtu.points(piece);
    soup.points.insert(soup.points.end(), points.begin(), points.end());
    const std::size_t n = vtu.count(piece, "NumberOfCells");
    if (n > 0) {
      const pugi::xml_node cells = piece.child("Cells");
      const auto types = vtu.values<std::int64_t>(vtu.find(cells, "types"));
      if (types.size() != n)
        file.fail("cannot be used: a piece of it has " + std::to_string(n) + " cells, but the types of " +
                  std::to_string(types.size()));
      const auto offsets = vtu.values<std::int64_t>(vtu.find(cells, "offsets"), n);
      const auto corners = vtp_connectivity(vtu, cells, points.size());
      std::size_t i = 0;
      for_each_vtk_cell(offsets, corners.size(), file, [&](std::size_t begin, std::size_t end) {
        add_vtk_polygon(corners, begin, end, shift, types[i], first_cell + i, soup);
        ++i;
      });
    }
    append_arrays(soup.point_arrays, vtp_arrays(vtu, piece.child("PointData"), points.size()), is_first);
    append_arrays(soup.cell_arrays, vtp_arrays(vtu, piece.child("CellData"), n), is_first);
    first_cell += n;
    is_first = false;
  }
  return soup;
}

// References are labels: this package's patches, where comments name them.
inline Polygon_soup read_medit_surface(const Input_file& file) {
  Mixed_mesh mesh;
  read_medit(file, mesh);
  Polygon_soup soup;
  for (const Point_3& p : mesh.points)
    soup.points.push_back(coordinates(p));
  std::vector<double> labels;
  const auto add = [&](const auto& block) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      soup.corners.insert(soup.corners.end(), block.vertices[i].begin(), block.vertices[i].end());
      soup.end_polygon();
      labels.push_back(block.label[i]);
    }
  };
  add(mesh.triangles);
  add(mesh.quads);
  soup.names = mesh.patch_names;
  soup.cell_arrays[mesh.patch_names.empty() ? "medit:ref" : "patch"] = std::move(labels);
  return soup;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_CELLS_AS_SURFACE_H

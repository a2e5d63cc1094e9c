// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_READ_CENTERLINES_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_READ_CENTERLINES_IMPL_H

#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/internal/Gmsh_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Legacy_vtk_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_file.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/IO/internal/read_vtp.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

struct Line_soup {
  std::vector<Coordinates> points;
  std::vector<double> radius;
  std::vector<std::vector<std::size_t>> lines;

  // A line of one point is none; files have them.
  template <class Iterator> void add(Iterator begin, Iterator end, std::size_t shift) {
    if (end - begin < 2)
      return;
    lines.emplace_back();
    lines.back().reserve(static_cast<std::size_t>(end - begin));
    for (; begin != end; ++begin)
      lines.back().push_back(static_cast<std::size_t>(*begin) + shift);
  }
};

inline Line_soup read_legacy_vtk_lines(const Input_file& file) {
  enum { line = 3, polyline = 4 };
  Legacy_vtk_file vtk(file);
  Line_soup soup;
  soup.points.swap(vtk.points);
  soup.radius.swap(vtk.point_arrays[radius_array_name]);
  const Vtk_cells& cells = vtk.cells[vtk.is_polydata() ? "LINES" : "CELLS"];
  if (!vtk.is_polydata() && vtk.cell_types.size() != cells.ends.size())
    file.fail("cannot be used: it has " + std::to_string(cells.ends.size()) + " cells, but the types of " +
              std::to_string(vtk.cell_types.size()));
  std::ptrdiff_t begin = 0;
  for (std::size_t i = 0; i < cells.ends.size(); begin = static_cast<std::ptrdiff_t>(cells.ends[i]), ++i)
    if (vtk.is_polydata() || vtk.cell_types[i] == line || vtk.cell_types[i] == polyline)
      soup.add(cells.corners.begin() + begin, cells.corners.begin() + static_cast<std::ptrdiff_t>(cells.ends[i]), 0);
  return soup;
}

inline Line_soup read_vtp_lines(const Input_file& file) {
  Line_soup soup;
  const Vtk_xml_file vtp(file, "PolyData");
  for (const pugi::xml_node piece : vtp.dataset().children("Piece")) {
    const std::size_t shift = soup.points.size();
    const std::vector<Coordinates> points = vtp.points(piece);
    soup.points.insert(soup.points.end(), points.begin(), points.end());
    if (const pugi::xml_node array = vtp.find(piece.child("PointData"), radius_array_name)) {
      const std::vector<double> radius = vtp.values<double>(array, points.size());
      soup.radius.insert(soup.radius.end(), radius.begin(), radius.end());
    }
    const std::size_t n = vtp.count(piece, "NumberOfLines");
    if (n == 0)
      continue;
    const auto corners = vtp_connectivity(vtp, piece.child("Lines"), points.size());
    const auto offsets = vtp.values<std::int64_t>(vtp.find(piece.child("Lines"), "offsets"), n);
    for_each_vtk_cell(offsets, corners.size(), file, [&](std::size_t begin, std::size_t end) {
      soup.add(corners.begin() + static_cast<std::ptrdiff_t>(begin), corners.begin() + static_cast<std::ptrdiff_t>(end),
               shift);
    });
  }
  return soup;
}

inline Line_soup read_msh_lines(const Input_file& file) {
  Gmsh_file msh(file);
  Line_soup soup;
  soup.points.swap(msh.points);
  for (const Gmsh_file::Element& e : msh.elements)
    if (e.type == gmsh::line) {
      const auto begin = msh.element_nodes.begin() + static_cast<std::ptrdiff_t>(e.first_node);
      soup.add(begin, begin + 2, 0);
    }
  for (const Gmsh_node_data& d : msh.node_data)
    if (d.name == radius_array_name && d.components == 1 && d.nodes.size() == soup.points.size()) {
      soup.radius.assign(soup.points.size(), 0.);
      for (std::size_t i = 0; i < d.nodes.size(); ++i)
        soup.radius[static_cast<std::size_t>(d.nodes[i])] = d.values[i];
    }
  return soup;
}

inline Line_soup read_lines_of_any_format(const Input_file& file) {
  const std::string ext = extension_of(file.name);
  if (ext == "vtk")
    return read_legacy_vtk_lines(file);
  if (ext == "vtp")
    return read_vtp_lines(file);
  if (ext == "msh")
    return read_msh_lines(file);
  file.fail("is in no known format; centerlines are read from .vtk, .vtp and .msh files");
}

inline Line_soup read_lines(const std::string& name) {
  const Input_file file(name);
  Line_soup soup = read_lines_of_any_format(file);
  if (soup.lines.empty())
    file.fail("contains no lines; check that it holds centerlines, and not a surface");
  check_finite(soup.points, file);
  if (!soup.radius.empty() && soup.radius.size() != soup.points.size())
    file.fail("cannot be used: its array " + std::string(radius_array_name) + " has " +
              std::to_string(soup.radius.size()) + " values for " + std::to_string(soup.points.size()) + " points");
  for (std::size_t i = 0; i < soup.radius.size(); ++i)
    if (!std::isfinite(soup.radius[i]) || soup.radius[i] < 0)
      file.fail("cannot be used: the radius at point " + std::to_string(i) +
                " (counted from 0) is not a finite number of at least 0");
  return soup;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void read_centerlines(const std::string& file, Centerline_polylines& centerlines) {
  internal::Line_soup soup = internal::read_lines(file);
  centerlines.points = internal::to_points(soup.points);
  centerlines.radius.swap(soup.radius);
  centerlines.lines.swap(soup.lines);
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_READ_CENTERLINES_IMPL_H

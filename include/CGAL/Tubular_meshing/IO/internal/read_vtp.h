// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_VTP_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_VTP_H

#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_file.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// Every second triangle of a strip turns the other way.
inline void add_strip(const std::vector<std::int64_t>& strip, std::size_t begin, std::size_t end, std::int64_t shift,
                      std::size_t cell, Polygon_soup& soup) {
  for (std::size_t i = begin; i + 2 < end; ++i) {
    const bool odd = (i - begin) % 2 == 1;
    for (std::size_t j : {i, odd ? i + 2 : i + 1, odd ? i + 1 : i + 2})
      soup.corners.push_back(strip[j] + shift);
    soup.end_polygon(cell);
  }
}

// A piece numbers its points from 0: its indices are checked before they are shifted behind those of other pieces.
inline std::vector<std::int64_t> vtp_connectivity(const Vtk_xml_file& vtp, pugi::xml_node cells, std::size_t points) {
  std::vector<std::int64_t> c = vtp.values<std::int64_t>(vtp.find(cells, "connectivity"));
  for (std::size_t i = 0; i < c.size(); ++i)
    check_index(c[i], points, "corner", i, vtp.file());
  return c;
}

// An array beside the geometry; where it is damaged, the surface need not be refused for it.
template <class T> std::vector<T> values_if_whole(const Vtk_xml_file& vtp, pugi::xml_node array) {
  try {
    return vtp.values<T>(array);
  } catch (const Input_error&) {
    return {};
  }
}

// The arrays of one number at each of n points or cells.
inline Polygon_soup::Arrays vtp_arrays(const Vtk_xml_file& vtp, pugi::xml_node data, std::size_t n) {
  Polygon_soup::Arrays arrays;
  for (const pugi::xml_node array : data.children("DataArray"))
    if (array.attribute("NumberOfComponents").as_int(1) == 1 && vtp.is_numeric(array)) {
      std::vector<double> values = values_if_whole<double>(vtp, array);
      if (values.size() == n)
        arrays[array.attribute("Name").value()] = std::move(values);
    }
  return arrays;
}

// Fields of pairs of a label and a dimension, 2 or 3, as this package writes names; other fields are passed over.
inline void read_vtp_names(const Vtk_xml_file& vtp, Polygon_soup& soup) {
  for (const pugi::xml_node array : vtp.dataset().child("FieldData").children("DataArray")) {
    if (array.attribute("type").value() != std::string("Int32"))
      continue;
    const std::vector<std::int32_t> pairs = values_if_whole<std::int32_t>(vtp, array);
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
      if (pairs[i + 1] == 2)
        soup.names[pairs[i]] = array.attribute("Name").value();
      else if (pairs[i + 1] == 3)
        soup.region_names[pairs[i]] = array.attribute("Name").value();
  }
}

// Polygons and triangle strips of all pieces; vertices and lines are passed over.
inline Polygon_soup read_vtp_surface(const Input_file& file) {
  Polygon_soup soup;
  const Vtk_xml_file vtp(file, "PolyData");
  read_vtp_names(vtp, soup);
  std::size_t first_cell = 0;
  bool is_first = true;
  for (const pugi::xml_node piece : vtp.dataset().children("Piece")) {
    const std::int64_t shift = static_cast<std::int64_t>(soup.points.size());
    const std::vector<Coordinates> points = vtp.points(piece);
    soup.points.insert(soup.points.end(), points.begin(), points.end());

    // cells are numbered through: vertices, lines, polygons, strips
    std::size_t cell = first_cell + vtp.count(piece, "NumberOfVerts") + vtp.count(piece, "NumberOfLines");
    const std::size_t number_of_polygons = vtp.count(piece, "NumberOfPolys");
    if (number_of_polygons > 0) {
      const auto corners = vtp_connectivity(vtp, piece.child("Polys"), points.size());
      const auto offsets = vtp.values<std::int64_t>(vtp.find(piece.child("Polys"), "offsets"), number_of_polygons);
      for_each_vtk_cell(offsets, corners.size(), file, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          soup.corners.push_back(corners[i] + shift);
        soup.end_polygon(cell++);
      });
    }
    const std::size_t number_of_strips = vtp.count(piece, "NumberOfStrips");
    if (number_of_strips > 0) {
      const auto corners = vtp_connectivity(vtp, piece.child("Strips"), points.size());
      const auto offsets = vtp.values<std::int64_t>(vtp.find(piece.child("Strips"), "offsets"), number_of_strips);
      for_each_vtk_cell(offsets, corners.size(), file, [&](std::size_t begin, std::size_t end) {
        add_strip(corners, begin, end, shift, cell++, soup);
      });
    }
    append_arrays(soup.point_arrays, vtp_arrays(vtp, piece.child("PointData"), points.size()), is_first);
    append_arrays(soup.cell_arrays, vtp_arrays(vtp, piece.child("CellData"), cell - first_cell), is_first);
    first_cell = cell;
    is_first = false;
  }
  return soup;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_VTP_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_VTU_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_VTU_H

#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_file.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/IO/internal/fail_quadratic.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// Field arrays that are pairs of a label and a dimension; other arrays are passed over.
inline void read_names(const Vtk_xml_file& vtu, pugi::xml_node fields, Mixed_mesh& mesh) {
  for (const pugi::xml_node array : fields.children("DataArray")) {
    if (array.attribute("type").value() != std::string("Int32"))
      continue;
    const std::vector<std::int32_t> pairs = vtu.values<std::int32_t>(array);
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
      if (pairs[i + 1] == 3)
        mesh.region_names[pairs[i]] = array.attribute("Name").value();
      else if (pairs[i + 1] == 2)
        mesh.patch_names[pairs[i]] = array.attribute("Name").value();
  }
}

// The labels of the cells of a piece; 0, if it has none.
inline std::vector<int> vtu_labels(const Vtk_xml_file& vtu, pugi::xml_node piece, const char* name, std::size_t cells) {
  const pugi::xml_node array = vtu.find(piece.child("CellData"), name);
  return array ? vtu.values<int>(array, cells) : std::vector<int>(cells, 0);
}

// A piece's array continues the one of the same name of the pieces before it.
inline void read_point_arrays(const Vtk_xml_file& vtu, pugi::xml_node piece, std::size_t n, Mixed_mesh& mesh) {
  for (const pugi::xml_node array : piece.child("PointData").children("DataArray")) {
    const std::string name = array.attribute("Name").value();
    const int components = array.attribute("NumberOfComponents").as_int(1);
    if (components < 1 || components > 9)
      vtu.file().fail("cannot be used: its point array " + printable(name) + " has " + std::to_string(components) +
                      " components instead of 1 to 9");
    const std::vector<double> values = vtu.values<double>(array, n * static_cast<std::size_t>(components));
    auto a = std::find_if(mesh.point_arrays.begin(), mesh.point_arrays.end(),
                          [&](const Point_array& b) { return b.name == name; });
    if (a == mesh.point_arrays.end())
      a = mesh.point_arrays.insert(a, Point_array{name, components, {}});
    a->values.insert(a->values.end(), values.begin(), values.end());
  }
}

inline void read_vtu_cells(const Vtk_xml_file& vtu, pugi::xml_node piece, std::size_t points, std::size_t shift,
                           Mixed_mesh& mesh) {
  const std::size_t n = vtu.count(piece, "NumberOfCells");
  const pugi::xml_node cells = piece.child("Cells");
  const auto types = vtu.values<std::int64_t>(vtu.find(cells, "types"));
  if (types.size() != n)
    vtu.file().fail("cannot be used: a piece of it has " + std::to_string(n) + " cells, but the types of " +
                    std::to_string(types.size()));
  const auto offsets = vtu.values<std::int64_t>(vtu.find(cells, "offsets"), n);
  auto corners = vtu.values<std::int64_t>(vtu.find(cells, "connectivity"));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    check_index(corners[i], points, "corner", i, vtu.file());
    corners[i] += static_cast<std::int64_t>(shift);
  }
  const std::vector<int> region = vtu_labels(vtu, piece, "region", n), patch = vtu_labels(vtu, piece, "patch", n);
  std::size_t i = 0;
  for_each_vtk_cell(offsets, corners.size(), vtu.file(), [&](std::size_t begin, std::size_t end) {
    const Element_kind* kind = find_kind(&Element_kind::vtk_type, types[i]);
    if (is_quadratic_vtk_type(types[i]))
      fail_quadratic(vtu.file(), "cell " + std::to_string(i));
    if (!kind || end - begin != kind->corners)
      vtu.file().fail("cannot be used: cell " + std::to_string(i) + " is of VTK's type " + std::to_string(types[i]) +
                      " and has " + std::to_string(end - begin) +
                      " corners; only linear tetrahedra, pyramids, wedges, hexahedra, triangles and quads are known");
    add_element(mesh, *kind, corners.begin() + static_cast<std::ptrdiff_t>(begin), true,
                kind->dimension == 3 ? region[i] : patch[i]);
    ++i;
  });
}

inline void read_vtu(const Input_file& file, Mixed_mesh& mesh) {
  const Vtk_xml_file vtu(file, "UnstructuredGrid");
  read_names(vtu, vtu.dataset().child("FieldData"), mesh);
  for (const pugi::xml_node piece : vtu.dataset().children("Piece")) {
    const std::size_t shift = mesh.points.size();
    const std::vector<Point_3> points = to_points(vtu.points(piece));
    mesh.points.insert(mesh.points.end(), points.begin(), points.end());
    read_point_arrays(vtu, piece, points.size(), mesh);
    read_vtu_cells(vtu, piece, points.size(), shift, mesh);
  }
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_VTU_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_POLYDATA_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_POLYDATA_H

#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/name_fields.h>

#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// What VTK calls PolyData, of cells of one sort: lines with values at points, or polygons with labels.
struct Polydata {
  std::vector<Coordinates> points;
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> ends;
  bool are_lines = false;
  std::string point_array_name; // empty: none
  std::size_t point_array_components = 1;
  std::vector<double> point_array;
  struct Cell_array {
    std::string name;
    std::vector<std::int32_t> values;
  };
  std::vector<Cell_array> cell_arrays;
  Label_names names; // of patches
};

inline void write_vtp(Output_file& file, const Polydata& data) {
  const std::string n = std::to_string(data.ends.size());
  Vtk_xml_writer out("PolyData");
  if (!data.names.empty()) {
    out.begin("FieldData");
    for (const auto& field : name_fields(data.names, {}))
      out.array(field.first, 0, field.second);
    out.end("FieldData");
  }
  out.begin("Piece NumberOfPoints=\"" + std::to_string(data.points.size()) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
            (data.are_lines ? n : "0") + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + (data.are_lines ? "0" : n) +
            "\"");
  out.begin("PointData");
  if (!data.point_array_name.empty())
    out.array(data.point_array_name, data.point_array_components, data.point_array);
  out.end("PointData");
  out.begin("CellData");
  for (const Polydata::Cell_array& a : data.cell_arrays)
    out.array(a.name, 1, a.values);
  out.end("CellData");
  out.begin("Points");
  out.array("Points", 3, coordinates_of(data.points));
  out.end("Points");
  const std::string section = data.are_lines ? "Lines" : "Polys";
  out.begin(section);
  out.array("connectivity", 1, data.corners);
  out.array("offsets", 1, data.ends);
  out.end(section);
  out.end("Piece");
  out.write(file);
}

// As fields; a blank would end a name there.
inline void write_legacy_names(const Label_names& names, Number_writer& out) {
  const auto fields = name_fields(names, {});
  if (fields.empty())
    return;
  out << "FIELD FieldData " << fields.size() << '\n';
  for (const auto& field : fields) {
    std::string name = field.first;
    std::replace(name.begin(), name.end(), ' ', '_');
    out << name << " 2 " << field.second.size() / 2 << " int\n";
    for (std::size_t i = 0; i < field.second.size(); ++i)
      out << field.second[i] << (i + 1 == field.second.size() ? '\n' : ' ');
  }
}

// Version 3.0, which all of VTK's readers know, and VMTK's.
inline void write_legacy_vtk(Output_file& file, const Polydata& data) {
  Number_writer out(file);
  out << "# vtk DataFile Version 3.0\nTubular_meshing\nASCII\nDATASET POLYDATA\n";
  write_legacy_names(data.names, out);
  out << "POINTS " << data.points.size() << " double\n";
  for (const Coordinates& p : data.points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  out << (data.are_lines ? "LINES " : "POLYGONS ") << data.ends.size() << ' ' << data.ends.size() + data.corners.size()
      << '\n';
  std::int64_t begin = 0;
  for (std::int64_t end : data.ends) {
    out << end - begin;
    for (; begin < end; ++begin)
      out << ' ' << data.corners[static_cast<std::size_t>(begin)];
    out << '\n';
  }
  if (!data.point_array_name.empty()) {
    out << "POINT_DATA " << data.points.size();
    if (data.point_array_components == 1)
      out << "\nSCALARS " << data.point_array_name << " double\nLOOKUP_TABLE default\n";
    else
      out << "\nFIELD FieldData 1\n"
          << data.point_array_name << ' ' << data.point_array_components << ' ' << data.points.size() << " double\n";
    for (double x : data.point_array)
      out << x << '\n';
  }
  if (!data.cell_arrays.empty())
    out << "CELL_DATA " << data.ends.size() << '\n';
  for (const Polydata::Cell_array& a : data.cell_arrays) {
    out << "SCALARS " << a.name << " int\nLOOKUP_TABLE default\n";
    for (std::int32_t x : a.values)
      out << x << '\n';
  }
  out.flush();
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_POLYDATA_H

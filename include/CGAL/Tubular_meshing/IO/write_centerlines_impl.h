// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_CENTERLINES_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_CENTERLINES_IMPL_H

#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/IO/internal/write_polydata.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

/* `points_of`: the indices of the points of one of the lines. */
template <class Lines, class Points_of>
Polydata polydata_of(const std::vector<Point_3>& points, const std::vector<double>& radius, const Lines& lines,
                     const Points_of& points_of) {
  Polydata data;
  data.are_lines = true;
  for (const Point_3& p : points)
    data.points.push_back(coordinates(p));
  for (const auto& line : lines) {
    for (std::size_t i : points_of(line))
      data.corners.push_back(static_cast<std::int64_t>(i));
    data.ends.push_back(static_cast<std::int64_t>(data.corners.size()));
  }
  if (!radius.empty()) {
    data.point_array_name = radius_array_name;
    data.point_array = radius;
  }
  return data;
}

inline Polydata polydata_of(const Centerline_polylines& c) {
  typedef std::vector<std::size_t> Line;
  return polydata_of(c.points, c.radius, c.lines, [](const Line& line) -> const Line& { return line; });
}

inline void write_lines(Output_file& file, const Polydata& data) {
  const std::string ext = extension_of(file.name());
  if (ext == "vtp")
    write_vtp(file, data);
  else if (ext == "vtk")
    write_legacy_vtk(file, data);
  else
    throw Output_error("The file " + quoted(file.name()) +
                       " cannot be written: centerlines are written as .vtp or .vtk; give it one of these extensions.");
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE bool is_supported_centerlines_format(const std::string& file) {
  const std::string ext = internal::extension_of(file);
  return ext == "vtp" || ext == "vtk";
}

CGAL_TUBULAR_MESHING_INLINE void write_centerlines(Output_file& file, const Centerline_polylines& centerlines) {
  internal::write_lines(file, internal::polydata_of(centerlines));
}

CGAL_TUBULAR_MESHING_INLINE void write_centerlines(Output_file& file, const Centerline_graph& graph) {
  typedef Centerline_graph::Branch Branch;
  internal::write_lines(
      file, internal::polydata_of(graph.points(), graph.radii(), graph.branches(),
                                  [](const Branch& b) -> const Centerline_graph::Polyline& { return b.points; }));
}

CGAL_TUBULAR_MESHING_INLINE void write_centerlines(Output_file& file, const Branched_centerlines& c) {
  internal::Polydata data = internal::polydata_of(c.lines);
  const auto add = [&](const char* name, const std::vector<int>& values) {
    data.cell_arrays.push_back({name, std::vector<std::int32_t>(values.begin(), values.end())});
  };
  add("CenterlineIds", c.centerline_ids);
  add("TractIds", c.tract_ids);
  add("GroupIds", c.group_ids);
  add("Blanking", c.blanking);
  internal::write_lines(file, data);
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_CENTERLINES_IMPL_H

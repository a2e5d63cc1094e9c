// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_CENTERLINES_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_CENTERLINES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/branched_centerlines.h>
#include <CGAL/Tubular_meshing/IO/internal/Output_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/read_lines.h>
#include <CGAL/Tubular_meshing/IO/internal/write_polydata.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/number_utils.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace IO {

namespace internal {

// `lines` is a range of ranges of indices.
template <class Points, class Line_of, class Lines>
Polydata polydata_of(const Points& points, const std::vector<double>& radius, const Lines& lines, Line_of line_of) {
  Polydata data;
  data.are_lines = true;
  for (const auto& p : points)
    data.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  for (const auto& line : lines) {
    for (std::size_t i : line_of(line))
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

inline Polydata polydata_of(const Centerline_graph& graph) {
  typedef typename Centerline_graph::Branch Branch;
  return polydata_of(
      graph.points(), graph.radii(), graph.branches(), [](const Branch& b) -> const auto& { return b.points; });
}

inline Polydata polydata_of(const Branched_centerlines& c) {
  Polydata data = polydata_of(c.lines);
  const auto add = [&](const char* name, const std::vector<int>& values) {
    data.cell_arrays.push_back({name, std::vector<std::int32_t>(values.begin(), values.end())});
  };
  add("CenterlineIds", c.centerline_ids);
  add("TractIds", c.tract_ids);
  add("GroupIds", c.group_ids);
  add("Blanking", c.blanking);
  return data;
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 * Whether write_centerlines() knows the extension of the file: .vtp or .vtk. */
inline bool is_supported_centerlines_format(const std::string& file) {
  const std::string ext = internal::extension_of(file);
  return ext == "vtp" || ext == "vtk";
}

/*! \ingroup PkgTubularMeshingRef
 * writes centerlines into a file that the caller commits: use it to write several files all or none. */
template <class Centerlines> void write_centerlines(Output_file& file, const Centerlines& centerlines) {
  const internal::Polydata data = internal::polydata_of(centerlines);
  const std::string ext = internal::extension_of(file.name());
  if (ext == "vtp")
    internal::write_vtp(file, data);
  else if (ext == "vtk")
    internal::write_legacy_vtk(file, data);
  else
    throw Output_error("The file " + internal::quoted(file.name()) +
                       " cannot be written: centerlines are written as .vtp or .vtk; give it one of these extensions.");
}

/*! \ingroup PkgTubularMeshingRef
 *
 * writes centerlines, a polyline for each line or branch, with the radii as point array `MaximumInscribedSphereRadius`,
 * as VMTK does; Branched_centerlines also with the cell arrays of VMTK's branch extractor. .vtp (zlib) or legacy .vtk
 * (ASCII). read_centerlines() reads the same numbers back. The file is written
 * whole or not at all. Linear in the number of points.
 *
 * \tparam Centerlines `Centerline_polylines`, `Centerline_graph` or `Branched_centerlines`
 * \param file the name of the file
 * \param centerlines the centerlines
 *
 * \exception Output_error if the file cannot be written
 */
template <class Centerlines> void write_centerlines(const std::string& file, const Centerlines& centerlines) {
  Output_file out(file);
  write_centerlines(out, centerlines);
  out.commit();
}

} // namespace IO
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_CENTERLINES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_TRIANGLES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_TRIANGLES_H

#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/write_polydata.h>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace IO {
namespace internal {

// A surface on its way into a file.
struct Labelled_triangles {
  std::vector<Coordinates> points;
  std::vector<Index_triangle> triangles;
  std::vector<std::int32_t> patch;         // one a triangle, or none
  std::vector<std::int32_t> surface_patch; // likewise
};

// Binary, in single precision, as the format is.
inline void write_stl(Output_file& file, const Labelled_triangles& surface) {
  const bool swapped = !host_is_little_endian();
  Number_writer out(file);
  std::string header = "binary STL written by Tubular_meshing";
  header.resize(80, ' ');
  out << header;
  out.bytes(static_cast<std::uint32_t>(surface.triangles.size()), swapped);
  for (const Index_triangle& t : surface.triangles) {
    const Coordinates& p = surface.points[t[0]];
    const Coordinates n = cross(minus(surface.points[t[1]], p), minus(surface.points[t[2]], p));
    const double length = std::sqrt(dot(n, n));
    for (double x : n)
      out.bytes(static_cast<float>(length > 0 ? x / length : 0.), swapped);
    for (std::size_t v : t)
      for (double x : surface.points[v])
        out.bytes(static_cast<float>(x), swapped);
    out.bytes(std::uint16_t(0), swapped);
  }
  out.flush();
}

inline void write_off(Output_file& file, const Labelled_triangles& surface) {
  Number_writer out(file);
  out << "OFF\n" << surface.points.size() << ' ' << surface.triangles.size() << " 0\n";
  for (const Coordinates& p : surface.points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const Index_triangle& t : surface.triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  out.flush();
}

inline void write_obj(Output_file& file, const Labelled_triangles& surface) {
  Number_writer out(file);
  for (const Coordinates& p : surface.points)
    out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const Index_triangle& t : surface.triangles)
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  out.flush();
}

inline void write_ply(Output_file& file, const Labelled_triangles& surface) {
  const bool swapped = !host_is_little_endian();
  Number_writer out(file);
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << surface.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << surface.triangles.size()
      << "\nproperty list uchar int vertex_indices\n"
      << (surface.patch.empty() ? "" : "property int patch\n")
      << (surface.surface_patch.empty() ? "" : "property int surface_patch\n") << "end_header\n";
  for (const Coordinates& p : surface.points)
    for (double x : p)
      out.bytes(x, swapped);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    out.bytes(std::uint8_t(3));
    for (std::size_t v : surface.triangles[i])
      out.bytes(static_cast<std::int32_t>(v), swapped);
    if (!surface.patch.empty())
      out.bytes(surface.patch[i], swapped);
    if (!surface.surface_patch.empty())
      out.bytes(surface.surface_patch[i], swapped);
  }
  out.flush();
}

inline Polydata polydata_of(const Labelled_triangles& surface) {
  Polydata data;
  data.points = surface.points;
  for (const Index_triangle& t : surface.triangles) {
    for (std::size_t v : t)
      data.corners.push_back(static_cast<std::int64_t>(v));
    data.ends.push_back(static_cast<std::int64_t>(data.corners.size()));
  }
  if (!surface.patch.empty())
    data.cell_arrays.push_back({"patch", surface.patch});
  if (!surface.surface_patch.empty())
    data.cell_arrays.push_back({"surface_patch", surface.surface_patch});
  return data;
}

} // namespace internal
} // namespace IO
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_TRIANGLES_H

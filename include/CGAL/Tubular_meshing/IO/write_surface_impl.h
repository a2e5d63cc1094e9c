// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_SURFACE_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_SURFACE_IMPL_H

#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/name_fields.h>
#include <CGAL/Tubular_meshing/IO/internal/check_names.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/write_msh.h>
#include <CGAL/Tubular_meshing/IO/internal/write_polydata.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

inline std::vector<Index_triangle> triangles_of(const std::vector<Index_face>& faces,
                                                const std::vector<Coordinates>& points) {
  std::vector<Index_triangle> result;
  for (const Index_face& f : faces) {
    const std::array<std::size_t, 4>& c = f.corners;
    const auto squared_length = [&](std::size_t i, std::size_t j) {
      const Coordinates d = minus(points[c[j]], points[c[i]]);
      return dot(d, d);
    };
    const std::size_t first = f.number_of_corners == 3 || squared_length(0, 2) <= squared_length(1, 3) ? 0 : 1;
    result.push_back({{c[first], c[first + 1], c[first + 2]}});
    if (f.number_of_corners == 4)
      result.push_back({{c[first + 2], c[(first + 3) % 4], c[first]}});
  }
  return result;
}

// Binary, in single precision, as the format is. It has triangles alone: quads are split by their shorter diagonals.
inline void write_stl(Output_file& file, const Labelled_faces& surface) {
  const bool swapped = !host_is_little_endian();
  const std::vector<Index_triangle> triangles = triangles_of(surface.faces, surface.points);
  Number_writer out(file);
  std::string header = "binary STL written by Tubular_meshing";
  header.resize(80, ' ');
  out << header;
  out.bytes(static_cast<std::uint32_t>(triangles.size()), swapped);
  for (const Index_triangle& t : triangles) {
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

inline bool has_names(const Labelled_faces& surface) {
  return !surface.patch_names.empty() && !surface.patch.empty();
}

inline std::string name_of_patch(const Labelled_faces& surface, std::int32_t patch) {
  const auto name = surface.patch_names.find(patch);
  return name == surface.patch_names.end() ? "patch_" + std::to_string(patch) : name->second;
}

// The faces of each patch, in the order of the labels.
inline std::map<std::int32_t, std::vector<std::size_t>> faces_by_patch(const std::vector<std::int32_t>& patch) {
  std::map<std::int32_t, std::vector<std::size_t>> faces;
  for (std::size_t i = 0; i < patch.size(); ++i)
    faces[patch[i]].push_back(i);
  return faces;
}

// Binary files have no names: a solid a patch.
inline void write_stl_solids(Output_file& file, const Labelled_faces& surface) {
  Number_writer out(file);
  for (const auto& patch : faces_by_patch(surface.patch)) {
    Labelled_faces part;
    for (std::size_t f : patch.second)
      part.faces.push_back(surface.faces[f]);
    const std::string name = name_of_patch(surface, patch.first);
    out << "solid " << name << '\n';
    for (const Index_triangle& t : triangles_of(part.faces, surface.points)) {
      const Coordinates& p = surface.points[t[0]];
      const Coordinates n = cross(minus(surface.points[t[1]], p), minus(surface.points[t[2]], p));
      const double length = std::sqrt(dot(n, n));
      out << "facet normal";
      for (double x : n)
        out << ' ' << (length > 0 ? x / length : 0.);
      out << "\nouter loop\n";
      for (std::size_t v : t)
        out << "vertex " << surface.points[v][0] << ' ' << surface.points[v][1] << ' ' << surface.points[v][2] << '\n';
      out << "endloop\nendfacet\n";
    }
    out << "endsolid " << name << '\n';
  }
  out.flush();
}

inline void write_off(Output_file& file, const Labelled_faces& surface) {
  Number_writer out(file);
  out << "OFF\n" << surface.points.size() << ' ' << surface.faces.size() << " 0\n";
  for (const Coordinates& p : surface.points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const Index_face& f : surface.faces) {
    out << f.number_of_corners;
    for (std::size_t v : f)
      out << ' ' << v;
    out << '\n';
  }
  out.flush();
}

inline void write_obj(Output_file& file, const Labelled_faces& surface) {
  Number_writer out(file);
  for (const Coordinates& p : surface.points)
    out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  const auto write_face = [&](const Index_face& f) {
    out << 'f';
    for (std::size_t v : f)
      out << ' ' << v + 1;
    out << '\n';
  };
  if (has_names(surface))
    for (const auto& patch : faces_by_patch(surface.patch)) {
      std::string name = name_of_patch(surface, patch.first);
      std::replace(name.begin(), name.end(), ' ', '_'); // a blank would end it
      out << "g " << name << '\n';
      for (std::size_t f : patch.second)
        write_face(surface.faces[f]);
    }
  else
    for (const Index_face& f : surface.faces)
      write_face(f);
  out.flush();
}

inline void write_ply(Output_file& file, const Labelled_faces& surface) {
  const bool swapped = !host_is_little_endian();
  Number_writer out(file);
  out << "ply\nformat binary_little_endian 1.0\n";
  if (has_names(surface))
    for (const auto& n : surface.patch_names)
      out << "comment patch " << n.first << ' ' << n.second << '\n';
  out << "element vertex " << surface.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << surface.faces.size()
      << "\nproperty list uchar int vertex_indices\n"
      << (surface.patch.empty() ? "" : "property int patch\n")
      << (surface.surface_patch.empty() ? "" : "property int surface_patch\n") << "end_header\n";
  for (const Coordinates& p : surface.points)
    for (double x : p)
      out.bytes(x, swapped);
  for (std::size_t i = 0; i < surface.faces.size(); ++i) {
    out.bytes(static_cast<std::uint8_t>(surface.faces[i].number_of_corners));
    for (std::size_t v : surface.faces[i])
      out.bytes(static_cast<std::int32_t>(v), swapped);
    if (!surface.patch.empty())
      out.bytes(surface.patch[i], swapped);
    if (!surface.surface_patch.empty())
      out.bytes(surface.surface_patch[i], swapped);
  }
  out.flush();
}

inline Polydata polydata_of(const Labelled_faces& surface) {
  Polydata data;
  data.points = surface.points;
  for (const Index_face& f : surface.faces) {
    for (std::size_t v : f)
      data.corners.push_back(static_cast<std::int64_t>(v));
    data.ends.push_back(static_cast<std::int64_t>(data.corners.size()));
  }
  if (!surface.metric.empty()) {
    data.point_array_name = metric_array_name;
    data.point_array_components = 6;
    data.point_array = surface.metric;
  }
  if (!surface.patch.empty())
    data.cell_arrays.push_back({"patch", surface.patch});
  if (!surface.patch.empty() && !surface.patch_ids.empty())
    data.cell_arrays.push_back({surface.patch_ids.array, ids_of(surface.patch, surface.patch_ids)});
  if (has_names(surface))
    data.names = surface.patch_names;
  if (!surface.surface_patch.empty())
    data.cell_arrays.push_back({"surface_patch", surface.surface_patch});
  return data;
}

// Names of the patches that occur, as labels.h has them.
inline Label_names names_of_patches(const std::vector<std::int32_t>& patch) {
  const std::set<int> used(patch.begin(), patch.end());
  const int most = used.empty() ? 0 : (std::min)(*used.rbegin(), labels::outer_wall - 1);
  Label_names names = lumen_patch_names((std::max)(0, most - labels::inlet + 1));
  for (auto n = names.begin(); n != names.end();)
    n = used.count(n->first) ? std::next(n) : names.erase(n);
  return names;
}

inline void write_msh_surface(Output_file& file, const Labelled_faces& surface) {
  Mixed_mesh mesh;
  mesh.points = to_points(surface.points);
  for (std::size_t i = 0; i < surface.faces.size(); ++i) {
    const Index_face& f = surface.faces[i];
    const std::int32_t label = surface.patch.empty() ? 0 : surface.patch[i];
    std::array<std::uint32_t, 4> c;
    std::copy(f.corners.begin(), f.corners.end(), c.begin());
    if (f.number_of_corners == 4)
      mesh.quads.push_back(c, label);
    else
      mesh.triangles.push_back({c[0], c[1], c[2]}, label);
  }
  if (!surface.metric.empty())
    mesh.point_arrays.push_back({metric_array_name, 6, surface.metric});
  mesh.patch_names = has_names(surface) ? surface.patch_names : names_of_patches(surface.patch);
  Msh_writer(file, mesh).write_4_1();
}

CGAL_TUBULAR_MESHING_INLINE void write_surface(Output_file& file, const Labelled_faces& surface) {
  const std::string ext = extension_of(file.name());
  check_names(surface.patch_names, file.name());
  if (ext == "stl")
    has_names(surface) ? write_stl_solids(file, surface) : write_stl(file, surface);
  else if (ext == "off")
    write_off(file, surface);
  else if (ext == "obj")
    write_obj(file, surface);
  else if (ext == "ply")
    write_ply(file, surface);
  else if (ext == "vtp")
    write_vtp(file, polydata_of(surface));
  else if (ext == "vtk")
    write_legacy_vtk(file, polydata_of(surface));
  else if (ext == "msh")
    write_msh_surface(file, surface);
  else
    throw Output_error(
        "The file " + quoted(file.name()) +
        " cannot be written: surfaces are written as .stl, .off, .obj, .ply, .vtp, .vtk or .msh; give it "
        "one of these extensions.");
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE bool is_supported_surface_format(const std::string& file) {
  const std::string ext = internal::extension_of(file);
  return ext == "stl" || ext == "off" || ext == "obj" || ext == "ply" || ext == "vtp" || ext == "vtk" || ext == "msh";
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_SURFACE_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_SURFACE_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_SURFACE_H

#include <CGAL/Tubular_meshing/IO/internal/write_faces.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace IO {

namespace internal {

// Appends the label of a face, if there is a map of labels.
template <class Face> void append_label(const CGAL::internal_np::Param_not_found&, Face, std::vector<std::int32_t>&) {}
template <class Label_map, class Face> void append_label(const Label_map& map, Face f, std::vector<std::int32_t>& to) {
  to.push_back(static_cast<std::int32_t>(get(map, f)));
}

// Appends the metric at a vertex, likewise.
template <class Vertex> void append_metric(const CGAL::internal_np::Param_not_found&, Vertex, std::vector<double>&) {}
template <class Metric_map, class Vertex> void append_metric(const Metric_map& map, Vertex v, std::vector<double>& to) {
  const auto components = get(map, v).components();
  to.insert(to.end(), components.begin(), components.end());
}

template <class TriangleMesh, class NamedParameters>
Labelled_faces labelled_faces(const TriangleMesh& mesh, const NamedParameters& np) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef boost::graph_traits<TriangleMesh> Graph;
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, mesh));

  Labelled_faces surface;
  std::unordered_map<typename Graph::vertex_descriptor, std::size_t> number;
  number.reserve(num_vertices(mesh));
  for (auto v : vertices(mesh)) {
    number.emplace(v, surface.points.size());
    const auto& p = get(point_map, v);
    surface.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    append_metric(get_parameter(np, internal_np::vertex_metric_map), v, surface.metric);
  }
  for (auto f : faces(mesh)) {
    Index_face face;
    for (auto v : vertices_around_face(halfedge(f, mesh), mesh)) {
      if (face.number_of_corners == 4)
        throw Output_error("The surface cannot be written: one of its faces has more than four edges; triangulate it "
                           "first.");
      face.corners[face.number_of_corners++] = number.at(v);
    }
    surface.faces.push_back(face);
    append_label(get_parameter(np, internal_np::face_patch_map), f, surface.patch);
    append_label(get_parameter(np, internal_np::surface_patch_map), f, surface.surface_patch);
  }
  return surface;
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
  mesh.patch_names = names_of_patches(surface.patch);
  Msh_writer<Mixed_mesh>(file, mesh).write_4_1();
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 * Whether write_surface() knows the extension of the file: .stl, .off, .obj, .ply, .vtp, .vtk or .msh. */
inline bool is_supported_surface_format(const std::string& file) {
  const std::string ext = internal::extension_of(file);
  return ext == "stl" || ext == "off" || ext == "obj" || ext == "ply" || ext == "vtp" || ext == "vtk" || ext == "msh";
}

/*! \ingroup PkgTubularMeshingRef
 * writes a surface into a file that the caller commits: use it to write several files all or none. */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_surface(Output_file& file, const TriangleMesh& mesh,
                   const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Labelled_faces surface = internal::labelled_faces(mesh, np);
  const std::string ext = internal::extension_of(file.name());
  if (ext == "stl")
    internal::write_stl(file, surface);
  else if (ext == "off")
    internal::write_off(file, surface);
  else if (ext == "obj")
    internal::write_obj(file, surface);
  else if (ext == "ply")
    internal::write_ply(file, surface);
  else if (ext == "vtp")
    internal::write_vtp(file, internal::polydata_of(surface));
  else if (ext == "vtk")
    internal::write_legacy_vtk(file, internal::polydata_of(surface));
  else if (ext == "msh")
    internal::write_msh_surface(file, surface);
  else
    throw Output_error(
        "The file " + internal::quoted(file.name()) +
        " cannot be written: surfaces are written as .stl, .off, .obj, .ply, .vtp, .vtk or .msh; give it "
        "one of these extensions.");
}

/*! \ingroup PkgTubularMeshingRef
 *
 * writes a mesh of triangles and quads in the format that the extension of the file names: STL (binary, single
 * precision), OFF, OBJ, PLY (binary), VTP (zlib), legacy VTK (ASCII) or MSH 4.1 (binary). All but STL keep coordinates
 * to the last bit, and quads, which STL has as two triangles, by their shorter diagonals. The file is written whole or
 * not at all. Linear in the size of the mesh.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` whose faces are triangles and quads
 * \param file the name of the file
 * \param mesh the surface
 * \param np named parameters: `vertex_point_map`; `face_patch_map`, a readable property map from face to the label of
 *        its patch, which is written as cell array `patch` (.vtp, .vtk), face property `patch` (.ply) or physical group
 *        (.msh). Default: none; `surface_patch_map`, the same for numbers of patches of a cut, which are written as
 *        `surface_patch` (.vtp, .vtk, .ply). Default: none; `vertex_metric_map`, a readable property map from vertex
 *        to Metric_tensor_3, which is written as point array `metric` (xx, xy, xz, yy, yz, zz; .vtp, .vtk, .msh).
 *        Default: none
 *
 * \exception Output_error if the file cannot be written, or a face has more than four edges
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_surface(const std::string& file, const TriangleMesh& mesh,
                   const NamedParameters& np = CGAL::parameters::default_values()) {
  Output_file out(file);
  write_surface(out, mesh, np);
  out.commit();
}

} // namespace IO
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_SURFACE_H

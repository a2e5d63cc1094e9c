// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_SURFACE_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_SURFACE_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

// A triangle or a quad.
struct Index_face {
  std::array<std::size_t, 4> corners{{0, 0, 0, 0}};
  std::size_t number_of_corners = 0;

  const std::size_t* begin() const { return corners.data(); }
  const std::size_t* end() const { return corners.data() + number_of_corners; }
};

// A surface on its way into a file.
struct Labelled_faces {
  std::vector<std::array<double, 3>> points;
  std::vector<Index_face> faces;
  std::vector<std::int32_t> patch;         // one a face, or none
  std::vector<std::int32_t> surface_patch; // likewise
  std::vector<double> metric;              // six a point: xx, xy, xz, yy, yz, zz; or none
  Label_names patch_names;                 // or none
  Patch_ids patch_ids;
};

void write_surface(Output_file& file, const Labelled_faces& surface);

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
  surface.patch_names = Tubular_meshing::internal::choose(np, internal_np::patch_names, surface.patch_names);
  surface.patch_ids = Tubular_meshing::internal::choose(np, internal_np::patch_ids, surface.patch_ids);
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

} // namespace internal

/*! \ingroup PkgTubularMeshingIO
 * Whether write_surface() knows the extension of the file: .stl, .off, .obj, .ply, .vtp, .vtk or .msh. */
bool is_supported_surface_format(const std::string& file);

/*! \ingroup PkgTubularMeshingIO
 * writes a surface into a file that the caller commits: use it to write several files all or none. */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_surface(Output_file& file, const TriangleMesh& mesh,
                   const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::write_surface(file, internal::labelled_faces(mesh, np));
}

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a mesh of triangles and quads in the format that the extension of the file names: STL (binary, single
 * precision), OFF, OBJ, PLY (binary), VTP (zlib), legacy VTK (ASCII) or MSH 4.1 (binary). All but STL keep coordinates
 * to the last bit, and quads, which STL has as two triangles, by their shorter diagonals. The file is written whole or
 * not at all. Linear in the size of the mesh.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`, of any kernel, whose faces are triangles and quads
 * \param file the name of the file
 * \param mesh the surface
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a readable property map from its vertices to points}
 *     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{the label of the patch of each face, which is written as cell array `patch` (.vtp, .vtk),
 * face property `patch` (.ply) or physical group (.msh)} \cgalParamType{a readable property map from faces to `int`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{patch_names}
 *     \cgalParamDescription{the names of these labels, which are written as field data (.vtp, .vtk), comments (.ply),
 *       groups (.obj), physical groups (.msh) or solids (.stl, which then is ASCII, and keeps coordinates); an .off file
 *       has no place for them}
 *     \cgalParamType{`Label_names`}
 *     \cgalParamDefault{none; in .msh files wall, inlet, outlet_1, …}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{patch_ids}
 *     \cgalParamDescription{the numbers that patches had in a cell array of the input, which is written beside `patch`
 *       (.vtp, .vtk)}
 *     \cgalParamType{`Patch_ids`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{surface_patch_map}
 *     \cgalParamDescription{the same for the numbers of patches of a cut, which are written as `surface_patch` (.vtp,
 *       .vtk, .ply)}
 *     \cgalParamType{a readable property map from faces to `int`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_metric_map}
 *     \cgalParamDescription{the metric at each vertex, which is written as point array `metric` (xx, xy, xz, yy, yz,
 * zz; .vtp, .vtk, .msh)} \cgalParamType{a readable property map from vertices to Metric_tensor_3}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
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

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_surface_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_SURFACE_H

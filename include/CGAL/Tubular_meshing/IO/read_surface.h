// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_READ_SURFACE_H
#define CGAL_TUBULAR_MESHING_IO_READ_SURFACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Surface_labels.h>
#include <CGAL/Tubular_meshing/base/Triangle_soup.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * All that a surface file tells: triangles, as read_triangle_soup() has them; which face is which end; values at its
 * points. */
struct Surface_data {
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  Surface_labels labels;                                   ///< of the triangles
  std::map<std::string, std::vector<double>> point_arrays; ///< those of one number a point
  std::map<std::string, std::vector<double>> cell_arrays;  ///< those of one number a cell: here one a triangle; and
                                                           ///< `solids`, `groups`, `physical groups`
  Label_names names;        ///< that the file has for labels, of whatever array; in VTK's files fields of dimension 2
  Label_names region_names; ///< for regions: fields of dimension 3; in PLY files comments, "region 4 plaque"
  std::vector<std::string> notes; ///< a sentence for each kind of thing that was skipped
};

namespace internal {

Surface_data read_surface_data(const std::string& file, const std::string& label_array);
Tubular_meshing::internal::Triangle_soup read_triangle_soup(const std::string& file);
void read_surface(const std::string& file, Surface& surface);

} // namespace internal

/*! \ingroup PkgTubularMeshingIO
 *
 * reads the triangles of a surface as they stand in the file, unoriented and unconnected.
 *
 * The extension of the file names its format: STL (ASCII or binary, which the content decides), OFF, OBJ, PLY (ASCII,
 * binary of either byte order), VTP (any encoding VTK writes, uncompressed or with zlib), legacy VTK (POLYDATA or
 * UNSTRUCTURED_GRID, ASCII or binary), MSH 2.2 and 4.1. Polygons are cut into triangles, triangle strips are unrolled.
 *
 * \param file the name of the file
 * \param points receives the points, in the file's order; those of an STL file, which has no indices, are merged where
 *        their coordinates are equal
 * \param triangles receives the corners of the triangles, as indices of `points`
 *
 * Linear in the size of the file, in time and in memory: nothing is allocated on the word of a header alone.
 *
 * \exception Input_error if the file cannot be read, is of no known format, damaged or truncated, has a coordinate that
 * is not finite or an index that is out of range, or contains no triangle
 */
template <class Point>
void read_triangle_soup(const std::string& file, std::vector<Point>& points,
                        std::vector<std::array<std::size_t, 3>>& triangles) {
  Tubular_meshing::internal::Triangle_soup soup = internal::read_triangle_soup(file);
  points.clear();
  points.reserve(soup.points.size());
  for (const std::array<double, 3>& p : soup.points)
    points.push_back(Point(p[0], p[1], p[2]));
  triangles.swap(soup.triangles);
}

/*! \ingroup PkgTubularMeshingIO
 *
 * reads the triangles of a surface with their labels, and the arrays at its points and in its cells.
 *
 * Labels are, in this order: the cell array that is asked for; the solids of an ASCII STL file, the groups (`g`, `o`)
 * of an OBJ file, the physical groups of an MSH file, if there are two at least; a cell array (in PLY files a property
 * of faces) of two integers at least with one of the names `ModelFaceID` (SimVascular), `CapID` and `CellEntityIds`
 * (VMTK; the wall is 0 or 1), `patch` (this package; the wall is 1), `gmsh:physical` and `medit:ref` (meshio).
 *
 * \param file the name of the file, see read_triangle_soup() for the formats
 * \param label_array the name of the cell array that is to be the labels; empty: as above
 *
 * \exception Input_error as read_triangle_soup() does; if there is no cell array of the name that is asked for, or not
 *   all of its values are integers
 */
inline Surface_data read_surface_data(const std::string& file, const std::string& label_array = "") {
  return internal::read_surface_data(file, label_array);
}

/*! \ingroup PkgTubularMeshingIO
 *
 * reads a surface as a triangle mesh: what read_triangle_soup() yields, with points of equal coordinates merged,
 * triangles without area by two equal corners and repeated triangles dropped, oriented consistently (a closed component
 * may still be inside out), and stitched. Where the surface is not a manifold, points are duplicated.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph`, of any kernel
 * \param file the name of the file, see read_triangle_soup() for the formats
 * \param mesh receives the surface; what it held before is removed
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the mesh's vertices}
 *     \cgalParamType{a writable property map from its vertices to points}
 *     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \exception Input_error as read_triangle_soup() does
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void read_surface(const std::string& file, TriangleMesh& mesh,
                  const NamedParameters& np = CGAL::parameters::default_values()) {
  using namespace Tubular_meshing::internal;
  if constexpr (is_core_surface<TriangleMesh, NamedParameters>)
    internal::read_surface(file, mesh);
  else {
    Surface surface;
    internal::read_surface(file, surface);
    typedef Core_point_map<typename GetVertexPointMap<TriangleMesh, NamedParameters>::type> Points;
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    const Points points{
        choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_property_map(vertex_point, mesh))};
    clear(mesh);
    copy_face_graph(surface, mesh, CGAL::parameters::default_values(), CGAL::parameters::vertex_point_map(points));
  }
}

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/read_surface_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_READ_SURFACE_H

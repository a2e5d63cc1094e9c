// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_READ_SURFACE_H
#define CGAL_TUBULAR_MESHING_IO_READ_SURFACE_H

#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/read_legacy_vtk_surface.h>
#include <CGAL/Tubular_meshing/IO/internal/read_msh_surface.h>
#include <CGAL/Tubular_meshing/IO/internal/read_obj.h>
#include <CGAL/Tubular_meshing/IO/internal/read_off.h>
#include <CGAL/Tubular_meshing/IO/internal/read_ply.h>
#include <CGAL/Tubular_meshing/IO/internal/read_stl.h>
#include <CGAL/Tubular_meshing/IO/internal/read_vtp.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace IO {

namespace internal {

inline Polygon_soup read_polygon_soup(const Input_file& file) {
  const std::string ext = extension_of(file.name);
  if (ext == "stl")
    return read_stl(file);
  if (ext == "off")
    return read_off(file);
  if (ext == "obj")
    return read_obj(file);
  if (ext == "ply")
    return read_ply(file);
  if (ext == "vtp")
    return read_vtp_surface(file);
  if (ext == "vtk")
    return read_legacy_vtk_surface(file);
  if (ext == "msh")
    return read_msh_surface(file);
  file.fail("is in no known format; surfaces are read from .stl, .off, .obj, .ply, .vtp, .vtk and .msh files");
}

inline Tubular_meshing::internal::Triangle_soup read_triangle_soup(const std::string& name) {
  const Input_file file(name);
  Polygon_soup polygons = read_polygon_soup(file);
  Tubular_meshing::internal::Triangle_soup soup;
  soup.triangles = triangulate(polygons, file);
  soup.points.swap(polygons.points);
  if (extension_of(name) == "stl") // the only format without indices
    merge_points(soup.points, soup.triangles);
  return soup;
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
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
  for (const internal::Coordinates& p : soup.points)
    points.push_back(Point(p[0], p[1], p[2]));
  triangles.swap(soup.triangles);
}

/*! \ingroup PkgTubularMeshingRef
 *
 * reads a surface as a triangle mesh: what read_triangle_soup() yields, with points of equal coordinates merged,
 * triangles without area by two equal corners and repeated triangles dropped, oriented consistently (a closed component
 * may still be inside out), and stitched. Where the surface is not a manifold, points are duplicated.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph`
 * \param file the name of the file, see read_triangle_soup() for the formats
 * \param mesh receives the surface; what it held before is removed
 * \param np named parameters: `vertex_point_map`
 *
 * \exception Input_error as read_triangle_soup() does
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void read_surface(const std::string& file, TriangleMesh& mesh,
                  const NamedParameters& np = CGAL::parameters::default_values()) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::type Vertex_point_map;
  typedef typename boost::property_traits<Vertex_point_map>::value_type Point;

  Tubular_meshing::internal::Triangle_soup soup = internal::read_triangle_soup(file);
  internal::merge_points(soup.points, soup.triangles);
  internal::drop_degenerate_and_duplicate(soup.triangles);
  internal::drop_unused_points(soup.points, soup.triangles);
  if (soup.triangles.empty())
    throw Input_error("The file " + internal::quoted(file) +
                      " contains no triangle with three different corners; check the unit and the precision it was "
                      "exported with.");

  std::vector<Point> points;
  points.reserve(soup.points.size());
  for (const internal::Coordinates& p : soup.points)
    points.push_back(Point(p[0], p[1], p[2]));
  PMP::orient_polygon_soup(points, soup.triangles);
  clear(mesh);
  PMP::polygon_soup_to_polygon_mesh(points, soup.triangles, mesh, CGAL::parameters::default_values(), np);
  PMP::stitch_borders(mesh, np);
}

} // namespace IO
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_IO_READ_SURFACE_H

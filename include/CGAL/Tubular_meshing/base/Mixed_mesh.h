// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_MIXED_MESH_H
#define CGAL_TUBULAR_MESHING_BASE_MIXED_MESH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingBase
 *
 * Elements of one kind: the vertices of each, and its label (a region for cells, a patch for facets).
 */
template <std::size_t N> struct Element_block {
  typedef std::array<std::uint32_t, N> Element;

  std::vector<Element> vertices;
  std::vector<int> label;

  std::size_t size() const { return vertices.size(); }
  bool empty() const { return vertices.empty(); }
  void reserve(std::size_t n) {
    vertices.reserve(n);
    label.reserve(n);
  }
  void push_back(const Element& e, int l) {
    vertices.push_back(e);
    label.push_back(l);
  }
};

/*! \ingroup PkgTubularMeshingBase
 * The name of the point array of a metric: xx, xy, xz, yy, yz, zz. */
constexpr const char* metric_array_name = "metric";

/*! \ingroup PkgTubularMeshingBase
 *
 * Values at the points of a mesh: `components` numbers a point, point after point.
 */
struct Point_array {
  std::string name;
  int components;
  std::vector<double> values; ///< `components` x number of points

  bool is_metric() const { return name == metric_array_name && components == 6; }
};

/*! \ingroup PkgTubularMeshingBase
 *
 * A volume mesh of tetrahedra, pyramids, prisms and hexahedra with a region a cell, together with the facets of its
 * boundary and of the interfaces between regions, with a patch each.
 *
 * Vertices of a cell are numbered so that its volume is positive:
 * - tetrahedron: 3 lies on the side of (0,1,2) from which 0,1,2 turns counterclockwise;
 * - pyramid: base 0,1,2,3 turns counterclockwise seen from the apex 4;
 * - prism: 0,1,2 turns counterclockwise seen from 3,4,5; edges 03, 14, 25 (Gmsh's order; VTK's differs, the writers
 *   know);
 * - hexahedron: 0,1,2,3 turns counterclockwise seen from 4,5,6,7; edges 04, 15, 26, 37.
 *
 * Facets are listed once and turn counterclockwise seen from outside the lumen (from outside the mesh, for the outer
 * patches of a wall). The struct is plain data: the algorithms that make it keep it consistent, and validity_report()
 * says whether it is.
 */
struct Mixed_mesh {
  typedef Point_3 Point;

  std::vector<Point> points;

  Element_block<4> tetrahedra;
  Element_block<5> pyramids;
  Element_block<6> prisms;
  Element_block<8> hexahedra;

  Element_block<3> triangles;
  Element_block<4> quads;

  Label_names region_names;
  Label_names patch_names;
  Patch_ids patch_ids; ///< written with .vtu files

  std::vector<Point_array> point_arrays;

  std::size_t number_of_cells() const { return tetrahedra.size() + pyramids.size() + prisms.size() + hexahedra.size(); }
  std::size_t number_of_facets() const { return triangles.size() + quads.size(); }
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_MIXED_MESH_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_ELEMENT_KINDS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_ELEMENT_KINDS_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL::Tubular_meshing::IO::internal {

// What the formats call the kinds of elements of a Mixed_mesh.
struct Element_kind {
  int dimension;
  std::size_t corners;
  int vtk_type;
  int gmsh_type;
  const char* medit_keyword;
};

constexpr int number_of_element_kinds = 6;
constexpr Element_kind element_kinds[number_of_element_kinds] = {
    {3, 4, 10, 4, "Tetrahedra"}, {3, 5, 14, 7, "Pyramids"}, {3, 6, 13, 6, "Prisms"},
    {3, 8, 12, 5, "Hexahedra"},  {2, 3, 5, 2, "Triangles"}, {2, 4, 9, 3, "Quadrilaterals"},
};

// What VTK and Gmsh call the quadratic elements of a kind, without and with nodes of their quads and middles. VTK has no
// pyramid of 14 nodes.
struct Quadratic_kind {
  int vtk_type, complete_vtk_type;
  int gmsh_type, complete_gmsh_type;
};
constexpr Quadratic_kind quadratic_kinds[number_of_element_kinds] = {
    {24, 24, 11, 11}, {27, 0, 19, 14}, {26, 32, 18, 13}, {25, 29, 17, 12}, {22, 22, 9, 9}, {23, 28, 16, 10}};

inline bool is_quadratic_vtk_type(std::int64_t type) {
  for (const Quadratic_kind& q : quadratic_kinds)
    if (type == q.vtk_type || (type == q.complete_vtk_type && type != 0))
      return true;
  return false;
}
inline bool is_quadratic_gmsh_type(std::int64_t type) {
  for (const Quadratic_kind& q : quadratic_kinds)
    if (type == q.gmsh_type || type == q.complete_gmsh_type)
      return true;
  return false;
}

// The kind of which a member has a value; null if there is none.
template <class Value, class Member> const Element_kind* find_kind(Member Element_kind::*member, const Value& value) {
  for (const Element_kind& k : element_kinds)
    if (value == Value(k.*member))
      return &k;
  return nullptr;
}

// Calls f(block, kind) for the elements of each kind, in the order of element_kinds.
template <class F> void for_each_block(const Mixed_mesh& mesh, F f) {
  f(mesh.tetrahedra, element_kinds[0]);
  f(mesh.pyramids, element_kinds[1]);
  f(mesh.prisms, element_kinds[2]);
  f(mesh.hexahedra, element_kinds[3]);
  f(mesh.triangles, element_kinds[4]);
  f(mesh.quads, element_kinds[5]);
}

// VTK counts the triangles of a prism the other way round. The exchange is its own inverse.
inline std::size_t vtk_corner(const Element_kind& kind, std::size_t i) {
  constexpr std::size_t prism[6] = {0, 2, 1, 3, 5, 4};
  return kind.vtk_type == 13 ? prism[i] : i;
}

template <std::size_t N, class Corners>
void add_element(Element_block<N>& block, const Element_kind& kind, Corners corners, bool vtk_order, int label) {
  typename Element_block<N>::Element e;
  for (std::size_t i = 0; i < N; ++i)
    e[i] = static_cast<std::uint32_t>(corners[vtk_order ? vtk_corner(kind, i) : i]);
  block.push_back(e, label);
}

// Adds an element whose corners, already checked, begin at `corners`.
template <class Corners>
void add_element(Mixed_mesh& mesh, const Element_kind& kind, Corners corners, bool vtk_order, int label) {
  switch (&kind - element_kinds) {
  case 0:
    return add_element(mesh.tetrahedra, kind, corners, vtk_order, label);
  case 1:
    return add_element(mesh.pyramids, kind, corners, vtk_order, label);
  case 2:
    return add_element(mesh.prisms, kind, corners, vtk_order, label);
  case 3:
    return add_element(mesh.hexahedra, kind, corners, vtk_order, label);
  case 4:
    return add_element(mesh.triangles, kind, corners, vtk_order, label);
  default:
    return add_element(mesh.quads, kind, corners, vtk_order, label);
  }
}

// The array in which VMTK keeps the radius at each point of a centerline.
constexpr const char* radius_array_name = "MaximumInscribedSphereRadius";

// A tensor at each point is kept as xx xy xz yy yz zz. Row by row it has nine components, and these are where:
constexpr std::size_t symmetric_component[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
// Medit's order is xx xy yy xz yz zz:
constexpr std::size_t medit_component[6] = {0, 1, 3, 2, 4, 5};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_ELEMENT_KINDS_H

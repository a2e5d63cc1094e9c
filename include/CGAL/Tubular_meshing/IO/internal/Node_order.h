// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_NODE_ORDER_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_NODE_ORDER_H

#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>

#include <array>
#include <cstddef>

namespace CGAL::Tubular_meshing::IO::internal {

/* In which order a format lists the nodes of a quadratic element behind its corners: first those of edges, then, of a
 * complete element, those of its quads and of its middle, which counts as behind the quads. Numbers are those of
 * topology_of(). By the kinds of element_kinds; triangles and quads are listed in one order by all. */
struct Node_order {
  std::array<int, 12> edges[number_of_element_kinds];
  std::array<int, 7> others[number_of_element_kinds];
};

// VTK, XDMF, and svMultiPhysics. The corners of a quadratic wedge are not turned as those of a linear one.
constexpr Node_order vtk_order = {{{0, 1, 2, 3, 4, 5},
                                   {0, 1, 2, 3, 4, 5, 6, 7},
                                   {0, 1, 2, 3, 4, 5, 6, 7, 8},
                                   {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
                                   {0, 1, 2},
                                   {0, 1, 2, 3}},
                                  {{}, {0}, {0, 1, 2}, {5, 3, 2, 4, 0, 1, 6}, {}, {0}}};

// Abaqus and CalculiX, which have no complete elements.
inline constexpr const Node_order& abaqus_order = vtk_order;

// Edges by their corners in ascending order, and so the faces.
constexpr Node_order gmsh_order = {{{0, 1, 2, 3, 5, 4},
                                    {0, 3, 4, 1, 5, 2, 6, 7},
                                    {0, 2, 6, 1, 7, 8, 3, 5, 4},
                                    {0, 3, 8, 1, 9, 2, 10, 11, 4, 7, 5, 6},
                                    {0, 1, 2},
                                    {0, 1, 2, 3}},
                                   {{}, {0}, {0, 2, 1}, {0, 2, 5, 3, 4, 1, 6}, {}, {0}}};

// Upright edges of prisms and hexahedra come before those above; the middle before the quads.
constexpr Node_order exodus_order = {{{0, 1, 2, 3, 4, 5},
                                      {0, 1, 2, 3, 4, 5, 6, 7},
                                      {0, 1, 2, 6, 7, 8, 3, 4, 5},
                                      {0, 1, 2, 3, 8, 9, 10, 11, 4, 5, 6, 7},
                                      {0, 1, 2},
                                      {0, 1, 2, 3}},
                                     {{}, {0}, {0, 1, 2}, {6, 0, 1, 5, 3, 2, 4}, {}, {0}}};

// The sides of hexahedra, round them, before what is below and above.
constexpr Node_order febio_order = {{{0, 1, 2, 3, 4, 5},
                                     {0, 1, 2, 3, 4, 5, 6, 7},
                                     {0, 1, 2, 3, 4, 5, 6, 7, 8},
                                     {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
                                     {0, 1, 2},
                                     {0, 1, 2, 3}},
                                    {{}, {0}, {0, 1, 2}, {2, 3, 4, 5, 0, 1, 6}, {}, {0}}};

// The nodes of an element, which may be linear, in the order of a format.
inline Element_nodes in_order(const Element_nodes& nodes, std::size_t kind, const Node_order& order) {
  const Element_topology& t = topology_of(Element_type(kind));
  Element_nodes result;
  for (std::size_t i = 0; i < t.corners; ++i)
    result.push_back(nodes[i]);
  const std::size_t edges = t.corners + t.number_of_edges;
  for (std::size_t i = t.corners; i < nodes.size; ++i)
    result.push_back(i < edges ? nodes[t.corners + std::size_t(order.edges[kind][i - t.corners])]
                               : nodes[edges + std::size_t(order.others[kind][i - edges])]);
  return result;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_NODE_ORDER_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_EDGE_DIVISION_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_EDGE_DIVISION_H

#include <CGAL/Tubular_meshing/Hexahedra/internal/Vertex_sets.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>

#include <boost/pending/disjoint_sets.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::array<std::uint32_t, 2> Edge_ends;

/* Calls visit(a, b) with the edges of a triangle, or of a quad, in order round it. */
template <std::size_t N, class Visit> void for_each_side(const std::array<std::uint32_t, N>& face, const Visit& visit) {
  for (std::size_t i = 0; i < N; ++i)
    visit(Edge_ends{{face[i], face[(i + 1) % N]}});
}

/* Calls on_triangle(corners) and on_quad(corners) with the faces of all cells and with all facets: those between two
 * cells twice. */
template <class On_triangle, class On_quad>
void for_each_face(const Mixed_mesh& mesh, const On_triangle& on_triangle, const On_quad& on_quad) {
  const auto faces_of = [&](const auto& cells) {
    typedef typename std::decay_t<decltype(cells)>::Element Element;
    typedef Cell_topology<std::tuple_size<Element>::value> Topology;
    for (const Element& c : cells.vertices) {
      for (const Triangle_corners& t : Topology::triangles())
        on_triangle(std::array<std::uint32_t, 3>{{c[t[0]], c[t[1]], c[t[2]]}});
      for (const Quad_corners& q : Topology::quads())
        on_quad(std::array<std::uint32_t, 4>{{c[q[0]], c[q[1]], c[q[2]], c[q[3]]}});
    }
  };
  faces_of(mesh.tetrahedra);
  faces_of(mesh.prisms);
  faces_of(mesh.hexahedra);
  for (const auto& t : mesh.triangles.vertices)
    on_triangle(t);
  for (const auto& q : mesh.quads.vertices)
    on_quad(q);
}

/* Which edges of a mesh without pyramids are divided in two for all of its faces to become quads that conform: those of
 * triangles; and with an edge of a quad, the one across from it. With the faces of a cell that holds for the cell: the
 * four parallel edges of a hexahedron are divided together, and so are the three lateral ones of a prism. */
class Edge_division {
public:
  explicit Edge_division(const Mixed_mesh& mesh)
      : edges_(mesh.points.size(),
               [&](const auto& visit) {
                 const auto sides = [&](const auto& face) { for_each_side(face, visit); };
                 for_each_face(mesh, sides, sides);
               })
      , midpoint_(edges_.size(), 0) {
    boost::disjoint_sets_with_storage<> classes(edges_.size());
    for_each_face(
        mesh, [](const auto&) {},
        [&](const std::array<std::uint32_t, 4>& q) {
          classes.union_set(edges_.number({{q[0], q[1]}}), edges_.number({{q[2], q[3]}}));
          classes.union_set(edges_.number({{q[1], q[2]}}), edges_.number({{q[3], q[0]}}));
        });
    std::vector<char> is_divided(edges_.size(), 0); // of a class, at its representative
    for_each_face(
        mesh,
        [&](const auto& t) {
          for_each_side(t, [&](const Edge_ends& e) { is_divided[classes.find_set(edges_.number(e))] = 1; });
        },
        [](const auto&) {});
    std::uint32_t next = std::uint32_t(mesh.points.size());
    for (std::size_t e = 0; e < edges_.size(); ++e)
      midpoint_[e] = is_divided[classes.find_set(e)] ? next++ : not_divided;
    number_of_midpoints_ = next - std::uint32_t(mesh.points.size());
  }

  bool is_divided(std::uint32_t a, std::uint32_t b) const { return midpoint(a, b) != not_divided; }
  /* The number of the point in the middle of a divided edge; they follow the mesh's own in order. */
  std::uint32_t midpoint(std::uint32_t a, std::uint32_t b) const { return midpoint_[edges_.number({{a, b}})]; }
  std::size_t number_of_midpoints() const { return number_of_midpoints_; }

  /* Calls visit(ends) for the divided edges, in the order of their midpoints. */
  template <class Visit> void for_each_divided(const Visit& visit) const {
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (midpoint_[e] != not_divided)
        visit(edges_[e]);
  }

private:
  static constexpr std::uint32_t not_divided = std::uint32_t(-1);

  Vertex_sets<2> edges_;
  std::vector<std::uint32_t> midpoint_;
  std::size_t number_of_midpoints_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_EDGE_DIVISION_H

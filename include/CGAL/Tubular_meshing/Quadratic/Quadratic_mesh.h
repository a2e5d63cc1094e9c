// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_MESH_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_MESH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuadratic
 * The kinds of elements of a Mixed_mesh, cells first. */
enum class Element_type { tetrahedron, pyramid, prism, hexahedron, triangle, quad };

/*! \ingroup PkgTubularMeshingQuadratic
 *
 * The edges of an element, and those of its faces that are quads, by its corners. Their order is that of the nodes
 * behind the corners of a quadratic element: the edges' nodes, then those of the quads, then the one in the middle of a
 * hexahedron. */
struct Element_topology {
  std::size_t corners;
  std::size_t number_of_edges;
  std::array<std::array<int, 2>, 12> edges;
  std::size_t number_of_quads;
  std::array<std::array<int, 4>, 6> quads;
};

/*! \ingroup PkgTubularMeshingQuadratic
 * The topology of a kind of elements. */
const Element_topology& topology_of(Element_type type);

/*! \ingroup PkgTubularMeshingQuadratic
 * The nodes of an element. */
struct Element_nodes {
  std::array<std::uint32_t, 27> node;
  std::size_t size = 0;

  const std::uint32_t* begin() const { return node.data(); }
  const std::uint32_t* end() const { return node.data() + size; }
  std::uint32_t operator[](std::size_t i) const { return node[i]; }
  void push_back(std::uint32_t n) { node[size++] = n; }
};

/*! \ingroup PkgTubularMeshingQuadratic
 *
 * A mesh of quadratic elements: a Mixed_mesh, which has the corners, the elements and all labels, and a node on each
 * edge; in a complete mesh also one on each quad and in each hexahedron. Elements are
 *
 * |             | serendipity | complete |
 * |-------------|-------------|----------|
 * | tetrahedron | 10 nodes    | 10       |
 * | pyramid     | 13          | 14       |
 * | prism       | 15          | 18       |
 * | hexahedron  | 20          | 27       |
 * | triangle    | 6           | 6        |
 * | quad        | 8           | 9        |
 *
 * Nodes are numbered: corners, edges, quads, hexahedra. Elements that share an edge or a quad share its node, as they
 * are found by the corners. make_quadratic_mesh() makes such a mesh.
 */
struct Quadratic_mesh {
  typedef std::array<std::uint32_t, 4> Quad; ///< corners, ascending

  Mixed_mesh linear; ///< its points are the corners

  std::vector<std::uint32_t> first_edge; ///< of each corner, to corners of higher numbers; and behind the last
  std::vector<std::uint32_t> edge_end;   ///< the higher corner of each edge, ascending for each lower one
  std::vector<Point_3> edge_points;

  bool is_complete = false;
  std::vector<Quad> quads;           ///< all of cells and facets, ascending; of a complete mesh
  std::vector<Point_3> quad_points;  ///< of a complete mesh
  std::vector<Point_3> inner_points; ///< of the hexahedra of a complete mesh

  std::size_t number_of_nodes() const {
    return linear.points.size() + edge_points.size() + quad_points.size() + inner_points.size();
  }
  const Point_3& node(std::size_t i) const {
    for (const std::vector<Point_3>* points : {&linear.points, &edge_points, &quad_points}) {
      if (i < points->size())
        return (*points)[i];
      i -= points->size();
    }
    return inner_points[i];
  }

  /// The number among the edges of the one between two corners; number of edges if there is none.
  std::size_t edge(std::uint32_t a, std::uint32_t b) const;

  /// The number among the quads of the one with these corners, in any order; number of quads if there is none.
  std::size_t quad(Quad corners) const;

  /*! The nodes of an element: its corners, and those behind them in the order of topology_of().
   * \param type its kind
   * \param corners its corners
   * \param number which it is of the mesh's elements of its kind */
  Element_nodes nodes(Element_type type, const std::uint32_t* corners, std::size_t number) const;
};

/*! \ingroup PkgTubularMeshingQuadratic
 *
 * makes a mesh of quadratic elements whose edges are straight: each node is the mean of the corners that it lies between.
 * O(n log n). make_quadratic_mesh() curves them.
 *
 * \param linear cells and facets of any kinds
 * \param complete_elements whether quads and hexahedra have nodes of their own
 * \param number_of_threads 0: all cores
 */
Quadratic_mesh straight_quadratic_mesh(Mixed_mesh linear, bool complete_elements = false, int number_of_threads = 0);

namespace internal {

/* The edges, and in a complete mesh the quads, of all elements; the points are not yet there. */
void add_edges_and_quads(Quadratic_mesh& mesh, int threads);

/* Calls f(type, block) for each kind of cells, and of facets. */
template <class F> void for_each_block_of_cells(const Mixed_mesh& mesh, const F& f) {
  f(Element_type::tetrahedron, mesh.tetrahedra);
  f(Element_type::pyramid, mesh.pyramids);
  f(Element_type::prism, mesh.prisms);
  f(Element_type::hexahedron, mesh.hexahedra);
}
template <class F> void for_each_block_of_facets(const Mixed_mesh& mesh, const F& f) {
  f(Element_type::triangle, mesh.triangles);
  f(Element_type::quad, mesh.quads);
}

} // namespace internal
} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_MESH_H

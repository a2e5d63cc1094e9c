// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_MESH_NODES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_MESH_NODES_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>
#include <CGAL/Tubular_meshing/IO/internal/Node_order.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/base/Cell_array.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* The nodes of a mesh, linear or quadratic, for writers: what lies beside what is a matter of the corners. With values of
 * its cells, if there are any. */
class Mesh_nodes {
public:
  Mesh_nodes(const Mixed_mesh& mesh, const std::vector<Cell_array>* cell_arrays = nullptr)
      : mesh_(mesh)
      , quadratic_(nullptr)
      , cell_arrays_(cell_arrays) {}
  Mesh_nodes(const Quadratic_mesh& mesh, const std::vector<Cell_array>* cell_arrays = nullptr)
      : mesh_(mesh.linear)
      , quadratic_(&mesh)
      , cell_arrays_(cell_arrays) {}

  const Mixed_mesh& mesh() const { return mesh_; }
  const std::vector<Cell_array>& cell_arrays() const {
    static const std::vector<Cell_array> none;
    return cell_arrays_ == nullptr ? none : *cell_arrays_;
  }
  bool is_quadratic() const { return quadratic_ != nullptr; }
  bool is_complete() const { return is_quadratic() && quadratic_->is_complete; }
  std::size_t size() const { return is_quadratic() ? quadratic_->number_of_nodes() : mesh_.points.size(); }
  const Point_3& point(std::size_t i) const { return is_quadratic() ? quadratic_->node(i) : mesh_.points[i]; }

  // Of an element of a kind of element_kinds, the number-th of its kind.
  Element_nodes of(std::size_t kind, const std::uint32_t* corners, std::size_t number, const Node_order& order) const {
    if (is_quadratic())
      return in_order(quadratic_->nodes(Element_type(kind), corners, number), kind, order);
    Element_nodes nodes;
    for (std::size_t i = 0; i < element_kinds[kind].corners; ++i)
      nodes.push_back(corners[i]);
    return nodes;
  }
  // Calls f(node) for them.
  template <class F>
  void for_each_of(std::size_t kind, const std::uint32_t* corners, std::size_t number, const Node_order& order,
                   const F& f) const {
    if (is_quadratic())
      for (std::uint32_t node : of(kind, corners, number, order))
        f(node);
    else
      for (std::size_t i = 0; i < element_kinds[kind].corners; ++i)
        f(corners[i]);
  }
  Element_nodes of_cell(const Numbered_cells& cells, std::size_t cell, const Node_order& order) const {
    const std::size_t kind = cells.kind(cell);
    return of(kind, cells.corners(cell).first, cell - cells.first_cell(kind), order);
  }
  Element_nodes of_face(const Face& face, const Node_order& order) const {
    return of(number_of_corners(face) == 3 ? 4 : 5, face.data(), 0, order);
  }
  // How many an element of a kind has.
  std::size_t number(std::size_t kind) const {
    const Element_topology& t = topology_of(Element_type(kind));
    return t.corners + (is_quadratic() ? t.number_of_edges : 0) +
           (is_complete() ? t.number_of_quads + (kind == 3 ? 1 : 0) : 0);
  }

  // A point array at all nodes: behind the corners, the means of those that a node lies between.
  std::vector<double> values(const Point_array& array) const {
    std::vector<double> result = array.values;
    if (!is_quadratic())
      return result;
    const std::size_t components = std::size_t(array.components);
    const auto add = [&](const std::uint32_t* corners, std::size_t n) {
      for (std::size_t k = 0; k < components; ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i)
          sum += array.values[corners[i] * components + k];
        result.push_back(sum / double(n));
      }
    };
    for (std::uint32_t a = 0; a + 1 < quadratic_->first_edge.size(); ++a)
      for (std::size_t e = quadratic_->first_edge[a]; e < quadratic_->first_edge[a + 1]; ++e) {
        const std::uint32_t ends[2] = {a, quadratic_->edge_end[e]};
        add(ends, 2);
      }
    for (const auto& q : quadratic_->quads)
      add(q.data(), 4);
    if (is_complete())
      for (const auto& h : mesh_.hexahedra.vertices)
        add(h.data(), 8);
    return result;
  }

private:
  const Mixed_mesh& mesh_;
  const Quadratic_mesh* quadratic_;
  const std::vector<Cell_array>* cell_arrays_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_MESH_NODES_H

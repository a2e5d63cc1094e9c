// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_CURVED_NODES_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_CURVED_NODES_H

#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/Quadratic/internal/Quadratic_cell.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A vector of a node, of which a part counts: all of it, a half, a quarter, an eighth, or nothing. */
class Held_vectors {
public:
  explicit Held_vectors(std::vector<Vector_3d> vectors)
      : vectors_(std::move(vectors))
      , part_(vectors_.size(), 1) {}

  std::size_t size() const { return vectors_.size(); }
  Vector_3d operator[](std::size_t i) const { return part_[i] * vectors_[i]; }
  bool is_there(std::size_t i) const { return part_[i] > 0 && squared_norm(vectors_[i]) > 0; }
  bool is_held_back(std::size_t i) const { return part_[i] < 1 && squared_norm(vectors_[i]) > 0; }
  void hold_back(std::size_t i) { part_[i] = part_[i] > 0.2 ? part_[i] / 2 : 0; }

private:
  std::vector<Vector_3d> vectors_;
  std::vector<double> part_;
};

/* The nodes of a quadratic mesh as they are to be: corners by their shifts, the others by how far they are from where
 * straight edges and what these imply would have them. */
class Curved_nodes {
public:
  Curved_nodes(const Quadratic_mesh& mesh, std::vector<Vector_3d> shifts, std::vector<Vector_3d> bends,
               std::vector<Vector_3d> bumps)
      : mesh_(mesh)
      , shifts(std::move(shifts))
      , bends(std::move(bends))
      , bumps(std::move(bumps)) {}

  Vector_3d corner(std::uint32_t v) const { return Vector_3d(mesh_.linear.points[v]) + shifts[v]; }
  Vector_3d middle_of_edge(std::uint32_t a, std::uint32_t b, std::size_t edge) const {
    return 0.5 * (corner(a) + corner(b)) + bends[edge];
  }

  // With those nodes that are implied.
  Cell_points cell(Element_type type, const std::uint32_t* v) const {
    const Element_topology& t = topology_of(type);
    Cell_points result;
    result.type = type;
    for (std::size_t k = 0; k < t.corners; ++k)
      result.point[k] = corner(v[k]);
    for (std::size_t k = 0; k < t.number_of_edges; ++k) {
      const std::size_t a = std::size_t(t.edges[k][0]), b = std::size_t(t.edges[k][1]);
      result.point[t.corners + k] = 0.5 * (result.point[a] + result.point[b]) + bends[mesh_.edge(v[a], v[b])];
    }
    result.imply_quads();
    for (std::size_t q = 0; q < t.number_of_quads && bumps.size() > 0; ++q)
      result.point[t.corners + t.number_of_edges + q] += bumps[quad_of(t, v, q)];
    result.imply_middle();
    return result;
  }

  bool is_straight(Element_type type, const std::uint32_t* v) const {
    bool result = true;
    for_each_node(type, v,
                  [&](bool is_of_quad, std::size_t i) { result &= !(is_of_quad ? bumps : bends).is_there(i); });
    return result;
  }

  // Calls f(whether it is of a quad, number) for the edges of an element and the quads that have a node.
  template <class F> void for_each_node(Element_type type, const std::uint32_t* v, const F& f) const {
    const Element_topology& t = topology_of(type);
    for (std::size_t k = 0; k < t.number_of_edges; ++k)
      f(false, mesh_.edge(v[std::size_t(t.edges[k][0])], v[std::size_t(t.edges[k][1])]));
    for (std::size_t q = 0; q < t.number_of_quads && bumps.size() > 0; ++q)
      f(true, quad_of(t, v, q));
  }

private:
  std::size_t quad_of(const Element_topology& t, const std::uint32_t* v, std::size_t q) const {
    Quadratic_mesh::Quad corners;
    for (std::size_t i = 0; i < 4; ++i)
      corners[i] = v[std::size_t(t.quads[q][i])];
    return mesh_.quad(corners);
  }

  const Quadratic_mesh& mesh_;

public:
  Held_vectors shifts, bends;
  Held_vectors bumps; // of quads; none of serendipity elements
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_CURVED_NODES_H

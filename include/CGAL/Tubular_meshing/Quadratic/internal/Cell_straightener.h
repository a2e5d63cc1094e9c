// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_CELL_STRAIGHTENER_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_CELL_STRAIGHTENER_H

#include <CGAL/Tubular_meshing/Quadratic/internal/Curved_nodes.h>
#include <CGAL/Tubular_meshing/Quadratic/internal/Quadratic_cell.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Makes the cells of a curved mesh valid: the nodes of one whose Jacobian is not proved to be positive go half of the
 * way back to where straight edges have them, and again, until they are there; and after them its corners to where they
 * came from. So do the corners of a thin tetrahedron that turns over between them, though it may be valid with its
 * curved edges: programs look at its corners alone. Cells that share such a node change with it, and are looked at
 * again. */
class Cell_straightener {
public:
  Cell_straightener(const Quadratic_mesh& mesh, Curved_nodes& nodes, int threads)
      : mesh_(mesh)
      , nodes_(nodes)
      , threads_(threads) {
    for_each_block_of_cells(mesh.linear, [&](Element_type type, const auto& block) {
      for (const auto& v : block.vertices)
        cells_.push_back({type, v.data()});
    });
  }

  void run() {
    std::vector<std::uint32_t> suspects(cells_.size());
    for (std::size_t i = 0; i < suspects.size(); ++i)
      suspects[i] = std::uint32_t(i);
    was_bad_.assign(cells_.size(), 0);
    cannot_.assign(cells_.size(), 0);
    while (!suspects.empty()) { // each round holds back what can be so four times, or gives a cell up
      const std::vector<std::uint32_t> bad = bad_ones(suspects, &Cell_straightener::is_valid);
      const std::vector<std::uint32_t> turned = bad_ones(suspects, &Cell_straightener::is_upright);
      changed_.assign(mesh_.linear.points.size(), 0);
      for (std::uint32_t c : turned)
        cannot_[c] = !hold_back_corners(cells_[c]); // such a one is not looked at again
      for (std::uint32_t c : bad) {
        was_bad_[c] = 1;
        cannot_[c] = !hold_back(cells_[c]);
      }
      suspects = cells_of_changed();
    }
  }

  std::size_t number_relaxed() const { return std::size_t(std::count(was_bad_.begin(), was_bad_.end(), 1)); }
  std::size_t number_straightened() const {
    std::size_t n = 0;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      n += was_bad_[c] && nodes_.is_straight(cells_[c].type, cells_[c].corners);
    return n;
  }
  // The numbers of a corner of each cell that is not valid.
  std::vector<std::uint32_t> invalid_ones() const {
    std::vector<std::uint32_t> suspects;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (was_bad_[c])
        suspects.push_back(std::uint32_t(c));
    std::vector<std::uint32_t> result;
    for (std::uint32_t c : bad_ones(suspects, &Cell_straightener::is_valid))
      result.push_back(cells_[c].corners[0]);
    return result;
  }

private:
  struct Cell {
    Element_type type;
    const std::uint32_t* corners;
  };

  std::vector<std::uint32_t> bad_ones(const std::vector<std::uint32_t>& suspects,
                                      bool (Cell_straightener::*is_good)(const Cell&) const) const {
    std::vector<char> is_bad(suspects.size(), 0);
    for_each_range(suspects.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        is_bad[i] = !(this->*is_good)(cells_[suspects[i]]);
    });
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < suspects.size(); ++i)
      if (is_bad[i])
        result.push_back(suspects[i]);
    return result;
  }

  bool is_valid(const Cell& c) const {
    if (c.type != Element_type::tetrahedron || !nodes_.is_straight(c.type, c.corners))
      return Quadratic_cell(nodes_.cell(c.type, c.corners)).validity() == Cell_validity::valid;
    return is_upright(c);
  }

  // Whether a tetrahedron has a positive volume with straight edges.
  bool is_upright(const Cell& c) const {
    if (c.type != Element_type::tetrahedron)
      return true;
    const Vector_3d a = nodes_.corner(c.corners[0]);
    return dot(cross(nodes_.corner(c.corners[1]) - a, nodes_.corner(c.corners[2]) - a),
               nodes_.corner(c.corners[3]) - a) > 0;
  }

  // Whether there was something to hold back. A node that two bad cells share goes back once a round for each.
  bool hold_back(const Cell& cell) {
    bool any = false;
    nodes_.for_each_node(cell.type, cell.corners, [&](bool is_of_quad, std::size_t i) {
      Held_vectors& vectors = is_of_quad ? nodes_.bumps : nodes_.bends;
      if (!vectors.is_there(i))
        return;
      vectors.hold_back(i);
      any = true;
    });
    if (!any)
      return hold_back_corners(cell);
    mark_changed(cell);
    return true;
  }

  bool hold_back_corners(const Cell& cell) {
    bool any = false;
    for (std::size_t k = 0; k < topology_of(cell.type).corners; ++k)
      if (nodes_.shifts.is_there(cell.corners[k])) {
        nodes_.shifts.hold_back(cell.corners[k]);
        any = true;
      }
    if (any)
      mark_changed(cell);
    return any;
  }

  void mark_changed(const Cell& cell) {
    for (std::size_t k = 0; k < topology_of(cell.type).corners; ++k)
      changed_[cell.corners[k]] = 1;
  }

  std::vector<std::uint32_t> cells_of_changed() const {
    std::vector<std::uint32_t> result;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const std::size_t n = topology_of(cells_[c].type).corners;
      bool touched = false;
      for (std::size_t k = 0; k < n && !touched; ++k)
        touched = changed_[cells_[c].corners[k]] != 0;
      if (touched && !cannot_[c])
        result.push_back(std::uint32_t(c));
    }
    return result;
  }

  const Quadratic_mesh& mesh_;
  Curved_nodes& nodes_;
  int threads_;
  std::vector<Cell> cells_;
  std::vector<char> was_bad_, cannot_, changed_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_CELL_STRAIGHTENER_H

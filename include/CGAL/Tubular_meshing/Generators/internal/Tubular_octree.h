// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_TUBULAR_OCTREE_H
#define CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_TUBULAR_OCTREE_H

#include <CGAL/Tubular_meshing/Generators/Tubular_distance_function.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* An octree that is refined near the surface of tubes, to cells smaller than the local radius, and balanced: cells that
 * share a face or an edge differ by one level at most. Linear in the number of cells, hashed.
 *
 * Cells have integer coordinates at their level, lattice points integer coordinates in half cells of the deepest
 * level that the keys allow, so that corners, edge midpoints and centres all have some. */
class Tubular_octree {
public:
  typedef std::array<std::int64_t, 3> Lattice_point;
  struct Cell {
    int level;
    std::array<std::int64_t, 3> at;
  };

  static constexpr int deepest = 17;

  Tubular_octree(const Tubular_distance_function& function, double cell_size_over_radius) {
    const std::array<Vector_3d, 2> box = function.bounding_box();
    const Vector_3d size = box[1] - box[0];
    // A little off, and odd, so that a symmetric shape does not meet the lattice everywhere at once.
    size_ = 1.0731 * (std::max)({size.x, size.y, size.z});
    const Vector_3d center = 0.5 * (box[0] + box[1]);
    origin_ = center - Vector_3d(0.5011 * size_, 0.4993 * size_, 0.5007 * size_);
    std::vector<Cell> cells = {Cell{0, {{0, 0, 0}}}};
    refine(function, cell_size_over_radius, cells);
    balance(cells);
    std::sort(leaves_.begin(), leaves_.end(), [](const Cell& a, const Cell& b) { return key(a) < key(b); });
  }

  const std::vector<Cell>& leaves() const { return leaves_; }

  bool is_divided(const Cell& c) const { return divided_.count(key(c)) != 0; }

  double size(const Cell& c) const { return std::ldexp(size_, -c.level); }

  /// The cell's corner (0, 0, 0) in lattice coordinates, and the lattice length of half its edge.
  Lattice_point corner(const Cell& c) const {
    const std::int64_t step = 2 * half_edge(c);
    return {{c.at[0] * step, c.at[1] * step, c.at[2] * step}};
  }
  std::int64_t half_edge(const Cell& c) const { return std::int64_t(1) << (deepest - c.level); }

  Vector_3d position(const Lattice_point& p) const {
    const double unit = std::ldexp(size_, -deepest - 1);
    return origin_ + unit * Vector_3d(double(p[0]), double(p[1]), double(p[2]));
  }

  Vector_3d center(const Cell& c) const {
    const std::int64_t h = half_edge(c);
    const Lattice_point p = corner(c);
    return position({{p[0] + h, p[1] + h, p[2] + h}});
  }

  static Cell neighbor(const Cell& c, int dx, int dy, int dz) {
    return Cell{c.level, {{c.at[0] + dx, c.at[1] + dy, c.at[2] + dz}}};
  }

private:
  // Coordinates outside the root, from -1 to 2^level, keep distinct keys: nothing there is ever divided.
  static std::uint64_t key(const Cell& c) {
    std::uint64_t k = std::uint64_t(c.level);
    for (std::int64_t x : c.at)
      k = (k << 19) | std::uint64_t(x + 1);
    return k;
  }

  static std::array<Cell, 8> children(const Cell& c) {
    std::array<Cell, 8> result;
    for (int i = 0; i < 8; ++i)
      result[std::size_t(i)] =
          Cell{c.level + 1, {{2 * c.at[0] + (i & 1), 2 * c.at[1] + (i >> 1 & 1), 2 * c.at[2] + (i >> 2)}}};
    return result;
  }

  // The leaves of the unbalanced tree are left in `cells`.
  void refine(const Tubular_distance_function& function, double ratio, std::vector<Cell>& cells) {
    std::vector<Cell> leaves;
    while (!cells.empty()) {
      const Cell c = cells.back();
      cells.pop_back();
      const double edge = size(c);
      if (!function.has_surface_near(center(c), 0.8661 * edge, edge / ratio)) {
        leaves.push_back(c);
        continue;
      }
      if (c.level == deepest)
        throw Meshing_error("the radii of the skeleton differ too much from its size: a tube is thinner than 1/100,000 "
                            "of it; leave the thinnest branches out.");
      divide(c, cells);
    }
    cells.swap(leaves);
  }

  void divide(const Cell& c, std::vector<Cell>& cells) {
    divided_.insert(key(c));
    for (const Cell& child : children(c))
      cells.push_back(child);
  }

  // A leaf must not touch, by face or edge, a cell two levels deeper: the ancestors of its neighbours must be divided.
  void balance(std::vector<Cell>& cells) {
    std::vector<Cell> pending = cells;
    while (!pending.empty()) {
      const Cell c = pending.back();
      pending.pop_back();
      if (c.level < 2)
        continue;
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dz = -1; dz <= 1; ++dz)
            if (std::abs(dx) + std::abs(dy) + std::abs(dz) <= 2)
              ensure_exists(parent(neighbor(c, dx, dy, dz)), pending);
    }
    // Leaves are the undivided children of divided cells.
    for (const Cell& c : cells)
      collect_leaves(c);
  }

  static Cell parent(const Cell& c) { return Cell{c.level - 1, {{c.at[0] >> 1, c.at[1] >> 1, c.at[2] >> 1}}}; }

  bool is_inside(const Cell& c) const {
    const std::int64_t n = std::int64_t(1) << c.level;
    return std::all_of(c.at.begin(), c.at.end(), [n](std::int64_t x) { return x >= 0 && x < n; });
  }

  void ensure_exists(const Cell& c, std::vector<Cell>& pending) {
    if (!is_inside(c) || c.level == 0)
      return;
    const Cell p = parent(c);
    if (divided_.count(key(p)))
      return;
    ensure_exists(p, pending);
    divide(p, pending);
  }

  void collect_leaves(const Cell& c) {
    if (!divided_.count(key(c))) {
      leaves_.push_back(c);
      return;
    }
    for (const Cell& child : children(c))
      collect_leaves(child);
  }

  double size_;
  Vector_3d origin_;
  std::unordered_set<std::uint64_t> divided_;
  std::vector<Cell> leaves_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_TUBULAR_OCTREE_H

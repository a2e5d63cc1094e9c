// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_USED_POINTS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_USED_POINTS_H

#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* The points of those cells that have one of some labels, counted in their order: solvers take no point that no cell
 * has. Four bytes a point, or none where all points are used. */
class Used_points {
public:
  // counts(label): whether a region does
  template <class Counts> Used_points(const Mesh_nodes& nodes, const Counts& counts) {
    std::vector<bool> is_used(nodes.size(), false);
    const Mixed_mesh& mesh = nodes.mesh();
    const auto mark = [&](std::size_t kind, const auto& block) {
      for (std::size_t i = 0; i < block.size(); ++i) {
        if (!counts(block.label[i]))
          continue;
        for (std::uint32_t v : block.vertices[i])
          is_used[v] = true;
        if (nodes.is_quadratic())
          for (std::uint32_t v : nodes.of(kind, block.vertices[i].data(), i, vtk_order))
            is_used[v] = true;
      }
    };
    mark(0, mesh.tetrahedra);
    mark(1, mesh.pyramids);
    mark(2, mesh.prisms);
    mark(3, mesh.hexahedra);
    size_ = std::uint32_t(std::count(is_used.begin(), is_used.end(), true));
    if (size_ == is_used.size())
      return;
    number_.assign(is_used.size(), unused);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < is_used.size(); ++i)
      if (is_used[i])
        number_[i] = next++;
  }

  std::size_t size() const { return size_; }
  bool contain(std::size_t point) const { return number_.empty() || number_[point] != unused; }
  std::uint32_t number(std::size_t point) const { return number_.empty() ? std::uint32_t(point) : number_[point]; }

private:
  static constexpr std::uint32_t unused = std::uint32_t(-1);
  std::vector<std::uint32_t> number_; // empty: all are used
  std::uint32_t size_ = 0;
};

inline bool any_region(int) {
  return true;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_USED_POINTS_H

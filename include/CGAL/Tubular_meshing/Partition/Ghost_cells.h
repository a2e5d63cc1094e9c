// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PARTITION_GHOST_CELLS_H
#define CGAL_TUBULAR_MESHING_PARTITION_GHOST_CELLS_H

#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPartition
 *
 * One layer of cells around each part of a partition: those of other parts that share a point with it, as VTK and Gmsh
 * count them. And which part a point belongs to: of those that have it, the lowest.
 *
 * O(n log n); memory for the points, and for the cells between parts. */
class Ghost_cells {
public:
  Ghost_cells(const Mixed_mesh& mesh, const Cell_partition& partition)
      : owner_(mesh.points.size(), no_part)
      , ghosts_(partition.number_of_parts) {
    const internal::cells::Numbered_cells cells(mesh);
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (std::uint32_t v : cells.corners(c))
        owner_[v] = (std::min)(owner_[v], partition.part[c]);
    list_sharing_parts(cells, partition);
    std::vector<std::uint32_t> others;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      others.clear();
      for (std::uint32_t v : cells.corners(c))
        if (is_shared_[v])
          add_parts_at(v, others);
      std::sort(others.begin(), others.end());
      others.erase(std::unique(others.begin(), others.end()), others.end());
      for (std::uint32_t p : others)
        if (p != partition.part[c])
          ghosts_[p].push_back(std::uint32_t(c));
    }
  }

  static constexpr std::uint32_t no_part = std::uint32_t(-1);

  /*! The ghost cells of a part, in the order of the mesh. */
  const std::vector<std::uint32_t>& of_part(std::size_t part) const { return ghosts_[part]; }

  /*! The lowest part that has the point; `no_part` where no cell has it. */
  std::uint32_t owner(std::size_t point) const { return owner_[point]; }

private:
  typedef std::pair<std::uint32_t, std::uint32_t> Point_and_part;

  // Those that have a point beside its owner.
  void list_sharing_parts(const internal::cells::Numbered_cells& cells, const Cell_partition& partition) {
    is_shared_.assign(owner_.size(), false);
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (std::uint32_t v : cells.corners(c))
        if (owner_[v] != partition.part[c]) {
          is_shared_[v] = true;
          sharing_.emplace_back(v, partition.part[c]);
        }
    std::sort(sharing_.begin(), sharing_.end());
    sharing_.erase(std::unique(sharing_.begin(), sharing_.end()), sharing_.end());
  }

  void add_parts_at(std::uint32_t point, std::vector<std::uint32_t>& parts) const {
    parts.push_back(owner_[point]);
    for (auto s = std::lower_bound(sharing_.begin(), sharing_.end(), Point_and_part(point, 0));
         s != sharing_.end() && s->first == point; ++s)
      parts.push_back(s->second);
  }

  std::vector<std::uint32_t> owner_;
  std::vector<bool> is_shared_;
  std::vector<Point_and_part> sharing_;
  std::vector<std::vector<std::uint32_t>> ghosts_;
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PARTITION_GHOST_CELLS_H

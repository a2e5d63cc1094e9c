// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_PART_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_PART_H

#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* The cells of each part of a mesh, in the order of the mesh, and the place of each cell among those of its part. */
class Cells_by_part {
public:
  explicit Cells_by_part(const Cell_partition& partition)
      : first_(partition.number_of_parts + 1, 0)
      , cells_(partition.part.size())
      , place_(partition.part.size()) {
    for (std::uint32_t p : partition.part)
      ++first_[p + std::size_t(1)];
    for (std::size_t p = 1; p < first_.size(); ++p)
      first_[p] += first_[p - 1];
    std::vector<std::size_t> next = first_;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const std::uint32_t p = partition.part[c];
      place_[c] = std::uint32_t(next[p] - first_[p]);
      cells_[next[p]++] = std::uint32_t(c);
    }
  }

  struct Range {
    const std::uint32_t *first, *last;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
    std::size_t size() const { return std::size_t(last - first); }
    std::uint32_t operator[](std::size_t i) const { return first[i]; }
  };

  Range of_part(std::size_t p) const { return {cells_.data() + first_[p], cells_.data() + first_[p + 1]}; }
  std::uint32_t place(std::size_t cell) const { return place_[cell]; }

private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> cells_, place_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_PART_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_REGION_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_REGION_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>

#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// Cells of one kind in one region.
struct Cells_of_region {
  int region;
  std::size_t kind; // as of Numbered_cells
  std::size_t size;
};

/* The cells by region and then by kind: the order in which formats list them that have blocks of a kind. O(n + r log b)
 * for r runs of cells that are alike, and b blocks. */
class Cells_by_region {
public:
  typedef boost::iterator_range<const std::uint32_t*> Cells;

  explicit Cells_by_region(const Numbered_cells& cells) {
    std::map<std::pair<int, std::size_t>, std::size_t> sizes;
    for_each_run(cells, [&](std::pair<int, std::size_t> block, std::size_t first, std::size_t last) {
      sizes[block] += last - first;
    });
    std::map<std::pair<int, std::size_t>, std::size_t> next;
    for (const auto& s : sizes) {
      next[s.first] = first_.back();
      blocks_.push_back({s.first.first, s.first.second, s.second});
      first_.push_back(first_.back() + s.second);
    }
    cells_.resize(cells.size());
    for_each_run(cells, [&](std::pair<int, std::size_t> block, std::size_t first, std::size_t last) {
      std::size_t& place = next.at(block);
      for (std::size_t c = first; c < last; ++c)
        cells_[place++] = std::uint32_t(c);
    });
  }

  const std::vector<Cells_of_region>& blocks() const { return blocks_; }
  bool is_first_of_region(std::size_t block) const {
    return block == 0 || blocks_[block - 1].region != blocks_[block].region;
  }

  // The cells of a block, in order.
  Cells cells_of(std::size_t block) const { return {cells_.data() + first_[block], cells_.data() + first_[block + 1]}; }

  // Where each cell is in that order, from 0.
  std::vector<std::uint32_t> numbers() const {
    std::vector<std::uint32_t> number(cells_.size());
    for (std::size_t i = 0; i < cells_.size(); ++i)
      number[cells_[i]] = std::uint32_t(i);
    return number;
  }

private:
  // Calls f((region, kind), first, behind the last) for cells one after the other that have the same.
  template <class F> static void for_each_run(const Numbered_cells& cells, F f) {
    for (std::size_t first = 0, last = 0; first < cells.size(); first = last) {
      const std::pair<int, std::size_t> block(cells.region(first), cells.kind(first));
      do
        ++last;
      while (last < cells.size() && cells.kind(last) == block.second && cells.region(last) == block.first);
      f(block, first, last);
    }
  }

  std::vector<Cells_of_region> blocks_;
  std::vector<std::size_t> first_ = {0}; // of each block, and behind the last, in cells_
  std::vector<std::uint32_t> cells_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_REGION_H

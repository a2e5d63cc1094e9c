// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_REGION_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_REGION_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>

#include <cstddef>
#include <cstdint>
#include <limits>
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

/* Cells by region and then by kind: the order in which formats list them that have blocks of a kind. Mostly it is the
 * order in the mesh, and nothing is kept then. O(n + r log b) for r runs of cells that are alike, and b blocks. */
class Cells_by_region {
public:
  // Where each cell is in that order, from 0.
  class Numbers {
  public:
    std::uint32_t operator[](std::size_t cell) const { return number_.empty() ? std::uint32_t(cell) : number_[cell]; }

  private:
    friend Cells_by_region;
    std::vector<std::uint32_t> number_; // empty: as in the mesh
  };

  // The cells in that order.
  class Listed {
  public:
    std::uint32_t operator[](std::size_t place) const { return cells_.empty() ? std::uint32_t(place) : cells_[place]; }

  private:
    friend Cells_by_region;
    std::vector<std::uint32_t> cells_; // empty: as in the mesh
  };

  explicit Cells_by_region(const Numbered_cells& cells)
      : cells_(cells) {
    std::map<std::pair<int, std::size_t>, std::size_t> sizes;
    std::pair<int, std::size_t> last((std::numeric_limits<int>::min)(), 0);
    for_each_run([&](std::pair<int, std::size_t> block, std::size_t first, std::size_t end) {
      sizes[block] += end - first;
      is_in_order_ = is_in_order_ && !(block < last);
      last = block;
    });
    for (const auto& s : sizes) {
      blocks_.push_back({s.first.first, s.first.second, s.second});
      first_.push_back(first_.back() + s.second);
    }
  }

  const std::vector<Cells_of_region>& blocks() const { return blocks_; }
  bool is_first_of_region(std::size_t block) const {
    return block == 0 || blocks_[block - 1].region != blocks_[block].region;
  }
  std::size_t number_of_cells() const { return first_.back(); }

  // The place of the first cell of a block; of the number of blocks, that behind the last.
  std::size_t first_place(std::size_t block) const { return first_[block]; }

  Listed listed() const {
    Listed result;
    if (!is_in_order_)
      result.cells_.resize(number_of_cells());
    for_each_place(result.cells_,
                   [&](std::size_t cell, std::size_t place) { result.cells_[place] = std::uint32_t(cell); });
    return result;
  }

  Numbers numbers() const {
    Numbers result;
    if (!is_in_order_)
      result.number_.resize(number_of_cells());
    for_each_place(result.number_,
                   [&](std::size_t cell, std::size_t place) { result.number_[cell] = std::uint32_t(place); });
    return result;
  }

private:
  // Calls f((region, kind), first, behind the last) for cells one after the other that have the same.
  template <class F> void for_each_run(F f) const {
    for (std::size_t first = 0, last = 0; first < cells_.size(); first = last) {
      const std::pair<int, std::size_t> block(cells_.region(first), cells_.kind(first));
      do
        ++last;
      while (last < cells_.size() && cells_.kind(last) == block.second && cells_.region(last) == block.first);
      f(block, first, last);
    }
  }

  // Calls f(cell, place) for all cells, if there is a table to be filled.
  template <class F> void for_each_place(const std::vector<std::uint32_t>& table, F f) const {
    if (table.empty())
      return;
    std::map<std::pair<int, std::size_t>, std::size_t> next;
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      next[{blocks_[b].region, blocks_[b].kind}] = first_[b];
    for_each_run([&](std::pair<int, std::size_t> block, std::size_t first, std::size_t end) {
      std::size_t& place = next.at(block);
      for (std::size_t c = first; c < end; ++c)
        f(c, place++);
    });
  }

  const Numbered_cells& cells_;
  bool is_in_order_ = true;
  std::vector<Cells_of_region> blocks_;
  std::vector<std::size_t> first_ = {0}; // of each block, and behind the last
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_REGION_H

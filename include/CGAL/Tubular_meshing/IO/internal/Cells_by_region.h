// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_REGION_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_REGION_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>

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

/* The cells by region and then by kind: the order in which formats list them that have blocks of a kind. O(n log l). */
class Cells_by_region {
public:
  explicit Cells_by_region(const Numbered_cells& cells)
      : cells_(cells) {
    std::map<std::pair<int, std::size_t>, std::size_t> sizes;
    for_each_run([&](int region, std::size_t kind, std::size_t first, std::size_t last) {
      sizes[{region, kind}] += last - first;
    });
    for (const auto& s : sizes)
      blocks_.push_back({s.first.first, s.first.second, s.second});
  }

  const std::vector<Cells_of_region>& blocks() const { return blocks_; }
  bool is_first_of_region(std::size_t block) const {
    return block == 0 || blocks_[block - 1].region != blocks_[block].region;
  }

  // The cells of a block, in order.
  std::vector<std::uint32_t> cells_of(std::size_t block) const {
    std::vector<std::uint32_t> result;
    result.reserve(blocks_[block].size);
    for_each_run([&](int region, std::size_t kind, std::size_t first, std::size_t last) {
      if (region == blocks_[block].region && kind == blocks_[block].kind)
        for (std::size_t c = first; c < last; ++c)
          result.push_back(std::uint32_t(c));
    });
    return result;
  }

  // Where each cell is in that order, from 0.
  std::vector<std::uint32_t> numbers() const {
    std::map<std::pair<int, std::size_t>, std::uint32_t> next;
    std::size_t size = 0;
    for (const Cells_of_region& b : blocks_) {
      next[{b.region, b.kind}] = std::uint32_t(size);
      size += b.size;
    }
    std::vector<std::uint32_t> number(cells_.size());
    for_each_run([&](int region, std::size_t kind, std::size_t first, std::size_t last) {
      std::uint32_t& n = next.at({region, kind});
      for (std::size_t c = first; c < last; ++c)
        number[c] = n++;
    });
    return number;
  }

private:
  // Calls f(region, kind, first, behind the last) for cells one after the other that have the same.
  template <class F> void for_each_run(F f) const {
    for (std::size_t first = 0, last = 0; first < cells_.size(); first = last) {
      const int region = cells_.region(first);
      const std::size_t kind = cells_.kind(first);
      do
        ++last;
      while (last < cells_.size() && cells_.kind(last) == kind && cells_.region(last) == region);
      f(region, kind, first, last);
    }
  }

  const Numbered_cells& cells_;
  std::vector<Cells_of_region> blocks_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_CELLS_BY_REGION_H

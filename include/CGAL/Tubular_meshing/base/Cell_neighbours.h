// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_CELL_NEIGHBOURS_H
#define CGAL_TUBULAR_MESHING_BASE_CELL_NEIGHBOURS_H

#include <CGAL/Tubular_meshing/base/Numbered_cells.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal::cells {

/* The cell across each face of each cell, in four bytes a face.
 *
 * Faces are gathered by their lowest corner, of which each has a few, and matched there by the others: expected time
 * O(n). Corners are taken in several ranges one after the other, so that the faces gathered at a time take less memory
 * than the mesh does. */
class Cell_neighbours {
public:
  explicit Cell_neighbours(const Numbered_cells& cells)
      : cells_(cells)
      , across_(cells.number_of_faces(), no_cell) {
    const std::vector<std::uint32_t> count = faces_at_corners();
    const std::size_t share = cells.number_of_faces() / 4 + 1;
    for (std::size_t begin = 0; begin < count.size();) {
      std::size_t end = begin, faces = 0;
      while (end < count.size() && (faces == 0 || faces + count[end] <= share))
        faces += count[end++];
      match(begin, end, count);
      begin = end;
    }
  }

  // no_cell on the boundary
  std::uint32_t across(std::size_t face) const { return across_[face]; }

  // Whether three cells share a face: there is no one across it then.
  bool has_crowded_face() const { return has_crowded_face_; }

private:
  struct Entry {
    std::uint64_t middle; // the corners between the lowest and the last, in one number
    std::uint32_t last, face;
    bool has_corners_of(const Entry& e) const { return middle == e.middle && last == e.last; }
    std::uint64_t hash() const { return (middle ^ std::uint64_t(last) << 17) * 0x9e3779b97f4a7c15u; }
  };

  std::vector<std::uint32_t> faces_at_corners() const {
    std::vector<std::uint32_t> count(cells_.mesh().points.size(), 0);
    cells_.for_each_face([&](std::size_t, std::size_t, const Face& f) { ++count[lowest_corner(f)]; });
    return count;
  }

  // Matches the faces whose lowest corner is in a range.
  void match(std::size_t begin, std::size_t end, const std::vector<std::uint32_t>& count) {
    std::vector<std::uint32_t> first(end - begin + 1, 0);
    for (std::size_t v = begin; v < end; ++v)
      first[v - begin + 1] = first[v - begin] + count[v];
    std::vector<std::uint32_t> faces(first.back());
    cells_.for_each_face_from(begin, end, [&](std::size_t number, const Face& f) {
      faces[first[lowest_corner(f) - begin]++] = std::uint32_t(number); // first becomes last
    });
    // Many faces are looked up at a time, before any of them is matched: their cells are all over the memory, and the
    // processor waits for several at once.
    const std::size_t corners_at_a_time = 256;
    std::vector<Entry> entries;
    for (std::size_t v = 0, next = 0, from = 0; v < end - begin; v = next) {
      next = (std::min)(end - begin, v + corners_at_a_time);
      const std::size_t to = first[next - 1];
      entries.resize(to - from);
      for (std::size_t i = from; i < to; ++i) {
        const Face s = sorted(cells_.face(faces[i]));
        entries[i - from] = {std::uint64_t(s[1]) << 32 | s[2], s[3], faces[i]};
      }
      std::size_t begin_of_corner = 0;
      for (std::size_t w = v; w < next; ++w) {
        const std::size_t end_of_corner = first[w] - from;
        match(entries.data() + begin_of_corner, end_of_corner - begin_of_corner);
        begin_of_corner = end_of_corner;
      }
      from = to;
    }
  }

  // Finds equal faces by a small hash table, which has room for twice as many.
  void match(const Entry* entries, std::size_t number) {
    int bits = 1;
    while ((std::size_t(1) << bits) < 2 * number)
      ++bits;
    const std::size_t mask = (std::size_t(1) << bits) - 1;
    table_.assign(mask + 1, no_entry);
    for (std::size_t i = 0; i < number; ++i) {
      std::size_t slot = entries[i].hash() >> (64 - bits);
      while (table_[slot] != no_entry && !entries[table_[slot]].has_corners_of(entries[i]))
        slot = (slot + 1) & mask;
      if (table_[slot] == no_entry)
        table_[slot] = std::uint32_t(i);
      else
        join(entries[table_[slot]].face, entries[i].face);
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    has_crowded_face_ = has_crowded_face_ || across_[a] != no_cell;
    across_[a] = std::uint32_t(cells_.face_of_cell(b).cell);
    across_[b] = std::uint32_t(cells_.face_of_cell(a).cell);
  }

  const Numbered_cells& cells_;
  std::vector<std::uint32_t> across_;
  bool has_crowded_face_ = false;
  static constexpr std::uint32_t no_entry = std::uint32_t(-1);
  std::vector<std::uint32_t> table_;
};

} // namespace CGAL::Tubular_meshing::internal::cells

#endif // CGAL_TUBULAR_MESHING_BASE_CELL_NEIGHBOURS_H

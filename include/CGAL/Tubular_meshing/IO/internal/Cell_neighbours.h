// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_CELL_NEIGHBOURS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_CELL_NEIGHBOURS_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* The cell across each face of each cell, in four bytes a face.
 *
 * Faces are gathered by their lowest corner, of which each has a few, and sorted there: O(n log d) for d faces at a
 * corner. Corners are taken in several ranges one after the other, so that the faces gathered at a time take less
 * memory than the mesh does. */
class Cell_neighbours {
public:
  Cell_neighbours(const Numbered_cells& cells, const std::string& file)
      : cells_(cells)
      , file_(file)
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

private:
  struct Entry {
    std::uint64_t middle; // the corners between the lowest and the last, in one number
    std::uint32_t last, face;
    bool has_corners_of(const Entry& e) const { return middle == e.middle && last == e.last; }
    bool operator<(const Entry& e) const {
      return middle != e.middle ? middle < e.middle : last != e.last ? last < e.last : face < e.face;
    }
  };

  static std::uint32_t lowest(const Face& f) { return (std::min)((std::min)(f[0], f[1]), (std::min)(f[2], f[3])); }

  std::vector<std::uint32_t> faces_at_corners() const {
    std::vector<std::uint32_t> count(cells_.mesh().points.size(), 0);
    cells_.for_each_face([&](std::size_t, std::size_t, const Face& f) { ++count[lowest(f)]; });
    return count;
  }

  // Matches the faces whose lowest corner is in a range.
  void match(std::size_t begin, std::size_t end, const std::vector<std::uint32_t>& count) {
    std::vector<std::uint32_t> first(end - begin + 1, 0);
    for (std::size_t v = begin; v < end; ++v)
      first[v - begin + 1] = first[v - begin] + count[v];
    std::vector<std::uint32_t> faces(first.back());
    std::uint32_t face = 0;
    cells_.for_each_face([&](std::size_t, std::size_t, const Face& f) {
      const std::size_t v = lowest(f);
      if (begin <= v && v < end)
        faces[first[v - begin]++] = face; // first becomes last
      ++face;
    });
    std::vector<Entry> entries;
    std::size_t from = 0;
    for (std::size_t v = begin; v < end; from = first[v - begin], ++v) {
      entries.clear();
      for (std::size_t i = from; i < first[v - begin]; ++i) {
        const Face s = sorted(cells_.face(faces[i]));
        entries.push_back({std::uint64_t(s[1]) << 32 | s[2], s[3], faces[i]});
      }
      std::sort(entries.begin(), entries.end());
      match(entries);
    }
  }

  void match(const std::vector<Entry>& entries) {
    for (std::size_t i = 0; i + 1 < entries.size(); ++i) {
      if (!entries[i].has_corners_of(entries[i + 1]))
        continue;
      if (i + 2 < entries.size() && entries[i].has_corners_of(entries[i + 2]))
        refuse(file_, "three of its cells share a face", "repair the mesh");
      const std::uint32_t a = entries[i].face, b = entries[i + 1].face;
      across_[a] = std::uint32_t(cells_.face_of_cell(b).cell);
      across_[b] = std::uint32_t(cells_.face_of_cell(a).cell);
    }
  }

  const Numbered_cells& cells_;
  const std::string& file_;
  std::vector<std::uint32_t> across_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_CELL_NEIGHBOURS_H

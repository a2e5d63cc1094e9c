// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_FACET_SIDES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_FACET_SIDES_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>
#include <CGAL/Tubular_meshing/IO/internal/Facet_index.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* The cells on the two sides of each facet of a mesh. Facets are counted through the triangles and on through the
 * quads. O(n + m log m) for n cells and m facets; five bytes a facet, or ten where one lies between cells. */
class Facet_sides {
public:
  struct Side {
    std::uint32_t cell = no_cell;
    std::uint8_t face = 0; // of the cell
    bool is_there() const { return cell != no_cell; }
  };
  typedef std::array<Side, 2> Sides;

  // Throws an Output_error that names the file if a facet bounds no cell, or another has its corners.
  Facet_sides(const Numbered_cells& cells, const std::string& file)
      : cells_(cells) {
    const Facet_index index(cells.mesh());
    check_differ(index, file);
    first_.resize(cells.mesh().number_of_facets());
    cells_.for_each_cell([&](std::size_t cell, const auto& vertices) {
      if (!index.may_have_facet(vertices))
        return;
      for (std::size_t k = 0; k < faces_of(vertices); ++k) {
        const Face corners = face_of(vertices, k);
        if (!index.may_be_facet(corners))
          continue;
        const Facet_index::Facets found = index.with_corners_of(corners);
        if (found.first != found.second)
          add(*found.first, Side{std::uint32_t(cell), std::uint8_t(k)});
      }
    });
    for (std::size_t f = 0; f < size(); ++f)
      if (!first_.side(f).is_there())
        refuse(file, "a facet of its patch " + std::to_string(label(f)) + " bounds no cell", write_vtu_instead);
  }

  std::size_t size() const { return cells_.mesh().number_of_facets(); }

  int label(std::size_t facet) const {
    const Mixed_mesh& m = cells_.mesh();
    return facet < m.triangles.size() ? m.triangles.label[facet] : m.quads.label[facet - m.triangles.size()];
  }
  std::size_t corners_of_facet(std::size_t facet) const { return facet < cells_.mesh().triangles.size() ? 3 : 4; }

  // The first one's region, or number, is the lower one; the second is there between cells only.
  Sides sides(std::size_t facet) const { return {first_.side(facet), second_.side(facet)}; }

  // seen from outside the cell of that side
  Face face(const Side& side) const { return cells_.face(side.cell, side.face); }

  bool is_inside(std::size_t facet) const { return second_.side(facet).is_there(); }

private:
  // A side of each facet, or of none.
  struct Packed_sides {
    std::vector<std::uint32_t> cells;
    std::vector<std::uint8_t> faces;

    void resize(std::size_t size) {
      cells.resize(size, no_cell);
      faces.resize(size, 0);
    }
    Side side(std::size_t facet) const { return cells.empty() ? Side() : Side{cells[facet], faces[facet]}; }
    void set(std::size_t facet, const Side& side) {
      cells[facet] = side.cell;
      faces[facet] = side.face;
    }
  };

  void check_differ(const Facet_index& index, const std::string& file) const {
    const std::pair<std::size_t, std::size_t> equal = index.equal_facets();
    if (equal.first < size())
      refuse(file,
             "two of its facets, of the patches " + std::to_string(label(equal.first)) + " and " +
                 std::to_string(label(equal.second)) + ", have the same corners",
             write_vtu_instead);
  }

  void add(std::size_t facet, Side side) {
    const Side other = first_.side(facet);
    if (!other.is_there())
      return first_.set(facet, side);
    if (second_.cells.empty())
      second_.resize(size());
    const bool is_lower = cells_.region(side.cell) < cells_.region(other.cell); // cells come in their order
    first_.set(facet, is_lower ? side : other);
    second_.set(facet, is_lower ? other : side);
  }

  const Numbered_cells& cells_;
  Packed_sides first_, second_;
};

/* The facets of each patch, in order. O(m + r log p) for m facets in r runs of one label, and p patches. */
inline std::map<int, std::vector<std::uint32_t>> facets_by_patch(const Facet_sides& facets) {
  std::map<int, std::vector<std::uint32_t>> patches;
  const auto for_each_run = [&](const auto& f) {
    for (std::size_t first = 0, last = 0; first < facets.size(); first = last) {
      const int label = facets.label(first);
      while (last < facets.size() && facets.label(last) == label)
        ++last;
      f(label, first, last);
    }
  };
  std::map<int, std::size_t> sizes;
  for_each_run([&](int label, std::size_t first, std::size_t last) { sizes[label] += last - first; });
  for (const auto& s : sizes)
    patches[s.first].reserve(s.second); // growing, they would take twice of it
  for_each_run([&](int label, std::size_t first, std::size_t last) {
    std::vector<std::uint32_t>& patch = patches.at(label);
    for (std::size_t f = first; f < last; ++f)
      patch.push_back(std::uint32_t(f));
  });
  return patches;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_FACET_SIDES_H

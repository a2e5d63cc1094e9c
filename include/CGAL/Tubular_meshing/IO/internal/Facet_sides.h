// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_FACET_SIDES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_FACET_SIDES_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* The cells on the two sides of each facet of a mesh. Facets are counted through the triangles and on through the
 * quads. O(n + m log m) for n cells and m facets; memory for the facets alone. */
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
      : cells_(cells)
      , sides_(cells.mesh().number_of_facets()) {
    const std::vector<Entry> facets = sorted_facets(file);
    find_sides(facets);
    for (std::size_t f = 0; f < size(); ++f)
      if (!sides_[f][0].is_there())
        refuse(file, "a facet of its patch " + std::to_string(label(f)) + " bounds no cell", write_vtu_instead);
  }

  std::size_t size() const { return sides_.size(); }

  int label(std::size_t facet) const {
    const Mixed_mesh& m = cells_.mesh();
    return facet < m.triangles.size() ? m.triangles.label[facet] : m.quads.label[facet - m.triangles.size()];
  }

  // The first one's region, or number, is the lower one; the second is there between cells only.
  const Sides& sides(std::size_t facet) const { return sides_[facet]; }

  // seen from outside the cell of that side
  Face face(const Side& side) const { return cells_.face(side.cell, side.face); }

  bool is_inside(std::size_t facet) const { return sides_[facet][1].is_there(); }

private:
  typedef std::pair<Face, std::uint32_t> Entry; // sorted corners, facet

  std::vector<Entry> sorted_facets(const std::string& file) const {
    const Mixed_mesh& m = cells_.mesh();
    std::vector<Entry> facets;
    facets.reserve(m.number_of_facets());
    for (const auto& t : m.triangles.vertices)
      facets.emplace_back(sorted(Face{t[0], t[1], t[2], no_vertex}), std::uint32_t(facets.size()));
    for (const auto& q : m.quads.vertices)
      facets.emplace_back(sorted(q), std::uint32_t(facets.size()));
    std::sort(facets.begin(), facets.end());
    for (std::size_t i = 1; i < facets.size(); ++i)
      if (facets[i].first == facets[i - 1].first)
        refuse(file,
               "two of its facets, of the patches " + std::to_string(label(facets[i - 1].second)) + " and " +
                   std::to_string(label(facets[i].second)) + ", have the same corners",
               write_vtu_instead);
    return facets;
  }

  void find_sides(const std::vector<Entry>& facets) {
    std::vector<char> on_facet(cells_.mesh().points.size(), 0);
    for (const Entry& e : facets)
      for (std::uint32_t v : e.first)
        if (v != no_vertex)
          on_facet[v] = 1;
    cells_.for_each_face([&](std::size_t cell, std::size_t k, const Face& corners) {
      for (std::uint32_t v : corners)
        if (v != no_vertex && !on_facet[v])
          return;
      const Face key = sorted(corners);
      const auto found = std::lower_bound(facets.begin(), facets.end(), Entry(key, 0));
      if (found != facets.end() && found->first == key)
        add(sides_[found->second], Side{std::uint32_t(cell), std::uint8_t(k)});
    });
  }

  void add(Sides& sides, const Side& side) {
    if (!sides[0].is_there()) {
      sides[0] = side;
      return;
    }
    sides[1] = side; // cells come in their order
    if (cells_.region(side.cell) < cells_.region(sides[0].cell))
      std::swap(sides[0], sides[1]);
  }

  const Numbered_cells& cells_;
  std::vector<Sides> sides_;
};

/* The facets of each patch, in order. */
inline std::map<int, std::vector<std::uint32_t>> facets_by_patch(const Facet_sides& facets) {
  std::map<int, std::vector<std::uint32_t>> patches;
  for (std::size_t f = 0; f < facets.size(); ++f)
    patches[facets.label(f)].push_back(std::uint32_t(f));
  return patches;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_FACET_SIDES_H

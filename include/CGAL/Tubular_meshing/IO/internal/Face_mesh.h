// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_FACE_MESH_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_FACE_MESH_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>
#include <CGAL/Tubular_meshing/IO/internal/Facet_sides.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/base/Cell_neighbours.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* A mesh as the formats see it that list faces, each with the cells on its two sides.
 *
 * Faces between cells are not stored: they are found cell by cell, as often as they are wanted, in upper triangular
 * order: by the lower cell, then by the higher one. Faces of the boundary are stored by patch. */
class Face_mesh {
public:
  typedef Facet_sides::Side Side;

  // The first side's cell is the owner, from outside of which the corners turn counterclockwise.
  struct Inner_face {
    Side owner;
    std::uint8_t kind; // of the owner, as of Numbered_cells
    std::uint32_t neighbour;
  };

  Face_mesh(const Mixed_mesh& mesh, const std::string& file)
      : cells_(mesh)
      , file_(file)
      , facets_(cells_, file)
      , neighbours_(checked()) {
    if (neighbours_.has_crowded_face())
      refuse(file_, "three of its cells share a face", "repair the mesh");
    list_patches();
    number_of_inner_faces_ = (cells_.number_of_faces() - number_of_outer_faces_) / 2;
  }
  Face_mesh(const Face_mesh&) = delete;

  const Numbered_cells& cells() const { return cells_; }
  const Facet_sides& facets() const { return facets_; }
  Face corners(const Side& side) const { return cells_.face(side.cell, side.face); }
  Face corners(const Inner_face& f) const { return cells_.face_of_kind(f.kind, f.owner.cell, f.owner.face); }

  std::size_t number_of_inner_facets() const { return inner_facets_.size(); } // those of the mesh between cells
  std::size_t number_of_inner_faces() const { return number_of_inner_faces_; }
  std::size_t number_of_faces() const { return number_of_inner_faces_ + number_of_outer_faces_; }

  // The faces of the boundary, by the label of their patch, each in the order of the cells.
  const std::map<int, std::vector<Side>>& patches() const { return patches_; }
  // Faces of the boundary that no facet of the mesh tells of.
  const std::vector<Side>& faces_without_patch() const { return without_patch_; }

  // Calls f(side) for the faces of the boundary: by patch, then those without one.
  template <class F> void for_each_outer_face(F f) const {
    for (const auto& p : patches_)
      for (const Side& side : p.second)
        f(side);
    for (const Side& side : without_patch_)
      f(side);
  }

  // no_cell on the boundary
  std::uint32_t across(std::size_t cell, std::size_t face) const {
    return neighbours_.across(cells_.first_face(cell) + face);
  }

  // Calls f(face) for those of the faces between cells whose owner is this cell, by their neighbour.
  template <class F> void for_each_face_owned_by(std::size_t cell, F f) const {
    const std::size_t kind = cells_.kind(cell), first = cells_.first_face(cell);
    if (kind == 0)
      for_each_upper_face<4>(kind, cell, first, f);
    else if (kind == 3)
      for_each_upper_face<6>(kind, cell, first, f);
    else
      for_each_upper_face<5>(kind, cell, first, f);
  }

  // Calls f(face) for the faces between cells.
  template <class F> void for_each_inner_face(F f) const {
    for_each_inner_face_of_kind<4>(0, f);
    for_each_inner_face_of_kind<5>(1, f);
    for_each_inner_face_of_kind<5>(2, f);
    for_each_inner_face_of_kind<6>(3, f);
  }

  // Calls f(face, facet) for them, with the facet that lies there, if any, else no_cell.
  template <class F> void for_each_inner_face_and_facet(F f) const {
    auto next = inner_facets_.begin();
    for_each_inner_face([&](const Inner_face& face) {
      while (next != inner_facets_.end() && next->cell < face.owner.cell)
        ++next;
      std::uint32_t facet = no_cell;
      for (auto it = next; it != inner_facets_.end() && it->cell == face.owner.cell; ++it)
        if (it->face == face.owner.face)
          facet = it->facet;
      f(face, facet);
    });
  }

private:
  struct Inner_facet {
    std::uint32_t cell, face, facet; // the lower cell
  };

  template <std::size_t NumberOfFaces, class F> void for_each_inner_face_of_kind(std::size_t kind, F& f) const {
    std::size_t first = cells_.first_face_of_kind(kind);
    for (std::size_t c = cells_.first_cell(kind), end = cells_.first_cell(kind + 1); c < end; ++c) {
      for_each_upper_face<NumberOfFaces>(kind, c, first, f);
      first += NumberOfFaces;
    }
  }

  template <std::size_t NumberOfFaces, class F>
  void for_each_upper_face(std::size_t kind, std::size_t cell, std::size_t first, F& f) const {
    std::array<Inner_face, NumberOfFaces> upper;
    std::size_t n = 0;
    for (std::size_t k = 0; k < NumberOfFaces; ++k) {
      const std::uint32_t other = neighbours_.across(first + k);
      if (other == no_cell || other < cell)
        continue;
      std::size_t at = n++; // few: put where they belong one by one
      for (; at > 0 && upper[at - 1].neighbour > other; --at)
        upper[at] = upper[at - 1];
      upper[at] = {{std::uint32_t(cell), std::uint8_t(k)}, std::uint8_t(kind), other};
    }
    for (std::size_t i = 0; i < n; ++i)
      f(upper[i]);
  }

  const Numbered_cells& checked() const {
    if (cells_.size() == 0)
      refuse(file_, "its format is for meshes with cells, and this one has none", write_vtu_instead);
    if (cells_.number_of_faces() >= no_cell)
      refuse(file_, "it has more than 4294967294 faces of cells", write_vtu_instead);
    return cells_;
  }

  // Room for as many as there are: they would take twice of it while they grow.
  void reserve_patches(std::vector<std::uint32_t>& listed) {
    std::map<int, std::size_t> sizes;
    std::size_t all = 0;
    for (std::size_t f = 0; f < facets_.size(); ++f)
      if (!facets_.is_inside(f)) {
        ++sizes[facets_.label(f)];
        ++all;
      }
    for (const auto& s : sizes)
      patches_[s.first].reserve(s.second);
    listed.reserve(all);
    inner_facets_.reserve(facets_.size() - all);
  }

  void list_patches() {
    std::vector<std::uint32_t> listed; // numbers of faces
    reserve_patches(listed);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const Facet_sides::Sides s = facets_.sides(f);
      if (s[1].is_there()) {
        const Side& lower = s[0].cell < s[1].cell ? s[0] : s[1];
        inner_facets_.push_back({lower.cell, lower.face, std::uint32_t(f)});
        continue;
      }
      patches_[facets_.label(f)].push_back(s[0]);
      listed.push_back(std::uint32_t(cells_.first_face(s[0].cell) + s[0].face));
    }
    std::sort(inner_facets_.begin(), inner_facets_.end(),
              [](const Inner_facet& a, const Inner_facet& b) { return a.cell < b.cell; });
    for (auto& p : patches_)
      std::sort(p.second.begin(), p.second.end(), [](const Side& a, const Side& b) {
        return std::make_pair(a.cell, a.face) < std::make_pair(b.cell, b.face);
      });
    std::sort(listed.begin(), listed.end());
    auto next = listed.begin();
    for (std::size_t n = 0; n < cells_.number_of_faces(); ++n) {
      if (neighbours_.across(n) != no_cell)
        continue;
      ++number_of_outer_faces_;
      if (next != listed.end() && *next == n) {
        ++next;
        continue;
      }
      const Numbered_cells::Face_of_cell f = cells_.face_of_cell(n);
      without_patch_.push_back({std::uint32_t(f.cell), std::uint8_t(f.face)});
    }
  }

  Numbered_cells cells_;
  const std::string file_;
  Facet_sides facets_;
  Cell_neighbours neighbours_;
  std::map<int, std::vector<Side>> patches_;
  std::vector<Side> without_patch_;
  std::vector<Inner_facet> inner_facets_; // by cell
  std::size_t number_of_inner_faces_ = 0, number_of_outer_faces_ = 0;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_FACE_MESH_H

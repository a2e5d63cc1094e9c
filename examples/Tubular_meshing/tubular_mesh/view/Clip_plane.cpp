// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Clip_plane.h"

#include <algorithm>
#include <cstdint>

namespace {

// Between cells of which one is kept, or on a cell that is; a facet without cells is its own.
bool is_seen(const Shown_mesh& mesh, std::size_t facet, const std::vector<char>& is_kept, const Clip_plane* plane) {
  const Shown_mesh::Sides& sides = mesh.sides(facet);
  if (sides[0] == Shown_mesh::none)
    return plane == nullptr || plane->keeps(mesh.center_of_face(mesh.facet(facet)));
  const bool first = is_kept[sides[0]], second = sides[1] != Shown_mesh::none && is_kept[sides[1]];
  return first != second;
}

} // namespace

Seen_faces seen_faces(const Shown_mesh& mesh) {
  Seen_faces seen;
  const std::vector<char> is_kept(mesh.cells().size(), 1);
  for (std::size_t f = 0; f < mesh.number_of_facets(); ++f)
    if (is_seen(mesh, f, is_kept, nullptr))
      seen.facets.push_back(f);
  return seen;
}

// No neighbours are needed: a face that is laid bare has corners that all belong to cells that were taken away.
Seen_faces seen_faces(const Shown_mesh& mesh, const Clip_plane& plane) {
  Seen_faces seen;
  std::vector<char> is_kept(mesh.cells().size()), is_laid_bare(mesh.mesh().points.size(), 0);
  for (std::size_t c = 0; c < is_kept.size(); ++c) {
    is_kept[c] = plane.keeps(mesh.center_of_cell(c));
    if (!is_kept[c])
      for (std::uint32_t v : mesh.cells().corners(c))
        is_laid_bare[v] = 1;
  }
  for (std::size_t f = 0; f < mesh.number_of_facets(); ++f)
    if (is_seen(mesh, f, is_kept, &plane))
      seen.facets.push_back(f);
  mesh.cells().for_each_face([&](std::size_t cell, std::size_t, const Shown_mesh::Face& face) {
    const auto n = CGAL::Tubular_meshing::internal::cells::number_of_corners(face);
    if (is_kept[cell] &&
        std::all_of(face.begin(), face.begin() + std::ptrdiff_t(n), [&](std::uint32_t v) { return is_laid_bare[v]; }))
      seen.cut.push_back({cell, face});
  });
  return seen;
}

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_FACET_INDEX_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_FACET_INDEX_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* Finds the facets of a mesh by their corners. Facets are counted through the triangles and on through the quads; they are
 * gathered by their lowest corner, of which each has a few. Four bytes a facet and five a point; O(n + m log m) for n
 * points and m facets, a search is O(log m), and mostly O(1). */
class Facet_index {
public:
  typedef std::pair<const std::uint32_t*, const std::uint32_t*> Facets;

  explicit Facet_index(const Mixed_mesh& mesh)
      : mesh_(mesh)
      , end_(mesh.points.size(), 0)
      , facets_(mesh.number_of_facets())
      , is_on_facet_(mesh.points.size(), 0) {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const Face corners = corners_of(f);
      ++end_[lowest_corner(corners)];
      for (std::uint32_t v : corners)
        if (v != no_vertex)
          is_on_facet_[v] = 1;
    }
    std::uint32_t begin = 0;
    for (std::uint32_t& e : end_)
      e = std::exchange(begin, begin + e);
    for (std::size_t f = 0; f < facets_.size(); ++f)
      facets_[end_[lowest_corner(corners_of(f))]++] = std::uint32_t(f); // what was the beginning becomes the end
    for (std::size_t v = 0; v < end_.size(); ++v)
      std::sort(facets_.begin() + begin_of(v), facets_.begin() + end_[v], [this](std::uint32_t f, std::uint32_t g) {
        return std::make_pair(sorted(corners_of(f)), f) < std::make_pair(sorted(corners_of(g)), g);
      });
  }

  // In the order of the mesh; the last one of a triangle is no_vertex.
  Face corners_of(std::size_t facet) const {
    const std::size_t triangles = mesh_.triangles.size();
    if (facet >= triangles)
      return mesh_.quads.vertices[facet - triangles];
    const auto& t = mesh_.triangles.vertices[facet];
    return {t[0], t[1], t[2], no_vertex};
  }

  // Whether all corners of a face are corners of facets: most faces of cells have none.
  bool may_be_facet(const Face& face) const {
    for (std::uint32_t v : face)
      if (v != no_vertex && is_on_facet_[v] == 0)
        return false;
    return true;
  }

  template <std::size_t N> bool may_have_facet(const std::array<std::uint32_t, N>& cell) const {
    int on_facets = 0;
    for (std::uint32_t v : cell)
      on_facets += is_on_facet_[v];
    return on_facets >= 3;
  }

  // Those that have these corners, in whatever order: one, if no two facets lie on each other.
  Facets with_corners_of(const Face& face) const {
    const Face key = sorted(face);
    const std::uint32_t* const begin = facets_.data() + begin_of(key[0]);
    const std::uint32_t* const end = facets_.data() + end_[key[0]];
    const auto first =
        std::lower_bound(begin, end, key, [this](std::uint32_t f, const Face& k) { return sorted(corners_of(f)) < k; });
    auto last = first;
    while (last != end && sorted(corners_of(*last)) == key)
      ++last;
    return {first, last};
  }

  // Two with the same corners, of all such pairs the one of the lowest corners; both are the number of facets where there
  // is none.
  std::pair<std::size_t, std::size_t> equal_facets() const {
    for (std::size_t v = 0; v < end_.size(); ++v)
      for (std::size_t i = begin_of(v) + std::size_t(1); i < end_[v]; ++i)
        if (sorted(corners_of(facets_[i - 1])) == sorted(corners_of(facets_[i])))
          return {facets_[i - 1], facets_[i]};
    return {facets_.size(), facets_.size()};
  }

  // All facets, by their sorted corners.
  const std::vector<std::uint32_t>& facets() const { return facets_; }

private:
  std::uint32_t begin_of(std::size_t corner) const { return corner == 0 ? 0 : end_[corner - 1]; }

  const Mixed_mesh& mesh_;
  std::vector<std::uint32_t> end_; // in facets_, of those of each lowest corner
  std::vector<std::uint32_t> facets_;
  std::vector<char> is_on_facet_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_FACET_INDEX_H

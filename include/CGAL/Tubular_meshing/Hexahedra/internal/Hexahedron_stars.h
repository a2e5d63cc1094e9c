// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_HEXAHEDRON_STARS_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_HEXAHEDRON_STARS_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The hexahedra around each vertex, and which corner of them it is. Linear. */
class Hexahedron_stars {
public:
  typedef std::uint32_t Index;

  // One hexahedron around a vertex; packed.
  class Entry {
  public:
    Entry() = default;
    Entry(std::size_t hexahedron, std::size_t corner)
        : code_(Index(8 * hexahedron + corner)) {}
    std::size_t hexahedron() const { return code_ / 8; }
    int corner() const { return int(code_ % 8); }

  private:
    Index code_;
  };
  struct Range {
    const Entry *first, *last;
    const Entry* begin() const { return first; }
    const Entry* end() const { return last; }
    bool empty() const { return first == last; }
  };

  Hexahedron_stars() = default;
  Hexahedron_stars(const Element_block<8>& hexahedra, std::size_t number_of_vertices)
      : begin_(number_of_vertices + 1, 0) {
    for (const auto& h : hexahedra.vertices)
      for (Index v : h)
        ++begin_[v + 1];
    for (std::size_t v = 0; v < number_of_vertices; ++v)
      begin_[v + 1] += begin_[v];
    entries_.resize(begin_.back());
    std::vector<Index> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t h = 0; h < hexahedra.size(); ++h)
      for (std::size_t c = 0; c < 8; ++c)
        entries_[next[hexahedra.vertices[h][c]]++] = Entry(h, c);
  }

  std::size_t number_of_vertices() const { return begin_.size() - 1; }
  Range operator()(std::size_t v) const { return {entries_.data() + begin_[v], entries_.data() + begin_[v + 1]}; }

private:
  std::vector<Index> begin_;
  std::vector<Entry> entries_;
};

/* Vertices in colors, no two of a color in one hexahedron: those of one color may be moved at the same time, so that the
 * result is the same for any number of threads. Greedy, in the order in which they are given; linear. */
class Vertex_colors {
public:
  typedef Hexahedron_stars::Index Index;

  Vertex_colors() = default;
  Vertex_colors(const Element_block<8>& hexahedra, const Hexahedron_stars& stars, const std::vector<Index>& vertices) {
    std::vector<std::uint16_t> color_of(stars.number_of_vertices(), none);
    std::vector<Index> used; // the last vertex whose neighbor has the color
    for (Index v : vertices) {
      for (const auto& e : stars(v))
        for (Index w : hexahedra.vertices[e.hexahedron()])
          if (color_of[w] != none)
            used[color_of[w]] = v;
      const std::size_t c =
          std::size_t(std::find_if(used.begin(), used.end(), [&](Index u) { return u != v; }) - used.begin());
      if (c == used.size())
        used.push_back(~v);
      color_of[v] = std::uint16_t(c);
    }
    begin_.assign(used.size() + 1, 0);
    for (Index v : vertices)
      ++begin_[color_of[v] + 1u];
    for (std::size_t c = 0; c < used.size(); ++c)
      begin_[c + 1] += begin_[c];
    by_color_.resize(vertices.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end());
    for (Index v : vertices)
      by_color_[next[color_of[v]]++] = v;
  }

  // body(first, last) on pieces of the vertices of a color, on `threads` threads; color after color.
  template <class Body> void for_each_range_of_color(int threads, const Body& body) const {
    for (std::size_t c = 0; c + 1 < begin_.size(); ++c)
      for_each_range(begin_[c + 1] - begin_[c], threads, [&](std::size_t first, std::size_t last) {
        body(by_color_.data() + begin_[c] + first, by_color_.data() + begin_[c] + last);
      });
  }

private:
  static constexpr std::uint16_t none = 65535;

  std::vector<std::size_t> begin_;
  std::vector<Index> by_color_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_HEXAHEDRON_STARS_H

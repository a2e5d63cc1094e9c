// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_NUMBERED_CELLS_H
#define CGAL_TUBULAR_MESHING_BASE_NUMBERED_CELLS_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Tubular_meshing::internal::cells {

constexpr std::uint32_t no_vertex = std::uint32_t(-1);
constexpr std::uint32_t no_cell = std::uint32_t(-1);

// Corners of a face of a cell; the last of a triangle is no_vertex, which sorts behind all others.
typedef std::array<std::uint32_t, 4> Face;

inline std::size_t number_of_corners(const Face& f) {
  return f[3] == no_vertex ? 3 : 4;
}

inline std::uint32_t lowest_corner(const Face& f) {
  return (std::min)((std::min)(f[0], f[1]), (std::min)(f[2], f[3]));
}

// By a network of five comparisons: there are millions to sort.
inline Face sorted(Face f) {
  const auto order = [](std::uint32_t& a, std::uint32_t& b) {
    const std::uint32_t low = (std::min)(a, b);
    b = (std::max)(a, b);
    a = low;
  };
  order(f[0], f[1]);
  order(f[2], f[3]);
  order(f[0], f[2]);
  order(f[1], f[3]);
  order(f[1], f[2]);
  return f;
}

// The faces of a kind of cells in the order of Mixed_mesh, each counterclockwise seen from outside; -1 ends a triangle.
template <std::size_t N> struct Cell_faces;

template <> struct Cell_faces<4> {
  static constexpr std::array<std::array<int, 4>, 4> corners = {
      {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{2, 0, 3, -1}}}};
};
template <> struct Cell_faces<5> {
  static constexpr std::array<std::array<int, 4>, 5> corners = {
      {{{0, 3, 2, 1}}, {{0, 1, 4, -1}}, {{1, 2, 4, -1}}, {{2, 3, 4, -1}}, {{3, 0, 4, -1}}}};
};
template <> struct Cell_faces<6> {
  static constexpr std::array<std::array<int, 4>, 5> corners = {
      {{{0, 2, 1, -1}}, {{3, 4, 5, -1}}, {{0, 1, 4, 3}}, {{1, 2, 5, 4}}, {{2, 0, 3, 5}}}};
};
template <> struct Cell_faces<8> {
  static constexpr std::array<std::array<int, 4>, 6> corners = {
      {{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}}};
};

template <std::size_t N> Face face_of(const std::array<std::uint32_t, N>& cell, std::size_t face) {
  const std::array<int, 4>& c = Cell_faces<N>::corners[face];
  return {cell[std::size_t(c[0])], cell[std::size_t(c[1])], cell[std::size_t(c[2])],
          c[3] < 0 ? no_vertex : cell[std::size_t(c[3])]};
}

template <std::size_t N> constexpr std::size_t faces_of(const std::array<std::uint32_t, N>&) {
  return Cell_faces<N>::corners.size();
}

/* The cells of a mesh counted through its blocks (tetrahedra, pyramids, prisms, hexahedra), and the faces of all cells counted
 * through the cells: a face's number stands for the cell and for which of its faces it is. */
class Numbered_cells {
public:
  explicit Numbered_cells(const Mixed_mesh& mesh)
      : mesh_(mesh) {
    const std::size_t sizes[4] = {mesh.tetrahedra.size(), mesh.pyramids.size(), mesh.prisms.size(),
                                  mesh.hexahedra.size()};
    for (std::size_t b = 0; b < 4; ++b) {
      first_cell_[b + 1] = first_cell_[b] + sizes[b];
      first_face_[b + 1] = first_face_[b] + sizes[b] * faces_of_kind[b];
    }
  }

  struct Face_of_cell {
    std::size_t cell, face;
  };

  const Mixed_mesh& mesh() const { return mesh_; }
  std::size_t size() const { return first_cell_[4]; }
  std::size_t number_of_faces() const { return first_face_[4]; } // those between cells twice

  // 0 to 3, in the order of the blocks
  std::size_t kind(std::size_t cell) const {
    std::size_t b = 0;
    while (cell >= first_cell_[b + 1])
      ++b;
    return b;
  }
  std::size_t first_cell(std::size_t kind) const { return first_cell_[kind]; } // kind 4: behind the last
  std::size_t first_face_of_kind(std::size_t kind) const { return first_face_[kind]; }

  int region(std::size_t cell) const {
    const std::size_t b = kind(cell), i = cell - first_cell_[b];
    return b == 0   ? mesh_.tetrahedra.label[i]
           : b == 1 ? mesh_.pyramids.label[i]
           : b == 2 ? mesh_.prisms.label[i]
                    : mesh_.hexahedra.label[i];
  }

  struct Corners {
    const std::uint32_t* first;
    std::size_t number;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return first + number; }
    std::uint32_t operator[](std::size_t i) const { return first[i]; }
  };
  Corners corners(std::size_t cell) const {
    const std::size_t b = kind(cell), i = cell - first_cell_[b];
    return b == 0   ? Corners{mesh_.tetrahedra.vertices[i].data(), 4}
           : b == 1 ? Corners{mesh_.pyramids.vertices[i].data(), 5}
           : b == 2 ? Corners{mesh_.prisms.vertices[i].data(), 6}
                    : Corners{mesh_.hexahedra.vertices[i].data(), 8};
  }

  std::size_t number_of_faces(std::size_t cell) const { return faces_of_kind[kind(cell)]; }
  std::size_t first_face(std::size_t cell) const {
    const std::size_t b = kind(cell);
    return first_face_[b] + (cell - first_cell_[b]) * faces_of_kind[b];
  }

  Face_of_cell face_of_cell(std::size_t number) const {
    return with_kind_of_face<Face_of_cell>(number, [&](std::size_t kind, std::size_t i, std::size_t face, const auto&) {
      return Face_of_cell{first_cell_[kind] + i, face};
    });
  }

  // seen from outside the cell
  Face face(std::size_t cell, std::size_t face) const { return face_of_kind(kind(cell), cell, face); }
  Face face_of_kind(std::size_t kind, std::size_t cell, std::size_t face) const {
    const std::size_t i = cell - first_cell_[kind];
    return kind == 0   ? face_of(mesh_.tetrahedra.vertices[i], face)
           : kind == 1 ? face_of(mesh_.pyramids.vertices[i], face)
           : kind == 2 ? face_of(mesh_.prisms.vertices[i], face)
                       : face_of(mesh_.hexahedra.vertices[i], face);
  }
  Face face(std::size_t number) const {
    return with_kind_of_face<Face>(number, [&](std::size_t, std::size_t i, std::size_t face, const auto& block) {
      return face_of(block.vertices[i], face);
    });
  }

  // Calls f(cell, vertices) for all cells, in order.
  template <class F> void for_each_cell(F f) const {
    std::size_t cell = 0;
    const auto visit = [&](const auto& block) {
      for (const auto& vertices : block.vertices)
        f(cell++, vertices);
    };
    visit(mesh_.tetrahedra);
    visit(mesh_.pyramids);
    visit(mesh_.prisms);
    visit(mesh_.hexahedra);
  }

  // Calls f(cell, face, corners) for all faces of all cells, in order.
  template <class F> void for_each_face(F f) const {
    for_each_cell([&](std::size_t cell, const auto& vertices) {
      for (std::size_t k = 0; k < faces_of(vertices); ++k)
        f(cell, k, face_of(vertices, k));
    });
  }

  // Calls f(number, corners) for those faces whose lowest corner is in a range, in order.
  template <class F> void for_each_face_from(std::size_t begin, std::size_t end, F f) const {
    std::size_t number = 0;
    for_each_cell([&](std::size_t, const auto& vertices) {
      std::size_t lowest = vertices[0], highest = vertices[0];
      for (std::uint32_t v : vertices) {
        lowest = (std::min)(lowest, std::size_t(v));
        highest = (std::max)(highest, std::size_t(v));
      }
      if (lowest < end && highest >= begin)
        for (std::size_t k = 0; k < faces_of(vertices); ++k) {
          const Face face = face_of(vertices, k);
          const std::size_t from = lowest_corner(face);
          if (begin <= from && from < end)
            f(number + k, face);
        }
      number += faces_of(vertices);
    });
  }

private:
  // f(kind, cell in its block, face, block); divisions are by constants, which is what makes them fast.
  template <class Result, class F> Result with_kind_of_face(std::size_t number, const F& f) const {
    if (number < first_face_[1])
      return f(0, number / 4, number % 4, mesh_.tetrahedra);
    if (number < first_face_[2])
      return f(1, (number - first_face_[1]) / 5, (number - first_face_[1]) % 5, mesh_.pyramids);
    if (number < first_face_[3])
      return f(2, (number - first_face_[2]) / 5, (number - first_face_[2]) % 5, mesh_.prisms);
    return f(3, (number - first_face_[3]) / 6, (number - first_face_[3]) % 6, mesh_.hexahedra);
  }

  static constexpr std::size_t faces_of_kind[4] = {4, 5, 5, 6};

  const Mixed_mesh& mesh_;
  std::array<std::size_t, 5> first_cell_ = {0, 0, 0, 0, 0}, first_face_ = {0, 0, 0, 0, 0};
};

} // namespace CGAL::Tubular_meshing::internal::cells

#endif // CGAL_TUBULAR_MESHING_BASE_NUMBERED_CELLS_H

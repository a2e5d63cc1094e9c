// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_FACE_BUCKETS_H
#define CGAL_TUBULAR_MESHING_BASE_FACE_BUCKETS_H

#include <CGAL/Tubular_meshing/base/Numbered_cells.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal::cells {

/* The faces of all cells, and on request the facets of the mesh, in buckets: each in that of its lowest corner, where
 * those with the same corners stand next to each other, cells before facets. Buckets hold a few dozen, so that this is
 * O(n log b) for n faces and b in a bucket; 16 bytes a face. On all threads; the result does not depend on their
 * number. */
class Face_buckets {
public:
  class Face {
  public:
    Face() = default;
    // `number`: among the faces of its owner, a cell, as in Cell_faces; of a facet, facet_number
    Face(const std::array<std::uint32_t, 3>& others, std::size_t owner, std::size_t number, bool is_reversed)
        : others(others)
        , code_(std::uint32_t(owner << 4 | number << 1 | std::size_t(is_reversed))) {}

    // Corners after the lowest, towards its lower neighbor; the last of a triangle is no_vertex.
    std::array<std::uint32_t, 3> others;

    std::uint32_t owner() const { return code_ >> 4; } // number of the cell or, triangles first, of the facet
    std::size_t number() const { return code_ >> 1 & 7; }
    bool is_reversed() const {
      return (code_ & 1) != 0;
    } // whether the corners are clockwise, seen from outside the cell
    bool is_facet() const { return number() == facet_number; }
    bool has_corners_of(const Face& f) const { return others == f.others; }

    bool operator<(const Face& f) const {
      for (std::size_t k = 0; k < 3; ++k)
        if (others[k] != f.others[k])
          return others[k] < f.others[k];
      return is_facet() != f.is_facet() ? f.is_facet() : code_ < f.code_;
    }

  private:
    std::uint32_t code_;
  };
  static constexpr std::size_t facet_number = 7;
  static constexpr std::size_t most_owners = std::size_t(1) << 28;

  enum Facets { without_facets, with_facets };

  // `region`: of the only cells that count; null: all.
  Face_buckets(const Numbered_cells& cells, Facets facets, int threads, const int* region = nullptr)
      : begin_(cells.mesh().points.size() + 1, 0) {
    if ((std::max)(cells.size(), cells.mesh().triangles.size() + cells.mesh().quads.size()) > most_owners)
      throw Input_error("The mesh has more than " + std::to_string(most_owners) + " cells: part it.");
    std::vector<std::atomic<std::uint32_t>> taken(cells.mesh().points.size());
    for_each_face(cells, facets, threads, region,
                  [&](std::uint32_t lowest, const Face&) { taken[lowest].fetch_add(1, std::memory_order_relaxed); });
    for (std::size_t v = 0; v < taken.size(); ++v) {
      begin_[v + 1] = begin_[v] + taken[v];
      taken[v] = 0;
    }
    faces_.reset(new Face[begin_.back()]); // not set to zero, which would be the work of one thread
    for_each_face(cells, facets, threads, region, [&](std::uint32_t lowest, const Face& face) {
      faces_[begin_[lowest] + taken[lowest].fetch_add(1, std::memory_order_relaxed)] = face;
    });
    for_each_range(taken.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        std::sort(faces_.get() + begin_[v], faces_.get() + begin_[v + 1]);
    });
  }

  std::size_t number_of_faces() const { return begin_.back(); } // those between cells twice
  std::size_t first_face(std::size_t vertex) const { return begin_[vertex]; }
  const Face& operator[](std::size_t k) const { return faces_[k]; }

  // Calls visit(first, last) for the faces with the same corners, the numbers [first, last), all whose lowest is `vertex`.
  template <class Visit> void for_each_group(std::size_t vertex, const Visit& visit) const {
    for (std::size_t first = begin_[vertex], last; first < begin_[vertex + 1]; first = last) {
      for (last = first + 1; last < begin_[vertex + 1] && faces_[last].has_corners_of(faces_[first]);)
        ++last;
      visit(first, last);
    }
  }

private:
  // Calls visit(lowest corner, face) for each, several at a time.
  template <class Visit>
  static void for_each_face(const Numbered_cells& cells, Facets facets, int threads, const int* region,
                            const Visit& visit) {
    const Mixed_mesh& mesh = cells.mesh();
    visit_cells(mesh.tetrahedra, cells.first_cell(0), threads, region, visit);
    visit_cells(mesh.pyramids, cells.first_cell(1), threads, region, visit);
    visit_cells(mesh.prisms, cells.first_cell(2), threads, region, visit);
    visit_cells(mesh.hexahedra, cells.first_cell(3), threads, region, visit);
    if (facets == without_facets)
      return;
    const std::size_t triangles = mesh.triangles.size();
    for_each_range(triangles + mesh.quads.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t f = first; f < last; ++f)
        if (f < triangles) {
          const auto& v = mesh.triangles.vertices[f];
          visit_face({v[0], v[1], v[2], no_vertex}, f, facet_number, visit);
        } else
          visit_face(mesh.quads.vertices[f - triangles], f, facet_number, visit);
    });
  }

  template <std::size_t N, class Visit>
  static void visit_cells(const Element_block<N>& block, std::size_t first_number, int threads, const int* region,
                          const Visit& visit) {
    for_each_range(block.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t c = first; c < last; ++c)
        if (region == nullptr || block.label[c] == *region)
          for (std::size_t f = 0; f < Cell_faces<N>::corners.size(); ++f)
            visit_face(face_of(block.vertices[c], f), first_number + c, f, visit);
    });
  }

  template <class Visit>
  static void visit_face(const cells::Face& f, std::size_t owner, std::size_t number, const Visit& visit) {
    const std::size_t n = number_of_corners(f);
    const std::size_t lowest = std::size_t(std::min_element(f.begin(), f.begin() + std::ptrdiff_t(n)) - f.begin());
    const auto corner = [&](std::size_t k) { return f[lowest + k < n ? lowest + k : lowest + k - n]; };
    std::array<std::uint32_t, 3> others = {corner(1), corner(2), n == 3 ? no_vertex : corner(3)};
    const bool is_reversed = others[n - 2] < others[0];
    if (is_reversed)
      std::swap(others[0], others[n - 2]);
    visit(f[lowest], Face(others, owner, number, is_reversed));
  }

  std::unique_ptr<Face[]> faces_;  // in the order of their lowest corners
  std::vector<std::size_t> begin_; // of each vertex
};

} // namespace CGAL::Tubular_meshing::internal::cells

#endif // CGAL_TUBULAR_MESHING_BASE_FACE_BUCKETS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_FACE_BUCKETS_H
#define CGAL_TUBULAR_MESHING_BASE_FACE_BUCKETS_H

#include <CGAL/Tubular_meshing/base/Numbered_cells.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
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
 * O(n log b) for n faces and b in a bucket; 4 bytes a face, as corners are those of the mesh, which must outlive this.
 * Copies share them. On all threads; the result does not depend on their number. */
class Face_buckets {
public:
  class Face {
  public:
    Face() = default;
    // `number`: among the faces of its owner, a cell, as in Cell_faces; of a facet, facet_number
    Face(std::size_t owner, std::size_t number)
        : code_(std::uint32_t(owner << 4 | number << 1)) {}

    std::uint32_t owner() const { return code_ >> 4; } // number of the cell or, triangles first, of the facet
    std::size_t number() const { return code_ >> 1 & 7; }
    bool is_facet() const { return number() == facet_number; }

  private:
    friend class Face_buckets;
    bool has_corners_of_last() const { return (code_ & 1) != 0; }
    void set_has_corners_of_last() { code_ |= 1; }

    std::uint32_t code_;
  };
  static constexpr std::size_t facet_number = 7;
  static constexpr std::size_t most_owners = std::size_t(1) << 28, most_points = std::size_t(1) << 31;

  enum Facets { without_facets, with_facets };

  // `region`: of the only cells that count; null: all.
  Face_buckets(const Numbered_cells& cells, Facets facets, int threads, const int* region = nullptr)
      : cells_(cells) {
    check_size((std::max)(cells.size(), cells.mesh().triangles.size() + cells.mesh().quads.size()), most_owners,
               "cells");
    check_size(cells.mesh().points.size(), most_points, "points");
    std::vector<std::atomic<std::uint32_t>> taken(cells.mesh().points.size());
    for_each_face(facets, threads, region,
                  [&](std::uint32_t lowest, const Face&) { taken[lowest].fetch_add(1, std::memory_order_relaxed); });
    const auto buckets = std::make_shared<Buckets>();
    std::vector<std::uint32_t>& begin = buckets->begin;
    begin.assign(taken.size() + 1, 0);
    for (std::size_t v = 0; v < taken.size(); ++v) {
      begin[v + 1] = begin[v] + taken[v];
      taken[v] = 0;
    }
    buckets->faces.reset(new Face[begin.back()]); // not set to zero, which would be the work of one thread
    Face* const faces = buckets->faces.get();
    for_each_face(facets, threads, region, [&](std::uint32_t lowest, const Face& face) {
      faces[begin[lowest] + taken[lowest].fetch_add(1, std::memory_order_relaxed)] = face;
    });
    std::atomic<bool> has_overlaps{false};
    for_each_range(taken.size(), threads, [&](std::size_t first, std::size_t last) {
      std::vector<Key> keys;
      for (std::size_t v = first; v < last; ++v)
        if (sort(faces + begin[v], faces + begin[v + 1], keys))
          has_overlaps.store(true, std::memory_order_relaxed);
    });
    buckets->has_overlaps = has_overlaps;
    buckets_ = buckets;
  }

  // The same faces of another mesh that has the same elements: O(1).
  Face_buckets(const Numbered_cells& cells, const Face_buckets& of_same_elements)
      : cells_(cells)
      , buckets_(of_same_elements.buckets_) {}

  std::size_t number_of_faces() const { return buckets_->begin.back(); } // those between cells twice
  std::size_t first_face(std::size_t vertex) const { return buckets_->begin[vertex]; }
  const Face& operator[](std::size_t k) const { return buckets_->faces[k]; }

  // As its owner has them: those of a cell's face are counterclockwise, seen from outside of the cell.
  cells::Face corners(const Face& face) const {
    return face.is_facet() ? facet_corners(face.owner()) : cells_.face(face.owner(), face.number());
  }
  // Of two faces of cells with the same corners: whether the cells are on the same side, which is rare.
  bool overlap(const Face& a, const Face& b) const {
    return buckets_->has_overlaps && is_reversed(corners(a)) == is_reversed(corners(b));
  }

  // Calls visit(first, last) for the faces with the same corners, the numbers [first, last), all whose lowest is `vertex`.
  template <class Visit> void for_each_group(std::size_t vertex, const Visit& visit) const {
    const Face* faces = buckets_->faces.get();
    const std::size_t end = buckets_->begin[vertex + 1];
    for (std::size_t first = buckets_->begin[vertex], last; first < end; first = last) {
      for (last = first + 1; last < end && faces[last].has_corners_of_last();)
        ++last;
      visit(first, last);
    }
  }

private:
  // Calls visit(lowest corner, face) for each, several at a time.
  template <class Visit> void for_each_face(Facets facets, int threads, const int* region, const Visit& visit) const {
    const Mixed_mesh& mesh = cells_.mesh();
    visit_cells(mesh.tetrahedra, cells_.first_cell(0), threads, region, visit);
    visit_cells(mesh.pyramids, cells_.first_cell(1), threads, region, visit);
    visit_cells(mesh.prisms, cells_.first_cell(2), threads, region, visit);
    visit_cells(mesh.hexahedra, cells_.first_cell(3), threads, region, visit);
    if (facets == with_facets)
      for_each_range(mesh.triangles.size() + mesh.quads.size(), threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f)
          visit(lowest_corner(facet_corners(f)), Face(f, facet_number));
      });
  }

  template <std::size_t N, class Visit>
  static void visit_cells(const Element_block<N>& block, std::size_t first_number, int threads, const int* region,
                          const Visit& visit) {
    for_each_range(block.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t c = first; c < last; ++c)
        if (region == nullptr || block.label[c] == *region)
          for (std::size_t f = 0; f < Cell_faces<N>::corners.size(); ++f)
            visit(lowest_corner(face_of(block.vertices[c], f)), Face(first_number + c, f));
    });
  }

  cells::Face facet_corners(std::size_t facet) const {
    const Mixed_mesh& mesh = cells_.mesh();
    if (facet >= mesh.triangles.size())
      return mesh.quads.vertices[facet - mesh.triangles.size()];
    const auto& v = mesh.triangles.vertices[facet];
    return {v[0], v[1], v[2], no_vertex};
  }

  // From the lowest corner towards its lower neighbor. Of most faces, which are triangles, without branches.
  static cells::Face in_order(const cells::Face& f) {
    if (number_of_corners(f) == 3) {
      const std::uint32_t low = (std::min)((std::min)(f[0], f[1]), f[2]);
      const std::uint32_t high = (std::max)((std::max)(f[0], f[1]), f[2]);
      return {low, f[0] ^ f[1] ^ f[2] ^ low ^ high, high, no_vertex};
    }
    const std::size_t lowest = std::size_t(std::min_element(f.begin(), f.end()) - f.begin());
    const std::uint32_t next = f[(lowest + 1) % 4], last = f[(lowest + 3) % 4];
    return {f[lowest], (std::min)(next, last), f[(lowest + 2) % 4], (std::max)(next, last)};
  }
  static bool is_reversed(const cells::Face& f) {
    const auto [low, next, opposite, last] = in_order(f);
    return (f[0] == low                 ? f[1]
            : f[1] == low               ? f[2]
            : number_of_corners(f) == 3 ? f[0]
            : f[2] == low               ? f[3]
                                        : f[0]) != next;
  }

  static void check_size(std::size_t n, std::size_t most, const char* what) {
    if (n > most)
      throw Input_error("The mesh has more than " + std::to_string(most) + " " + what + ": part it.");
  }

  /* What faces of a bucket are sorted by: three corners, those of cells first, owner and number. */
  struct Key {
    std::uint64_t high, low;

    Key(const cells::Face& f, const Face& face) {
      const cells::Face ordered = in_order(f);
      high = std::uint64_t(ordered[1]) << 32 | ordered[2];
      low = std::uint64_t(ordered[3]) << 33 | std::uint64_t(face.is_facet()) << 32 | std::uint64_t(face.owner()) << 4 |
            face.number() << 1 | std::uint64_t(is_reversed(f));
    }

    Face face() const { return Face(std::uint32_t(low) >> 4, low >> 1 & 7); }
    bool has_corners_of(const Key& k) const { return high == k.high && low >> 33 == k.low >> 33; }
    bool overlaps(const Key& k) const { return ((low | k.low) >> 32 & 1) == 0 && ((low ^ k.low) & 1) == 0; }
    bool operator<(const Key& k) const { return high != k.high ? high < k.high : low < k.low; }
  };

  // Whether cells with a face in common are on the same side of it.
  bool sort(Face* first, Face* last, std::vector<Key>& keys) const {
    keys.clear();
    for (const Face* f = first; f != last; ++f)
      keys.emplace_back(corners(*f), *f);
    std::sort(keys.begin(), keys.end());
    bool has_overlaps = false;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      first[k] = keys[k].face();
      if (k == 0 || !keys[k].has_corners_of(keys[k - 1]))
        continue;
      first[k].set_has_corners_of_last();
      has_overlaps |= keys[k].overlaps(keys[k - 1]);
    }
    return has_overlaps;
  }

  struct Buckets {
    std::unique_ptr<Face[]> faces;    // in the order of their lowest corners
    std::vector<std::uint32_t> begin; // of each vertex
    bool has_overlaps = false;
  };

  Numbered_cells cells_;
  std::shared_ptr<const Buckets> buckets_;
};

} // namespace CGAL::Tubular_meshing::internal::cells

#endif // CGAL_TUBULAR_MESHING_BASE_FACE_BUCKETS_H

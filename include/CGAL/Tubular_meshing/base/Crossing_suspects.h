// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_CROSSING_SUSPECTS_H
#define CGAL_TUBULAR_MESHING_BASE_CROSSING_SUSPECTS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>
#include <CGAL/Tubular_meshing/base/place_on_curve.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Which triangles may meet elsewhere than at common edges and vertices: those of which plain doubles cannot tell, by a
 * plane that parts them by more than rounding errors, that they do not. On a sound surface there are next to none; exact
 * tests are for these alone. Pairs that are near each other come from boxes round eight triangles each, neighbours on a
 * curve that fills space, in a binary tree. O(n log n) on surfaces, on all threads. */
class Crossing_suspects {
public:
  typedef Surface::Face_index Face;

  Crossing_suspects(const std::vector<Face>& faces, const Surface& surface) {
    copy(order_of(faces, surface), surface);
    is_suspect_ = std::vector<std::atomic<bool>>(triangles_.size());
    for (std::atomic<bool>& s : is_suspect_)
      s.store(false, std::memory_order_relaxed);
    make_boxes();
    for_each_range(
        levels_.front().size(), 0,
        [&](std::size_t first, std::size_t last) {
          for (std::size_t leaf = first; leaf < last; ++leaf)
            search_from(leaf);
        },
        16);
  }

  /* In order. */
  std::vector<Face> faces() const {
    std::vector<Face> result;
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      if (is_suspect_[i].load(std::memory_order_relaxed))
        result.push_back(triangles_[i].face);
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  static constexpr std::size_t leaf_size = 8;

  struct Triangle {
    std::array<Vector_3d, 3> corners;
    std::array<Surface::Vertex_index, 3> vertices;
    std::array<Face, 3> neighbors; // beyond the sides from each corner to the next
    Face face;
  };
  struct Box {
    Vector_3d low, high;

    void add(const Vector_3d& p) {
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
    }
    bool overlaps(const Box& b) const {
      return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y && low.z <= b.high.z &&
             b.low.z <= high.z;
    }
  };
  static Box nothing() {
    const double infinity = (std::numeric_limits<double>::infinity)();
    return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  }

  // --- boxes ---

  static std::vector<Face> order_of(const std::vector<Face>& faces, const Surface& surface) {
    Box all = nothing();
    std::vector<Vector_3d> middles;
    middles.reserve(faces.size());
    for (Face f : faces) {
      const auto h = surface.halfedge(f);
      middles.push_back((1. / 3) *
                        (Vector_3d(surface.point(surface.source(h))) + Vector_3d(surface.point(surface.target(h))) +
                         Vector_3d(surface.point(surface.target(surface.next(h))))));
      all.add(middles.back());
    }
    const Vector_3d extents = all.high - all.low;
    const double extent = (std::max)({extents.x, extents.y, extents.z, (std::numeric_limits<double>::min)()});
    std::vector<std::pair<std::uint64_t, Face>> order;
    order.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Vector_3d p = (1 / extent) * (middles[i] - all.low);
      order.emplace_back(place_on_curve({p.x, p.y, p.z}), faces[i]);
    }
    std::sort(order.begin(), order.end());
    std::vector<Face> result;
    result.reserve(order.size());
    for (const auto& o : order)
      result.push_back(o.second);
    return result;
  }

  void copy(const std::vector<Face>& faces, const Surface& surface) {
    triangles_.resize(faces.size());
    for_each_range(faces.size(), 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        Triangle& t = triangles_[i];
        t.face = faces[i];
        auto h = surface.halfedge(faces[i]);
        for (std::size_t k = 0; k < 3; ++k, h = surface.next(h)) {
          t.vertices[k] = surface.source(h);
          t.corners[k] = Vector_3d(surface.point(t.vertices[k]));
          t.neighbors[k] = surface.face(surface.opposite(h));
        }
      }
    });
  }

  void make_boxes() {
    boxes_.assign(triangles_.size(), nothing());
    levels_.emplace_back((triangles_.size() + leaf_size - 1) / leaf_size, nothing());
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      for (const Vector_3d& p : triangles_[i].corners)
        boxes_[i].add(p);
      unite(levels_.front()[i / leaf_size], boxes_[i]);
    }
    while (levels_.back().size() > 1) {
      std::vector<Box> above((levels_.back().size() + 1) / 2, nothing());
      for (std::size_t i = 0; i < levels_.back().size(); ++i)
        unite(above[i / 2], levels_.back()[i]);
      levels_.push_back(std::move(above));
    }
  }

  static void unite(Box& box, const Box& other) {
    box.add(other.low);
    box.add(other.high);
  }

  // --- pairs ---

  // Pairs of the leaf's triangles with those that come later.
  void search_from(std::size_t leaf) {
    const Box& box = levels_.front()[leaf];
    std::array<std::pair<std::size_t, std::size_t>, 128> waiting; // levels and places in them
    std::size_t size = 0;
    waiting[size++] = {levels_.size() - 1, 0};
    while (size > 0) {
      const auto [level, i] = waiting[--size];
      if (((i + 1) << level) <= leaf || !box.overlaps(levels_[level][i]))
        continue;
      if (level == 0) {
        look_at_leaves(leaf, i);
        continue;
      }
      for (std::size_t child : {2 * i + 1, 2 * i})
        if (child < levels_[level - 1].size())
          waiting[size++] = {level - 1, child};
    }
  }

  void look_at_leaves(std::size_t a, std::size_t b) {
    for (std::size_t i = a * leaf_size; i < (std::min)(triangles_.size(), (a + 1) * leaf_size); ++i) {
      if (a == b && is_flat(triangles_[i]))
        is_suspect_[i].store(true, std::memory_order_relaxed);
      if (!boxes_[i].overlaps(levels_.front()[b]))
        continue;
      for (std::size_t j = a == b ? i + 1 : b * leaf_size; j < (std::min)(triangles_.size(), (b + 1) * leaf_size); ++j)
        if (boxes_[i].overlaps(boxes_[j]) && may_cross(triangles_[i], triangles_[j])) {
          is_suspect_[i].store(true, std::memory_order_relaxed);
          is_suspect_[j].store(true, std::memory_order_relaxed);
        }
    }
  }

  // --- tests: all of them are false where rounding errors may have decided ---

  /* Whether n · d < 0, n being a product of vectors whose squared lengths have this product. */
  static bool is_below(const Vector_3d& n, double squared_size, const Vector_3d& d) {
    const double rounding = 1e-24, x = dot(n, d);
    return x < 0 && x * x > rounding * squared_size * squared_norm(d);
  }

  static Vector_3d normal(const Triangle& t, std::size_t k) {
    return cross(t.corners[(k + 1) % 3] - t.corners[k], t.corners[(k + 2) % 3] - t.corners[k]);
  }
  static double squared_size(const Triangle& t, std::size_t k) {
    return squared_norm(t.corners[(k + 1) % 3] - t.corners[k]) * squared_norm(t.corners[(k + 2) % 3] - t.corners[k]);
  }

  static bool is_flat(const Triangle& t) { return !(squared_norm(normal(t, 0)) > 1e-20 * squared_size(t, 0)); }

  static bool may_cross(const Triangle& s, const Triangle& t) {
    for (std::size_t k = 0; k < 3; ++k)
      if (s.neighbors[k] == t.face)
        return may_be_folded(s, k, t);
    std::size_t i = 0, j = 0, common = 0;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t l = 0; l < 3; ++l)
        if (s.vertices[k] == t.vertices[l]) {
          i = k;
          j = l;
          ++common;
        }
    return common > 1 ||
           !(common == 1 ? is_parted(s, i, t, j) || is_parted(t, j, s, i) : is_parted(s, t) || is_parted(t, s));
  }

  // Two triangles beside an edge, turned alike: they overlap only if they lie on each other.
  static bool may_be_folded(const Triangle& s, std::size_t side, const Triangle& t) {
    const Vector_3d m = normal(s, side), n = normal(t, 0);
    const double turn = dot(m, n);
    if (turn > 0 && turn * turn > 1e-6 * squared_norm(m) * squared_norm(n))
      return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (t.vertices[k] != s.vertices[side] && t.vertices[k] != s.vertices[(side + 1) % 3]) {
        const Vector_3d d = t.corners[k] - s.corners[side];
        return !is_below(m, squared_size(s, side), d) && !is_below(-1. * m, squared_size(s, side), d);
      }
    return true;
  }

  // Two triangles at a common vertex, by a plane through it that has s on itself or on one side.
  static bool is_parted(const Triangle& s, std::size_t i, const Triangle& t, std::size_t j) {
    const Vector_3d &v = s.corners[i], a = s.corners[(i + 1) % 3] - v, b = s.corners[(i + 2) % 3] - v;
    const Vector_3d c = t.corners[(j + 1) % 3] - v, d = t.corners[(j + 2) % 3] - v, n = cross(a, b);
    const double a2 = squared_norm(a), b2 = squared_norm(b);
    const auto parts = [&](const Vector_3d& m, double size) { return is_below(m, size, c) && is_below(m, size, d); };
    return parts(n, a2 * b2) || parts(-1. * n, a2 * b2) || parts(cross(n, a), a2 * b2 * a2) ||
           parts(cross(b, n), a2 * b2 * b2);
  }

  // Two triangles that have nothing in common, by a plane that has s on itself or on one side.
  static bool is_parted(const Triangle& s, const Triangle& t) {
    const Vector_3d n = normal(s, 0);
    const double size = squared_size(s, 0);
    const auto parts = [&](const Vector_3d& origin, const Vector_3d& m, double squared) {
      return std::all_of(t.corners.begin(), t.corners.end(),
                         [&](const Vector_3d& p) { return is_below(m, squared, p - origin); });
    };
    if (parts(s.corners[0], n, size) || parts(s.corners[0], -1. * n, size))
      return true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector_3d side = s.corners[(k + 1) % 3] - s.corners[k];
      if (parts(s.corners[k], cross(n, side), size * squared_norm(side)))
        return true;
    }
    return false;
  }

  std::vector<Triangle> triangles_;      // along the curve
  std::vector<Box> boxes_;               // of each
  std::vector<std::vector<Box>> levels_; // of leaves, of two of them, of four …
  std::vector<std::atomic<bool>> is_suspect_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_CROSSING_SUSPECTS_H

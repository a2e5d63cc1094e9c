// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_RECOMBINATION_BORDER_FAN_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_RECOMBINATION_BORDER_FAN_H

#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The triangles around a vertex v of the border, counterclockwise, by their halfedges that leave v: the first one is
 * the border's that leaves v; that which precedes the last one is the border's that comes to v.
 *
 * Where the first and the last triangle remain single, v is split: the border keeps v, the triangles between get a new
 * vertex, and the edge between the two makes quads of the first triangle and the last one. */
class Border_fan {
public:
  Border_fan(const std::vector<Patch_triangle>& triangles, const std::vector<Vector_3d>& points,
             std::vector<int> halfedges)
      : halfedges_(std::move(halfedges))
      , v_(points[std::size_t(source_of(triangles, halfedges_.front()))]) {
    for (int h : halfedges_)
      ring_.push_back(points[std::size_t(target_of(triangles, h))]);
    ring_.push_back(points[std::size_t(source_of(triangles, previous_halfedge(halfedges_.back())))]);
  }

  const std::vector<int>& halfedges() const { return halfedges_; }
  int first_triangle() const { return triangle_of(halfedges_.front()); }
  int last_triangle() const { return triangle_of(halfedges_.back()); }

  /* Looks for the place of the new vertex, on the triangles between: where the worse one of the two quads is best, and
   * nothing turns over. `on_border` says so of the ends of the halfedges: from there, another vertex may come. */
  void place_new_vertex(const std::vector<char>& on_border) {
    const double parts[] = {1. / 2, 1. / 3, 1. / 6};
    new_vertex_ = v_ + (1. / 6) * (ring_[ring_.size() / 2] - v_);
    for (double part : parts)
      for (std::size_t k = 2; k + 2 < 2 * ring_.size() - 1; ++k) { // spokes, and the directions halfway
        if (part == parts[0] && (on_border[k / 2] || on_border[(k + 1) / 2]))
          continue;
        const Vector_3d p = v_ + part * (0.5 * (ring_[k / 2] + ring_[(k + 1) / 2]) - v_);
        const double eta = worse_eta(p);
        if (eta > eta_) {
          eta_ = eta;
          new_vertex_ = p;
        }
      }
  }

  const Vector_3d& new_vertex() const { return new_vertex_; }
  double eta() const { return eta_; } // (14) of the worse quad; 0 if something turns over

private:
  static bool same_side(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c, const Vector_3d& normal) {
    return dot(cross(b - a, c - a), normal) > 0;
  }

  double worse_eta(const Vector_3d& p) const {
    const std::size_t n = ring_.size();
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const Vector_3d normal = cross(ring_[i] - v_, ring_[i + 1] - v_);
      if (!same_side(p, ring_[i], ring_[i + 1], normal) || (i == 0 && !same_side(p, v_, ring_[0], normal)) ||
          (i + 2 == n && !same_side(p, ring_[n - 1], v_, normal)))
        return 0;
    }
    return (std::min)(quad_eta({v_, ring_[0], ring_[1], p}), quad_eta({ring_[n - 1], v_, p, ring_[n - 2]}));
  }

  std::vector<int> halfedges_;
  Vector_3d v_, new_vertex_;
  std::vector<Vector_3d> ring_; // the other ends of the edges at v
  double eta_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_RECOMBINATION_BORDER_FAN_H

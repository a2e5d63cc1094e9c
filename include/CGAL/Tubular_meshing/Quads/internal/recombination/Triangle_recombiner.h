// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_RECOMBINATION_TRIANGLE_RECOMBINER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_RECOMBINATION_TRIANGLE_RECOMBINER_H

#include <CGAL/Tubular_meshing/Quads/blossom_recombination.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
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

/* Decides which triangles become quads: by the edges between two that go, and the vertices of the border that are
 * split. The border is that of each patch. */
class Triangle_recombiner {
public:
  // An empty vector of patches stands for one patch.
  Triangle_recombiner(const std::vector<Patch_triangle>& triangles, const std::vector<Vector_3d>& points,
                      const std::vector<int>& patches)
      : triangles_(triangles)
      , points_(points)
      , inner_opposite_(opposite_halfedges(triangles)) {
    for (int h = 0; h < int(inner_opposite_.size()); ++h) {
      int& o = inner_opposite_[std::size_t(h)];
      if (o >= 0 && !patches.empty() && patches[std::size_t(h / 3)] != patches[std::size_t(o / 3)])
        o = -1;
    }
    find_fans();
  }

  void run() {
    propose_joins();
    propose_splits();
    std::vector<char> single(triangles_.size(), 1);
    for (std::size_t i : minimum_cost_matching(triangles_.size(), pairs_)) {
      single[std::size_t(pairs_[i].first)] = single[std::size_t(pairs_[i].second)] = 0;
      if (i < joins_.size())
        accept_join(joins_[i]);
      else
        accept_split(fans_[proposed_fans_[i - joins_.size()]]);
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (single[t])
        left_.push_back(int(t));
  }

  /* One halfedge of each edge that goes. */
  const std::vector<int>& joined() const { return joined_; }
  const std::vector<Border_fan>& splits() const { return splits_; }
  const std::vector<int>& left() const { return left_; }
  std::size_t number_of_invalid_quads() const { return invalid_; }

  /* The corners of the quad around an edge that goes, as halfedges that leave them. */
  std::array<int, 4> corners(int h) const {
    const int o = inner_opposite_[std::size_t(h)];
    return {{h, previous_halfedge(o), next_halfedge(h), previous_halfedge(h)}};
  }

private:
  // Splits cost more than all quads can gain by them; a quad that is none costs more than a few splits.
  double cost_of_split() const { return 1 + double(triangles_.size()); }
  double cost_of_invalid_quad() const { return 8 * cost_of_split(); }

  bool is_border(int h) const { return inner_opposite_[std::size_t(h)] < 0; }
  const Vector_3d& point(int h) const { return points_[std::size_t(source_of(triangles_, h))]; }
  double angle_at(int h) const { return angle(point(previous_halfedge(h)), point(h), point(next_halfedge(h))); }

  // (14), where an angle beyond π counts as such.
  double eta(int h) const {
    const int o = inner_opposite_[std::size_t(h)];
    if (angle_at(h) + angle_at(next_halfedge(o)) >= pi || angle_at(next_halfedge(h)) + angle_at(o) >= pi)
      return 0;
    const auto c = corners(h);
    return quad_eta({point(c[0]), point(c[1]), point(c[2]), point(c[3])});
  }

  void find_fans() {
    std::vector<char> on_border(points_.size(), 0);
    for (int h = 0; h < int(inner_opposite_.size()); ++h)
      if (is_border(h))
        on_border[std::size_t(source_of(triangles_, h))] = on_border[std::size_t(target_of(triangles_, h))] = 1;
    for (int h = 0; h < int(inner_opposite_.size()); ++h) {
      if (!is_border(h))
        continue;
      std::vector<int> around(1, h);
      while (!is_border(previous_halfedge(around.back())))
        around.push_back(inner_opposite_[std::size_t(previous_halfedge(around.back()))]);
      if (around.size() < 3) // one triangle, or two, that an edge joins
        continue;
      std::vector<char> ring_on_border;
      for (int g : around)
        ring_on_border.push_back(on_border[std::size_t(target_of(triangles_, g))]);
      ring_on_border.push_back(1);
      fans_.emplace_back(triangles_, points_, std::move(around));
      fans_.back().place_new_vertex(ring_on_border);
    }
  }

  void propose_joins() {
    for (int h = 0; h < int(inner_opposite_.size()); ++h) {
      const int o = inner_opposite_[std::size_t(h)];
      if (o < h)
        continue;
      const double quality = eta(h);
      pairs_.push_back({triangle_of(h), triangle_of(o), quality > 0 ? 1 - quality : cost_of_invalid_quad()});
      joins_.push_back(h);
    }
  }

  void propose_splits() {
    for (std::size_t k = 0; k < fans_.size(); ++k) {
      const Border_fan& fan = fans_[k];
      if (fan.first_triangle() == fan.last_triangle())
        continue; // a border that meets itself
      const double cost = fan.eta() > 0 ? cost_of_split() + 2 * (1 - fan.eta()) : cost_of_invalid_quad();
      pairs_.push_back({fan.first_triangle(), fan.last_triangle(), cost});
      proposed_fans_.push_back(k);
    }
  }

  void accept_join(int h) {
    joined_.push_back(h);
    invalid_ += eta(h) > 0 ? 0 : 1;
  }
  void accept_split(const Border_fan& fan) {
    splits_.push_back(fan);
    invalid_ += fan.eta() > 0 ? 0 : 2;
  }

  const std::vector<Patch_triangle>& triangles_;
  const std::vector<Vector_3d>& points_;
  std::vector<int> inner_opposite_; // negative on borders of patches
  std::vector<Border_fan> fans_;
  std::vector<Node_pair> pairs_; // first joins, then splits
  std::vector<int> joins_;
  std::vector<std::size_t> proposed_fans_;
  std::vector<int> joined_;
  std::vector<Border_fan> splits_;
  std::vector<int> left_;
  std::size_t invalid_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_RECOMBINATION_TRIANGLE_RECOMBINER_H

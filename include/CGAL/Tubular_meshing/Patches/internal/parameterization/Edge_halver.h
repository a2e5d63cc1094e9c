// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_EDGE_HALVER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_EDGE_HALVER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Indexed_patch.h>
#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A patch and where its parts were before they were divided. */
struct Divided_patch {
  Indexed_patch patch;
  std::vector<int> origin;                    ///< the given triangle that each triangle is part of
  std::vector<std::vector<double>> positions; ///< of the vertices of each loop on the given one, 1 an edge; and its end

  explicit Divided_patch(Indexed_patch given)
      : patch(std::move(given))
      , origin(patch.triangles.size()) {
    std::iota(origin.begin(), origin.end(), 0);
    for (const std::vector<int>& loop : patch.loops) {
      positions.emplace_back(loop.size() + 1);
      std::iota(positions.back().begin(), positions.back().end(), 0.);
    }
  }
};

/* Divides triangles of a patch along with those of their edges that are to be halved: the surface stays what it is. Of
 * each triangle divided the longest edge is halved too (Rivara), unless it is on a loop, so that angles do not get ever
 * smaller. */
class Edge_halver {
public:
  explicit Edge_halver(Divided_patch& divided)
      : divided_(divided)
      , patch_(divided.patch) {}

  // Both halfedges of an edge are marked, or none. `opposite` may know of halfedges beyond those of the patch.
  void run(const std::vector<int>& opposite, std::vector<char> is_marked) {
    const auto is_inside = [&](int h) { return h >= 0 && h < int(is_marked.size()); };
    mark_longest(opposite, is_marked);
    middle_.assign(is_marked.size(), -1);
    std::vector<int> border(patch_.points.size(), -1);
    for (int h = 0; h < int(is_marked.size()); ++h) {
      const int o = opposite[std::size_t(h)];
      if (!is_inside(o))
        border[std::size_t(source_of(patch_.triangles, h))] = h;
      if (!is_marked[std::size_t(h)] || (is_inside(o) && o > h))
        continue;
      middle_[std::size_t(h)] = add_middle(h);
      if (is_inside(o))
        middle_[std::size_t(o)] = middle_[std::size_t(h)];
    }
    for (std::size_t l = 0; l < patch_.loops.size(); ++l)
      divide_loop(border, patch_.loops[l], divided_.positions[l]);
    for (std::size_t t = 0; t < divided_.origin.size(); ++t)
      divide(int(t));
    patch_.triangles = std::move(triangles_);
    divided_.origin = std::move(origins_);
  }

private:
  void mark_longest(const std::vector<int>& opposite, std::vector<char>& is_marked) const {
    std::vector<int> queue;
    for (int h = 0; h < int(is_marked.size()); ++h)
      if (is_marked[std::size_t(h)])
        queue.push_back(triangle_of(h));
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const int h = longest_halfedge(queue[i]), o = opposite[std::size_t(h)];
      if (is_marked[std::size_t(h)] || o < 0 || o >= int(is_marked.size()))
        continue;
      is_marked[std::size_t(h)] = is_marked[std::size_t(o)] = 1;
      queue.push_back(triangle_of(o));
    }
  }

  int longest_halfedge(int t) const {
    int longest = 3 * t;
    for (int h = 3 * t + 1; h < 3 * t + 3; ++h)
      if (is_shorter(source_of(patch_.triangles, longest), target_of(patch_.triangles, longest),
                     source_of(patch_.triangles, h), target_of(patch_.triangles, h)))
        longest = h;
    return longest;
  }

  int add_middle(int h) {
    const Vector_3d a(patch_.points[std::size_t(source_of(patch_.triangles, h))]);
    const Vector_3d b(patch_.points[std::size_t(target_of(patch_.triangles, h))]);
    patch_.points.push_back(as<Point_3>(0.5 * (a + b)));
    return int(patch_.points.size()) - 1;
  }

  void divide_loop(const std::vector<int>& border, std::vector<int>& loop, std::vector<double>& positions) const {
    std::vector<int> divided;
    std::vector<double> divided_positions;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      divided.push_back(loop[i]);
      divided_positions.push_back(positions[i]);
      const int middle = middle_[std::size_t(border[std::size_t(loop[i])])];
      if (middle < 0)
        continue;
      divided.push_back(middle);
      divided_positions.push_back((positions[i] + positions[i + 1]) / 2);
    }
    divided_positions.push_back(positions.back());
    loop.swap(divided);
    positions.swap(divided_positions);
  }

  void add(int t, int a, int b, int c) {
    triangles_.push_back({{a, b, c}});
    origins_.push_back(divided_.origin[std::size_t(t)]);
  }

  bool is_shorter(int a, int b, int c, int d) const {
    const auto squared_length = [this](int v, int w) {
      return squared_norm(Vector_3d(patch_.points[std::size_t(w)]) - Vector_3d(patch_.points[std::size_t(v)]));
    };
    return squared_length(a, b) < squared_length(c, d);
  }

  void divide(int t) {
    int marked = 0,
        first = 3 * t; // turned so that of one or two marked edges, the first one comes after one that is not
    for (int h = 3 * t; h < 3 * t + 3; ++h) {
      marked += is_halved(h);
      if (is_halved(h) && !is_halved(previous_halfedge(h)))
        first = h;
    }
    const int second = next_halfedge(first), third = next_halfedge(second);
    const int a = source_of(patch_.triangles, first), b = source_of(patch_.triangles, second),
              c = source_of(patch_.triangles, third);
    const int ab = middle_[std::size_t(first)], bc = middle_[std::size_t(second)], ca = middle_[std::size_t(third)];
    if (marked == 0)
      add(t, a, b, c);
    else if (marked == 1) {
      add(t, a, ab, c);
      add(t, ab, b, c);
    } else {
      add(t, ab, b, bc);
      if (marked == 3) {
        add(t, a, ab, ca);
        add(t, ca, bc, c);
        add(t, ab, bc, ca);
      } else if (is_shorter(a, bc, ab, c)) {
        add(t, a, ab, bc);
        add(t, a, bc, c);
      } else {
        add(t, a, ab, c);
        add(t, ab, bc, c);
      }
    }
  }

  bool is_halved(int h) const { return middle_[std::size_t(h)] >= 0; }

  Divided_patch& divided_;
  Indexed_patch& patch_;
  std::vector<int> middle_; // of each halfedge, −1 if it stays
  std::vector<Patch_triangle> triangles_;
  std::vector<int> origins_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_EDGE_HALVER_H

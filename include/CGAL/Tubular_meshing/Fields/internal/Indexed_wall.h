// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_INDEXED_WALL_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_INDEXED_WALL_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/curvature.h>
#include <CGAL/Tubular_meshing/base/Corner_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Some of a mesh's faces, the wall of a lumen as a rule, in compact arrays: what lies beyond (a cap) does not exist.
 * Faces without an area are left out. Built in O(n). */
class Indexed_wall {
public:
  typedef std::uint32_t Index;

  explicit Indexed_wall(const Indexed_triangles& faces) {
    points_.reserve(faces.points.size());
    for (const Point_3& p : faces.points)
      points_.emplace_back(p);
    triangles_.reserve(faces.triangles.size());
    for (const std::array<Index, 3>& t : faces.triangles)
      if (squared_norm(doubled_area(t)) > 0)
        triangles_.push_back(t);
    connect();
  }

  std::size_t number_of_vertices() const { return points_.size(); }
  const std::vector<Vector_3d>& points() const { return points_; }
  const std::vector<std::array<Index, 3>>& triangles() const { return triangles_; }
  const Vector_3d& point(Index v) const { return points_[v]; }
  /* Whether the wall ends at a vertex. */
  bool is_on_rim(Index v) const { return on_rim_[v]; }

  const Index* neighbors_begin(Index v) const { return neighbors_.data() + first_neighbor_[v]; }
  const Index* neighbors_end(Index v) const { return neighbors_.data() + first_neighbor_[v + 1]; }

  /* The normal of a triangle; its length is twice the area. */
  Vector_3d doubled_area(const std::array<Index, 3>& t) const {
    return cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]);
  }

  /* At each vertex. */
  std::vector<double> shortest_edges() const {
    std::vector<double> result(points_.size(), (std::numeric_limits<double>::infinity)());
    for (Index v = 0; v < points_.size(); ++v)
      for (const Index* w = neighbors_begin(v); w != neighbors_end(v); ++w)
        result[v] = (std::min)(result[v], norm(points_[*w] - points_[v]));
    return result;
  }

  /* The tree of the triangles, by their numbers here. */
  Corner_tree<Double_kernel::Triangle_3> make_tree() const {
    const auto point = [&](Index v) { return Double_kernel::Point_3(points_[v].x, points_[v].y, points_[v].z); };
    std::vector<Double_kernel::Triangle_3> shapes;
    shapes.reserve(triangles_.size());
    for (const auto& t : triangles_)
      shapes.emplace_back(point(t[0]), point(t[1]), point(t[2]));
    return Corner_tree<Double_kernel::Triangle_3>(shapes);
  }

private:
  // Every halfedge once from either side; what comes once only is on the rim.
  void connect() {
    std::vector<std::size_t> first(points_.size() + 1, 0); // of the corners that are met at each point, some twice
    for (const auto& t : triangles_)
      for (Index v : t)
        first[v + 1] += 2;
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::size_t> next(first.begin(), first.end());
    std::vector<Index> met(first.back());
    for (const auto& t : triangles_)
      for (int i = 0; i < 3; ++i)
        for (int k : {1, 2})
          met[next[t[i]]++] = t[(i + k) % 3];
    first_neighbor_.assign(1, 0);
    first_neighbor_.reserve(points_.size() + 1);
    neighbors_.reserve(met.size() / 2);
    on_rim_.assign(points_.size(), false);
    for (Index v = 0; v < points_.size(); ++v) {
      std::sort(met.begin() + std::ptrdiff_t(first[v]), met.begin() + std::ptrdiff_t(first[v + 1]));
      for (std::size_t i = first[v], j = i; i < first[v + 1]; i = j) {
        while (j < first[v + 1] && met[j] == met[i])
          ++j;
        if (j == i + 1)
          on_rim_[v] = on_rim_[met[i]] = true;
        neighbors_.push_back(met[i]);
      }
      first_neighbor_.push_back(neighbors_.size());
    }
  }

  std::vector<Vector_3d> points_;
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<Index> neighbors_;
  std::vector<std::size_t> first_neighbor_;
  std::vector<bool> on_rim_;
};

/* Visits the vertices near one of them, along edges and outward: a vessel that only passes by is not met. At most
 * `max_vertices` are visited, or fewer if wanted, which bounds the time where the mesh is very fine. Of use to one
 * thread at a time. */
class Wall_neighborhood {
public:
  static constexpr std::size_t max_vertices = 256;

  explicit Wall_neighborhood(const Indexed_wall& wall, std::size_t most = max_vertices)
      : wall_(wall)
      , most_(most < max_vertices ? most : std::size_t(max_vertices))
      , seen_(table_size, Slot{0, 0}) {}

  /* Calls visit(vertex, weight) for all vertices closer than the radius, the center included; the weight falls from 1
   * at the center to 0, smoothly. */
  template <class Visit> void for_each(Indexed_wall::Index center, double radius, const Visit& visit) {
    ++round_;
    found_.clear();
    const Vector_3d middle = wall_.point(center);
    const double radius2 = radius * radius;
    std::size_t beyond = 0;
    slot_of(center) = Slot{center, round_};
    found_.push_back(Found{center, 0});
    for (std::size_t head = 0; head < found_.size(); ++head) {
      const Found at = found_[head];
      const double x = at.squared_distance / radius2;
      visit(at.vertex, (1 - x) * (1 - x));
      const auto *n = wall_.neighbors_begin(at.vertex), *end = wall_.neighbors_end(at.vertex);
      for (; n != end && found_.size() < most_; ++n) {
        Slot& slot = slot_of(*n);
        if (slot.round == round_)
          continue;
        const double squared_distance = squared_norm(wall_.point(*n) - middle);
        const bool is_near = squared_distance < radius2;
        if (is_near || beyond++ < table_size / 2)
          slot = Slot{*n, round_};
        if (is_near)
          found_.push_back(Found{*n, squared_distance});
      }
    }
  }

private:
  static constexpr std::size_t table_size = 1024; // a power of two; a quarter for what is near, half for what is beyond

  struct Slot {
    Indexed_wall::Index vertex;
    std::uint32_t round;
  };
  struct Found {
    Indexed_wall::Index vertex;
    double squared_distance; // from the center
  };

  // Where a vertex is, if it was seen in this round, or where it belongs.
  Slot& slot_of(Indexed_wall::Index v) {
    std::size_t i = (v * 2654435761u) % table_size;
    while (seen_[i].round == round_ && seen_[i].vertex != v)
      i = (i + 1) % table_size;
    return seen_[i];
  }

  const Indexed_wall& wall_;
  std::size_t most_;
  std::vector<Slot> seen_;
  std::vector<Found> found_;
  std::uint32_t round_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_INDEXED_WALL_H

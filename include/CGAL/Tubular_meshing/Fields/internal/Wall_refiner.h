// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_REFINER_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_REFINER_H

#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/base/Point_boxes.h>
#include <CGAL/Tubular_meshing/Fields/internal/find_spikes.h>
#include <CGAL/Tubular_meshing/base/opposite_ball.h>
#include <CGAL/Tubular_meshing/base/Growing_numbering.h>
#include <CGAL/Tubular_meshing/base/Triangle_soup.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Divides the edges of long, thin triangles until none is longer than .7 of the lumen's radius there. A vertex's neighborhood
 * reaches as far as its edges: if these are longer, what is averaged there is of all sides of the vessel; of their normals
 * only what points along it is left. The shape remains as it is; vertices keep their numbers.
 *
 * The radius is measured at the middle of an edge, along its triangles' normal, against the corners of the wall and points
 * on thin triangles as far from each other as these are wide. What is not turned towards the edge, as beyond a crease, does
 * not count. Edges at spikes are left; parts are no shorter than half of the shortest edges of the wall there. What is
 * divided depends on the surface alone, not on the order of its triangles, or on its place in space. O(n + m log m) for m
 * triangles that come of thin ones. */
class Wall_refiner {
public:
  typedef Indexed_wall::Index Index;
  typedef std::array<Index, 3> Triangle;

  /* `orientation` is 1 if the triangles are turned outward, else -1. */
  Wall_refiner(const Indexed_wall& wall, double orientation, int threads)
      : orientation_(orientation)
      , threads_(threads)
      , most_(32 * wall.triangles().size() + 100000) {
    find_suspects(wall);
    if (suspects_.empty())
      return;
    points_ = wall.points();
    triangles_ = wall.triangles();
    parent_.resize(triangles_.size());
    std::iota(parent_.begin(), parent_.end(), Index(0));
    is_spike_ = find_spikes(wall);
    origin_.resize(points_.size());
    std::iota(origin_.begin(), origin_.end(), Index(0));
    resolved_ = wall.shortest_edges();
    extent_ = extent_of(points_);
    collect_obstacles();
    for (int round = 0; round < most_rounds && points_.size() < most_; ++round) {
      ask_for_edges();
      if (!divide_edges())
        break;
      divide_triangles();
      has_divided_ = true;
    }
  }

  bool has_divided() const { return has_divided_; }
  const std::vector<Vector_3d>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /* The shortest edge at each vertex before; at the others, as between those on their edge. */
  const std::vector<double>& resolved() const { return resolved_; }
  /* Of which of the wall's triangles each is a part. */
  const std::vector<Index>& parents() const { return parent_; }

private:
  static constexpr double thin = 5;           // a triangle that is so many times as long as it is wide
  static constexpr double longest_side = 0.7; // of a thin triangle, in radii
  static constexpr double long_for_part = 2;  // of a side of a thin triangle, or of its parts, in their width there
  static constexpr int most_rounds = 8;       // of parts, of the parts' own, and so on
  static constexpr int most_halvings = 10;    // of an edge in one of them
  static constexpr Index none = Index(-1);
  static constexpr double as_far = 1 + 1e-9; // the same in any place, unit and direction

  struct Chain {
    Index first = none,
          size = 0; // points along an edge from its end with the lower number on; `none`: it was not asked for
  };
  struct Edge {
    Index number;
    Index a, b;       // a < b
    Vector_3d normal; // of the triangles that ask for it
  };
  // A piece of an edge, from k / 2^level on.
  struct Piece {
    Index edge; // in asked_
    std::uint32_t level, k;
    bool is_long;
  };
  struct Hash_of_key {
    std::size_t operator()(std::uint64_t key) const { return std::size_t(mixed_bits(key)); }
  };

  static Vector_3d doubled_area(const Triangle& t, const std::vector<Vector_3d>& points) {
    return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
  }

  static bool is_thin(const Triangle& t, const std::vector<Vector_3d>& points) {
    double longest2 = 0;
    for (int k = 0; k < 3; ++k)
      longest2 = (std::max)(longest2, squared_norm(points[t[k]] - points[t[(k + 1) % 3]]));
    return longest2 > as_far * thin * norm(doubled_area(t, points));
  }

  /* Thin triangles among others: those of single slivers, as on the steps of an image, reach no further than what is around.
   * At two corners at least, all triangles together are small for the longest edge there. */
  void find_suspects(const Indexed_wall& wall) {
    const double small = 2; // about 5 in a regular surface, of this unit
    const std::vector<Vector_3d>& points = wall.points();
    std::vector<Index> thin_ones;
    for (Index i = 0; i < wall.triangles().size(); ++i)
      if (is_thin(wall.triangles()[i], points))
        thin_ones.push_back(i);
    if (thin_ones.empty())
      return;
    std::vector<double> wide(points.size(), 0.), longest2(points.size(), 0.);
    for (const Triangle& t : wall.triangles()) {
      const double area = norm(doubled_area(t, points));
      for (int k = 0; k < 3; ++k) {
        const Index a = t[k], b = t[(k + 1) % 3];
        const double length2 = squared_norm(points[a] - points[b]);
        wide[a] += wall.is_on_rim(a) ? 2 * area : area;
        longest2[a] = (std::max)(longest2[a], length2);
        longest2[b] = (std::max)(longest2[b], length2);
      }
    }
    for (Index i : thin_ones) {
      int count = 0;
      for (Index v : wall.triangles()[i])
        count += as_far * wide[v] < small * longest2[v];
      if (count >= 2)
        suspects_.push_back(i);
    }
  }

  void collect_obstacles() {
    const double most_a_side = 512;
    normals_.assign(points_.size(), Vector_3d()); // inward, as long as areas are wide
    for (const Triangle& t : triangles_)
      for (Index v : t)
        normals_[v] += (-orientation_) * doubled_area(t, points_);
    for (int ring = 0; ring < 2; ++ring) { // what a step of an image says is less than what is around
      const std::vector<Vector_3d> before = normals_;
      for (const Triangle& t : triangles_)
        for (Index v : t)
          normals_[v] += before[t[0]] + before[t[1]] + before[t[2]];
    }
    std::vector<Vector_3d> obstacles;
    std::vector<double> numbers; // of their normals
    for (Index v = 0; v < points_.size(); ++v)
      if (!is_spike_[v]) {
        obstacles.push_back(points_[v]);
        numbers.push_back(double(v));
      }
    for (Index i : suspects_) {
      const Triangle& t = triangles_[i];
      if (is_spike_[t[0]] || is_spike_[t[1]] || is_spike_[t[2]])
        continue;
      normals_.push_back((-orientation_) * doubled_area(t, points_));
      const double wide = norm(normals_.back());
      for (int k = 0; k < 3; ++k) {
        const Vector_3d &p = points_[t[k]], d = points_[t[(k + 1) % 3]] - p;
        const double n = (std::min)(most_a_side, std::ceil(squared_norm(d) / (as_far * wide)));
        for (double j = 1; j < n; ++j) {
          obstacles.push_back(p + (j / n) * d);
          numbers.push_back(double(normals_.size() - 1));
        }
      }
    }
    obstacles_ = Point_boxes(obstacles, numbers);
  }

  // Those that are long for their triangle, and have not been asked for yet.
  void ask_for_edges() {
    asked_.clear();
    std::vector<Index> place; // in asked_, of each edge by its number
    for (Index i : suspects_) {
      const Triangle& t = triangles_[i];
      const Vector_3d area = doubled_area(t, points_);
      const double least2 = as_far * long_for_part * norm(area);
      for (int k = 0; k < 3; ++k) {
        const Index a = (std::min)(t[k], t[(k + 1) % 3]), b = (std::max)(t[k], t[(k + 1) % 3]);
        if (is_spike_[a] || is_spike_[b] || squared_norm(points_[a] - points_[b]) <= least2)
          continue;
        const Index e = number_of_edge(a, b);
        if (chains_[e].first != none)
          continue;
        place.resize(chains_.size(), none);
        if (place[e] == none) {
          place[e] = Index(asked_.size());
          asked_.push_back(Edge{e, a, b, Vector_3d()});
        }
        asked_[place[e]].normal += (-orientation_) * normalized(area);
      }
    }
  }

  Index number_of_edge(Index a, Index b) {
    const Index e = edges_.number_of((std::uint64_t((std::min)(a, b)) << 32) | (std::max)(a, b));
    chains_.resize(edges_.size());
    return e;
  }

  // All by one halving after the other, so that there is an end where they would be too many.
  bool divide_edges() {
    std::vector<Piece> pieces, done;
    for (Index i = 0; i < asked_.size(); ++i)
      pieces.push_back(Piece{i, 0, 0, false});
    while (!pieces.empty()) {
      const bool may_divide = points_.size() + pieces.size() + done.size() < most_;
      for_each_range(pieces.size(), threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          pieces[i].is_long = may_divide && pieces[i].level < most_halvings && is_long(pieces[i]);
      });
      std::vector<Piece> halves;
      for (const Piece& p : pieces)
        if (p.is_long)
          for (std::uint32_t half : {0u, 1u})
            halves.push_back(Piece{p.edge, p.level + 1, 2 * p.k + half, false});
        else
          done.push_back(p);
      pieces = std::move(halves);
    }
    const auto start = [](const Piece& p) { return std::ldexp(double(p.k), -int(p.level)); };
    std::sort(done.begin(), done.end(), [&](const Piece& p, const Piece& q) {
      return std::make_pair(p.edge, start(p)) < std::make_pair(q.edge, start(q));
    });
    is_end_.assign(points_.size(), 0);
    bool result = false;
    for (const Piece& p : done) {
      const Edge& e = asked_[p.edge];
      Chain& chain = chains_[e.number];
      if (p.k == 0) {
        chain.first = Index(points_.size());
        continue;
      }
      result = true;
      ++chain.size;
      is_end_[e.a] = is_end_[e.b] = 1;
      points_.push_back(points_[e.a] + start(p) * (points_[e.b] - points_[e.a]));
      resolved_.push_back(resolved_[e.a] + start(p) * (resolved_[e.b] - resolved_[e.a]));
      is_spike_.push_back(0);
      origin_.push_back(origin_[start(p) < 0.5 ? e.a : e.b]);
    }
    return result;
  }

  // Whether a ball of the radius for which it would be no more than long enough has something inside.
  bool is_long(const Piece& p) const {
    const Edge& e = asked_[p.edge];
    const double part = std::ldexp(1., -int(p.level)), t = part * (p.k + 0.5);
    const Vector_3d d = points_[e.b] - points_[e.a], middle = points_[e.a] + t * d;
    const double bound = part * norm(d) / (as_far * longest_side);
    if (bound <= resolved_[e.a] + t * (resolved_[e.b] - resolved_[e.a]))
      return false;
    // on the steps of an image, triangles lie across the wall: what the vertices say counts, too
    for (const Vector_3d& direction : {e.normal, normals_[origin_[e.a]], normals_[origin_[e.b]]}) {
      const Vector_3d n = normalized(direction);
      const auto faces_it = [&](double number) {
        const Vector_3d& other = normals_[std::size_t(number)];
        return dot(other, n) < -0.1 * norm(other);
      };
      if (!(ball_within(obstacles_, middle, n, (std::min)(bound, 4 * extent_), faces_it) > 0))
        return false;
    }
    return true;
  }

  void divide_triangles() {
    suspects_.clear();
    const std::size_t n = triangles_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Triangle t = triangles_[i];
      const auto is_end = [&](Index v) { return v < is_end_.size() && is_end_[v]; };
      if (is_end(t[0]) + is_end(t[1]) + is_end(t[2]) < 2)
        continue;
      collect_border(t);
      if (border_.size() == 3)
        continue;
      parts_.clear();
      cut_border();
      triangles_[i] = parts_[0];
      suspects_.push_back(Index(i));
      for (std::size_t k = 1; k < parts_.size(); ++k) {
        suspects_.push_back(Index(triangles_.size()));
        triangles_.push_back(parts_[k]);
        parent_.push_back(parent_[i]);
      }
    }
  }

  // A triangle's corners and the points on its sides, in order.
  struct On_border {
    Index point;
    unsigned sides; // a bit for each that it is on
  };

  void collect_border(const Triangle& t) {
    border_.clear();
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      border_.push_back(On_border{a, (1u << k) | (1u << (k + 2) % 3)});
      if (!(is_end_[a] && is_end_[b]))
        continue;
      const Chain chain = chains_[number_of_edge(a, b)];
      for (Index j = 0; j < chain.size; ++j)
        border_.push_back(On_border{chain.first + (a < b ? j : chain.size - 1 - j), 1u << k});
    }
  }

  // By the shortest diagonal next to a corner that is left, one after the other.
  void cut_border() {
    std::array<std::size_t, 3> on_side = {0, 0, 0};
    for (const On_border& p : border_)
      for (int k = 0; k < 3; ++k)
        on_side[k] += (p.sides >> k) & 1;
    while (border_.size() > 3) {
      const std::size_t n = border_.size();
      std::size_t best = n;
      double shortest2 = (std::numeric_limits<double>::infinity)();
      for (std::size_t i = 0; i < n; ++i) {
        const On_border &before = border_[(i + n - 1) % n], &after = border_[(i + 1) % n];
        if ((before.sides & border_[i].sides & after.sides) != 0)
          continue;
        bool is_flat = false; // what is left
        for (int k = 0; k < 3; ++k)
          is_flat = is_flat || on_side[k] - ((border_[i].sides >> k) & 1) == n - 1;
        const double length2 = squared_norm(points_[before.point] - points_[after.point]);
        if (!is_flat && as_far * length2 < shortest2) {
          shortest2 = length2;
          best = i;
        }
      }
      if (best == n)
        break;
      parts_.push_back({border_[(best + n - 1) % n].point, border_[best].point, border_[(best + 1) % n].point});
      for (int k = 0; k < 3; ++k)
        on_side[k] -= (border_[best].sides >> k) & 1;
      border_.erase(border_.begin() + std::ptrdiff_t(best));
    }
    parts_.push_back({border_[0].point, border_[1].point, border_[2].point});
  }

  double orientation_;
  int threads_;
  std::size_t most_; // points
  bool has_divided_ = false;
  std::vector<Vector_3d> points_;
  std::vector<Triangle> triangles_;
  std::vector<Index> parent_;
  std::vector<Index> suspects_; // triangles whose edges may be long
  std::vector<double> resolved_;
  std::vector<Index> origin_; // the nearest of the wall's vertices, as edges are divided
  std::vector<char> is_spike_, is_end_;
  double extent_ = 0;
  std::vector<Vector_3d> normals_; // of obstacles
  Point_boxes obstacles_;          // values are numbers of normals
  Growing_numbering<std::uint64_t, Hash_of_key> edges_;
  std::vector<Chain> chains_; // of each edge
  std::vector<Edge> asked_;
  std::vector<On_border> border_;
  std::vector<Triangle> parts_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_REFINER_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_ESSENTIAL_MEETINGS_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_ESSENTIAL_MEETINGS_H

#include <CGAL/Tubular_meshing/Centerlines/internal/Interior_voronoi_diagram.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Loop_linking.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Voronoi_front.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/number_type_basic.h>

#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where a front meets itself after it has gone round something: the first meetings, as many as the lumen has
 * independent loops, by which each of these is closed.
 *
 * Two neighbours in the diagram, the ways by which the front came to them, and the step from one to the other make a
 * closed line; if it is linked with a loop on the surface (see Loop_linking), the two ways are in different vessels.
 * Holes in the diagram, which irregular samples tear, do not count, however wide the ways round them are; nor do lines
 * that leave the surface, as they may close to a wall that is concave, unless there are no others. The earliest meetings are those where vessels
 * are wide.
 *
 * To tell which of all neighbours have come by different ways, the linking numbers of the ways along the front's tree
 * are added up, vertex by vertex, multiplied by random numbers, so that one number stands for all. O(n log n). */
class Essential_meetings {
public:
  typedef Interior_voronoi_diagram Diagram;
  typedef Diagram::Index Index;
  typedef std::array<Index, 2> Edge;

  typedef Shape_tree<Double_kernel::Triangle_3> Wall;

  Essential_meetings(const Diagram& diagram, const Voronoi_front& front,
                     const std::vector<std::vector<Diagram::Point>>& surface_loops, const Wall& wall)
      : diagram_(diagram)
      , front_(front)
      , wall_(wall)
      , linking_(surface_loops) {
    std::mt19937_64 random; // the same in each run
    for (std::size_t k = 0; k < surface_loops.size(); ++k)
      weights_.push_back(random() | 1);
    sum_along_ways();
    search();
  }

  const std::vector<Edge>& meetings() const { return meetings_; }

private:
  static constexpr int most_trials = 200; // of edges that should have the same numbers
  static constexpr int most_steps_back = 8;

  static bool is_zero(const Loop_linking::Numbers& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](long x) { return x == 0; });
  }

  std::uint64_t share(Index a, Index b) const {
    std::uint64_t sum = 0;
    linking_.for_each_pass(diagram_.points[a], diagram_.points[b],
                           [&](std::size_t loop, int sign) { sum += sign > 0 ? weights_[loop] : -weights_[loop]; });
    return sum;
  }

  void sum_along_ways() {
    vertex_of_rank_.assign(diagram_.points.size(), Diagram::none);
    for (Index v = 0; v < diagram_.points.size(); ++v)
      if (front_.has_reached(v))
        vertex_of_rank_[front_.rank(v)] = v;
    sum_.assign(diagram_.points.size(), 0);
    for (Index v : vertex_of_rank_)
      if (v != Diagram::none && front_.parent(v) != Diagram::none)
        sum_[v] = sum_[front_.parent(v)] + share(front_.parent(v), v);
  }

  // By rank, the later vertex first, in the order in which the front reaches them.
  std::vector<Edge> edges() const {
    std::vector<Edge> result;
    for (Index f = 0; f < diagram_.number_of_faces(); ++f) {
      const Index begin = diagram_.face_begin[f], end = diagram_.face_begin[f + 1];
      for (Index i = begin; i < end; ++i) {
        const Index v = diagram_.face_vertices[i], w = diagram_.face_vertices[i + 1 < end ? i + 1 : begin];
        const Index a = front_.rank(v), b = front_.rank(w);
        if (a != Diagram::none && b != Diagram::none)
          result.push_back(Edge{{(std::max)(a, b), (std::min)(a, b)}});
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  void search() {
    const std::size_t most = weights_.size() / 2;
    Independent_numbers found;
    std::map<std::uint64_t, int> trials; // by what stands for the linking numbers, whatever the direction
    std::vector<std::pair<Edge, Loop_linking::Numbers>>
        crossing; // of each of these the first whose line leaves the surface
    for (const Edge& ranks : edges()) {
      if (found.size() == most)
        break;
      const Edge e = {{vertex_of_rank_[ranks[0]], vertex_of_rank_[ranks[1]]}};
      const std::uint64_t round = sum_[e[1]] + share(e[1], e[0]) - sum_[e[0]];
      if (round == 0 || is_too_short(e))
        continue;
      int& n = trials[(std::min)(round, -round)];
      if (++n > most_trials)
        continue;
      // the ways of steepest descent may be others than those of the tree, but are not from a little before the edge
      Edge from = e;
      std::vector<Diagram::Point> line = line_round(from);
      Loop_linking::Numbers numbers = numbers_of(line);
      for (int step = 0; step < most_steps_back && is_zero(numbers); ++step) {
        for (Index& v : from)
          v = front_.parent(v) != Diagram::none ? front_.parent(v) : v;
        line = line_round(from);
        numbers = numbers_of(line);
      }
      if (is_zero(numbers))
        continue;
      if (crosses_wall(line)) {
        if (n == 1)
          crossing.emplace_back(from, numbers);
        continue;
      }
      n = most_trials;
      if (found.add(numbers))
        meetings_.push_back(from);
    }
    // Lines cut corners where the surface is coarse: such ones are taken for the loops that no other line goes round.
    for (const auto& c : crossing)
      if (found.size() < most && found.add(c.second))
        meetings_.push_back(c.first);
  }

  /* Whether the closed line along the tree is so short that, with the room that its vertices have, it goes round nothing
   * on the wall: what is linked with a curve and keeps a distance r from it is as long as the circle of radius r at
   * least (M. Edelstein and B. Schwarz, On the length of linked curves, 1976). */
  bool is_too_short(const Edge& e) const {
    double length = step(e[0], e[1]), least_radius = (std::min)(diagram_.radii[e[0]], diagram_.radii[e[1]]);
    Index a = e[0], b = e[1];
    while (a != b) {
      Index& later = front_.rank(a) > front_.rank(b) ? a : b;
      length += step(later, front_.parent(later));
      later = front_.parent(later);
      least_radius = (std::min)(least_radius, diagram_.radii[later]);
    }
    return length < 2 * CGAL_PI * least_radius;
  }
  double step(Index a, Index b) const { return distance(diagram_.points[a], diagram_.points[b]); }

  // From one end of the edge to the other, by the front's ways of steepest descent, but for what they have in common.
  std::vector<Diagram::Point> line_round(const Edge& e) const {
    const Sampled_line there = front_.path_from(e[0]), back = front_.path_from(e[1]);
    std::size_t common = 0; // steps
    while (common + 1 < (std::min)(there.size(), back.size()) &&
           there[there.size() - 2 - common].point == back[back.size() - 2 - common].point)
      ++common;
    std::vector<Diagram::Point> line;
    for (std::size_t i = 0; i < there.size() - common; ++i)
      line.push_back(there[i].point);
    for (std::size_t i = back.size() - common - 1; i-- > 0;)
      line.push_back(back[i].point);
    return line;
  }

  Loop_linking::Numbers numbers_of(const std::vector<Diagram::Point>& line) const {
    Loop_linking::Numbers numbers(weights_.size(), 0);
    for (std::size_t i = 0; i < line.size(); ++i)
      linking_.add(line[i], line[(i + 1) % line.size()], 1, numbers);
    return numbers;
  }

  bool crosses_wall(const std::vector<Diagram::Point>& line) const {
    for (std::size_t i = 0; i < line.size(); ++i) {
      Crossing crossing;
      wall_.visit(Double_kernel::Segment_3(line[i], line[(i + 1) % line.size()]), crossing);
      if (crossing.found)
        return true;
    }
    return false;
  }

  // The traversal traits.
  struct Crossing {
    bool found = false;

    bool go_further() const { return !found; }
    template <class Node> bool do_intersect(const Double_kernel::Segment_3& s, const Node& node) const {
      return CGAL::do_overlap(s.bbox(), node.bbox());
    }
    void intersection(const Double_kernel::Segment_3& s, const Wall::Primitive& triangle) {
      found = found || CGAL::do_intersect(s, triangle.datum());
    }
  };

  const Diagram& diagram_;
  const Voronoi_front& front_;
  const Wall& wall_;
  const Loop_linking linking_;
  std::vector<std::uint64_t> weights_; // of the surface's loops
  std::vector<Index> vertex_of_rank_;
  std::vector<std::uint64_t> sum_; // along the way to each vertex
  std::vector<Edge> meetings_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_ESSENTIAL_MEETINGS_H

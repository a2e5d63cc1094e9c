// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_LOOP_LINKING_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_LOOP_LINKING_H

#include <CGAL/Tubular_meshing/base/Box_tree.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* How closed lines inside a surface are linked with loops on it. The linking numbers with loops that generate all those
 * of the surface (see Surface_loops) tell what a line goes round: they are all zero if and only if it can be drawn
 * together inside (Alexander duality; for closed lines, but for commutators). No distance and no size enters.
 *
 * They are counted in the plane, seen along a direction in which nothing lines up: how often a line passes over a loop
 * from its right to its left, less how often it does from its left to its right. For a part of a line, that is its share.
 * O(log n) a step for loops of n edges, and what it passes. */
class Loop_linking {
public:
  typedef Double_kernel::Point_3 Point;
  typedef std::vector<long> Numbers; // one for each loop

  explicit Loop_linking(const std::vector<std::vector<Point>>& loops)
      : number_of_loops_(loops.size()) {
    std::vector<Tree::Box> boxes;
    std::vector<Tree::Place> centers;
    for (std::size_t k = 0; k < loops.size(); ++k)
      for (std::size_t i = 0; i < loops[k].size(); ++i) {
        edges_.push_back({seen(loops[k][i]), seen(loops[k][(i + 1) % loops[k].size()]), k});
        boxes.push_back(box_of(edges_.back().from, edges_.back().to));
        centers.push_back(
            {{(boxes.back().low[0] + boxes.back().high[0]) / 2, (boxes.back().low[1] + boxes.back().high[1]) / 2}});
      }
    tree_ = Tree(std::move(boxes), centers);
  }

  std::size_t number_of_loops() const { return number_of_loops_; }

  /* Calls visit(loop, sign) for each pass of the step from p to q over a loop. */
  template <class Visit> void for_each_pass(const Point& p, const Point& q, const Visit& visit) const {
    const Seen from = seen(p), to = seen(q);
    tree_.for_each_overlapping(box_of(from, to), [&](Tree::Index i) {
      const Edge& e = edges_[i];
      const bool begins_left = is_left(e.from, e.to, from), ends_left = is_left(e.from, e.to, to);
      if (begins_left == ends_left || is_left(from, to, e.from) == is_left(from, to, e.to))
        return;
      if (height_at(from, to, e) > height_at(e, from, to))
        visit(e.loop, ends_left ? 1 : -1);
    });
  }

  /* Adds the shares of a step, times `factor`. */
  void add(const Point& p, const Point& q, long factor, Numbers& numbers) const {
    for_each_pass(p, q, [&](std::size_t loop, int sign) { numbers[loop] += factor * sign; });
  }

private:
  typedef Box_tree<2> Tree;
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_2 Point_2;

  // A point as it is seen, and how high it is above the plane.
  struct Seen {
    Point_2 place;
    double height;
  };
  struct Edge {
    Seen from, to;
    std::size_t loop;
  };

  // Turned by angles of which none is a simple part of a turn, nor is the direction one of a grid.
  static Seen seen(const Point& p) {
    static constexpr double x[3] = {0.819152044288992, 0.409732116391, -0.401335742671};
    static constexpr double y[3] = {-0.130526192220, 0.823456718342, 0.552131456729};
    static constexpr double z[3] = {0.558487345612, -0.393127845172, 0.730451287463};
    const auto along = [&](const double* a) { return a[0] * p.x() + a[1] * p.y() + a[2] * p.z(); };
    return {Point_2(along(x), along(y)), along(z)};
  }

  static Tree::Box box_of(const Seen& a, const Seen& b) {
    Tree::Box box;
    box.add({{a.place.x(), a.place.y()}});
    box.add({{b.place.x(), b.place.y()}});
    return box;
  }

  // Points on the line are on its left, for all steps and edges alike.
  static bool is_left(const Seen& a, const Seen& b, const Seen& p) {
    return CGAL::orientation(a.place, b.place, p.place) != CGAL::RIGHT_TURN;
  }

  static double area(const Seen& a, const Seen& b, const Seen& p) {
    return (b.place.x() - a.place.x()) * (p.place.y() - a.place.y()) -
           (b.place.y() - a.place.y()) * (p.place.x() - a.place.x());
  }
  // The height of the step ab where it crosses the step cd.
  static double height(const Seen& a, const Seen& b, const Seen& c, const Seen& d) {
    const double at_a = area(c, d, a), at_b = area(c, d, b);
    const double t = at_a != at_b ? at_a / (at_a - at_b) : 0.5;
    return a.height + t * (b.height - a.height);
  }
  static double height_at(const Seen& from, const Seen& to, const Edge& e) { return height(from, to, e.from, e.to); }
  static double height_at(const Edge& e, const Seen& from, const Seen& to) { return height(e.from, e.to, from, to); }

  std::size_t number_of_loops_;
  std::vector<Edge> edges_;
  Tree tree_;
};

/* A set of independent vectors of whole numbers, which grows. They are reduced modulo a prime: what is independent so
 * is independent. */
class Independent_numbers {
public:
  // False if the numbers are a sum of multiples of those that are there.
  bool add(const std::vector<long>& numbers) {
    std::vector<long> v;
    for (long x : numbers)
      v.push_back(((x % prime) + prime) % prime);
    for (const Row& row : rows_)
      subtract(row, v[row.pivot], v);
    for (std::size_t i = 0; i < v.size(); ++i)
      if (v[i] != 0) {
        const long factor = inverse(v[i]);
        for (long& x : v)
          x = x * factor % prime;
        rows_.push_back({i, std::move(v)});
        return true;
      }
    return false;
  }
  std::size_t size() const { return rows_.size(); }

private:
  static constexpr long prime = 46337; // its square is less than 2^31
  struct Row {
    std::size_t pivot; // where it is 1
    std::vector<long> numbers;
  };

  static void subtract(const Row& row, long factor, std::vector<long>& v) {
    for (std::size_t i = 0; i < v.size() && factor != 0; ++i)
      v[i] = (v[i] + (prime - factor) * row.numbers[i]) % prime;
  }
  // x to the power of prime − 2.
  static long inverse(long x) {
    long result = 1;
    for (long n = prime - 2; n > 0; n /= 2, x = x * x % prime)
      if (n % 2 == 1)
        result = result * x % prime;
    return result;
  }

  std::vector<Row> rows_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_LOOP_LINKING_H

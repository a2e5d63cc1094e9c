// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_LUMEN_TREE_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_LUMEN_TREE_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <queue>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A graph of centerlines as balls in the lumen, from which branches can be taken that lead into bumps: those that then
 * meet end to end are one. Loops are allowed. */
class Lumen_tree {
public:
  struct Ball {
    Point_3 center;
    double radius;
  };

  /* The balls from a leaf on to the next place where vessels meet, or to the other end. */
  struct Line {
    std::vector<Point_3> points;
    std::vector<double> radii, way; ///< way: the length from the leaf
    std::size_t last_node = 0;      ///< where it ends
    bool ends_at_junction = false;
  };

  /* The balls nearly as large as the largest that a leaf leads to before a neck, and the necks out of them. */
  struct Bulge {
    double radius = 0; ///< of the largest ball
    double length = 0; ///< of the part of the lines with balls nearly as large
    double neck = 0;   ///< radius of a neck of the same area as all necks
    std::size_t number_of_necks = 0;
  };

  explicit Lumen_tree(const Centerline_graph& graph)
      : graph_(graph)
      , is_taken_(graph.branches().size(), false)
      , degree_(graph.nodes().size(), 0) {
    for (std::size_t n = 0; n < graph.nodes().size(); ++n)
      degree_[n] = graph.nodes()[n].branches.size();
  }

  bool is_leaf(std::size_t node) const { return degree_[node] == 1; }

  /* Not further than many of its widest balls. */
  Line line_from(std::size_t leaf) const {
    Line line;
    double widest = 0;
    std::size_t node = leaf, branch = only_branch(leaf);
    append(line, graph_.nodes()[leaf].point);
    for (;;) {
      Walk walk = walk_from(node, branch);
      for (; !walk.is_done(); walk.go_on()) {
        append(line, walk.point());
        widest = (std::max)(widest, line.radii.back());
      }
      node = walk.target;
      line.last_node = node;
      line.ends_at_junction = degree_[node] > 2;
      if (degree_[node] != 2 || node == leaf || line.way.back() > far * widest)
        return line;
      branch = other_branch(node, branch);
    }
  }

  /* Balls of the other lines around the node where the line of a leaf ends, within some radii of it; further on those that
   * the ball of the leaf reaches into, as that of a sac does whose neck it lies in. */
  std::vector<Ball> balls_around(const Line& line) const {
    std::vector<Ball> balls;
    if (!line.ends_at_junction)
      return balls;
    const Point_3& before = line.points[line.points.size() - 2];
    const double reach = 3 * line.radii.back();
    std::vector<std::array<std::size_t, 2>> open; // nodes, branches
    std::vector<double> way;
    const auto open_all = [&](std::size_t node, std::size_t from, double length) {
      for (std::size_t b : graph_.nodes()[node].branches)
        if (!is_taken_[b] && b != from) {
          open.push_back({{node, b}});
          way.push_back(length);
        }
    };
    open_all(line.last_node, std::size_t(-1), 0);
    for (std::size_t i = 0; i < open.size() && i < 1000; ++i) {
      Walk walk = walk_from(open[i][0], open[i][1]);
      if (open[i][0] == line.last_node && graph_.points()[walk.point()] == before)
        continue; // the line itself
      double length = way[i];
      for (; !walk.is_done() && length < 2 * reach; walk.go_on()) {
        length += walk.step();
        const Ball ball = {graph_.points()[walk.point()], graph_.radii()[walk.point()]};
        if (length - walk.step() < reach ||
            point_distance(ball.center, line.points.front()) < ball.radius + line.radii.front())
          balls.push_back(ball);
      }
      if (walk.is_done() && length < 2 * reach)
        open_all(walk.target, open[i][1], length);
    }
    balls.push_back({line.points.back(), line.radii.back()});
    return balls;
  }

  /* Takes the branches of a line from a leaf. */
  void take(std::size_t leaf) {
    std::size_t node = leaf, branch = only_branch(leaf);
    for (;;) {
      is_taken_[branch] = true;
      --degree_[node];
      node = other_node(branch, node);
      --degree_[node];
      if (degree_[node] != 1)
        return; // of 1 there is the next branch of the line
      branch = only_branch(node);
    }
  }

  /* The leaves whose lines end at a node, or pass through it. */
  std::vector<std::size_t> leaves_around(std::size_t node) const {
    std::vector<std::size_t> leaves;
    for (std::size_t first : graph_.nodes()[node].branches) {
      if (is_taken_[first])
        continue;
      std::size_t n = other_node(first, node), b = first;
      while (degree_[n] == 2 && n != node) {
        b = other_branch(n, b);
        n = other_node(b, n);
      }
      if (degree_[n] == 1)
        leaves.push_back(n);
    }
    return leaves;
  }

  /* Goes from the leaf to ever smaller balls, the largest first, as long as they are nearly as large as the largest. */
  Bulge bulge_at(std::size_t leaf, double narrower) const {
    struct Front {
      double radius, way;
      Walk walk;
      bool operator<(const Front& f) const { return radius != f.radius ? radius < f.radius : way > f.way; }
    };
    std::priority_queue<Front> queue;
    std::unordered_set<std::size_t> seen = {leaf};
    Bulge bulge;
    bulge.radius = graph_.radii()[graph_.nodes()[leaf].point];
    const auto push = [&](Walk walk, double way) {
      if (!walk.is_done())
        queue.push({graph_.radii()[walk.point()], way + walk.step(), walk});
    };
    const auto push_all = [&](std::size_t node, std::size_t from, double way) {
      for (std::size_t b : graph_.nodes()[node].branches)
        if (!is_taken_[b] && b != from)
          push(walk_from(node, b), way);
    };
    push_all(leaf, std::size_t(-1), 0);
    std::vector<double> dead_ends;                                        // ways to them
    std::vector<std::pair<double, double>> passed = {{0., bulge.radius}}; // ways, radii
    while (!queue.empty()) {
      Front front = queue.top();
      if (front.radius * narrower < bulge.radius)
        break;
      queue.pop();
      bulge.radius = (std::max)(bulge.radius, front.radius);
      passed.emplace_back(front.way, front.radius);
      if (front.way > far * bulge.radius) { // a long vessel: no bulge
        bulge.length = front.way;
        return bulge;
      }
      const std::size_t node = front.walk.target;
      front.walk.go_on();
      if (!front.walk.is_done())
        push(front.walk, front.way);
      else if (degree_[node] == 1)
        dead_ends.push_back(front.way);
      else if (seen.insert(node).second)
        push_all(node, front.walk.branch, front.way);
    }
    double area = 0;
    std::vector<double> ways = dead_ends;
    for (; !queue.empty(); queue.pop()) {
      const Front& front = queue.top();
      ways.push_back(front.way);
      const double of_neck = area_of_neck(front.walk, front.radius, 2 * bulge.radius);
      area += of_neck;
      bulge.number_of_necks += of_neck > 0 ? 1 : 0;
    }
    bulge.neck = std::sqrt(area);
    bulge.length = length_between(ways, passed, bulge.radius / narrower);
    return bulge;
  }

private:
  static constexpr double far = 25; // times the radius: a vessel so long is no bulge

  // Along the points of a branch, from one of its nodes; at first at the point after that of the node.
  struct Walk {
    const Centerline_graph* graph;
    std::size_t branch, position; // the number of points passed
    bool is_backward;
    std::size_t target;

    const std::vector<std::size_t>& points() const { return graph->branches()[branch].points; }
    std::size_t point_at(std::size_t i) const { return points()[is_backward ? points().size() - 1 - i : i]; }
    std::size_t point() const { return point_at(position); }
    double step() const { return point_distance(graph->points()[point_at(position - 1)], graph->points()[point()]); }
    bool is_done() const { return position >= points().size(); }
    void go_on() { ++position; }
  };

  Walk walk_from(std::size_t node, std::size_t branch) const {
    const auto& b = graph_.branches()[branch];
    return {&graph_, branch, 1, b.source != node, b.source == node ? b.target : b.source};
  }

  std::size_t other_node(std::size_t branch, std::size_t node) const { return walk_from(node, branch).target; }

  std::size_t only_branch(std::size_t node) const { return other_branch(node, std::size_t(-1)); }
  std::size_t other_branch(std::size_t node, std::size_t branch) const {
    for (std::size_t b : graph_.nodes()[node].branches)
      if (!is_taken_[b] && b != branch)
        return b;
    return branch;
  }

  void append(Line& line, std::size_t point) const {
    const Point_3& p = graph_.points()[point];
    line.way.push_back(line.points.empty() ? 0 : line.way.back() + point_distance(line.points.back(), p));
    line.points.push_back(p);
    line.radii.push_back(graph_.radii()[point]);
  }

  // Of the narrowest ball within a way, squared; where the vessel divides before, of the sum of its branches if that is
  // less. None where it ends soon: that is a lobe.
  double area_of_neck(Walk walk, double least, double room) const {
    const double way_at_first = room;
    for (; !walk.is_done(); walk.go_on()) {
      const double r = graph_.radii()[walk.point()];
      least = (std::min)(least, r);
      room -= walk.step();
      if (room < 0 || r > 1.15 * least)
        return least * least;
    }
    const std::size_t node = walk.target;
    if (degree_[node] == 1)
      return way_at_first - room + graph_.radii()[graph_.nodes()[node].point] < 3 * least ? 0 : least * least;
    double sum = 0;
    for (std::size_t b : graph_.nodes()[node].branches)
      if (!is_taken_[b] && b != walk.branch)
        sum += area_of_neck(walk_from(node, b), graph_.radii()[graph_.nodes()[node].point], room);
    return (std::min)(least * least, sum);
  }

  // Between the two most distant of the ends, which are at ways from the leaf, with balls of a radius at least.
  static double length_between(std::vector<double> ends, const std::vector<std::pair<double, double>>& passed,
                               double radius) {
    double first = (std::numeric_limits<double>::infinity)();
    for (const auto& p : passed)
      if (p.second >= radius)
        first = (std::min)(first, p.first);
    std::sort(ends.rbegin(), ends.rend());
    double length = 0;
    for (std::size_t i = 0; i < ends.size() && i < 2; ++i)
      length += (std::max)(0., ends[i] - first);
    return length;
  }

  const Centerline_graph& graph_;
  std::vector<bool> is_taken_;      // by branch
  std::vector<std::size_t> degree_; // by node, without branches that are taken
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_LUMEN_TREE_H

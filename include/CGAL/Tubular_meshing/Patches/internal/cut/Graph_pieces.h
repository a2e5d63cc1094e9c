// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_GRAPH_PIECES_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_GRAPH_PIECES_H

#include <CGAL/Tubular_meshing/Patches/internal/cut/Disk_cutter.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A part of a branch: between two of its cuts, or a cut and an end, or all of it. */
struct Branch_part {
  std::size_t branch;
  double from, to;
  double length() const { return to - from; }
};

/* What the cuts leave of the centerlines around a node: connected parts of branches. */
struct Graph_piece {
  std::vector<std::size_t> nodes;
  std::vector<Branch_part> parts;
  std::vector<Branch_part> longest_way; // from one of its ends to another, in order along it
  double length = 0;                    // see Piece_finder
  double min_radius = (std::numeric_limits<double>::infinity)(), max_radius = 0;

  double aspect_ratio() const { return length / (min_radius + max_radius); }
};

/* Finds the piece around a node, and its length: of a tube, along its centerline; of a junction, the greatest way
 * downstream from one of its ends to another, or the greatest distance between two ends, if that is greater. The way
 * from one daughter vessel back to the other does not count: it says nothing of two that run side by side.
 * O(piece) for trees, and O(ends²) of the piece. */
class Piece_finder {
public:
  explicit Piece_finder(const Disk_cutter& cutter)
      : cutter_(cutter)
      , graph_(cutter.graph()) {}

  Graph_piece piece_at(size_type node) {
    piece_ = Graph_piece();
    points_.clear();
    number_.clear();
    collect(node);
    for (const Branch_part& p : piece_.parts)
      measure(p);
    find_length();
    return std::move(piece_);
  }

  // A piece that is one part of a branch.
  Graph_piece piece_of(const Branch_part& part) {
    piece_ = Graph_piece();
    piece_.parts = piece_.longest_way = {part};
    piece_.length = part.length();
    measure(part);
    return std::move(piece_);
  }

private:
  static constexpr size_type none = (std::numeric_limits<size_type>::max)();

  // A part of a branch that leads to another point of the piece, along the branch's direction or against it.
  struct Link {
    size_type part, other;
    bool downstream;
  };

  // A node or a cut.
  struct Point {
    Vector_3d position;
    std::vector<Link> links;
  };

  size_type point_at(size_type node) {
    const auto inserted = number_.insert(std::make_pair(node, points_.size()));
    if (inserted.second) {
      points_.push_back(Point{Vector_3d(graph_.points()[graph_.nodes()[node].point]), {}});
      piece_.nodes.push_back(node);
    }
    return inserted.first->second;
  }

  size_type point_at_cut(size_type branch, double abscissa) {
    points_.push_back(Point{cutter_.axis(branch).point(abscissa), {}});
    return points_.size() - 1;
  }

  void join(const Branch_part& part, size_type source, size_type target) {
    points_[source].links.push_back(Link{piece_.parts.size(), target, true});
    points_[target].links.push_back(Link{piece_.parts.size(), source, false});
    piece_.parts.push_back(part);
  }

  void collect(size_type start) {
    std::unordered_set<size_type> done;
    point_at(start);
    for (size_type head = 0; head < piece_.nodes.size(); ++head)
      for (size_type i : graph_.nodes()[piece_.nodes[head]].branches)
        add_branch(i, piece_.nodes[head], done);
  }

  void add_branch(size_type i, size_type node, std::unordered_set<size_type>& done) {
    const auto& b = graph_.branches()[i];
    const std::vector<size_type>& cuts = cutter_.cuts_of(i);
    if (cuts.empty()) {
      if (done.insert(i).second) {
        const size_type source = point_at(b.source), target = point_at(b.target);
        join(Branch_part{i, 0, b.length}, source, target);
      }
      return;
    }
    const size_type here = point_at(node), target_part = graph_.branches().size() + i;
    const double first = cutter_.abscissa_of(cuts.front()), last = cutter_.abscissa_of(cuts.back());
    if (b.source == node && done.insert(i).second)
      join(Branch_part{i, 0, first}, here, point_at_cut(i, first));
    if (b.target == node && done.insert(target_part).second)
      join(Branch_part{i, last, b.length}, point_at_cut(i, last), here);
  }

  void measure(const Branch_part& p) {
    const std::pair<double, double> r = cutter_.axis(p.branch).radius_range(p.from, p.to);
    piece_.min_radius = (std::min)(piece_.min_radius, r.first);
    piece_.max_radius = (std::max)(piece_.max_radius, r.second);
  }

  void find_length() {
    std::vector<size_type> ends;
    for (size_type i = 0; i < points_.size(); ++i)
      if (points_[i].links.size() == 1)
        ends.push_back(i);
    const bool is_junction = ends.size() > 2;
    size_type from = 0, to = 0;
    const auto consider = [&](size_type a, size_type b, double length) {
      if (length > piece_.length) {
        piece_.length = length;
        from = a;
        to = b;
      }
    };
    for (size_type a : ends) {
      find_ways(a, is_junction);
      for (size_type b : ends) {
        consider(a, b, distance_[b]);
        if (is_junction)
          consider(a, b, norm(points_[b].position - points_[a].position));
      }
    }
    find_ways(from, false);
    for (size_type at = to; at != from; at = back_[at].other)
      piece_.longest_way.push_back(piece_.parts[back_[at].part]);
  }

  // Ways from a point to the others, −1 where there is none. A piece has no cycles, as a rule; if it has, any way will
  // do.
  void find_ways(size_type start, bool only_downstream) {
    distance_.assign(points_.size(), -1.);
    back_.assign(points_.size(), Link{none, none, false});
    std::vector<size_type> queue(1, start);
    distance_[start] = 0;
    for (size_type head = 0; head < queue.size(); ++head)
      for (const Link& link : points_[queue[head]].links)
        if (distance_[link.other] < 0 && (link.downstream || !only_downstream)) {
          distance_[link.other] = distance_[queue[head]] + piece_.parts[link.part].length();
          back_[link.other] = Link{link.part, queue[head], !link.downstream};
          queue.push_back(link.other);
        }
  }

  const Disk_cutter& cutter_;
  const Centerline_graph& graph_;
  Graph_piece piece_;
  std::vector<Point> points_;
  std::unordered_map<size_type, size_type> number_; // of a node's point
  std::vector<double> distance_;                    // of the last ways found
  std::vector<Link> back_;
};

/* The pieces into which cuts part the whole graph, numbered along it from its root. */
class Graph_partition {
public:
  // O(graph)
  explicit Graph_partition(const Disk_cutter& cutter)
      : cutter_(cutter)
      , piece_of_part_(cutter.graph().branches().size()) {
    Piece_finder finder(cutter);
    std::vector<size_type> piece_at_node(cutter.graph().nodes().size(), none);
    const auto at_node = [&](size_type node) {
      if (piece_at_node[node] == none) {
        pieces_.push_back(finder.piece_at(node));
        for (size_type n : pieces_.back().nodes)
          piece_at_node[n] = pieces_.size() - 1;
      }
      return piece_at_node[node];
    };
    for (size_type i : branches_from_root()) {
      const auto& b = cutter.graph().branches()[i];
      const std::vector<size_type>& cuts = cutter.cuts_of(i);
      piece_of_part_[i].push_back(at_node(b.source));
      for (size_type k = 1; k < cuts.size(); ++k) {
        pieces_.push_back(
            finder.piece_of(Branch_part{i, cutter.abscissa_of(cuts[k - 1]), cutter.abscissa_of(cuts[k])}));
        piece_of_part_[i].push_back(pieces_.size() - 1);
      }
      if (!cuts.empty())
        piece_of_part_[i].push_back(at_node(b.target));
    }
  }

  const std::vector<Graph_piece>& pieces() const { return pieces_; }
  /// Of the branch's parts: 0 before its first cut, 1 behind that, …
  size_type piece_of(size_type branch, size_type part) const { return piece_of_part_[branch][part]; }
  /// The branches, breadth first from the graph's root.
  std::vector<size_type> branches_from_root() const {
    const auto& graph = cutter_.graph();
    std::vector<bool> node_done(graph.nodes().size(), false), branch_done(graph.branches().size(), false);
    std::vector<size_type> order;
    for (size_type n = 0; n <= graph.nodes().size(); ++n) // the root's component first
      add_from(n == 0 ? graph.root() : n - 1, node_done, branch_done, order);
    return order;
  }

private:
  static constexpr size_type none = (std::numeric_limits<size_type>::max)();

  void add_from(size_type start, std::vector<bool>& node_done, std::vector<bool>& branch_done,
                std::vector<size_type>& order) const {
    const auto& graph = cutter_.graph();
    if (node_done[start])
      return;
    node_done[start] = true;
    std::vector<size_type> queue(1, start);
    for (size_type head = 0; head < queue.size(); ++head)
      for (size_type i : graph.nodes()[queue[head]].branches) {
        if (branch_done[i])
          continue;
        branch_done[i] = true;
        order.push_back(i);
        for (size_type n : {graph.branches()[i].source, graph.branches()[i].target})
          if (!node_done[n]) {
            node_done[n] = true;
            queue.push_back(n);
          }
      }
  }

  const Disk_cutter& cutter_;
  std::vector<std::vector<size_type>> piece_of_part_;
  std::vector<Graph_piece> pieces_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_GRAPH_PIECES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_CUT_GRAPH_PIECES_H
#define CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_CUT_GRAPH_PIECES_H

#include <CGAL/Tubular_meshing/Operators/internal/cut/Branch_axis.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

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
  double length = 0;                    // of the longest way
  double min_radius = (std::numeric_limits<double>::infinity)(), max_radius = 0;

  double aspect_ratio() const { return length / (min_radius + max_radius); }
};

/* Finds the piece around a node. O(piece), but for looking up radii. */
template <class Cutter> class Piece_finder {
public:
  typedef std::size_t size_type;

  explicit Piece_finder(const Cutter& cutter)
      : cutter_(cutter)
      , graph_(cutter.graph()) {}

  Graph_piece piece_at(size_type node) {
    piece_ = Graph_piece();
    links_.clear();
    number_.clear();
    collect(node);
    for (const Branch_part& p : piece_.parts)
      measure(p);
    find_longest_way();
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

  // A part of a branch that joins two points of the piece: nodes or cuts.
  struct Link {
    size_type part, other;
  };

  size_type point_at(size_type node) {
    const auto inserted = number_.insert(std::make_pair(node, links_.size()));
    if (inserted.second) {
      links_.emplace_back();
      piece_.nodes.push_back(node);
    }
    return inserted.first->second;
  }

  size_type new_point() {
    links_.emplace_back();
    return links_.size() - 1;
  }

  void join(const Branch_part& part, size_type u, size_type v) {
    links_[u].push_back(Link{piece_.parts.size(), v});
    links_[v].push_back(Link{piece_.parts.size(), u});
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
    const size_type u = point_at(node);
    if (cuts.empty()) {
      if (done.insert(i).second)
        join(Branch_part{i, 0, b.length}, point_at(b.source), point_at(b.target));
      return;
    }
    if (b.source == node && (b.source != b.target || done.insert(i).second))
      join(Branch_part{i, 0, cutter_.abscissa_of(cuts.front())}, u, new_point());
    if (b.target == node && (b.source != b.target || done.insert(i + graph_.branches().size()).second))
      join(Branch_part{i, cutter_.abscissa_of(cuts.back()), b.length}, u, new_point());
  }

  void measure(const Branch_part& p) {
    const std::pair<double, double> r = cutter_.axis(p.branch).radius_range(p.from, p.to);
    piece_.min_radius = (std::min)(piece_.min_radius, r.first);
    piece_.max_radius = (std::max)(piece_.max_radius, r.second);
  }

  // In a tree: what is furthest from any point is an end of the longest way.
  void find_longest_way() {
    std::vector<Link> back;
    const size_type one_end = furthest(0, back), other_end = furthest(one_end, back);
    for (size_type at = other_end; at != one_end; at = back[at].other) {
      piece_.longest_way.push_back(piece_.parts[back[at].part]);
      piece_.length += piece_.longest_way.back().length();
    }
  }

  size_type furthest(size_type start, std::vector<Link>& back) const {
    std::vector<double> distance(links_.size(), -1.);
    back.assign(links_.size(), Link{none, none});
    std::vector<size_type> queue(1, start);
    distance[start] = 0;
    size_type best = start;
    for (size_type head = 0; head < queue.size(); ++head)
      for (const Link& link : links_[queue[head]])
        if (distance[link.other] < 0) {
          distance[link.other] = distance[queue[head]] + piece_.parts[link.part].length();
          back[link.other] = Link{link.part, queue[head]};
          queue.push_back(link.other);
          if (distance[link.other] > distance[best])
            best = link.other;
        }
    return best;
  }

  const Cutter& cutter_;
  const typename Cutter::Graph& graph_;
  Graph_piece piece_;
  std::vector<std::vector<Link>> links_; // of each point
  std::unordered_map<size_type, size_type> number_;
};

/* The pieces into which cuts part the whole graph, numbered along it from its root. */
template <class Cutter> class Graph_partition {
public:
  typedef std::size_t size_type;

  // O(graph)
  explicit Graph_partition(const Cutter& cutter)
      : cutter_(cutter)
      , piece_of_part_(cutter.graph().branches().size()) {
    Piece_finder<Cutter> finder(cutter);
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

  const Cutter& cutter_;
  std::vector<std::vector<size_type>> piece_of_part_;
  std::vector<Graph_piece> pieces_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_CUT_GRAPH_PIECES_H

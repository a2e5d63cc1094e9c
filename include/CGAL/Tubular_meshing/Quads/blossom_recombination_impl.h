// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_BLOSSOM_RECOMBINATION_IMPL_H
#define CGAL_TUBULAR_MESHING_QUADS_BLOSSOM_RECOMBINATION_IMPL_H

#include <CGAL/Tubular_meshing/Quads/blossom_recombination.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>

// LEMON 1.3 calls members of std::allocator that C++20 has removed.
#if defined(CGAL_TUBULAR_MESHING_WITH_LEMON) && __cplusplus < 202002L
#define CGAL_TUBULAR_MESHING_HAS_LEMON
// LEMON's library holds nothing but a constant that is needed here: so there is nothing to link.
#ifndef LEMON_ONLY_TEMPLATES
#define LEMON_ONLY_TEMPLATES
#endif
#include <boost/pending/disjoint_sets.hpp>
#include <lemon/matching.h>
#include <lemon/smart_graph.h>
#endif

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE bool has_lemon() {
#ifdef CGAL_TUBULAR_MESHING_HAS_LEMON
  return true;
#else
  return false;
#endif
}

namespace internal {

#ifdef CGAL_TUBULAR_MESHING_HAS_LEMON

/* The nodes and pairs of each connected component of a graph. */
struct Graph_components {
  Graph_components(std::size_t number_of_nodes, const std::vector<Node_pair>& pairs) {
    boost::disjoint_sets_with_storage<> sets(number_of_nodes);
    for (const Node_pair& p : pairs)
      sets.union_set(std::size_t(p.first), std::size_t(p.second));
    std::vector<int> number(number_of_nodes, -1);
    for (int v = 0; v < int(number_of_nodes); ++v) {
      int& k = number[sets.find_set(std::size_t(v))];
      if (k < 0) {
        k = int(nodes.size());
        nodes.emplace_back();
        edges.emplace_back();
      }
      nodes[std::size_t(k)].push_back(v);
    }
    for (std::size_t e = 0; e < pairs.size(); ++e)
      edges[std::size_t(number[sets.find_set(std::size_t(pairs[e].first))])].push_back(e);
  }

  std::vector<std::vector<int>> nodes;
  std::vector<std::vector<std::size_t>> edges;
};

/* The matching of one connected graph. Costs become integers, with which LEMON's result is exact. */
class Component_matcher {
public:
  typedef lemon::SmartGraph Graph;
  typedef long long Weight;
  typedef Graph::EdgeMap<Weight> Weights;

  Component_matcher(const std::vector<int>& nodes, const std::vector<std::size_t>& edges,
                    const std::vector<Node_pair>& pairs, std::vector<int>& position)
      : edges_(edges)
      , pairs_(pairs)
      , weights_(graph_) {
    graph_.reserveNode(int(nodes.size()));
    graph_.reserveEdge(int(edges.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      graph_.addNode();
      position[std::size_t(nodes[i])] = int(i);
    }
    for (std::size_t e : edges) {
      graph_.addEdge(Graph::nodeFromId(position[std::size_t(pairs[e].first)]),
                     Graph::nodeFromId(position[std::size_t(pairs[e].second)]));
      greatest_cost_ = (std::max)(greatest_cost_, pairs[e].cost);
    }
  }

  void run(std::vector<std::size_t>& chosen) {
    if (graph_.nodeNum() % 2 == 0) {
      set_weights(finest, 0);
      lemon::MaxWeightedPerfectMatching<Graph, Weights> matching(graph_, weights_);
      if (matching.run())
        return collect(matching, chosen);
    }
    // One pair more outweighs what all others can cost; the grid of costs is as fine as that leaves room for.
    const double room = 1e17, all = (greatest_cost_ + 1) * (graph_.nodeNum() / 2 + 1);
    set_weights((std::min)(finest, room / all), all);
    lemon::MaxWeightedMatching<Graph, Weights> matching(graph_, weights_);
    matching.run();
    collect(matching, chosen);
  }

private:
  static constexpr double finest = 1 << 20; // steps of a cost of one

  void set_weights(double steps, double bonus) {
    for (std::size_t i = 0; i < edges_.size(); ++i)
      weights_[Graph::edgeFromId(int(i))] = std::llround(steps * bonus) - std::llround(steps * pairs_[edges_[i]].cost);
  }
  template <class Matching> void collect(const Matching& matching, std::vector<std::size_t>& chosen) const {
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (matching.matching(Graph::edgeFromId(int(i))))
        chosen.push_back(edges_[i]);
  }

  const std::vector<std::size_t>& edges_;
  const std::vector<Node_pair>& pairs_;
  Graph graph_;
  Weights weights_;
  double greatest_cost_ = 0;
};

#endif

CGAL_TUBULAR_MESHING_INLINE std::vector<std::size_t> minimum_cost_matching(std::size_t number_of_nodes,
                                                                           const std::vector<Node_pair>& pairs) {
  std::vector<std::size_t> chosen;
#ifdef CGAL_TUBULAR_MESHING_HAS_LEMON
  const Graph_components components(number_of_nodes, pairs);
  std::vector<int> position(number_of_nodes);
  for (std::size_t k = 0; k < components.nodes.size(); ++k)
    if (!components.edges[k].empty())
      Component_matcher(components.nodes[k], components.edges[k], pairs, position).run(chosen);
  std::sort(chosen.begin(), chosen.end());
#else
  (void)number_of_nodes, (void)pairs;
  throw Meshing_error("This program was built without LEMON, by which triangles are paired: build it in C++17, where "
                      "CMake finds LEMON (liblemon-dev).");
#endif
  return chosen;
}

} // namespace internal
} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUADS_BLOSSOM_RECOMBINATION_IMPL_H

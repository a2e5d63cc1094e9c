// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_NETWORK_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_NETWORK_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Opening_rim.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Vessel_path.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The vessels between junctions and ends: branches of the centerline graph, but for those between two junctions that are
 * nearer to each other than a part of their radius. The junctions there are one. */
class Vessel_network {
public:
  struct Vessel {
    Vessel_path path;
    std::array<std::size_t, 2> nodes; // from, to
    std::size_t branch;               // of the graph
  };
  // The end of a vessel at a node: the one where its path begins, or the other.
  struct Vessel_end {
    std::size_t vessel;
    bool last;
  };
  struct Node {
    Vector_3d point;
    std::vector<Vessel_end> ends;
    int opening = 0; // the label of its cap; 0 for a junction, and for a vessel's blind end
    bool is_junction() const { return ends.size() > 1; }
    bool is_blind() const { return ends.size() == 1 && opening == 0; }
  };

  std::vector<Vessel> vessels;
  std::vector<Node> nodes;
  std::vector<int> openings_without_vessel;

  /* `nearness`: in radii, how near junctions are that become one;
   * those at the ends of the branches in `joined` do in any case. */
  Vessel_network(const Centerline_graph& graph, const Opening_rims& openings, double nearness,
                 const std::set<std::size_t>& joined) {
    std::vector<std::size_t> merged(graph.nodes().size());
    std::iota(merged.begin(), merged.end(), std::size_t(0));
    const auto root = [&](std::size_t n) {
      while (merged[n] != n)
        n = merged[n];
      return n;
    };
    std::vector<bool> contracted(graph.branches().size());
    for (std::size_t b = 0; b < graph.branches().size(); ++b) {
      const auto& branch = graph.branches()[b];
      const bool inner = !graph.nodes()[branch.source].is_end() && !graph.nodes()[branch.target].is_end();
      if (!inner || (branch.length >= nearness * branch.max_radius && joined.count(b) == 0))
        continue;
      const std::size_t s = root(branch.source), t = root(branch.target);
      contracted[b] = s != t; // else it closes a loop
      merged[(std::max)(s, t)] = (std::min)(s, t);
    }
    std::vector<std::size_t> number(graph.nodes().size(), std::size_t(-1)), members;
    const auto node_of = [&](std::size_t n) {
      const std::size_t r = root(n);
      if (number[r] == std::size_t(-1)) {
        number[r] = nodes.size();
        nodes.emplace_back();
        members.push_back(0);
      }
      return number[r];
    };
    for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
      Node& node = nodes[node_of(n)];
      node.point += Vector_3d(graph.points()[graph.nodes()[n].point]);
      ++members[node_of(n)];
    }
    for (std::size_t n = 0; n < nodes.size(); ++n)
      nodes[n].point = (1. / double(members[n])) * nodes[n].point;
    for (std::size_t b = 0; b < graph.branches().size(); ++b)
      if (!contracted[b]) {
        const auto& branch = graph.branches()[b];
        Vessel v{{}, {{node_of(branch.source), node_of(branch.target)}}, b};
        for (std::size_t p : branch.points)
          v.path.push_back(Vector_3d(graph.points()[p]), graph.radii()[p]);
        nodes[v.nodes[0]].ends.push_back({vessels.size(), false});
        nodes[v.nodes[1]].ends.push_back({vessels.size(), true});
        vessels.push_back(std::move(v));
      }
    for (const auto& [label, rim] : openings)
      if (Node* n = nearest(rim, [](const Node& node) { return node.is_blind(); }))
        n->opening = label;
      else if (Node* j = nearest(rim, [&](const Node& node) { return can_have_trunk(node, graph.branches().size()); }))
        add_trunk(std::size_t(j - nodes.data()), label, rim, graph.branches().size() + trunks_++);
      else
        openings_without_vessel.push_back(label);
  }

  // The end of a vessel at the node where its path begins, or ends: its place among the node's.
  std::size_t place_at(std::size_t node, std::size_t vessel, bool last) const {
    const std::vector<Vessel_end>& ends = nodes[node].ends;
    std::size_t i = 0;
    while (ends[i].vessel != vessel || ends[i].last != last)
      ++i;
    return i;
  }

private:
  // The nearest of some nodes that lies in an opening: not farther from its center than the opening is wide.
  template <class Counts> Node* nearest(const Opening_rim& rim, const Counts& counts) {
    Node* result = nullptr;
    double least = rim.radius;
    for (Node& n : nodes)
      if (counts(n) && norm(n.point - rim.center) < least) {
        least = norm(n.point - rim.center);
        result = &n;
      }
    return result;
  }

  // A junction of vessels that lead elsewhere and have a length, none of them a trunk.
  bool can_have_trunk(const Node& node, std::size_t number_of_branches) const {
    return node.is_junction() && std::all_of(node.ends.begin(), node.ends.end(), [&](const Vessel_end& e) {
             const Vessel& v = vessels[e.vessel];
             return v.path.points.size() > 1 && v.nodes[0] != v.nodes[1] && v.branch < number_of_branches;
           });
  }

  /* Where several vessels begin in an opening, as an atrium's veins do in its valve, they are to begin a part of its
   * radius inside, where a vessel leads to the opening. */
  void add_trunk(std::size_t junction, int label, const Opening_rim& rim, std::size_t branch) {
    double depth = 0.75 * rim.radius;
    for (const Vessel_end& e : nodes[junction].ends)
      depth = (std::min)(depth, 0.5 * vessels[e.vessel].path.length());
    Vector_3d sum;
    double radius = 0;
    for (const Vessel_end& e : nodes[junction].ends) {
      const Vessel_path path = path_from(e).from(depth);
      sum += path.points.front();
      radius = (std::max)(radius, path.radii.front());
      vessels[e.vessel].path = e.last ? path.reversed() : path;
    }
    Node& n = nodes[junction];
    n.point = (1. / double(n.ends.size())) * sum;
    Vessel trunk{{}, {{junction, nodes.size()}}, branch};
    trunk.path.push_back(n.point, radius);
    trunk.path.push_back(rim.center, rim.radius);
    n.ends.push_back({vessels.size(), false});
    nodes.push_back({rim.center, {{vessels.size(), true}}, label});
    vessels.push_back(std::move(trunk));
  }

  std::size_t trunks_ = 0;

public:
  // From the node on.
  Vessel_path path_from(const Vessel_end& e) const {
    return e.last ? vessels[e.vessel].path.reversed() : vessels[e.vessel].path;
  }
  // Of all vessels at a node.
  std::vector<Vessel_path> paths_from(std::size_t node) const {
    std::vector<Vessel_path> paths;
    for (const Vessel_end& e : nodes[node].ends)
      paths.push_back(path_from(e));
    return paths;
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_NETWORK_H

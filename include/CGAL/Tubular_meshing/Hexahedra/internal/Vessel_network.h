// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_NETWORK_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_NETWORK_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A polyline with a radius at each point. */
struct Vessel_path {
  std::vector<Vector_3d> points;
  std::vector<double> radii, abscissa;

  void push_back(const Vector_3d& p, double r) {
    const double a = points.empty() ? 0 : abscissa.back() + norm(p - points.back());
    if (!points.empty() && a == abscissa.back())
      return;
    points.push_back(p);
    radii.push_back(r);
    abscissa.push_back(a);
  }
  double length() const { return abscissa.back(); }

  // A place on the path: the segment, and how far along.
  std::pair<std::size_t, double> at(double a) const {
    const auto next = std::upper_bound(abscissa.begin() + 1, abscissa.end() - 1, a);
    const std::size_t i = std::size_t(next - abscissa.begin()) - 1;
    return {i, (std::min)((std::max)((a - abscissa[i]) / (abscissa[i + 1] - abscissa[i]), 0.), 1.)};
  }
  Vector_3d point(double a) const {
    const auto [i, t] = at(a);
    return (1 - t) * points[i] + t * points[i + 1];
  }
  double radius(double a) const {
    const auto [i, t] = at(a);
    return (1 - t) * radii[i] + t * radii[i + 1];
  }
  // The direction of the chord over `width`.
  Vector_3d tangent(double a, double width) const {
    const double first = (std::max)(a - width / 2, 0.), last = (std::min)(a + width / 2, length());
    return normalized(point(last) - point(first));
  }
  Vessel_path reversed() const {
    Vessel_path result;
    for (std::size_t i = points.size(); i-- > 0;)
      result.push_back(points[i], radii[i]);
    return result;
  }
};

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
    bool is_junction() const { return ends.size() > 2; }
  };

  std::vector<Vessel> vessels;
  std::vector<Node> nodes;

  /* `nearness`: in radii, how near junctions are that become one. */
  Vessel_network(const Centerline_graph& graph, const std::vector<Opening>& openings, double nearness) {
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
      if (!inner || branch.length >= nearness * branch.max_radius)
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
    for (const Opening& o : openings)
      if (o.node != Opening::no_branch)
        nodes[node_of(o.node)].opening = o.patch;
  }

  // From the node on.
  Vessel_path path_from(const Vessel_end& e) const {
    return e.last ? vessels[e.vessel].path.reversed() : vessels[e.vessel].path;
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_NETWORK_H

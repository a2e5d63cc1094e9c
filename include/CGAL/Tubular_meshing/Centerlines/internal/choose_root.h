// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CHOOSE_ROOT_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CHOOSE_ROOT_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_line.h>
#include <CGAL/Tubular_meshing/Centerlines/graph_segments.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// Half-way along the branch: at the very end of a closed surface the nearest wall is the cap.
inline double radius_of_end(const Centerline_graph& graph, std::size_t node) {
  const auto& points = graph.branches()[graph.nodes()[node].branches.front()].points;
  return graph.radii()[points[points.size() / 2]];
}

/* The end at which most of the lines start or end, two at least; among equals, and if there is none, the end of largest
 * radius; node 0 of a graph without ends. Lines count for an end within two radii of it. O(n log n). */
inline std::size_t choose_root(const Centerline_graph& graph, const std::vector<Sampled_line>& lines) {
  Graph_segments where(graph);
  const Nearest_tree<Double_kernel::Segment_3> tree(std::move(where.segments));
  std::vector<std::size_t> votes(graph.nodes().size(), 1); // one line or none: no common start

  std::vector<std::size_t> lines_at(graph.nodes().size(), 0);
  const auto vote = [&](const Line_point& p) {
    const auto found = tree.nearest(p.point);
    const Centerline_graph::Branch& b = graph.branches()[where.places[found.index].branch];
    const double abscissa = b.abscissa[where.places[found.index].segment];
    const std::size_t node = abscissa < 0.5 * b.length ? b.source : b.target;
    const double away = distance(p.point, to_double_point(graph.points()[graph.nodes()[node].point]));
    if (graph.nodes()[node].is_end() && away <= 2 * p.radius)
      ++lines_at[node];
  };
  for (const Sampled_line& line : lines) {
    vote(line.front());
    vote(line.back());
  }

  std::size_t best = 0;
  bool found = false;
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    if (!graph.nodes()[n].is_end())
      continue;
    votes[n] = (std::max)(votes[n], lines_at[n]);
    const double r = radius_of_end(graph, n), best_r = found ? radius_of_end(graph, best) : 0;
    if (!found || votes[n] > votes[best] || (votes[n] == votes[best] && r > best_r))
      best = n;
    found = true;
  }
  return best;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CHOOSE_ROOT_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_BRANCHED_CENTERLINES_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_BRANCHED_CENTERLINES_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/branched_centerlines.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL::Tubular_meshing {

namespace internal {

/* Cuts paths of branches into tracts. A bifurcation reaches one local radius from its node into each branch, but no
 * further than to a third of the branch's length. */
class Tract_cutter {
public:
  typedef Centerline_graph Graph;

  explicit Tract_cutter(const Graph& graph)
      : graph_(graph) {}

  // `path`: branches from the root on, each beginning where the one before ends
  void add_line(const std::vector<std::size_t>& path) {
    int tract = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Graph::Branch& b = graph_.branches()[path[i]];
      const std::size_t from = i == 0 ? 0 : cut_after_source(b);
      const std::size_t to = i + 1 == path.size() ? b.points.size() - 1 : cut_before_target(b);
      if (i > 0)
        through_.insert(through_.end(), b.points.begin() + 1, b.points.begin() + from + 1);
      if (i > 0)
        add_tract(through_, tract++, int(graph_.branches().size() + b.source), 1);
      add_tract({b.points.begin() + from, b.points.begin() + to + 1}, tract++, int(path[i]), 0);
      through_.assign(b.points.begin() + to, b.points.end());
    }
    ++line_;
  }

  Branched_centerlines result() { return std::move(result_); }

private:
  typedef std::vector<std::size_t> Polyline;

  std::size_t cut_after_source(const Graph::Branch& b) const {
    const double reach = (std::min)(graph_.radii()[b.points.front()], b.length / 3);
    std::size_t i = 1;
    while (i + 2 < b.points.size() && b.abscissa[i] < reach)
      ++i;
    return b.points.size() > 2 ? i : 0;
  }

  std::size_t cut_before_target(const Graph::Branch& b) const {
    const double reach = (std::min)(graph_.radii()[b.points.back()], b.length / 3);
    std::size_t i = b.points.size() - 2;
    while (i > 1 && i > cut_after_source(b) + 1 && b.length - b.abscissa[i] < reach)
      --i;
    return b.points.size() > 2 && i > cut_after_source(b) ? i : b.points.size() - 1;
  }

  void add_tract(const Polyline& points, int tract, int group, int blanking) {
    Centerline_polylines& lines = result_.lines;
    lines.lines.emplace_back();
    for (std::size_t p : points) {
      lines.lines.back().push_back(lines.points.size());
      lines.points.push_back(graph_.points()[p]);
      lines.radius.push_back(graph_.radii()[p]);
    }
    result_.centerline_ids.push_back(line_);
    result_.tract_ids.push_back(tract);
    result_.group_ids.push_back(group);
    result_.blanking.push_back(blanking);
  }

  const Graph& graph_;
  int line_ = 0;
  Polyline through_; // the bifurcation that is being passed
  Branched_centerlines result_;
};

// The paths from the root along the branches' directions: to each end, and one through each branch that no other uses.
inline std::vector<std::vector<std::size_t>> paths_from_root(const Centerline_graph& graph) {
  const std::size_t none = std::size_t(-1);
  std::vector<std::size_t> entered_by(graph.nodes().size(), none), queue;
  std::vector<bool> found(graph.nodes().size(), false), used(graph.branches().size(), false);
  queue.push_back(graph.root());
  found[graph.root()] = true;
  for (std::size_t head = 0; head < queue.size(); ++head)
    for (std::size_t b : graph.nodes()[queue[head]].branches) {
      const std::size_t target = graph.branches()[b].target;
      if (graph.branches()[b].source == queue[head] && !found[target]) {
        found[target] = true;
        entered_by[target] = b;
        queue.push_back(target);
      }
    }
  std::vector<std::vector<std::size_t>> paths;
  const auto add_path = [&](std::size_t last) {
    std::vector<std::size_t> path;
    for (std::size_t b = last; b != none; b = entered_by[graph.branches()[b].source]) {
      path.push_back(b);
      used[b] = true;
    }
    std::reverse(path.begin(), path.end());
    paths.push_back(std::move(path));
  };
  for (std::size_t n = 0; n < graph.nodes().size(); ++n)
    if (graph.nodes()[n].is_end() && entered_by[n] != none)
      add_path(entered_by[n]);
  for (std::size_t b = 0; b < graph.branches().size(); ++b)
    if (!used[b] && found[graph.branches()[b].source])
      add_path(b);
  return paths;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Branched_centerlines branched_centerlines(const Centerline_graph& graph) {
  internal::Tract_cutter cutter(graph);
  if (!graph.empty())
    for (const std::vector<std::size_t>& path : internal::paths_from_root(graph))
      cutter.add_line(path);
  return cutter.result();
}

CGAL_TUBULAR_MESHING_INLINE Centerline_polylines centerlines_from_root(const Centerline_graph& graph) {
  Centerline_polylines result;
  if (graph.empty())
    return result;
  for (const std::vector<std::size_t>& path : internal::paths_from_root(graph)) {
    result.lines.emplace_back();
    for (std::size_t b : path)
      for (std::size_t p : graph.branches()[b].points) {
        if (!result.lines.back().empty() && p == graph.branches()[b].points.front())
          continue; // where the branch before ended
        result.lines.back().push_back(result.points.size());
        result.points.push_back(graph.points()[p]);
        result.radius.push_back(graph.radii()[p]);
      }
  }
  return result;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_BRANCHED_CENTERLINES_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CLIP_TO_OPENINGS_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CLIP_TO_OPENINGS_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/clip_to_openings.h>
#include <CGAL/Tubular_meshing/Centerlines/graph_segments.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Tubular_meshing {

namespace internal {

/* Cuts or extends one end of a branch at an opening. The path is the branch's points, from its other node to this end.
 */
class End_clipper {
public:
  typedef std::vector<std::size_t> Path;

  End_clipper(std::vector<Point_3>& points, std::vector<double>& radii, const Opening& opening)
      : points_(points)
      , radii_(radii)
      , opening_(opening) {}

  // Whether the path ends at the opening now.
  bool clip(Path& path) {
    for (std::size_t i = 1; i < path.size(); ++i)
      if (crosses_disk(path[i - 1], path[i])) {
        path.resize(i + 1);
        path[i] = crossing(path[i - 1], path[i]);
        return true;
      }
    return extend(path);
  }

private:
  double height(std::size_t p) const { return (points_[p] - opening_.center) * opening_.normal; }
  double away(const Point_3& p) const { return std::sqrt((p - opening_.center).squared_length()); }

  std::size_t new_point(const Point_3& p, double radius) {
    points_.push_back(p);
    radii_.push_back(radius);
    return points_.size() - 1;
  }

  Point_3 crossing_point(std::size_t p, std::size_t q) const {
    const double t = height(p) / (height(p) - height(q));
    return points_[p] + t * (points_[q] - points_[p]);
  }

  // From inside to outside, within the opening and not elsewhere in its plane.
  bool crosses_disk(std::size_t p, std::size_t q) const {
    return height(p) < 0 && height(q) >= 0 && away(crossing_point(p, q)) < opening_.radius;
  }

  std::size_t crossing(std::size_t p, std::size_t q) {
    const double t = height(p) / (height(p) - height(q));
    return new_point(crossing_point(p, q), (1 - t) * radii_[p] + t * radii_[q]);
  }

  bool extend(Path& path) {
    const double reach = 2; // radii
    const std::size_t last = path.back();
    if (height(last) >= 0 || away(points_[last]) > reach * (std::max)(opening_.radius, radii_[last]))
      return false;
    path.push_back(new_point(opening_.center, opening_.radius));
    return true;
  }

  std::vector<Point_3>& points_;
  std::vector<double>& radii_;
  const Opening& opening_;
};

/* Drops points that no branch uses. Returns the new number of each old point. */
inline std::vector<std::size_t> compact(std::vector<Point_3>& points, std::vector<double>& radii,
                                        std::vector<std::vector<std::size_t>>& branches) {
  const std::size_t unused = std::size_t(-1);
  std::vector<std::size_t> number(points.size(), unused);
  std::vector<Point_3> kept_points;
  std::vector<double> kept_radii;
  for (auto& b : branches)
    for (std::size_t& p : b) {
      if (number[p] == unused) {
        number[p] = kept_points.size();
        kept_points.push_back(points[p]);
        kept_radii.push_back(radii[p]);
      }
      p = number[p];
    }
  points.swap(kept_points);
  radii.swap(kept_radii);
  return number;
}

/* The segment of the graph nearest to the opening's centre tells the branch, and its direction which of the branch's
 * ends is the opening's. */
class Opening_locator {
public:
  typedef Centerline_graph Graph;

  struct End {
    std::size_t branch, node;
    bool is_target;
  };

  explicit Opening_locator(const Graph& graph)
      : graph_(graph) {
    Graph_segments all(graph);
    places_ = std::move(all.places);
    tree_ = Nearest_tree<Double_kernel::Segment_3>(std::move(all.segments));
  }

  End end_at(const Opening& opening) const {
    const std::size_t found = tree_.nearest(to_double_point(opening.center)).index;
    const Graph::Branch& b = graph_.branches()[places_[found].branch];
    const Double_kernel::Vector_3 along = tree_.shape(found).to_vector();
    const Double_kernel::Vector_3 normal(opening.normal.x(), opening.normal.y(), opening.normal.z());
    const bool is_target = along * normal > 0;
    return End{places_[found].branch, is_target ? b.target : b.source, is_target};
  }

private:
  const Graph& graph_;
  std::vector<Graph_segments::Place> places_;
  Nearest_tree<Double_kernel::Segment_3> tree_;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE std::vector<std::size_t> clip_to_openings(Centerline_graph& graph,
                                                                      const std::vector<Opening>& openings) {
  typedef Centerline_graph Graph;
  const std::size_t none = Opening::no_branch;
  std::vector<std::size_t> nodes(openings.size(), none);
  if (graph.empty())
    return nodes;

  std::vector<Point_3> points = graph.points();
  std::vector<double> radii = graph.radii();
  std::vector<std::vector<std::size_t>> branches;
  for (const Graph::Branch& b : graph.branches())
    branches.push_back(b.points);
  std::vector<std::size_t> node_points;
  for (const Graph::Node& n : graph.nodes())
    node_points.push_back(n.point);

  const internal::Opening_locator locator(graph);
  std::vector<bool> taken(node_points.size(), false);
  for (std::size_t i = 0; i < openings.size(); ++i) {
    const auto end = locator.end_at(openings[i]);
    if (!graph.nodes()[end.node].is_end() || taken[end.node])
      continue;
    std::vector<std::size_t>& path = branches[end.branch];
    if (!end.is_target)
      std::reverse(path.begin(), path.end());
    if (internal::End_clipper(points, radii, openings[i]).clip(path)) {
      taken[end.node] = true;
      nodes[i] = end.node;
      node_points[end.node] = path.back();
    }
    if (!end.is_target)
      std::reverse(path.begin(), path.end());
  }

  const std::vector<std::size_t> number = internal::compact(points, radii, branches);
  const std::size_t root_point = number[node_points[graph.root()]];
  graph = Graph(std::move(points), std::move(radii), std::move(branches));
  std::vector<std::size_t> node_at(graph.points().size(), none);
  for (std::size_t n = 0; n < graph.nodes().size(); ++n)
    node_at[graph.nodes()[n].point] = n;
  graph.direct_from(node_at[root_point]);
  for (std::size_t& n : nodes)
    if (n != none)
      n = node_at[number[node_points[n]]];
  return nodes;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CLIP_TO_OPENINGS_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_GRAPH_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_GRAPH_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE Centerline_graph::Centerline_graph(std::vector<Point_3> points, std::vector<double> radii,
                                                               std::vector<Polyline> branches)
    : points_(std::move(points)) {
  set_radii(std::move(radii));
  std::unordered_map<size_type, size_type> node_at;
  branches_.reserve(branches.size());
  for (Polyline& polyline : branches)
    add_branch(std::move(polyline), node_at);
  if (!nodes_.empty())
    direct_from(0);
}

CGAL_TUBULAR_MESHING_INLINE Centerline_graph::size_type Centerline_graph::number_of_ends() const {
  return std::count_if(nodes_.begin(), nodes_.end(), [](const Node& n) { return n.is_end(); });
}

CGAL_TUBULAR_MESHING_INLINE double Centerline_graph::length() const {
  double sum = 0;
  for (const Branch& b : branches_)
    sum += b.length;
  return sum;
}

CGAL_TUBULAR_MESHING_INLINE double Centerline_graph::aspect_ratio(size_type branch) const {
  const Branch& b = branches_[branch];
  const double diameter = b.min_radius + b.max_radius;
  return diameter > 0 ? b.length / diameter : (std::numeric_limits<double>::infinity)();
}

CGAL_TUBULAR_MESHING_INLINE void Centerline_graph::set_radii(std::vector<double> radii) {
  if (radii.size() != points_.size())
    throw Input_error("The centerlines have " + std::to_string(points_.size()) + " points but " +
                      std::to_string(radii.size()) + " radii; give one radius a point.");
  radii_ = std::move(radii);
  for (Branch& b : branches_)
    measure_radii(b);
}

CGAL_TUBULAR_MESHING_INLINE void Centerline_graph::direct_from(size_type node) {
  direct_from(std::vector<size_type>(1, node));
}

CGAL_TUBULAR_MESHING_INLINE void Centerline_graph::direct_from(const std::vector<size_type>& nodes) {
  if (nodes.empty())
    throw Input_error("There is no node from which the centerlines are to be directed.");
  for (size_type node : nodes)
    if (node >= nodes_.size())
      throw Input_error("The centerlines have no node " + std::to_string(node) + "; they have " +
                        std::to_string(nodes_.size()) + ".");
  root_ = nodes.front();
  std::vector<bool> node_found(nodes_.size(), false), branch_done(branches_.size(), false);
  for (size_type node : nodes)
    if (!node_found[node])
      direct_component(node, node_found, branch_done);
  for (size_type other : nodes_by_eligibility())
    if (!node_found[other])
      direct_component(other, node_found, branch_done);
  link_branches();
}

CGAL_TUBULAR_MESHING_INLINE bool Centerline_graph::is_consistent() const {
  for (size_type i = 0; i < branches_.size(); ++i)
    if (!is_consistent(i))
      return false;
  for (const Node& n : nodes_)
    for (size_type b : n.branches)
      if (b >= branches_.size() || (point_of(branches_[b].source) != n.point && //
                                    point_of(branches_[b].target) != n.point))
        return false;
  return radii_.size() == points_.size() && (empty() || root_ < nodes_.size());
}

CGAL_TUBULAR_MESHING_INLINE void Centerline_graph::add_branch(Polyline polyline,
                                                              std::unordered_map<size_type, size_type>& node_at) {
  const size_type index = branches_.size();
  if (polyline.size() < 2)
    throw Input_error("Branch " + std::to_string(index) + " of the centerlines has fewer than two points.");
  for (size_type p : polyline)
    if (p >= points_.size())
      throw Input_error("Branch " + std::to_string(index) + " of the centerlines refers to point " + std::to_string(p) +
                        ", but there are only " + std::to_string(points_.size()) + " points.");
  Branch b;
  b.points = std::move(polyline);
  b.source = node_of(b.points.front(), node_at);
  b.target = node_of(b.points.back(), node_at);
  nodes_[b.source].branches.push_back(index);
  nodes_[b.target].branches.push_back(index);
  measure_lengths(b);
  measure_radii(b);
  branches_.push_back(std::move(b));
}

CGAL_TUBULAR_MESHING_INLINE Centerline_graph::size_type
Centerline_graph::node_of(size_type point, std::unordered_map<size_type, size_type>& node_at) {
  const auto inserted = node_at.insert(std::make_pair(point, nodes_.size()));
  if (inserted.second)
    nodes_.push_back(Node{point, {}});
  return inserted.first->second;
}

CGAL_TUBULAR_MESHING_INLINE double Centerline_graph::distance(size_type p, size_type q) const {
  return std::sqrt((points_[q] - points_[p]).squared_length());
}

CGAL_TUBULAR_MESHING_INLINE void Centerline_graph::measure_lengths(Branch& b) const {
  b.abscissa.assign(b.points.size(), 0);
  for (size_type i = 1; i < b.points.size(); ++i)
    b.abscissa[i] = b.abscissa[i - 1] + distance(b.points[i - 1], b.points[i]);
  b.length = b.abscissa.back();
}

CGAL_TUBULAR_MESHING_INLINE void Centerline_graph::measure_radii(Branch& b) const {
  b.min_radius = b.max_radius = radii_[b.points.front()];
  for (size_type p : b.points) {
    b.min_radius = (std::min)(b.min_radius, radii_[p]);
    b.max_radius = (std::max)(b.max_radius, radii_[p]);
  }
}

CGAL_TUBULAR_MESHING_INLINE void Centerline_graph::reverse(Branch& b) const {
  std::reverse(b.points.begin(), b.points.end());
  std::swap(b.source, b.target);
  measure_lengths(b);
}

CGAL_TUBULAR_MESHING_INLINE void Centerline_graph::direct_component(size_type start, std::vector<bool>& node_found,
                                                                    std::vector<bool>& branch_done) {
  std::vector<size_type> queue(1, start);
  node_found[start] = true;
  for (size_type head = 0; head < queue.size(); ++head)
    for (size_type i : nodes_[queue[head]].branches) {
      if (branch_done[i])
        continue;
      branch_done[i] = true;
      Branch& b = branches_[i];
      if (b.source != queue[head])
        reverse(b);
      if (!node_found[b.target]) {
        node_found[b.target] = true;
        queue.push_back(b.target);
      }
    }
}

// Where to begin in components without the root: ends first, wide ones first.
CGAL_TUBULAR_MESHING_INLINE std::vector<Centerline_graph::size_type> Centerline_graph::nodes_by_eligibility() const {
  std::vector<size_type> order(nodes_.size());
  for (size_type i = 0; i < order.size(); ++i)
    order[i] = i;
  std::stable_sort(order.begin(), order.end(), [this](size_type a, size_type b) {
    if (nodes_[a].is_end() != nodes_[b].is_end())
      return nodes_[a].is_end();
    return radii_[nodes_[a].point] > radii_[nodes_[b].point];
  });
  return order;
}

CGAL_TUBULAR_MESHING_INLINE void Centerline_graph::link_branches() {
  for (Branch& b : branches_) {
    b.parents.clear();
    b.children.clear();
  }
  for (size_type n = 0; n < nodes_.size(); ++n)
    for (size_type i : nodes_[n].branches)
      for (size_type j : nodes_[n].branches)
        if (i != j && branches_[i].target == n && branches_[j].source == n) {
          branches_[i].children.push_back(j);
          branches_[j].parents.push_back(i);
        }
}

CGAL_TUBULAR_MESHING_INLINE bool Centerline_graph::is_consistent(size_type i) const {
  const Branch& b = branches_[i];
  if (b.points.size() < 2 || b.abscissa.size() != b.points.size() || b.source >= nodes_.size() ||
      b.target >= nodes_.size() || point_of(b.source) != b.points.front() || point_of(b.target) != b.points.back())
    return false;
  for (size_type c : b.children)
    if (c >= branches_.size() || branches_[c].source != b.target)
      return false;
  for (size_type p : b.parents)
    if (p >= branches_.size() || branches_[p].target != b.source)
      return false;
  for (size_type p : b.points)
    if (p >= points_.size() || !(radii_[p] >= b.min_radius && radii_[p] <= b.max_radius))
      return false;
  return std::is_sorted(b.abscissa.begin(), b.abscissa.end()) && b.abscissa.back() == b.length;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_GRAPH_IMPL_H

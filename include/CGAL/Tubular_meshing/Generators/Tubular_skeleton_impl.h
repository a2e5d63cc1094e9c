// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SKELETON_IMPL_H
#define CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SKELETON_IMPL_H

#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE std::vector<std::size_t> Tubular_skeleton::degrees() const {
  std::vector<std::size_t> degree(nodes.size(), 0);
  for (const Branch& b : branches) {
    ++degree[b.source];
    ++degree[b.target];
  }
  return degree;
}

CGAL_TUBULAR_MESHING_INLINE std::size_t Tubular_skeleton::number_of_openings() const {
  const std::vector<std::size_t> degree = degrees();
  return std::size_t(std::count(degree.begin(), degree.end(), std::size_t(1)));
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Tubular_skeleton::End> Tubular_skeleton::ends() const {
  const std::vector<std::size_t> degree = degrees();
  std::vector<End> result;
  const auto add = [&](std::size_t node, std::size_t branch, const Point_3& p, const Point_3& inside, double radius) {
    if (degree[node] == 1)
      result.push_back({node, branch, p, (p - inside) / internal::point_distance(p, inside), radius});
  };
  for (std::size_t i = 0; i < branches.size(); ++i) {
    const Branch& b = branches[i];
    const std::size_t n = b.points.size();
    add(b.source, i, b.points[0], b.points[1], b.radius[0]);
    add(b.target, i, b.points[n - 1], b.points[n - 2], b.radius[n - 1]);
  }
  std::sort(result.begin(), result.end(), [this](const End& a, const End& b) {
    return std::make_pair(a.node != inlet, a.node) < std::make_pair(b.node != inlet, b.node);
  });
  return result;
}

CGAL_TUBULAR_MESHING_INLINE void Tubular_skeleton::add_branch(std::size_t source, std::size_t target,
                                                              internal::Function_view<Point_3(double)> curve,
                                                              internal::Function_view<double(double)> radius) {
  const int probes = 32;
  double length_over_radius = 0;
  for (int i = 0; i < probes; ++i)
    length_over_radius +=
        internal::point_distance(curve(double(i) / probes), curve(double(i + 1) / probes)) / radius((i + 0.5) / probes);
  const int steps = (std::max)(2, int(std::ceil(4 * length_over_radius)));
  Branch b;
  b.source = source;
  b.target = target;
  for (int i = 0; i <= steps; ++i) {
    b.points.push_back(i == 0 ? nodes[source] : i == steps ? nodes[target] : curve(double(i) / steps));
    b.radius.push_back(radius(double(i) / steps));
  }
  branches.push_back(b);
}

CGAL_TUBULAR_MESHING_INLINE void check_skeleton(const Tubular_skeleton& skeleton) {
  for (std::size_t i = 0; i < skeleton.branches.size(); ++i) {
    const auto& b = skeleton.branches[i];
    const std::string name = "branch " + std::to_string(i) + " of the skeleton ";
    if (b.points.size() < 2 || b.points.size() != b.radius.size())
      throw Input_error(name + "has " + std::to_string(b.points.size()) + " points and " +
                        std::to_string(b.radius.size()) + " radii; give it two or more points, and a radius each.");
    if (b.source >= skeleton.nodes.size() || b.target >= skeleton.nodes.size() ||
        b.points.front() != skeleton.nodes[b.source] || b.points.back() != skeleton.nodes[b.target])
      throw Input_error(name + "does not run from its source node to its target node; make its first and last points "
                               "equal to these.");
    for (std::size_t j = 0; j < b.points.size(); ++j)
      if (!(b.radius[j] > 0) || !std::isfinite(b.radius[j]) ||
          (j > 0 && !((b.points[j] - b.points[j - 1]).squared_length() > 0)))
        throw Input_error(name + "has a radius that is not positive, or two equal points in a row, at its point " +
                          std::to_string(j) + "; correct or remove this point.");
  }
  const std::vector<std::size_t> degree = skeleton.degrees();
  if (skeleton.inlet >= degree.size() || degree[skeleton.inlet] != 1)
    throw Input_error("the inlet of the skeleton must be a node where exactly one branch ends; set it to one.");
}

namespace internal {

inline void append_branch(const Tubular_skeleton::Branch& b, bool forwards, Centerline_polylines& lines) {
  const std::size_t n = b.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = forwards ? i : n - 1 - i;
    if (i == 0 && !lines.lines.back().empty())
      continue; // where the one before ended
    lines.lines.back().push_back(lines.points.size());
    lines.points.push_back(b.points[j]);
    lines.radius.push_back(b.radius[j]);
  }
}

// For each node the branch through which a tree is entered from the inlet; that of the inlet itself is one past the
// end.
inline std::vector<std::size_t> branches_from_inlet(const Tubular_skeleton& skeleton) {
  const std::size_t none = skeleton.branches.size();
  std::vector<std::vector<std::size_t>> incident(skeleton.nodes.size());
  for (std::size_t i = 0; i < none; ++i) {
    incident[skeleton.branches[i].source].push_back(i);
    incident[skeleton.branches[i].target].push_back(i);
  }
  std::vector<std::size_t> entered_by(skeleton.nodes.size(), none), queue = {skeleton.inlet};
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (std::size_t b : incident[queue[i]])
      if (b != entered_by[queue[i]]) {
        const auto& branch = skeleton.branches[b];
        const std::size_t other = branch.source == queue[i] ? branch.target : branch.source;
        entered_by[other] = b;
        queue.push_back(other);
      }
  return entered_by;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Centerline_polylines centerlines_of(const Tubular_skeleton& skeleton) {
  Centerline_polylines lines;
  if (skeleton.number_of_loops() > 0) {
    for (const auto& b : skeleton.branches) {
      lines.lines.emplace_back();
      internal::append_branch(b, true, lines);
    }
    return lines;
  }
  const std::vector<std::size_t> entered_by = internal::branches_from_inlet(skeleton);
  for (const auto& end : skeleton.ends()) {
    if (end.node == skeleton.inlet)
      continue;
    std::vector<std::pair<std::size_t, bool>> path; // branches upstream, and whether they run downstream
    for (std::size_t node = end.node; node != skeleton.inlet;) {
      const auto& b = skeleton.branches[entered_by[node]];
      path.emplace_back(entered_by[node], b.target == node);
      node = b.target == node ? b.source : b.target;
    }
    lines.lines.emplace_back();
    for (auto step = path.rbegin(); step != path.rend(); ++step)
      internal::append_branch(skeleton.branches[step->first], step->second, lines);
  }
  return lines;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SKELETON_IMPL_H

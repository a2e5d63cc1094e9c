// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_WALL_THICKNESS_IMPL_H
#define CGAL_TUBULAR_MESHING_LAYERS_WALL_THICKNESS_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Layers/Wall_thickness.h>
#include <CGAL/Tubular_meshing/Layers/internal/Located_triangles.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {
namespace internal {

inline bool is_thickness(double value) {
  return value > 0 && std::isfinite(value);
}

// One sentence for all values that are none.
inline void check_thicknesses(const Wall_array& array) {
  std::size_t bad = 0;
  const std::size_t none = std::size_t(-1);
  std::size_t first = none;
  double value = 0;
  const auto look_at = [&](double v, std::size_t point) {
    if (is_thickness(v))
      return;
    ++bad;
    if (first == none) {
      first = point;
      value = v;
    }
  };
  if (array.of == Array_of::triangles) {
    for (std::size_t i = 0; i < array.triangles.size(); ++i)
      look_at(array.values[i], array.triangles[i][0]);
  } else {
    std::vector<char> seen(array.points.size(), 0);
    for (const auto& t : array.triangles)
      for (std::size_t v : t)
        if (!seen[v]) {
          seen[v] = 1;
          look_at(array.values[v], v);
        }
  }
  if (bad > 0)
    throw Input_error("The array \"" + array.name + "\" has " + std::to_string(bad) +
                      (bad == 1 ? " value" : " values") + " on the wall that cannot be a thickness, the first at " +
                      place_of(array.points[first]) + ": " + std::to_string(value) +
                      "; a wall is thicker than 0 everywhere.");
}

/* Values of points, of values of triangles: the mean of those around, by area. Points of equal coordinates are one, as
 * files may have one for each triangle. */
inline std::vector<double> values_at_points(const Wall_array& array) {
  typedef std::array<double, 3> Place;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < array.points.size(); ++i)
    order.push_back(i);
  const auto place = [&](std::size_t i) {
    const Point_3& p = array.points[i];
    return Place{p.x(), p.y(), p.z()};
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
  std::vector<std::size_t> first(array.points.size()); // of the points in its place
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && place(order[k]) == place(order[k - 1]) ? first[order[k - 1]] : order[k];
  std::vector<double> sum(array.points.size(), 0), area(array.points.size(), 0);
  for (std::size_t i = 0; i < array.triangles.size(); ++i) {
    const auto& t = array.triangles[i];
    const Vector_3d p(array.points[t[0]]), q(array.points[t[1]]), r(array.points[t[2]]);
    const double a = norm(cross(q - p, r - p));
    for (std::size_t v : t) {
      sum[first[v]] += a * array.values[i];
      area[first[v]] += a;
    }
  }
  std::vector<double> result(array.points.size(), 0);
  for (std::size_t i = 0; i < array.triangles.size(); ++i)
    for (std::size_t v : array.triangles[i])
      result[v] = area[first[v]] > 0 ? sum[first[v]] / area[first[v]] : array.values[i];
  return result;
}

/* The thickness of branches by abscissa. */
class Branch_thickness {
public:
  Branch_thickness(const Centerline_graph& graph, const std::map<std::size_t, double>& thickness, double otherwise)
      : graph_(graph)
      , field_(graph) {
    check(thickness, otherwise);
    for (std::size_t b = 0; b < graph.branches().size(); ++b) {
      const auto found = thickness.find(b);
      of_branch_.push_back(found == thickness.end() ? otherwise : found->second);
    }
    for (const auto& node : graph.nodes()) {
      double sum = 0;
      for (std::size_t b : node.branches)
        sum += of_branch_[b];
      at_node_.push_back(sum / double(node.branches.size()));
    }
  }

  double operator()(const Point_3& p) const {
    const auto d = field_.descriptors(p);
    const Centerline_graph::Branch& branch = graph_.branches()[d.branch];
    const double from_source = share(branch.source, d.abscissa, branch.length),
                 from_target = share(branch.target, branch.length - d.abscissa, branch.length);
    const double own = of_branch_[d.branch];
    return own + (1 - from_source) * (at_node_[branch.source] - own) +
           (1 - from_target) * (at_node_[branch.target] - own);
  }

private:
  void check(const std::map<std::size_t, double>& thickness, double otherwise) const {
    const std::size_t n = graph_.branches().size();
    for (const auto& t : thickness) {
      if (t.first >= n)
        throw Input_error("There is no branch " + std::to_string(t.first) + " to have a thickness: there are " +
                          std::to_string(n) + ", counted from 0.");
      if (!is_thickness(t.second))
        throw Input_error("The thickness of branch " + std::to_string(t.first) + " is " + std::to_string(t.second) +
                          ": a wall is thicker than 0 everywhere.");
    }
    if (otherwise != 0 && !is_thickness(otherwise))
      throw Input_error("The thickness of other branches is " + std::to_string(otherwise) +
                        ": a wall is thicker than 0 everywhere.");
    for (std::size_t b = 0; b < n && otherwise == 0; ++b)
      if (thickness.count(b) == 0)
        throw Input_error("Branch " + std::to_string(b) + " has no thickness: there are " + std::to_string(n) +
                          " branches, counted from 0, and each needs one.");
  }

  // That the branch's own thickness has, at a distance from one of its nodes.
  double share(std::size_t node, double distance, double length) const {
    const Centerline_graph::Node& n = graph_.nodes()[node];
    const double reach = (std::min)(2 * graph_.radii()[n.point], 0.5 * length);
    return n.is_end() || !(distance < reach) ? 1 : (std::max)(distance, 0.) / reach;
  }

  const Centerline_graph graph_;
  const Centerline_field field_;
  std::vector<double> of_branch_, at_node_;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Wall_thickness thickness_of_array(const Wall_array& array) {
  internal::check_thicknesses(array);
  const auto located = std::make_shared<const internal::Located_triangles>(array);
  const auto values = std::make_shared<const std::vector<double>>(
      array.of == Array_of::points ? array.values : internal::values_at_points(array));
  return Wall_thickness([located, values](const Point_3& p) {
    const auto place = (*located)(p);
    const auto& c = located->corners(place.triangle);
    return place.weights[0] * (*values)[c[0]] + place.weights[1] * (*values)[c[1]] + place.weights[2] * (*values)[c[2]];
  });
}

CGAL_TUBULAR_MESHING_INLINE Wall_thickness thickness_of_branches(const Centerline_graph& graph,
                                                                 const std::map<std::size_t, double>& thickness,
                                                                 double otherwise) {
  const auto branches = std::make_shared<const internal::Branch_thickness>(graph, thickness, otherwise);
  return Wall_thickness([branches](const Point_3& p) { return (*branches)(p); });
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_LAYERS_WALL_THICKNESS_IMPL_H

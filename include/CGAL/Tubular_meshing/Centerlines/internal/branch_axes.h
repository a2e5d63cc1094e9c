// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_BRANCH_AXES_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_BRANCH_AXES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef Double_kernel::Vector_3 Double_vector;

inline Double_vector unit(const Double_vector& v, const Double_vector& otherwise) {
  const double l = std::sqrt(v.squared_length());
  return l > 0 && std::isfinite(l) ? v / l : otherwise;
}

// The part of v that is perpendicular to the unit vector t.
inline Double_vector rejected(const Double_vector& v, const Double_vector& t) {
  return v - (v * t) * t;
}

inline Double_vector any_perpendicular(const Double_vector& t) {
  const double x = std::abs(t.x()), y = std::abs(t.y()), z = std::abs(t.z());
  const Double_vector axis = x <= y && x <= z ? Double_vector(1, 0, 0)
                             : y <= z         ? Double_vector(0, 1, 0)
                                              : Double_vector(0, 0, 1);
  return unit(rejected(axis, t), Double_vector(0, 0, 1));
}

// Carries the normal n at p, where the curve runs along t, to q, where it runs along u: double reflection.
inline Double_vector transported(const Double_vector& n, const Double_kernel::Point_3& p, const Double_vector& t,
                                 const Double_kernel::Point_3& q, const Double_vector& u) {
  Double_vector carried = n, tangent = t;
  for (const bool along_chord : {true, false}) {
    const Double_vector mirror = along_chord ? q - p : u - tangent;
    const double m = mirror.squared_length();
    if (m > 0) {
      carried = carried - (2 * (mirror * carried) / m) * mirror;
      tangent = tangent - (2 * (mirror * tangent) / m) * mirror;
    }
  }
  return unit(rejected(carried, u), any_perpendicular(u));
}

/* A tangent and a rotation-minimizing normal at each point of each branch.
 *
 * The tangent is that of the chord over a quarter radius to either side, less where the branch ends sooner: as smooth
 * as the vessel, whatever the spacing and the noise of the points, and exact on lines and arcs. Normals are carried
 * from parent to child. O(n log n).
 */
class Branch_axes {
public:
  typedef Centerline_graph Graph;

  explicit Branch_axes(const Graph& graph)
      : graph_(graph)
      , tangents_(graph.branches().size())
      , normals_(graph.branches().size()) {
    for (std::size_t b = 0; b < tangents_.size(); ++b)
      compute_tangents(b);
    for (std::size_t b : graph.nodes()[graph.root()].branches)
      carry_normals(b);
    for (std::size_t b = 0; b < tangents_.size(); ++b) // other components
      if (graph.branches()[b].parents.empty())
        carry_normals(b);
    for (std::size_t b = 0; b < tangents_.size(); ++b) // closed curves
      carry_normals(b);
  }

  const std::vector<Double_vector>& tangents(std::size_t branch) const { return tangents_[branch]; }
  const std::vector<Double_vector>& normals(std::size_t branch) const { return normals_[branch]; }

private:
  Double_kernel::Point_3 point(std::size_t branch, std::size_t i) const {
    return to_double_point(graph_.points()[graph_.branches()[branch].points[i]]);
  }

  // The point of the branch at an abscissa.
  Double_kernel::Point_3 point_at(std::size_t branch, double abscissa) const {
    const std::vector<double>& s = graph_.branches()[branch].abscissa;
    const std::size_t i =
        (std::min)(std::size_t(std::max<std::ptrdiff_t>(std::upper_bound(s.begin(), s.end(), abscissa) - s.begin(), 1)),
                   s.size() - 1);
    const double step = s[i] - s[i - 1], t = step > 0 ? (abscissa - s[i - 1]) / step : 0;
    const Double_kernel::Point_3 p = point(branch, i - 1);
    return p + (std::min)(1., (std::max)(0., t)) * (point(branch, i) - p);
  }

  void compute_tangents(std::size_t branch) {
    const Graph::Branch& b = graph_.branches()[branch];
    const std::size_t n = b.points.size();
    tangents_[branch].resize(n);
    for (std::size_t i = 1; i + 1 < n; ++i)
      tangents_[branch][i] = chord(branch, b.abscissa[i], window(branch, i));
    tangents_[branch].front() = end_tangent(branch, 0, (std::min)(window(branch, 0), b.length));
    tangents_[branch].back() = end_tangent(branch, b.length, -(std::min)(window(branch, n - 1), b.length));
  }

  // A quarter radius, and at least a step.
  double window(std::size_t branch, std::size_t i) const {
    const Graph::Branch& b = graph_.branches()[branch];
    const double infinity = (std::numeric_limits<double>::infinity)();
    const double before = i > 0 ? b.abscissa[i] - b.abscissa[i - 1] : infinity;
    const double after = i + 1 < b.points.size() ? b.abscissa[i + 1] - b.abscissa[i] : infinity;
    return (std::max)(0.25 * graph_.radii()[b.points[i]], (std::min)(before, after));
  }

  // The direction from w before to w after an abscissa, or from as far as the branch reaches to both sides.
  Double_vector chord(std::size_t branch, double s, double w) const {
    const Graph::Branch& b = graph_.branches()[branch];
    w = (std::min)({w, s, b.length - s});
    return direction(branch, s - w, s + w);
  }

  Double_vector direction(std::size_t branch, double from, double to) const {
    const std::size_t n = tangents_[branch].size();
    return unit(point_at(branch, to) - point_at(branch, from),
                unit(point(branch, n - 1) - point(branch, 0), Double_vector(0, 0, 1)));
  }

  // The tangent at `step` inside the end, mirrored at the chord between: exact on arcs.
  Double_vector end_tangent(std::size_t branch, double end, double step) const {
    const Graph::Branch& b = graph_.branches()[branch];
    const double inside = end + step;
    const Double_vector c = direction(branch, (std::min)(end, inside), (std::max)(end, inside));
    const double room = (std::min)(inside, b.length - inside);
    if (!(room > 0.1 * std::abs(step)))
      return c;
    const Double_vector t = chord(branch, inside, std::abs(step));
    return unit(2 * (c * t) * c - t, c);
  }

  // From this branch on to all its descendants that have no normals yet.
  void carry_normals(std::size_t first) {
    std::vector<std::size_t> stack(1, first);
    while (!stack.empty()) {
      const std::size_t b = stack.back();
      stack.pop_back();
      if (!normals_[b].empty())
        continue;
      const std::vector<Double_vector>& t = tangents_[b];
      std::vector<Double_vector> normals(1, first_normal(b));
      for (std::size_t i = 1; i < t.size(); ++i)
        normals.push_back(transported(normals.back(), point(b, i - 1), t[i - 1], point(b, i), t[i]));
      normals_[b].swap(normals);
      for (std::size_t child : graph_.branches()[b].children)
        stack.push_back(child);
    }
  }

  Double_vector first_normal(std::size_t b) const {
    const Double_vector& t = tangents_[b].front();
    for (std::size_t parent : graph_.branches()[b].parents)
      if (!normals_[parent].empty()) {
        const Double_kernel::Point_3 p = point(b, 0);
        return transported(normals_[parent].back(), p, tangents_[parent].back(), p, t);
      }
    return any_perpendicular(t);
  }

  const Graph& graph_;
  std::vector<std::vector<Double_vector>> tangents_, normals_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_BRANCH_AXES_H

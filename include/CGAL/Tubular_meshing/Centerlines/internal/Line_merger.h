// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_LINE_MERGER_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_LINE_MERGER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Growing_segment_tree.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_line.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Overlays lines into one network of segments, line after line (long ones first, so that the outcome does not depend on
 * their order).
 *
 * A point of a line is *on* the network if it is within `tolerance` radii of it. What is on adds nothing. A run of
 * points that are off is added, joined to the network where it leaves and rejoins it, if it gets out of the vessel it
 * leaves: further from the network than `out_of_vessel` radii. Otherwise it is noise, or a corner cut at a
 * bifurcation. Lines are to be sampled with steps of half a radius at most.
 */
class Line_merger {
public:
  typedef std::array<std::size_t, 2> Edge;

  // A run that stays within this many radii of the network is in the same vessel.
  static constexpr double out_of_vessel = 0.75;
  // One that comes back joins it where it is within so many.
  static constexpr double beside = 0.5;

  explicit Line_merger(double tolerance)
      : tolerance_(tolerance) {}

  void insert(const Sampled_line& line) {
    locate(line);
    const std::size_t n = line.size();
    for (std::size_t i = 0; i < n;) {
      if (feet_[i].on) {
        if (i + 1 < n && feet_[i + 1].on)
          bridge(i, i + 1);
        ++i;
        continue;
      }
      std::size_t end = i;
      while (end < n && !feet_[end].on)
        ++end;
      add_run(line, i, end);
      i = end;
    }
    flush();
  }

  const std::vector<Line_point>& vertices() const { return vertices_; }

  // The edges of the network, cut where branches are attached; sorted, each once.
  std::vector<Edge> edges() const {
    std::vector<Edge> result;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      std::vector<std::pair<double, std::size_t>> stops = {{0., segments_[s][0]}, {1., segments_[s][1]}};
      const auto found = cuts_.find(s);
      if (found != cuts_.end())
        stops.insert(stops.end() - 1, found->second.begin(), found->second.end());
      std::stable_sort(stops.begin() + 1, stops.end() - 1);
      for (std::size_t i = 1; i < stops.size(); ++i)
        result.push_back(
            Edge{{(std::min)(stops[i - 1].second, stops[i].second), (std::max)(stops[i - 1].second, stops[i].second)}});
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

private:
  // Where a point of the line projects to on the network.
  struct Foot {
    std::size_t segment;
    double t; // along the segment, 0 to 1
    double distance, radius;
    bool on;
  };

  static constexpr std::size_t none = std::size_t(-1);

  void locate(const Sampled_line& line) {
    feet_.resize(line.size());
    const std::size_t few = 32; // searches that are worth a task
    for_each_range(
        line.size(), 0,
        [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i)
            feet_[i] = foot_of(line[i]);
        },
        few);
  }

  Foot foot_of(const Line_point& p) const {
    const Growing_segment_tree::Result found = tree_.nearest(p.point);
    Foot foot = {none, 0, found.squared_distance, p.radius, false};
    if (found.index < tree_.size()) {
      const Line_point& a = vertices_[segments_[found.index][0]];
      const Line_point& b = vertices_[segments_[found.index][1]];
      const double whole = distance(a.point, b.point);
      foot.segment = found.index;
      foot.t = whole > 0 ? (std::min)(1., distance(a.point, found.point) / whole) : 0;
      foot.distance = std::sqrt(found.squared_distance);
      foot.radius = (1 - foot.t) * a.radius + foot.t * b.radius;
      foot.on = foot.distance <= tolerance_ * p.radius;
    }
    return foot;
  }

  // Adds the run [begin, end[ of points that are off, if it is worth it.
  void add_run(const Sampled_line& line, std::size_t begin, std::size_t end) {
    const bool leaves = begin > 0;
    if (gets_out(begin, end)) {
      if (leaves)
        leave_out_what_is_beside(line, begin, end);
    } else if (!(leaves && end < line.size() && !connected(feet_[begin - 1], feet_[end]))) {
      return;
    }
    const bool rejoins = end < line.size();
    Sampled_line run(line.begin() + begin, line.begin() + end);
    const std::size_t first = leaves ? attach(begin - 1) : none;
    const std::size_t last = rejoins ? attach(end) : none;
    if (leaves)
      ease(run.begin(), run.end(), line[begin - 1], vertices_[first].point);
    if (rejoins)
      ease(run.rbegin(), run.rend(), line[end], vertices_[last].point);

    std::vector<std::size_t> path;
    if (leaves)
      path.push_back(first);
    const bool closed = !leaves && !rejoins && is_closed(run);
    for (std::size_t i = 0; i + (closed ? 1 : 0) < run.size(); ++i)
      path.push_back(new_vertex(run[i]));
    if (rejoins)
      path.push_back(last);
    else if (closed)
      path.push_back(path.front());
    for (std::size_t i = 1; i < path.size(); ++i)
      new_segment(path[i - 1], path[i]);
  }

  /* A run that goes over into another vessel may have been beside the network for long, in the same vessel, or be so
   * afterwards: where a lumen is flat, as beside a septum, there are several ways through it. It then joins the network
   * where it comes near for good, as long as that is more than a radius before it would, or if it would not at all. */
  void leave_out_what_is_beside(const Sampled_line& line, std::size_t& begin, std::size_t& end) const {
    std::size_t first = begin, last = end - 1; // those that are out
    while (first < end && !is_out(first))
      ++first;
    if (first == end)
      return; // there is no network yet
    while (!is_out(last))
      --last;
    const auto is_near = [&](std::size_t i) { return feet_[i].distance <= beside * feet_[i].radius; };
    const auto is_far = [&](std::size_t i, std::size_t j) {
      return j == line.size() || distance(line[i].point, line[j].point) > line[i].radius;
    };
    std::size_t comes_back = last + 1, leaves = first;
    while (comes_back < end && !is_near(comes_back))
      ++comes_back;
    if (comes_back < end && is_far(comes_back, end))
      end = comes_back;
    while (leaves > begin && !is_near(leaves - 1))
      --leaves;
    // of a branch that does not come back, where it leaves is as it is
    if (leaves > begin && end < line.size() && is_far(leaves - 1, begin))
      begin = leaves;
  }

  bool is_out(std::size_t i) const { return feet_[i].distance > out_of_vessel * feet_[i].radius; }

  bool gets_out(std::size_t begin, std::size_t end) const {
    if (feet_[begin].segment == none || (begin == 0 && end == feet_.size()))
      return true;
    for (std::size_t i = begin; i < end; ++i)
      if (is_out(i))
        return true;
    return false;
  }

  bool is_closed(const Sampled_line& line) const {
    return line.size() > 3 && distance(line.front().point, line.back().point) <= tolerance_ * line.front().radius &&
           length(line) > 6 * line.front().radius;
  }

  // Two neighbouring points may be on parts of the network that do not meet yet.
  void bridge(std::size_t i, std::size_t j) {
    if (!connected(feet_[i], feet_[j])) {
      const std::size_t a = attach(i), b = attach(j);
      new_segment(a, b);
    }
  }

  // Spreads the small step from the line to the network over one radius, so that a branch leaves without a kink.
  template <class Iterator>
  void ease(Iterator first, Iterator last, const Line_point& from, const Double_kernel::Point_3& to) const {
    const Double_kernel::Vector_3 shift = to - from.point;
    Double_kernel::Point_3 previous = from.point;
    double s = 0;
    for (; first != last; ++first) {
      s += distance(previous, first->point);
      previous = first->point;
      const double u = s / from.radius;
      if (!(u < 1))
        return;
      first->point = first->point + (1 - u) * (1 - u) * (1 + 2 * u) * shift;
    }
  }

  // The vertex of the network at a foot; one that is there already, if it is within the tolerance.
  std::size_t attach(std::size_t i) {
    const Foot& foot = feet_[i];
    const Edge edge = segments_[foot.segment];
    const Double_kernel::Point_3 &a = vertices_[edge[0]].point, &b = vertices_[edge[1]].point;
    const Double_kernel::Point_3 p = a + foot.t * (b - a);

    std::vector<std::pair<double, std::size_t>>& cuts = cuts_[foot.segment];
    double nearest = tolerance_ * foot.radius;
    std::size_t result = none;
    const auto consider = [&](std::size_t v) {
      const double d = distance(vertices_[v].point, p);
      if (d <= nearest) {
        nearest = d;
        result = v;
      }
    };
    consider(edge[0]);
    consider(edge[1]);
    for (const auto& cut : cuts)
      consider(cut.second);
    if (result == none) {
      result = new_vertex(Line_point{p, foot.radius});
      unite(result, edge[0]);
      cuts.emplace_back(foot.t, result);
    }
    return result;
  }

  std::size_t new_vertex(const Line_point& p) {
    vertices_.push_back(p);
    component_.push_back(component_.size());
    return vertices_.size() - 1;
  }

  void new_segment(std::size_t a, std::size_t b) {
    if (a == b)
      return;
    segments_.push_back(Edge{{a, b}});
    unite(a, b);
  }

  // Makes this line's segments visible to the next.
  void flush() {
    std::vector<Double_kernel::Segment_3> batch;
    for (std::size_t s = tree_.size(); s < segments_.size(); ++s)
      batch.emplace_back(vertices_[segments_[s][0]].point, vertices_[segments_[s][1]].point);
    tree_.insert(std::move(batch));
  }

  bool connected(const Foot& f, const Foot& g) {
    return root(segments_[f.segment][0]) == root(segments_[g.segment][0]);
  }
  std::size_t root(std::size_t v) {
    while (component_[v] != v)
      v = component_[v] = component_[component_[v]];
    return v;
  }
  void unite(std::size_t a, std::size_t b) { component_[root(a)] = root(b); }

  double tolerance_;
  std::vector<Line_point> vertices_;
  std::vector<std::size_t> component_; // union-find over vertices
  std::vector<Edge> segments_;
  std::unordered_map<std::size_t, std::vector<std::pair<double, std::size_t>>> cuts_; // segment → (t, vertex)
  Growing_segment_tree tree_;
  std::vector<Foot> feet_; // of the line being inserted
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_LINE_MERGER_H

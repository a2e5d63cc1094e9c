// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_MATCH_CENTERLINES_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_MATCH_CENTERLINES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The free ends of a centerline graph, and which opening each belongs to.
 *
 * A centerline may stop short of the opening (VMTK's do, by up to a radius) or pass through it (centerlines computed
 * with flow extensions). So an opening is not compared with end points, but with whole end branches, prolonged by
 * two radii along their last tangents: the opening belongs to the end whose line passes nearest to its centre.
 */
class Centerline_ends {
  typedef Double_kernel::Point_3 Point;
  typedef Double_kernel::Vector_3 Vector;
  typedef Double_kernel::Segment_3 Segment;

public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  struct End {
    std::size_t node, branch;
    Point tip;
    double radius;
    std::size_t site = none; ///< of its opening
    double distance = 0;     ///< from the tip to that site's centre
  };

  /* `fallback_radius` is for graphs without radii. O(n log n) in the number of points of the end branches. */
  Centerline_ends(const Centerline_graph& graph, double fallback_radius) {
    for (std::size_t n = 0; n < graph.nodes().size(); ++n)
      if (graph.nodes()[n].is_end())
        add_end(graph, n, fallback_radius);
    std::vector<Segment> segments;
    segments.swap(segments_);
    tree_ = Nearest_tree<Segment>(std::move(segments));
  }

  const std::vector<End>& ends() const { return ends_; }
  bool all_matched() const {
    return std::all_of(ends_.begin(), ends_.end(), [](const End& e) { return e.site != none; });
  }
  bool none_matched() const {
    return std::all_of(ends_.begin(), ends_.end(), [](const End& e) { return e.site == none; });
  }

  /* Gives each unmatched end the nearest of sites[first...] that it passes through. A flat end, which is only one
   * because a centerline ends there, must moreover be met in the direction of its normal. O(log n) a site. */
  void match(const std::vector<Opening_site>& sites, std::size_t first, bool inside_out) {
    std::vector<End> updated = ends_;
    for (std::size_t s = first; s < sites.size(); ++s) {
      const auto& shape = sites[s].shape;
      const Point center = to_double_point(shape.center);
      const double reach = (sites[s].is_open() ? 1 : 0.7) * shape.radius;
      const auto nearest = tree_.nearest(center, reach * reach);
      if (nearest.index >= tree_.size())
        continue;
      const std::size_t e = end_of_segment_[nearest.index];
      if (ends_[e].site != none || (!sites[s].is_open() && !is_met_head_on(nearest.index, shape, inside_out)))
        continue;
      const double distance = std::sqrt(CGAL::squared_distance(center, ends_[e].tip));
      if (updated[e].site == none || distance < updated[e].distance) {
        updated[e].site = s;
        updated[e].distance = distance;
      }
    }
    ends_.swap(updated);
  }

  /* Drops those of sites[first...] that belong to no end. */
  void keep_matched(std::vector<Opening_site>& sites, std::size_t first) {
    std::vector<std::size_t> end_of_site(sites.size(), none);
    for (std::size_t e = 0; e < ends_.size(); ++e)
      if (ends_[e].site != none)
        end_of_site[ends_[e].site] = e;
    std::size_t kept = first;
    for (std::size_t s = first; s < sites.size(); ++s)
      if (end_of_site[s] != none) {
        ends_[end_of_site[s]].site = kept;
        std::swap(sites[kept++], sites[s]);
      }
    sites.resize(kept);
  }

private:
  void add_end(const Centerline_graph& graph, std::size_t n, double fallback_radius) {
    const std::size_t b = graph.nodes()[n].branches[0];
    const auto& branch = graph.branches()[b];
    std::vector<std::size_t> points(branch.points.begin(), branch.points.end()); // to go from the tip inwards
    if (branch.target == n)
      std::reverse(points.begin(), points.end());
    auto at = [&](std::size_t i) { return to_double_point(graph.points()[points[i]]); };
    End end;
    end.node = n;
    end.branch = b;
    end.tip = at(0);
    end.radius = branch.max_radius > 0 ? branch.max_radius : fallback_radius;
    const bool both_free = graph.nodes()[branch.source].is_end() && graph.nodes()[branch.target].is_end();
    const double share = both_free ? branch.length / 2 : std::numeric_limits<double>::infinity();

    Vector tangent = at(0) - at(points.size() - 1);
    double walked = 0;
    for (std::size_t i = 0; i + 1 < points.size() && walked < share; ++i) {
      Segment s(at(i), at(i + 1));
      const double length = std::sqrt(s.squared_length());
      if (walked < end.radius && length > 0)
        tangent = end.tip - s.target();
      if (walked + length > share)
        s = Segment(s.source(), s.source() + ((share - walked) / length) * (s.target() - s.source()));
      add_segment(s);
      walked += length;
    }
    const double length = std::sqrt(tangent.squared_length());
    if (length > 0)
      add_segment(Segment(end.tip + (2 * end.radius / length) * tangent, end.tip));
    ends_.push_back(end);
  }

  void add_segment(const Segment& s) { // of the end that is being made; directed inwards
    segments_.push_back(s);
    end_of_segment_.push_back(ends_.size());
  }

  bool is_met_head_on(std::size_t segment, const Rim_shape& shape, bool inside_out) const {
    const Vector outwards = tree_.shape(segment).source() - tree_.shape(segment).target();
    const auto& n = shape.plane.normal();
    const double cosine = outwards.x() * n.x() + outwards.y() * n.y() + outwards.z() * n.z();
    return (inside_out ? -cosine : cosine) > 0.5 * std::sqrt(outwards.squared_length());
  }

  std::vector<End> ends_;
  std::vector<Segment> segments_;
  std::vector<std::size_t> end_of_segment_;
  Nearest_tree<Segment> tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_MATCH_CENTERLINES_H

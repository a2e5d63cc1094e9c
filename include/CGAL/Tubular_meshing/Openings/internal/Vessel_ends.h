// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_VESSEL_ENDS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_VESSEL_ENDS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/Round_end_report.h>
#include <CGAL/Tubular_meshing/Openings/internal/Blind_leaves.h>
#include <CGAL/Tubular_meshing/Openings/internal/Round_end.h>
#include <CGAL/Tubular_meshing/Openings/internal/Lumen_tree.h>
#include <CGAL/Tubular_meshing/Openings/internal/Tip_finder.h>
#include <CGAL/Tubular_meshing/Openings/internal/ball_at_wall.h>
#include <CGAL/Tubular_meshing/Openings/internal/flatten_spikes.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The blind ends of vessels in a surface of one piece: the leaves of centerlines that lead to their tips. */
class Vessel_ends {
  typedef Surface::Vertex_index Vertex;

public:
  struct End {
    Vertex tip; ///< of the surface that was given; null if none is near
    Round_end shape;
    bool is_sac;
    bool is_named; ///< a point says that it is to be cut
    bool is_kept;  ///< a point says that it is to stay
    Point_3 named_by;
  };

  explicit Vessel_ends(const Surface& surface)
      : surface_(surface)
      , closed_(surface) {}

  /* Also places that are no tips, where the options name them. */
  void find(const Cut_round_ends_options& options) {
    close(options.blind_ends);
    const std::vector<Point_3> named = points_away_from_openings(options.ends_to_cut);
    if (named.empty() && !options.all_round_ends)
      return;
    find_originals();
    flatten_spikes(closed_.surface);
    find_tips();
    const std::size_t number_of_tips = tips_.size();
    for (const Point_3& p : named)
      tips_.push_back(nearest_vertex(p));
    trace_lines();
    find_ends();
    for (std::size_t i = 0; i < named.size(); ++i)
      name_end(named[i], tips_[number_of_tips + i]);
    for (const Point_3& p : options.blind_ends)
      for (End& end : ends_)
        end.is_kept = end.is_kept || is_at(p, end);
  }

  const std::vector<End>& ends() const { return ends_; }

  /* A cap of the wall at a point of it, to be cut off where no vessel ends, or where its end cannot be cut. */
  std::optional<End> cap_at(const Point_3& p) const {
    const Vertex at = nearest_vertex(p), tip = originals_[std::size_t(at)];
    const Lumen_tree::Line line = line_into_ball(closed_.surface, at);
    if (tip == Surface::null_vertex() || line.points.empty() ||
        point_distance(p, closed_.surface.point(at)) > line.radii.front() + longest_edge(at))
      return std::nullopt;
    return End{tip, Round_end(line), false, true, false, p};
  }

private:
  // Between the balls in the tips, in radii: what is shorter is a ball, and has no ends; and a body that has ends, but
  // where what is beside these is another place.
  static constexpr double shortest_vessel = 0.3, longest_compact = 3;

  void close(const std::vector<Point_3>& blind_ends) {
    Find_openings_options but_for_blind_ends;
    but_for_blind_ends.blind_ends = blind_ends;
    openings_ = find_any_openings(closed_.surface, but_for_blind_ends);
    if (!openings_.empty()) {
      Tubular_meshing::close_openings(closed_.surface, openings_, closed_.patch);
      return;
    }
    if (is_inside_out(closed_.surface, {}))
      CGAL::Polygon_mesh_processing::reverse_face_orientations(closed_.surface);
    for (auto f : closed_.surface.faces())
      closed_.patch[f] = labels::wall;
  }

  bool is_at_opening(const Point_3& p) const {
    return std::any_of(openings_.begin(), openings_.end(),
                       [&](const Opening& o) { return point_distance(p, o.center) <= 1.5 * o.radius; });
  }

  std::vector<Point_3> points_away_from_openings(const std::vector<Point_3>& points) const {
    std::vector<Point_3> away;
    for (const Point_3& p : points) {
      if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
        throw Parameter_error("The point of an end, " + coordinates(p) + ", has to have finite coordinates.");
      if (!is_at_opening(p))
        away.push_back(p);
    }
    return away;
  }

  // The source of the lines comes first, unless it is an opening.
  void find_tips() {
    Tip_finder finder(closed_.surface);
    std::vector<Vertex> source;
    for (auto f : closed_.surface.faces())
      if (!openings_.empty() && closed_.patch[f] == openings_.front().patch)
        for (Vertex v : CGAL::vertices_around_face(closed_.surface.halfedge(f), closed_.surface))
          source.push_back(v);
    if (source.empty()) {
      source.push_back(finder.farthest_of_all());
      tips_ = source;
    }
    for (Vertex tip : finder.find_from_all_sides(source))
      if (!is_at_opening(closed_.surface.point(tip)))
        tips_.push_back(tip);
  }

  // One pass over the surface for each of the few points that a user gives.
  Vertex nearest_vertex(const Point_3& p) const {
    const auto& mesh = closed_.surface;
    return *std::min_element(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex v, Vertex w) {
      return CGAL::squared_distance(mesh.point(v), p) < CGAL::squared_distance(mesh.point(w), p);
    });
  }

  // From an opening; else from a tip. Where a dent or a needle parts that from the lumen, another one will do.
  void trace_lines() {
    std::vector<std::pair<Point_3, int>> ends;
    for (const Opening& o : openings_)
      ends.emplace_back(o.center, o.patch);
    if (!ends.empty()) {
      trace_lines(ends, tips_);
      return;
    }
    const std::size_t most_tries = 3;
    for (std::size_t i = 0; i < tips_.size() && i < most_tries; ++i) {
      std::vector<Vertex> further(tips_);
      further.erase(further.begin() + std::ptrdiff_t(i));
      if (trace_lines({{closed_.surface.point(tips_[i]), int(labels::wall)}}, further))
        return;
    }
  }

  // False if there are no lines.
  bool trace_lines(const std::vector<std::pair<Point_3, int>>& ends, const std::vector<Vertex>& further) {
    Centerline_computation computation(closed_.surface, closed_.patch, ends, false, true, 1);
    for (Vertex v : further)
      add_end(computation, v);
    const double longest = computation.longest_line();
    is_compact_ = openings_.empty() && longest < longest_compact;
    if (longest > (openings_.empty() ? shortest_vessel : 0))
      computation.make_graph(graph_, Build_centerline_graph_options());
    if (openings_.empty() && !graph_.branches().empty())
      start_in_a_vessel(computation, ends.front().first);
    return longest > 0;
  }

  // A tip may be that of a sac. Where that is broad and lies along a vessel, the lines from it lead to the ends of this
  // vessel by different ways, and none along the vessel, which looks like two bulbs before necks then. From an end of a
  // vessel they do: from that which keeps its radius furthest.
  void start_in_a_vessel(Centerline_computation& computation, const Point_3& source) {
    const std::vector<Blind_leaves::Leaf> leaves = Blind_leaves(graph_, {}).leaves();
    const auto is_at_source = [&](const Round_end& end) {
      return point_distance(source, end.center()) < 1.5 * end.tip_radius();
    };
    const auto length = [](const Round_end& end) { return end.level_length() / end.radius(); };
    const Round_end* furthest = nullptr;
    for (const auto& leaf : leaves) {
      if (!is_at_source(leaf.shape)) {
        if (furthest == nullptr || length(leaf.shape) > length(*furthest))
          furthest = &leaf.shape;
      } else if (leaf.kind == Blind_end_kind::vessel)
        return;
    }
    if (furthest == nullptr)
      return;
    computation.start_from(furthest->center());
    computation.make_graph(graph_, Build_centerline_graph_options());
  }

  // Where a dent or a needle beside the tip parts the ball at it from those of the vessel, that at a neighbour will do.
  void add_end(Centerline_computation& computation, Vertex tip) const {
    const auto& mesh = closed_.surface;
    if (computation.add_ends({tip}))
      return;
    for (Vertex v : CGAL::vertices_around_target(mesh.halfedge(tip), mesh))
      if (computation.add_ends({v}))
        return;
  }

  bool is_leaf_at_opening(std::size_t node) const { return is_at_opening(graph_.points()[graph_.nodes()[node].point]); }

  void find_ends() {
    const Lumen_tree tree(graph_);
    std::set<std::size_t> at_openings;
    for (std::size_t n = 0; n < graph_.nodes().size(); ++n)
      if (tree.is_leaf(n) && is_leaf_at_opening(n))
        at_openings.insert(n);
      else if (tree.is_leaf(n))
        leaves_.push_back({n, 2 * Round_end(tree.line_from(n)).radius()});
    const std::map<std::size_t, Vertex> tips = tips_of_leaves();
    for (const Blind_leaves::Leaf& leaf : Blind_leaves(graph_, at_openings).leaves()) {
      const auto tip = tips.find(leaf.node);
      ends_.push_back(End{tip == tips.end() ? Surface::null_vertex() : originals_[std::size_t(tip->second)], leaf.shape,
                          leaf.kind == Blind_end_kind::sac, false, false, Point_3(0, 0, 0)});
    }
  }

  // Of the tips that are near a leaf that which is farthest out.
  std::map<std::size_t, Vertex> tips_of_leaves() const {
    std::map<std::size_t, Vertex> result;
    std::map<std::size_t, double> farthest;
    for (Vertex tip : tips_) {
      const Point_3& p = closed_.surface.point(tip);
      const std::size_t leaf = leaf_at(p);
      if (leaf == Opening::no_branch)
        continue;
      const auto& branch = graph_.branches()[graph_.nodes()[leaf].branches.front()];
      const std::size_t next = branch.target == leaf ? branch.points[branch.points.size() - 2] : branch.points[1];
      const Point_3& q = graph_.points()[graph_.nodes()[leaf].point];
      const double out = (p - q) * (q - graph_.points()[next]);
      const auto known = farthest.emplace(leaf, out);
      if (known.second || out > known.first->second) {
        known.first->second = out;
        result[leaf] = tip;
      }
    }
    return result;
  }

  // The leaf in the dome of the tip.
  std::size_t leaf_at(const Point_3& tip) const {
    std::size_t best = Opening::no_branch;
    double least = (std::numeric_limits<double>::infinity)();
    for (const Leaf& leaf : leaves_) {
      const double d = point_distance(tip, graph_.points()[graph_.nodes()[leaf.node].point]);
      if (d < least && d <= leaf.reach) {
        least = d;
        best = leaf.node;
      }
    }
    return best;
  }

  // A tip near the point, else the wall at the point itself. An end has one point; another one near it says nothing new.
  void name_end(const Point_3& p, Vertex at) {
    End* nearest = nullptr;
    for (End& end : ends_)
      if (is_at(p, end) && is_before(p, end.shape, end.is_sac || is_compact_) &&
          (nearest == nullptr || distance(p, end) < distance(p, *nearest)))
        nearest = &end;
    if (nearest != nullptr && nearest->is_named) {
      if (point_distance(p, nearest->named_by) <= nearest->shape.radius())
        return;
      nearest = nullptr;
    }
    if (nearest == nullptr) {
      ends_.push_back(end_at_wall(p, at));
      nearest = &ends_.back();
    }
    nearest->is_named = true;
    nearest->named_by = p;
  }

  // Not at the side of the vessel further back than it keeps its radius, nor beside it; nor, of a sac or of what keeps no
  // radius, behind its tip: on a ball, or on what has edges and corners, that is another place.
  static bool is_before(const Point_3& p, const Round_end& end, bool is_wide) {
    const double r = end.radius(), level = (std::min)(end.level_length(), 2 * r);
    const bool is_level = level > 0.5 * r && !is_wide;
    const Vector_3 d = p - (is_level ? end.base() : end.center()), normal = end.direction();
    const double height = d * normal;
    return height >= (is_level ? -level : -0.5 * end.tip_radius()) &&
           (d - height * normal).squared_length() <= 1.6 * r * r;
  }

  // Of the vessel whose tip the vertex is; else a cap of the ball there, if the point is at the wall.
  End end_at_wall(const Point_3& p, Vertex at) const {
    const Vertex tip = originals_[std::size_t(at)];
    const std::size_t leaf = leaf_at(closed_.surface.point(at));
    if (tip != Surface::null_vertex() && leaf != Opening::no_branch) {
      const Round_end shape(Lumen_tree(graph_).line_from(leaf));
      if (is_before(p, shape, true) && std::none_of(ends_.begin(), ends_.end(), [&](const End& end) {
            return end.is_named && point_distance(end.shape.center(), shape.center()) < shape.radius();
          }))
        return End{tip, shape, false, false, false, p};
    }
    const std::optional<End> cap = cap_at(p);
    if (!cap)
      throw Input_error("No vessel ends at " + coordinates(p) +
                        ", where an opening is to be, nor is there wall: give a point at its end.");
    return *cap;
  }

  double longest_edge(Vertex v) const {
    double longest = 0;
    for (Vertex w : CGAL::vertices_around_target(closed_.surface.halfedge(v), closed_.surface))
      longest = (std::max)(longest, point_distance(closed_.surface.point(v), closed_.surface.point(w)));
    return longest;
  }

  double distance(const Point_3& p, const End& end) const {
    const double d = point_distance(p, end.shape.center());
    return end.tip == Surface::null_vertex() ? d : (std::min)(d, point_distance(p, surface_.point(end.tip)));
  }
  bool is_at(const Point_3& p, const End& end) const { return distance(p, end) <= 2 * end.shape.radius(); }

  // Closing openings gives the vertices other numbers, but does not move those far from them.
  void find_originals() {
    std::map<std::array<double, 3>, Vertex> at;
    const auto key = [](const Point_3& p) { return std::array<double, 3>{{p.x(), p.y(), p.z()}}; };
    for (Vertex v : surface_.vertices())
      at.emplace(key(surface_.point(v)), v);
    originals_.assign(closed_.surface.num_vertices(), Surface::null_vertex());
    for (Vertex v : closed_.surface.vertices()) {
      const auto found = at.find(key(closed_.surface.point(v)));
      if (found != at.end())
        originals_[std::size_t(v)] = found->second;
    }
  }

  struct Leaf {
    std::size_t node;
    double reach; ///< of its dome
  };

  const Surface& surface_;
  Labelled_surface closed_;
  std::vector<Opening> openings_;
  std::vector<Vertex> originals_; ///< by vertex of the closed surface: that of the surface that was given, or null
  std::vector<Vertex> tips_;      ///< of the closed surface
  Centerline_graph graph_;
  bool is_compact_ = false;
  std::vector<Leaf> leaves_;
  std::vector<End> ends_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_VESSEL_ENDS_H

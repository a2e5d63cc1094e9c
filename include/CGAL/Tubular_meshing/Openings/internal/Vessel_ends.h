// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_VESSEL_ENDS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_VESSEL_ENDS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/Round_end_report.h>
#include <CGAL/Tubular_meshing/Openings/internal/Round_end.h>
#include <CGAL/Tubular_meshing/Openings/internal/Tip_finder.h>
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
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The blind ends of vessels in a surface of one piece: the leaves of centerlines that lead to their tips. */
class Vessel_ends {
  typedef Surface::Vertex_index Vertex;

public:
  struct End {
    Vertex tip; ///< of the surface that was given
    Round_end shape;
    bool is_named; ///< a point says that it is to be cut
    bool is_kept;  ///< a point says that it is to stay
  };

  explicit Vessel_ends(const Surface& surface)
      : surface_(surface)
      , closed_(surface) {}

  /* Also places that are no tips, where the options name them. */
  void find(const Cut_round_ends_options& options) {
    close();
    const std::vector<Point_3> named = points_away_from_openings(options.ends_to_cut);
    if (named.empty() && !options.all_round_ends)
      return;
    find_tips();
    const std::size_t number_of_tips = tips_.size();
    for (const Point_3& p : named)
      tips_.push_back(nearest_vertex(p));
    trace_lines();
    for (std::size_t i = 0; i < number_of_tips; ++i)
      add_end(tips_[i]);
    for (std::size_t i = 0; i < named.size(); ++i)
      name_end(named[i], tips_[number_of_tips + i]);
    for (const Point_3& p : options.blind_ends)
      for (End& end : ends_)
        end.is_kept = end.is_kept || is_at(p, end);
  }

  const std::vector<End>& ends() const { return ends_; }

private:
  void close() {
    openings_ = find_any_openings(closed_.surface, Find_openings_options());
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
    const std::size_t sources = tips_.size();
    for (const Tip_finder::Tip& tip : finder.find_from_both_ends(source))
      if (!is_at_opening(closed_.surface.point(tip.vertex)) &&
          (sources == 0 || !finder.is_one_dome(tip, {tips_.front(), 0})))
        tips_.push_back(tip.vertex);
  }

  // One pass over the surface for each of the few points that a user gives.
  Vertex nearest_vertex(const Point_3& p) const {
    const auto& mesh = closed_.surface;
    return *std::min_element(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex v, Vertex w) {
      return CGAL::squared_distance(mesh.point(v), p) < CGAL::squared_distance(mesh.point(w), p);
    });
  }

  void trace_lines() {
    std::vector<std::pair<Point_3, int>> ends;
    std::vector<Vertex> further(tips_);
    for (const Opening& o : openings_)
      ends.emplace_back(o.center, o.patch);
    const std::size_t needed = openings_.empty() ? 2 : 1;
    for (std::size_t i = 0; ends.size() < 2 && i < needed && i < tips_.size(); ++i) {
      ends.emplace_back(closed_.surface.point(tips_[i]), int(labels::wall));
      further.erase(further.begin());
    }
    if (ends.size() < 2)
      return; // one opening, or one tip: there is no line
    Centerline_computation computation(closed_.surface, closed_.patch, ends, false, true);
    for (Vertex v : further)
      computation.add_end(v);
    computation.make_graph(graph_, Build_centerline_graph_options());
    for (std::size_t n = 0; n < graph_.nodes().size(); ++n)
      if (graph_.nodes()[n].is_end())
        leaves_.push_back(n);
  }

  // The leaf in the dome of the tip.
  std::size_t leaf_at(const Point_3& tip) const {
    std::size_t best = Opening::no_branch;
    double least = (std::numeric_limits<double>::infinity)();
    for (std::size_t n : leaves_) {
      const Point_3& p = graph_.points()[graph_.nodes()[n].point];
      if (point_distance(tip, p) < least && !is_at_opening(p)) {
        least = point_distance(tip, p);
        best = n;
      }
    }
    return best != Opening::no_branch && least <= 2 * Round_end(graph_, best).radius() ? best : Opening::no_branch;
  }

  // Two tips of one dome lead to one leaf.
  void add_end(Vertex tip) {
    const Point_3 p = closed_.surface.point(tip);
    const std::size_t leaf = leaf_at(p);
    const Vertex v = vertex_of_surface(p);
    if (leaf == Opening::no_branch || v == Surface::null_vertex() || !known_leaves_.insert(leaf).second)
      return;
    ends_.push_back(End{v, Round_end(graph_, leaf), false, false});
  }

  // A tip near the point, else the wall at the point itself.
  void name_end(const Point_3& p, Vertex at) {
    End* nearest = nullptr;
    for (End& end : ends_)
      if (is_at(p, end) && (nearest == nullptr || distance(p, end) < distance(p, *nearest)))
        nearest = &end;
    if (nearest != nullptr) {
      nearest->is_named = true;
      return;
    }
    const std::size_t before = ends_.size();
    add_end(at);
    if (ends_.size() == before)
      throw Input_error("No vessel ends at " + coordinates(p) +
                        ", where an opening is to be: give a point at its end.");
    ends_.back().is_named = true;
  }

  double distance(const Point_3& p, const End& end) const {
    return (std::min)(point_distance(p, surface_.point(end.tip)), point_distance(p, end.shape.center()));
  }
  bool is_at(const Point_3& p, const End& end) const { return distance(p, end) <= 2 * end.shape.radius(); }

  // Closing openings numbers the vertices anew, but does not move those far from them.
  Vertex vertex_of_surface(const Point_3& p) {
    if (vertices_.empty())
      for (Vertex v : surface_.vertices())
        vertices_.emplace(std::array<double, 3>{{surface_.point(v).x(), surface_.point(v).y(), surface_.point(v).z()}},
                          v);
    const auto found = vertices_.find({{p.x(), p.y(), p.z()}});
    return found == vertices_.end() ? Surface::null_vertex() : found->second;
  }

  const Surface& surface_;
  Labelled_surface closed_;
  std::vector<Opening> openings_;
  std::map<std::array<double, 3>, Vertex> vertices_; ///< of the surface that was given
  std::vector<Vertex> tips_;                         ///< of the closed surface
  Centerline_graph graph_;
  std::vector<std::size_t> leaves_;
  std::unordered_set<std::size_t> known_leaves_;
  std::vector<End> ends_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_VESSEL_ENDS_H

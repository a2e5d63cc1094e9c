// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_INTERNAL_TRIM_PLANNER_H
#define CGAL_TUBULAR_MESHING_RIMS_INTERNAL_TRIM_PLANNER_H

#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/Rims/internal/Trim_plan.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Decides everything about a trim on the untouched mesh: its application then cannot fail. */
class Trim_planner {
public:
  Trim_planner(const Surface& mesh, const Oriented_plane& plane)
      : mesh_(mesh) {
    plan_.plane = plane;
  }

  /* False if the cut would not be one simple closed loop. */
  bool plan(const std::vector<Vertex>& seeds, double reach) {
    reach_ = reach;
    seeds_.insert(seeds.begin(), seeds.end());
    if (!place_seeds(seeds) || !flood() || !find_crossing_edges() || !absorb_islands())
      return false;
    const Positions placed_seeds = plan_.on;
    do {
      plan_.on = placed_seeds;
      snap_to_vertices();
      classify_faces();
      find_cut(seeds);
      if (cut_is_one_loop())
        return true;
    } while (forbid_snaps_in_trouble());
    return false;
  }

  const Trim_plan& result() const { return plan_; }

private:
  typedef std::unordered_map<Vertex, Point_3> Positions;
  typedef std::pair<bool, std::size_t> Node; // of the cut: a split edge, or else a vertex, and its index
  struct Node_hash {
    std::size_t operator()(const Node& n) const { return 2 * n.second + (n.first ? 1 : 0); }
  };

  static constexpr double snap_fraction = 0.1;        // of the edge
  static constexpr double negligible_fraction = 1e-9; // of the edge: moving so little harms nothing

  // --- geometry ---

  double height(Vertex v) const { return plan_.plane.height(mesh_.point(v)); }

  double shortest_edge(Vertex v) const {
    double shortest = (std::numeric_limits<double>::max)();
    for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_))
      shortest = (std::min)(shortest, point_distance(mesh_.point(mesh_.source(h)), mesh_.point(v)));
    return shortest;
  }

  double crossing_fraction(Halfedge h) const {
    return plan_.crossing_fraction(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)));
  }

  Point_3 planned_position(Vertex v) const {
    auto found = plan_.on.find(v);
    return found == plan_.on.end() ? mesh_.point(v) : found->second;
  }

  // --- states ---

  bool is_on(Vertex v) const { return plan_.is_on(v); }
  bool is_above(Vertex v) const { return plan_.is_above(v); }
  bool is_below(Vertex v) const { return plan_.is_below(v); }
  bool is_crossing(Halfedge h) const { return is_above(mesh_.source(h)) && is_below(mesh_.target(h)); }
  bool is_in_reach(Vertex v) const {
    return CGAL::squared_distance(mesh_.point(v), plan_.plane.origin()) <= reach_ * reach_;
  }
  void make_above(Vertex v) {
    if (plan_.above.insert(v).second)
      above_order_.push_back(v);
  }

  // --- what goes ---

  // Vertices of the opening that all but lie in the plane are put into it; the others must be above it.
  bool place_seeds(const std::vector<Vertex>& seeds) {
    for (Vertex v : seeds) {
      const double h = height(v), edge = shortest_edge(v);
      if (mesh_.is_border(v) && std::abs(h) <= snap_fraction * edge &&
          snap(v, plan_.plane.projection(mesh_.point(v)), std::abs(h) <= negligible_fraction * edge))
        continue;
      if (!(h > 0))
        return false;
      make_above(v);
    }
    return true;
  }

  bool flood() {
    for (std::size_t i = 0; i < above_order_.size(); ++i) {
      if (!is_in_reach(above_order_[i]))
        return false;
      for (Vertex w : CGAL::vertices_around_target(above_order_[i], mesh_)) {
        if (plan_.above.count(w) || is_on(w) || !(height(w) > 0))
          continue;
        if (mesh_.is_border(w) && !seeds_.count(w))
          return false;
        make_above(w);
      }
    }
    return true;
  }

  bool find_crossing_edges() {
    for (Vertex v : above_order_)
      for (Halfedge h : CGAL::halfedges_around_source(v, mesh_)) {
        if (plan_.above.count(mesh_.target(h)))
          continue;
        if (mesh_.is_border(mesh_.edge(h)) && !is_on(mesh_.target(h)))
          return false;
        crossing_.push_back(h);
      }
    return true;
  }

  // The crossing edges line up in strips: closed ones, and ones that end at the opening. The longest closed strip, or
  // the open ones together, is where the cut runs; the others surround islands of vertices that are below the plane
  // (a bump of the noise, a fold of the rim), which go with the rest if they are small.
  bool absorb_islands() {
    const std::vector<std::vector<Halfedge>> strips = strips_of_crossing_edges();
    if (strips.size() < 2)
      return true;
    std::size_t main = 0;
    for (std::size_t i = 1; i < strips.size(); ++i)
      if (strips[i].size() > strips[main].size())
        main = i;
    std::unordered_set<Vertex> main_shore;
    for (Halfedge h : strips[main])
      main_shore.insert(mesh_.target(h));
    for (std::size_t i = 0; i < strips.size(); ++i)
      if (i != main && !absorb_island(strips[i], main_shore))
        return false;
    crossing_ = strips[main];
    return true;
  }

  // Strip 0 holds all that end at the opening (it may be empty).
  std::vector<std::vector<Halfedge>> strips_of_crossing_edges() const {
    std::vector<std::vector<Halfedge>> strips(1);
    std::unordered_set<Edge> visited;
    for (Halfedge h : crossing_)
      if (mesh_.is_border(mesh_.edge(h)) && visited.insert(mesh_.edge(h)).second)
        follow_strip(h, visited, strips[0]);
    for (Halfedge h : crossing_)
      if (visited.insert(mesh_.edge(h)).second) {
        strips.emplace_back();
        follow_strip(h, visited, strips.back());
      }
    if (strips[0].empty())
      strips.erase(strips.begin());
    return strips;
  }

  void follow_strip(Halfedge h, std::unordered_set<Edge>& visited, std::vector<Halfedge>& strip) const {
    bool on_the_left = !mesh_.is_border(h); // walk through the faces left, or right, of the crossing edges
    for (;;) {
      strip.push_back(h);
      const Halfedge inner = on_the_left ? h : mesh_.opposite(h);
      if (mesh_.is_border(inner))
        return;
      h = other_crossing(inner);
      if (!visited.insert(mesh_.edge(h)).second)
        return;
    }
  }

  // The other crossing halfedge of the triangle, again directed down; of the two ways through it, the one the walk
  // goes stays on the same side of the directed edges.
  Halfedge other_crossing(Halfedge h) const {
    for (Halfedge g : {mesh_.next(h), mesh_.prev(h)}) {
      if (plan_.above.count(mesh_.source(g)) != plan_.above.count(mesh_.target(g)))
        return plan_.above.count(mesh_.source(g)) ? g : mesh_.opposite(g);
    }
    return h;
  }

  bool absorb_island(const std::vector<Halfedge>& strip, const std::unordered_set<Vertex>& main_shore) {
    const std::size_t most = (std::max)(plan_.above.size(), std::size_t(64));
    std::vector<Vertex> island;
    std::unordered_set<Vertex> visited;
    for (Halfedge h : strip)
      if (visited.insert(mesh_.target(h)).second)
        island.push_back(mesh_.target(h));
    for (std::size_t i = 0; i < island.size(); ++i) {
      const Vertex v = island[i];
      if (island.size() > most || main_shore.count(v) || (mesh_.is_border(v) && !seeds_.count(v)))
        return false;
      for (Vertex w : CGAL::vertices_around_target(v, mesh_))
        if (!plan_.above.count(w) && visited.insert(w).second)
          island.push_back(w);
    }
    for (Vertex v : island) {
      plan_.on.erase(v);
      make_above(v);
    }
    return true;
  }

  // --- snapping ---

  void snap_to_vertices() {
    std::unordered_map<Vertex, std::pair<double, Point_3>> nearest;
    for (Halfedge h : crossing_) {
      if (!is_crossing(h))
        continue;
      const double t = crossing_fraction(h);
      const Vertex v = t < 0.5 ? mesh_.source(h) : mesh_.target(h);
      const double fraction = (std::min)(t, 1 - t);
      if (fraction > snap_fraction || unsnappable_.count(v) || (is_below(v) && mesh_.is_border(v)))
        continue;
      const Point_3& p = mesh_.point(mesh_.source(h));
      const std::pair<double, Point_3> candidate(fraction,
                                                 plan_.plane.projection(p + t * (mesh_.point(mesh_.target(h)) - p)));
      auto inserted = nearest.emplace(v, candidate);
      if (!inserted.second && candidate.first < inserted.first->second.first)
        inserted.first->second = candidate;
    }
    std::vector<std::tuple<double, Vertex, Point_3>> candidates;
    for (const auto& c : nearest)
      candidates.emplace_back(c.second.first, c.first, c.second.second);
    std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
      return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
    });
    for (const auto& [fraction, v, p] : candidates)
      snap(v, p, fraction <= negligible_fraction);
  }

  bool snap(Vertex v, const Point_3& p, bool always) {
    if (!always)
      for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_))
        if (!mesh_.is_border(h) && !stays_good(h, p))
          return false;
    plan_.on.insert(std::make_pair(v, p));
    return true;
  }

  // Whether the triangle of h keeps its orientation and most of its shape when the target of h moves to p, and is not
  // laid flat into the plane.
  bool stays_good(Halfedge h, const Point_3& p) const {
    const Vertex a = mesh_.source(h), b = mesh_.target(mesh_.next(h));
    if (is_on(a) && is_on(b))
      return false;
    const Point_3 pa = planned_position(a), pb = planned_position(b), &old = mesh_.point(mesh_.target(h));
    const Vector_3 before = CGAL::cross_product(pb - old, pa - old), after = CGAL::cross_product(pb - p, pa - p);
    const double scale_before = longest_squared(old, pa, pb), scale_after = longest_squared(p, pa, pb);
    const double area_before = std::sqrt(before.squared_length()), area_after = std::sqrt(after.squared_length());
    return before * after >= 0.7 * area_before * area_after &&
           area_after * scale_before >= 0.4 * area_before * scale_after;
  }

  static double longest_squared(const Point_3& a, const Point_3& b, const Point_3& c) {
    return (std::max)(CGAL::squared_distance(a, b),
                      (std::max)(CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)));
  }

  // --- the cut ---

  void classify_faces() {
    plan_.removed_faces.clear();
    plan_.split_faces.clear();
    removed_.clear();
    std::unordered_set<Face> visited;
    for (Vertex v : above_order_)
      for (Face f : CGAL::faces_around_target(mesh_.halfedge(v), mesh_)) {
        if (f == Surface::null_face() || !visited.insert(f).second)
          continue;
        bool above = false, below = false;
        for (Vertex w : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_)) {
          above = above || is_above(w);
          below = below || is_below(w);
        }
        if (above && below)
          plan_.split_faces.push_back(f);
        else if (above) {
          plan_.removed_faces.push_back(f);
          removed_.insert(f);
        }
      }
  }

  // The segments of the cut: across the split faces, along the edges between removed and remaining faces, and along
  // those edges of the opening that already lie in the plane.
  void find_cut(const std::vector<Vertex>& seeds) {
    cut_.clear();
    plan_.split_edges.clear();
    for (Halfedge h : crossing_)
      if (is_crossing(h))
        plan_.split_edges.push_back(h);
    for (Face f : plan_.split_faces) {
      std::vector<Node> nodes;
      for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_)) {
        if (is_crossing(h) || is_crossing(mesh_.opposite(h)))
          nodes.emplace_back(true, std::size_t(mesh_.edge(h)));
        if (is_on(mesh_.target(h)))
          nodes.emplace_back(false, std::size_t(mesh_.target(h)));
      }
      if (nodes.size() == 2)
        add_segment(nodes[0], nodes[1]);
    }
    for (Face f : plan_.removed_faces)
      for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
        if (is_on(mesh_.source(h)) && is_on(mesh_.target(h)) && !mesh_.is_border(mesh_.opposite(h)) &&
            !removed_.count(mesh_.face(mesh_.opposite(h))))
          add_segment(mesh_.source(h), mesh_.target(h));
    for (Vertex v : seeds)
      for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_))
        if (mesh_.is_border(h) && is_on(v) && is_on(mesh_.source(h)) && !removed_.count(mesh_.face(mesh_.opposite(h))))
          add_segment(mesh_.source(h), v);
  }

  void add_segment(Vertex a, Vertex b) { add_segment(Node(false, std::size_t(a)), Node(false, std::size_t(b))); }
  void add_segment(Node a, Node b) {
    cut_[a].push_back(b);
    cut_[b].push_back(a);
    if (!a.first)
      plan_.loop_vertex = Vertex(Surface::size_type(a.second));
  }

  bool cut_is_one_loop() const {
    if (cut_.size() < 3)
      return false;
    for (const auto& node : cut_)
      if (node.second.size() != 2)
        return false;
    const Node start = cut_.begin()->first;
    Node previous = start, current = cut_.begin()->second[0];
    std::size_t visited = 1;
    for (; current != start; ++visited) {
      const std::vector<Node>& ends = cut_.at(current);
      const Node next = ends[0] == previous ? ends[1] : ends[0];
      previous = current;
      current = next;
    }
    return visited == cut_.size();
  }

  // Without any snapping the cut is one loop, so what is in the way are snapped vertices: those where the cut touches
  // itself first, all of them else.
  bool forbid_snaps_in_trouble() {
    const std::size_t known = unsnappable_.size();
    for (const auto& node : cut_)
      if (node.second.size() != 2 && !node.first.first)
        unsnappable_.insert(Vertex(Surface::size_type(node.first.second)));
    if (unsnappable_.size() == known)
      for (const auto& snapped : plan_.on)
        unsnappable_.insert(snapped.first);
    return unsnappable_.size() != known;
  }

  const Surface& mesh_;
  double reach_ = 0;
  Trim_plan plan_;
  std::unordered_set<Vertex> seeds_;
  std::vector<Vertex> above_order_;
  std::unordered_set<Vertex> unsnappable_;
  std::vector<Halfedge> crossing_; // each directed down
  std::unordered_set<Face> removed_;
  std::unordered_map<Node, std::vector<Node>, Node_hash> cut_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_INTERNAL_TRIM_PLANNER_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_TRIM_BY_PLANE_H
#define CGAL_TUBULAR_MESHING_RIMS_TRIM_BY_PLANE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
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

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// The work behind trim_by_plane(): plan() decides everything on the untouched mesh, apply() then cannot fail.
//
// A vertex is `above` (it goes: on the positive side and connected to the seed through vertices of that side), `on`
// (it is moved onto the plane) or `below` (it stays, whichever side it lies on). An edge between above and below is
// crossing, and is split. A face is removed when it has an above and no below vertex, split when it has both.
class Plane_trimmer {
public:
  typedef CGAL::Surface_mesh<Point_3> Mesh;
  typedef typename Kernel_traits<Point_3>::Kernel::Vector_3 Vector;
  typedef typename Mesh::Vertex_index Vertex;
  typedef typename Mesh::Halfedge_index Halfedge;
  typedef typename Mesh::Edge_index Edge;
  typedef typename Mesh::Face_index Face;

  Plane_trimmer(Mesh& mesh, const Point_3& origin, const Vector& normal)
      : mesh_(mesh)
      , origin_(origin)
      , normal_(normal / std::sqrt(normal.squared_length())) {}

  bool plan(const std::vector<Vertex>& seeds, double reach) {
    reach_ = reach;
    seeds_.insert(seeds.begin(), seeds.end());
    if (!place_seeds(seeds) || !flood() || !find_crossing_edges() || !absorb_islands())
      return false;
    const Positions placed_seeds = on_;
    do {
      on_ = placed_seeds;
      snap_to_vertices();
      classify_faces();
      find_cut(seeds);
      if (cut_is_one_loop())
        return true;
    } while (forbid_snaps_in_trouble());
    return false;
  }

  // A halfedge of the border that the cut leaves.
  Halfedge apply() {
    std::unordered_set<Vertex> cut_vertices;
    for (const auto& [v, p] : on_) {
      mesh_.point(v) = p;
      cut_vertices.insert(v);
    }
    for (Halfedge h : split_edges_) {
      const Point_3 p = crossing_point(h); // before the edge is no more
      const Vertex v = target(CGAL::Euler::split_edge(h, mesh_), mesh_);
      mesh_.point(v) = p;
      cut_vertices.insert(v);
      last_cut_vertex_ = v;
    }
    if (split_edges_.empty())
      last_cut_vertex_ = loop_vertex_;
    for (Face f : split_faces_)
      split_face(f, cut_vertices);
    for (Face f : removed_faces_)
      CGAL::Euler::remove_face(mesh_.halfedge(f), mesh_);
    for (Halfedge h : CGAL::halfedges_around_target(last_cut_vertex_, mesh_))
      if (mesh_.is_border(h))
        return h;
    return Mesh::null_halfedge();
  }

private:
  typedef std::unordered_map<Vertex, Point_3> Positions;
  typedef std::pair<bool, std::size_t> Node; // of the cut: a split edge, or else a vertex, and its index
  struct Node_hash {
    std::size_t operator()(const Node& n) const { return 2 * n.second + (n.first ? 1 : 0); }
  };

  static constexpr double snap_fraction() { return 0.1; }        // of the edge
  static constexpr double negligible_fraction() { return 1e-9; } // of the edge: moving so little harms nothing

  // --- geometry ---

  double height(const Point_3& p) const { return (p - origin_) * normal_; }
  double height(Vertex v) const { return height(mesh_.point(v)); }

  // Twice, as the first rounding error is relative to the height, the second to what is left of it.
  Point_3 on_plane(Point_3 p) const {
    p = p - height(p) * normal_;
    return p - height(p) * normal_;
  }

  double shortest_edge(Vertex v) const {
    double shortest = (std::numeric_limits<double>::max)();
    for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_))
      shortest = (std::min)(shortest, length(h));
    return shortest;
  }

  double length(Halfedge h) const {
    return std::sqrt(CGAL::squared_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h))));
  }

  // Where the plane crosses, as a fraction of the edge from its source, which is above.
  double crossing_fraction(Halfedge h) const {
    const double above = height(mesh_.source(h)), below = height(mesh_.target(h));
    return above > below ? above / (above - below) : 0.5;
  }

  // Crossings at the very end of an edge, left over where snapping was refused, keep a little distance from it.
  Point_3 crossing_point(Halfedge h) const {
    const double t = (std::min)((std::max)(crossing_fraction(h), 0.02), 0.98);
    const Point_3& p = mesh_.point(mesh_.source(h));
    return on_plane(p + t * (mesh_.point(mesh_.target(h)) - p));
  }

  Point_3 planned_position(Vertex v) const {
    auto found = on_.find(v);
    return found == on_.end() ? mesh_.point(v) : found->second;
  }

  // --- states ---

  bool is_on(Vertex v) const { return on_.count(v) != 0; }
  bool is_above(Vertex v) const { return above_.count(v) != 0 && !is_on(v); }
  bool is_below(Vertex v) const { return above_.count(v) == 0 && !is_on(v); }
  bool is_crossing(Halfedge h) const { return is_above(mesh_.source(h)) && is_below(mesh_.target(h)); }
  bool is_in_reach(Vertex v) const { return CGAL::squared_distance(mesh_.point(v), origin_) <= reach_ * reach_; }
  void make_above(Vertex v) {
    if (above_.insert(v).second)
      above_order_.push_back(v);
  }

  // --- what goes ---

  // Vertices of the opening that all but lie in the plane are put into it; the others must be above it.
  bool place_seeds(const std::vector<Vertex>& seeds) {
    for (Vertex v : seeds) {
      const double h = height(v), edge = shortest_edge(v);
      if (mesh_.is_border(v) && std::abs(h) <= snap_fraction() * edge &&
          snap(v, on_plane(mesh_.point(v)), std::abs(h) <= negligible_fraction() * edge))
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
        if (above_.count(w) || is_on(w) || !(height(w) > 0))
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
        if (above_.count(mesh_.target(h)))
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
      if (above_.count(mesh_.source(g)) != above_.count(mesh_.target(g)))
        return above_.count(mesh_.source(g)) ? g : mesh_.opposite(g);
    }
    return h;
  }

  bool absorb_island(const std::vector<Halfedge>& strip, const std::unordered_set<Vertex>& main_shore) {
    const std::size_t most = (std::max)(above_.size(), std::size_t(64));
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
        if (!above_.count(w) && visited.insert(w).second)
          island.push_back(w);
    }
    for (Vertex v : island) {
      on_.erase(v);
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
      if (fraction > snap_fraction() || unsnappable_.count(v) || (is_below(v) && mesh_.is_border(v)))
        continue;
      const Point_3& p = mesh_.point(mesh_.source(h));
      const std::pair<double, Point_3> candidate(fraction, on_plane(p + t * (mesh_.point(mesh_.target(h)) - p)));
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
      snap(v, p, fraction <= negligible_fraction());
  }

  bool snap(Vertex v, const Point_3& p, bool always) {
    if (!always)
      for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_))
        if (!mesh_.is_border(h) && !stays_good(h, p))
          return false;
    on_.insert(std::make_pair(v, p));
    return true;
  }

  // Whether the triangle of h keeps its orientation and most of its shape when the target of h moves to p, and is not
  // laid flat into the plane.
  bool stays_good(Halfedge h, const Point_3& p) const {
    const Vertex a = mesh_.source(h), b = mesh_.target(mesh_.next(h));
    if (is_on(a) && is_on(b))
      return false;
    const Point_3 pa = planned_position(a), pb = planned_position(b), &old = mesh_.point(mesh_.target(h));
    const Vector before = CGAL::cross_product(pb - old, pa - old), after = CGAL::cross_product(pb - p, pa - p);
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
    removed_faces_.clear();
    split_faces_.clear();
    removed_.clear();
    std::unordered_set<Face> visited;
    for (Vertex v : above_order_)
      for (Face f : CGAL::faces_around_target(mesh_.halfedge(v), mesh_)) {
        if (f == Mesh::null_face() || !visited.insert(f).second)
          continue;
        bool above = false, below = false;
        for (Vertex w : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_)) {
          above = above || is_above(w);
          below = below || is_below(w);
        }
        if (above && below)
          split_faces_.push_back(f);
        else if (above) {
          removed_faces_.push_back(f);
          removed_.insert(f);
        }
      }
  }

  // The segments of the cut: across the split faces, along the edges between removed and remaining faces, and along
  // those edges of the opening that already lie in the plane.
  void find_cut(const std::vector<Vertex>& seeds) {
    cut_.clear();
    split_edges_.clear();
    for (Halfedge h : crossing_)
      if (is_crossing(h))
        split_edges_.push_back(h);
    for (Face f : split_faces_) {
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
    for (Face f : removed_faces_)
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
      loop_vertex_ = Vertex(static_cast<typename Mesh::size_type>(a.second));
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
        unsnappable_.insert(Vertex(static_cast<typename Mesh::size_type>(node.first.second)));
    if (unsnappable_.size() == known)
      for (const auto& snapped : on_)
        unsnappable_.insert(snapped.first);
    return unsnappable_.size() != known;
  }

  // --- applying ---

  // Splits the polygon that a split triangle has become along the cut; the part above joins the removed faces.
  void split_face(Face f, const std::unordered_set<Vertex>& cut_vertices) {
    std::vector<Halfedge> to_cut;
    for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
      if (cut_vertices.count(mesh_.target(h)))
        to_cut.push_back(h);
    const Halfedge cut = CGAL::Euler::split_face(to_cut[0], to_cut[1], mesh_);
    const bool left_is_above = is_above(mesh_.target(mesh_.next(cut)));
    const Halfedge below = left_is_above ? mesh_.opposite(cut) : cut;
    removed_faces_.push_back(mesh_.face(mesh_.opposite(below)));
    const Halfedge second = mesh_.next(below), third = mesh_.next(second);
    if (mesh_.next(third) == below)
      return;
    if (diagonal(below, third) <= diagonal(second, mesh_.next(third)))
      CGAL::Euler::split_face(below, third, mesh_);
    else
      CGAL::Euler::split_face(second, mesh_.next(third), mesh_);
  }

  double diagonal(Halfedge a, Halfedge b) const {
    return CGAL::squared_distance(mesh_.point(mesh_.target(a)), mesh_.point(mesh_.target(b)));
  }

  Mesh& mesh_;
  const Point_3 origin_;
  const Vector normal_;
  double reach_ = 0;

  std::unordered_set<Vertex> seeds_;
  std::unordered_set<Vertex> above_;
  std::vector<Vertex> above_order_;
  Positions on_;
  std::unordered_set<Vertex> unsnappable_;
  std::vector<Halfedge> crossing_; // each directed down
  std::vector<Halfedge> split_edges_;
  std::vector<Face> split_faces_, removed_faces_;
  std::unordered_set<Face> removed_;
  std::unordered_map<Node, std::vector<Node>, Node_hash> cut_;
  Vertex loop_vertex_, last_cut_vertex_;
};

/*!
 * Cuts the part off a triangulated surface that lies above a plane and is connected to a set of vertices, and leaves a
 * planar border there: the way to give an opening an exactly planar rim, and to open a closed end.
 *
 * What goes is everything that the seed reaches through vertices with a positive height over the plane, whatever else
 * the plane crosses elsewhere. Small islands below the plane within that part (noise, a folded rim) go with it. Only
 * the triangles that the plane crosses there are split. Where the plane crosses an edge within a tenth of its length
 * from one of its vertices, that vertex is moved to the crossing instead, unless this would turn or flatten a triangle,
 * so that no slivers arise. All vertices of the new border have a height over the plane of rounding size, about
 * 1e-16 x the largest coordinate.
 *
 * Nothing is changed, and a null halfedge is returned, if the cut would not be one simple closed loop, in particular
 * - if a seed is below the plane, unless it is on the border and nearer to it than a tenth of its shortest edge (it is
 *   then moved onto the plane),
 * - if a border other than the seed's would be cut or removed (the plane's upper side leads to another opening),
 * - if the part to remove reaches farther than `reach` from `origin`,
 * - if the plane cuts that part in several loops that do not enclose small islands.
 *
 * If the border of the seed lies in the plane already, no face is changed and a halfedge of it is returned.
 *
 * Removed elements are only marked as such: call `mesh.collect_garbage()` after the last of a series of cuts.
 * New vertices and faces have the default values of all property maps. Indices of elements that remain are stable,
 * but a halfedge of a split edge may be either of its parts.
 *
 * \param mesh a triangle mesh, manifold; what is outside the part that goes and its rim is neither read nor changed
 * \param origin a point of the plane
 * \param normal its normal, of any length; the side it points to is removed
 * \param seeds vertices of the side to remove; for an opening, all vertices of its border
 * \param reach how far from `origin` the part to remove may reach, in the unit of the mesh
 * \return a border halfedge of the new loop, or `null_halfedge()`
 *
 * Complexity: linear in the number of faces removed and split (expected, as it hashes).
 */
inline Surface::Halfedge_index trim_by_plane(CGAL::Surface_mesh<Point_3>& mesh, const Point_3& origin,
                                             const typename Kernel_traits<Point_3>::Kernel::Vector_3& normal,
                                             const std::vector<Surface::Vertex_index>& seeds,
                                             double reach = (std::numeric_limits<double>::infinity)()) {
  Plane_trimmer trimmer(mesh, origin, normal);
  if (seeds.empty() || !trimmer.plan(seeds, reach))
    return CGAL::Surface_mesh<Point_3>::null_halfedge();
  return trimmer.apply();
}

/*! As above; the seeds are the vertices of the border that `seed` is on, or its target if it is not a border halfedge.
 */
inline Surface::Halfedge_index trim_by_plane(CGAL::Surface_mesh<Point_3>& mesh, const Point_3& origin,
                                             const typename Kernel_traits<Point_3>::Kernel::Vector_3& normal,
                                             Surface::Halfedge_index seed,
                                             double reach = (std::numeric_limits<double>::infinity)()) {
  std::vector<Surface::Vertex_index> seeds;
  if (!mesh.is_border(seed))
    seeds.push_back(mesh.target(seed));
  else
    for (auto h : CGAL::halfedges_around_face(seed, mesh))
      seeds.push_back(mesh.target(h));
  return trim_by_plane(mesh, origin, normal, seeds, reach);
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_RIMS_TRIM_BY_PLANE_H

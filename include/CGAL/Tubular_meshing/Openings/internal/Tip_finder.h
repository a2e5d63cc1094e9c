// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_TIP_FINDER_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_TIP_FINDER_H

#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Finds the tips of vessels that end blind: where the way along the wall from a source is longest. Of the local maxima
 * of this way those count whose surroundings, down to where they meet those of another tip, are a tube: what sticks out
 * of a wall by less is a bump. O(n log n) for n vertices; scale- and rotation-independent. */
class Tip_finder {
  typedef Surface::Vertex_index Vertex;

public:
  struct Tip {
    Vertex vertex;
    double width; ///< of the vessel, about its diameter
  };

  explicit Tip_finder(const Surface& mesh)
      : mesh_(mesh)
      , area_(mesh.num_vertices(), 0) {
    for (auto f : mesh.faces()) {
      const double a = std::sqrt(area_vector(mesh.halfedge(f), mesh).squared_length()) / 3;
      for (Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        area_[std::size_t(v)] += a;
    }
  }

  /* A vertex at the end of the longest way along the surface, or nearly so: a tip of a closed one. */
  Vertex farthest_of_all() {
    Vertex v = *mesh_.vertices().begin();
    for (int sweep = 0; sweep < 3; ++sweep) {
      measure_ways({v});
      v = farthest();
    }
    return v;
  }

  /* The vertex to which the way from a source is longest. */
  Vertex farthest_from(const std::vector<Vertex>& source) {
    measure_ways(source);
    return farthest();
  }

  /* The tips but for the source, the farthest first. */
  std::vector<Tip> find(const std::vector<Vertex>& source) {
    measure_ways(source);
    sort_by_way();
    grow_regions();
    std::stable_sort(tips_.begin(), tips_.end(),
                     [&](const Tip& a, const Tip& b) { return way(a.vertex) > way(b.vertex); });
    return tips_;
  }

  /* Those from the source, and those from the farthest of these: a branch that leads back to one leads away from the
   * other. */
  std::vector<Tip> find_from_both_ends(const std::vector<Vertex>& source) {
    std::vector<Tip> tips = find(source);
    if (tips.empty())
      return tips;
    for (const Tip& t : find({tips.front().vertex}))
      if (std::none_of(tips.begin(), tips.end(), [&](const Tip& known) { return is_one_dome(t, known); }))
        tips.push_back(t);
    return tips;
  }

  bool is_one_dome(const Tip& a, const Tip& b) const {
    return point_distance(mesh_.point(a.vertex), mesh_.point(b.vertex)) < (std::max)(a.width, b.width);
  }

private:
  // The area over that of a disk with the same border: 2 for a half ball, 1 + 2 l / r for a tube of length l with a flat
  // end.
  static constexpr double min_height = 2.7;
  // Of a large part only: the way squared over the area, as a multiple of that of a disk around the tip. 1.2 for a half
  // ball, 1.8 where a tube as long as its radius is behind the ball.
  static constexpr double min_slenderness = 1.3;
  static constexpr std::size_t none = std::size_t(-1);

  // A set of vertices of long ways, connected; known by its representative.
  struct Region {
    Vertex tip;
    double area = 0;
    bool is_settled = false;      ///< its tips are known
    std::vector<Vertex> vertices; ///< all of them
  };

  double way(Vertex v) const { return way_[std::size_t(v)]; }
  Vertex farthest() const {
    std::size_t best = 0;
    for (std::size_t i = 0; i < way_.size(); ++i)
      if (way_[i] < (std::numeric_limits<double>::infinity)() && way_[i] > way_[best])
        best = i;
    return Vertex(Surface::size_type(best));
  }

  // Dijkstra's algorithm along the edges.
  void measure_ways(const std::vector<Vertex>& source) {
    way_.assign(mesh_.num_vertices(), (std::numeric_limits<double>::infinity)());
    typedef std::pair<double, Vertex> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for (Vertex v : source) {
      way_[std::size_t(v)] = 0;
      queue.emplace(0., v);
    }
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > way(v))
        continue;
      for (Vertex w : CGAL::vertices_around_target(mesh_.halfedge(v), mesh_)) {
        const double through_v = d + point_distance(mesh_.point(v), mesh_.point(w));
        if (through_v < way(w)) {
          way_[std::size_t(w)] = through_v;
          queue.emplace(through_v, w);
        }
      }
    }
  }

  void sort_by_way() {
    order_.clear();
    for (Vertex v : mesh_.vertices())
      if (way(v) < (std::numeric_limits<double>::infinity)())
        order_.push_back(v);
    std::sort(order_.begin(), order_.end(),
              [&](Vertex a, Vertex b) { return way(a) != way(b) ? way(a) > way(b) : std::size_t(a) < std::size_t(b); });
  }

  void grow_regions() {
    parent_.assign(mesh_.num_vertices(), none);
    region_.assign(mesh_.num_vertices(), Region());
    tips_.clear();
    for (Vertex v : order_) {
      const std::size_t i = std::size_t(v);
      parent_[i] = i;
      region_[i].tip = v;
      region_[i].area = area_[i];
      region_[i].vertices.push_back(v);
      for (Vertex w : CGAL::vertices_around_target(mesh_.halfedge(v), mesh_))
        if (parent_[std::size_t(w)] != none)
          join(find_root(i), find_root(std::size_t(w)), way(v));
    }
    if (order_.empty())
      return;
    Region& all = region_[find_root(std::size_t(order_.front()))]; // of a single tube
    if (is_slender(all, 0))
      settle(all, 0);
  }

  std::size_t find_root(std::size_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  // Two vessels part here. Where only one is a vessel, the other is but a bump of it if it is small; else it goes on by
  // itself, and may become one.
  void join(std::size_t a, std::size_t b, double level) {
    if (a == b)
      return;
    if (region_[a].vertices.size() < region_[b].vertices.size())
      std::swap(a, b);
    Region &large = region_[a], &small = region_[b];
    const bool large_is_vessel = is_slender(large, level), small_is_vessel = small.is_settled || is_tube(small, level);
    if (large_is_vessel && small_is_vessel) {
      settle(large, level);
      settle(small, level);
      large.area += small.area;
    } else if (small_is_vessel) {
      settle(small, level); // and the stout one goes on
    } else if (large_is_vessel && small.area > 0.5 * large.area) {
      settle(large, level);
      large.tip = small.tip;
      large.area = small.area;
      large.is_settled = false;
    } else {
      if (!large_is_vessel && way(small.tip) > way(large.tip))
        large.tip = small.tip;
      large.area += small.area;
    }
    large.vertices.insert(large.vertices.end(), small.vertices.begin(), small.vertices.end());
    std::vector<Vertex>().swap(small.vertices);
    parent_[b] = a;
  }

  bool is_slender(const Region& r, double level) const {
    const double length = way(r.tip) - level;
    return r.is_settled || CGAL_PI * length * length > min_slenderness * r.area;
  }

  // Of the part above the level. Linear in its size: only the smaller of two that meet is asked.
  bool is_tube(const Region& r, double level) const {
    if (r.vertices.size() < 6)
      return false;
    const std::unordered_set<Vertex> inside(r.vertices.begin(), r.vertices.end());
    std::unordered_set<Surface::Face_index> seen;
    double area = 0, border = 0;
    for (Vertex v : r.vertices)
      for (auto f : CGAL::faces_around_target(mesh_.halfedge(v), mesh_))
        if (f != Surface::null_face() && seen.insert(f).second)
          add_part_above(mesh_.halfedge(f), inside, level, area, border);
    return 4 * CGAL_PI * area > min_height * border * border;
  }

  // Of a face, the part inside, as if ways were linear in it, and the line that bounds this part.
  void add_part_above(Surface::Halfedge_index h, const std::unordered_set<Vertex>& inside, double level, double& area,
                      double& border) const {
    const double face_area = std::sqrt(area_vector(h, mesh_).squared_length());
    int number = 0;
    for (auto g : CGAL::halfedges_around_face(h, mesh_))
      number += int(inside.count(mesh_.target(g)));
    if (number == 3) {
      area += face_area;
      return;
    }
    // to the corner that is alone on its side
    while ((inside.count(mesh_.target(h)) == 1) != (number == 1))
      h = mesh_.next(h);
    const Vertex alone = mesh_.target(h), before = mesh_.source(h), after = mesh_.target(mesh_.next(h));
    const double s = crossing(alone, before, level), t = crossing(alone, after, level);
    area += face_area * (number == 1 ? s * t : 1 - s * t);
    const Point_3 &p = mesh_.point(alone), &q = mesh_.point(before), &r = mesh_.point(after);
    border += point_distance(p + s * (q - p), p + t * (r - p));
  }

  // Where the way from one vertex to the other passes the level, as a fraction.
  double crossing(Vertex from, Vertex to, double level) const {
    const double difference = way(from) - way(to);
    const double t = difference != 0 ? (way(from) - level) / difference : 0.5;
    return (std::max)(0., (std::min)(1., t));
  }

  void settle(Region& r, double level) {
    if (!r.is_settled)
      tips_.push_back({r.tip, r.area / (CGAL_PI * (way(r.tip) - level))}); // of a tube 2 pi r l / (pi l)
    r.is_settled = true;
  }

  const Surface& mesh_;
  std::vector<double> area_, way_;
  std::vector<Vertex> order_;
  std::vector<Tip> tips_;
  std::vector<std::size_t> parent_;
  std::vector<Region> region_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_TIP_FINDER_H

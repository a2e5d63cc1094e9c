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
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Finds where vessels may end blind: the places from which the way along the wall to a source is longest, and from
 * which it is longer than from all around by a good part of the width of the region that they rise from. These are the
 * tips of vessels, of sacs and of bumps alike, which the lines that lead to them tell apart. O(n log n) for n vertices;
 * scale- and rotation-independent. */
class Tip_finder {
  typedef Surface::Vertex_index Vertex;

public:
  explicit Tip_finder(const Surface& mesh)
      : mesh_(mesh)
      , area_(mesh.num_vertices(), 0) {
    for (auto f : mesh.faces()) {
      const double a = std::sqrt(area_vector(mesh.halfedge(f), mesh).squared_length()) / 3;
      for (Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        area_[std::size_t(v)] += a;
    }
  }

  /* A vertex at the end of the longest way along the surface, or nearly so: a tip of a closed one. It does not depend on
   * the order of the vertices. */
  Vertex farthest_of_all() {
    Vertex v = farthest_from_middle();
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
  std::vector<Vertex> find(const std::vector<Vertex>& source) {
    measure_ways(source);
    sort_by_way();
    grow_regions();
    std::stable_sort(tips_.begin(), tips_.end(), [&](Vertex a, Vertex b) { return way(a) > way(b); });
    return tips_;
  }

  /* Those from the source, from the farthest of these, and from the places farthest from all sources before: a branch
   * that leads back to one leads away from another, and a stub that the front passes along from one is seen from
   * another. */
  std::vector<Vertex> find_from_all_sides(const std::vector<Vertex>& source) {
    std::vector<Vertex> tips = find(source), sources = source;
    std::vector<bool> known(mesh_.num_vertices(), false);
    for (Vertex v : tips)
      known[std::size_t(v)] = true;
    for (Vertex v : source)
      known[std::size_t(v)] = true;
    for (int side = 0; side < 3 && !tips.empty(); ++side) {
      sources.push_back(farthest_from(sources));
      for (Vertex v : find({sources.back()}))
        if (!known[std::size_t(v)]) {
          known[std::size_t(v)] = true;
          tips.push_back(v);
        }
    }
    return tips;
  }

private:
  // How much longer the way is than where the region meets another, over the radius of a disk of the region's area. 1 in
  // a plane, 1.1 for a half ball that the front comes upon from below, less where it comes from the side.
  static constexpr double min_rise = 0.2;
  static constexpr std::size_t none = std::size_t(-1);

  // A connected set of vertices of long ways; known by its representative.
  struct Region {
    Vertex tip;
    double area = 0;
    std::size_t vertices = 1;
  };

  double way(Vertex v) const { return way_[std::size_t(v)]; }

  Vertex farthest_from_middle() const {
    const Point_3 o = mesh_.point(*mesh_.vertices().begin());
    Vector_3 sum(0, 0, 0);
    double area = 0;
    for (Vertex v : mesh_.vertices()) {
      sum = sum + area_[std::size_t(v)] * (mesh_.point(v) - o);
      area += area_[std::size_t(v)];
    }
    const Point_3 middle = area > 0 ? Point_3(o + sum / area) : o;
    return *std::max_element(mesh_.vertices().begin(), mesh_.vertices().end(), [&](Vertex v, Vertex w) {
      return CGAL::squared_distance(mesh_.point(v), middle) < CGAL::squared_distance(mesh_.point(w), middle);
    });
  }

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
      region_[i] = Region{v, area_[i], 1};
      for (Vertex w : CGAL::vertices_around_target(mesh_.halfedge(v), mesh_))
        if (parent_[std::size_t(w)] != none)
          join(find_root(i), find_root(std::size_t(w)), way(v));
    }
    if (!order_.empty())
      tips_.push_back(order_.front());
  }

  std::size_t find_root(std::size_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  // Two tips part here: that of the longer way goes on, the other one is done.
  void join(std::size_t a, std::size_t b, double level) {
    if (a == b)
      return;
    const bool goes_on = way(region_[a].tip) > way(region_[b].tip) ||
                         (way(region_[a].tip) == way(region_[b].tip) && region_[a].vertices >= region_[b].vertices);
    const std::size_t longer = goes_on ? a : b, shorter = goes_on ? b : a;
    const Region& r = region_[shorter];
    if (way(r.tip) - level > min_rise * std::sqrt(r.area / CGAL_PI))
      tips_.push_back(r.tip);
    Region joined = region_[longer];
    joined.area += r.area;
    joined.vertices += r.vertices;
    const bool is_larger = region_[a].vertices >= region_[b].vertices;
    const std::size_t root = is_larger ? a : b;
    parent_[is_larger ? b : a] = root;
    region_[root] = joined;
  }

  const Surface& mesh_;
  std::vector<double> area_, way_;
  std::vector<Vertex> order_, tips_;
  std::vector<std::size_t> parent_;
  std::vector<Region> region_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_TIP_FINDER_H

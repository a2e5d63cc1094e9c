// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SPLIT_TOUCHING_LOOPS_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SPLIT_TOUCHING_LOOPS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where a border loop comes back to a point that it has passed, in another vertex of the same coordinates, it is two
 * loops that touch: the end of a vessel, say, and a triangle that is missing beside it. There the two vertices become
 * one again, so that each loop can be judged, and filled, by itself. Vertices are looked up by their coordinates:
 * O(b log b) in the border's length. */
class Touching_loop_splitter {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Halfedge_index Halfedge;

public:
  explicit Touching_loop_splitter(Surface& mesh)
      : mesh_(mesh) {}

  /* How many loops were split off. */
  std::size_t split() {
    std::size_t number = 0;
    for (const auto& loop : border_cycles(mesh_))
      number += split(loop.rim);
    if (number > 0)
      mesh_.collect_garbage();
    return number;
  }

private:
  std::size_t split(const std::vector<Halfedge>& rim) {
    std::size_t number = 0;
    std::vector<Halfedge> path; // what is left of the loop up to here
    std::map<Point_3, std::size_t> place;
    for (Halfedge h : rim) {
      const auto known = place.find(mesh_.point(mesh_.target(h)));
      path.push_back(h);
      if (known == place.end()) {
        place.emplace(mesh_.point(mesh_.target(h)), path.size() - 1);
        continue;
      }
      const std::size_t first = known->second; // path[first] and h end in the same point
      if (!can_join(path[first], h))
        continue;
      join(path[first], h);
      ++number;
      for (std::size_t i = first + 1; i + 1 < path.size(); ++i) {
        const auto gone = place.find(mesh_.point(mesh_.target(path[i])));
        if (gone != place.end() && gone->second == i)
          place.erase(gone);
      }
      path.resize(first + 1);
    }
    return number;
  }

  // Whether no two edges between the same points arise.
  bool can_join(Halfedge h, Halfedge k) const {
    if (mesh_.target(h) == mesh_.target(k))
      return false;
    std::set<Point_3> around;
    for (Vertex v : CGAL::vertices_around_target(h, mesh_))
      around.insert(mesh_.point(v));
    const auto others = CGAL::vertices_around_target(k, mesh_);
    return std::none_of(others.begin(), others.end(), [&](Vertex v) { return around.count(mesh_.point(v)) > 0; });
  }

  // Border halfedges h and k, of one loop, from then on end in one vertex, and each leads on along its own loop.
  void join(Halfedge h, Halfedge k) {
    const Vertex kept = mesh_.target(h), gone = mesh_.target(k);
    for (Halfedge i : CGAL::halfedges_around_target(k, mesh_))
      moved_.push_back(i);
    for (Halfedge i : moved_)
      mesh_.set_target(i, kept);
    moved_.clear();
    const Halfedge after_h = mesh_.next(h), after_k = mesh_.next(k);
    mesh_.set_next(h, after_k);
    mesh_.set_next(k, after_h);
    mesh_.set_halfedge(kept, h);
    mesh_.remove_vertex(gone);
  }

  Surface& mesh_;
  std::vector<Halfedge> moved_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SPLIT_TOUCHING_LOOPS_H

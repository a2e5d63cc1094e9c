// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SURFACE_LOOPS_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SURFACE_LOOPS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Loops on a closed surface of which all others are sums, but for such as bound a part of it: 2 · genus of each of its
 * pieces. Edges make a tree of the vertices of each piece, and edges across which faces make a tree; each of those that
 * are in neither closes a loop (D. Eppstein, Dynamic generators of topologically embedded graphs, 2003). O(n α(n)), and
 * the lengths of the loops. */
class Surface_loops {
public:
  typedef std::vector<Vertex> Loop;

  explicit Surface_loops(const Surface& surface)
      : surface_(surface)
      , towards_root_(surface.number_of_vertices(), Surface::null_halfedge())
      , depth_(surface.number_of_vertices(), 0) {
    grow_trees();
    boost::disjoint_sets_with_storage<> faces(surface.number_of_faces());
    for (auto e : surface.edges()) {
      const Halfedge h = surface.halfedge(e), back = surface.opposite(h);
      if (is_in_tree(h) || is_in_tree(back))
        continue;
      const std::size_t a = faces.find_set(std::size_t(surface.face(h)));
      const std::size_t b = faces.find_set(std::size_t(surface.face(back)));
      if (a == b)
        loops_.push_back(loop_closed_by(h));
      else
        faces.link(a, b);
    }
  }

  /* Each by its vertices in order. */
  const std::vector<Loop>& loops() const { return loops_; }

private:
  // Breadth first, so that loops have few edges.
  void grow_trees() {
    std::vector<bool> reached(surface_.number_of_vertices(), false);
    std::vector<Vertex> queue;
    for (Vertex root : surface_.vertices()) {
      if (reached[root])
        continue;
      reached[root] = true;
      queue.assign(1, root);
      for (std::size_t i = 0; i < queue.size(); ++i)
        for (Halfedge h : surface_.halfedges_around_target(surface_.halfedge(queue[i]))) {
          const Vertex w = surface_.source(h);
          if (reached[w])
            continue;
          reached[w] = true;
          towards_root_[w] = h;
          depth_[w] = depth_[queue[i]] + 1;
          queue.push_back(w);
        }
    }
  }

  bool is_in_tree(Halfedge h) const { return towards_root_[surface_.source(h)] == h; }

  // From where the ways of its two ends to the root part.
  Loop loop_closed_by(Halfedge h) const {
    Loop there, back;
    Vertex a = surface_.source(h), b = surface_.target(h);
    const auto step = [&](Vertex& v, Loop& way) {
      way.push_back(v);
      v = surface_.target(towards_root_[v]);
    };
    while (a != b)
      depth_[a] >= depth_[b] ? step(a, there) : step(b, back);
    there.push_back(a);
    there.insert(there.end(), back.rbegin(), back.rend());
    return there;
  }

  const Surface& surface_;
  std::vector<Halfedge> towards_root_; // from each vertex
  std::vector<std::size_t> depth_;
  std::vector<Loop> loops_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SURFACE_LOOPS_H

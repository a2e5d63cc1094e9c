// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_HANDLE_LOOP_FINDER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_HANDLE_LOOP_FINDER_H

#include <CGAL/Tubular_meshing/Patches/internal/cut/Wall_region.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Finds a short loop that does not part a region of positive genus: a way from face to face, round a handle.
 *
 * The shortest of all loops through one face is found by trees, J. Erickson and K. Whittlesey, Greedy Optimal Homotopy
 * and Homology Generators, 2005: shortest ways from the face to all others are a tree of faces; of the edges that it
 * does not cross, those across which the longest loops lead are made a tree of vertices, and 2 · genus edges are left.
 * Each of these closes a loop of which no sum of the others is the like. That is tried at a few faces far from each
 * other, then at faces of the shortest loop found, as long as it gets shorter. O(n log n) in the size of the region. */
class Handle_loop_finder {
public:
  explicit Handle_loop_finder(const Wall_region& region)
      : region_(region)
      , mesh_(region.mesh()) {
    for (Face f : region.faces()) {
      const Halfedge h = mesh_.halfedge(f);
      centers_.push_back((1. / 3) * (region.point(mesh_.source(h)) + region.point(mesh_.target(h)) +
                                     region.point(mesh_.target(mesh_.next(h)))));
    }
  }

  /* The halfedges across which the loop leads, each of the face that it leaves: none of the faces comes twice. */
  std::vector<Halfedge> find() {
    const std::size_t first_bases = 4, most_rounds = 4;
    std::vector<double> to_bases(centers_.size(), (std::numeric_limits<double>::infinity)());
    spread(0);
    std::size_t base = farthest(distance_);
    for (std::size_t i = 0; i < first_bases; ++i) {
      try_through(base);
      for (std::size_t f = 0; f < to_bases.size(); ++f)
        to_bases[f] = (std::min)(to_bases[f], distance_[f]);
      base = farthest(to_bases);
    }
    for (std::size_t i = 0; i < most_rounds && shorten(); ++i) {
    }
    return best_;
  }

private:
  static std::size_t farthest(const std::vector<double>& distance) {
    return std::size_t(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }

  double step(Halfedge h) const {
    const Vector_3d middle = 0.5 * (region_.point(mesh_.source(h)) + region_.point(mesh_.target(h)));
    return norm(middle - centers_[from(h)]) + norm(middle - centers_[to(h)]);
  }
  std::size_t from(Halfedge h) const { return region_.number(mesh_.face(h)); }
  std::size_t to(Halfedge h) const { return region_.number(mesh_.face(mesh_.opposite(h))); }

  // Dijkstra's algorithm.
  void spread(std::size_t base) {
    typedef std::pair<double, std::size_t> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    distance_.assign(centers_.size(), (std::numeric_limits<double>::infinity)());
    entry_.assign(centers_.size(), Surface::null_halfedge());
    distance_[base] = 0;
    queue.emplace(0, base);
    while (!queue.empty()) {
      const Entry e = queue.top();
      queue.pop();
      if (e.first > distance_[e.second])
        continue;
      for (Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(region_.faces()[e.second])))
        if (!region_.is_boundary(h) && e.first + step(h) < distance_[to(h)]) {
          distance_[to(h)] = e.first + step(h);
          entry_[to(h)] = h;
          queue.emplace(distance_[to(h)], to(h));
        }
    }
  }

  void try_through(std::size_t base) {
    spread(base);
    typedef std::pair<double, Halfedge> Closing; // minus the length of the loop that the edge closes
    std::vector<Closing> closing;
    for (Halfedge h : region_.edges())
      if (entry_[to(h)] != h && entry_[from(h)] != mesh_.opposite(h))
        closing.emplace_back(-(distance_[from(h)] + step(h) + distance_[to(h)]), h);
    std::sort(closing.begin(), closing.end());
    boost::disjoint_sets_with_storage<> nodes(region_.number_of_nodes());
    Halfedge shortest = Surface::null_halfedge();
    for (const Closing& c : closing) {
      const std::size_t a = nodes.find_set(std::size_t(region_.source(c.second)));
      const std::size_t b = nodes.find_set(std::size_t(region_.target(c.second)));
      if (a == b)
        shortest = c.second;
      else
        nodes.link(a, b);
    }
    if (shortest != Surface::null_halfedge())
      keep_if_shorter(loop_across(shortest));
  }

  std::vector<Halfedge> way_to(std::size_t face) const {
    std::vector<Halfedge> way;
    for (Halfedge h = entry_[face]; h != Surface::null_halfedge(); h = entry_[from(h)])
      way.push_back(h);
    std::reverse(way.begin(), way.end());
    return way;
  }

  // From where the ways to its two faces part.
  std::vector<Halfedge> loop_across(Halfedge closing) const {
    const std::vector<Halfedge> there = way_to(from(closing)), back = way_to(to(closing));
    std::size_t common = 0;
    while (common < there.size() && common < back.size() && there[common] == back[common])
      ++common;
    std::vector<Halfedge> loop(there.begin() + std::ptrdiff_t(common), there.end());
    loop.push_back(closing);
    for (std::size_t i = back.size(); i-- > common;)
      loop.push_back(mesh_.opposite(back[i]));
    return loop;
  }

  bool keep_if_shorter(std::vector<Halfedge> loop) {
    const double rounding = 1e-9;
    double length = 0;
    for (Halfedge h : loop)
      length += step(h);
    if (length >= length_ * (1 - rounding))
      return false;
    length_ = length;
    best_ = std::move(loop);
    return true;
  }

  bool shorten() {
    const std::size_t bases = 4;
    const std::vector<Halfedge> loop = best_;
    const double before = length_;
    for (std::size_t i = 0; i < bases && !loop.empty(); ++i)
      try_through(from(loop[i * loop.size() / bases]));
    return length_ < before;
  }

  const Wall_region& region_;
  const Surface& mesh_;
  std::vector<Vector_3d> centers_; // of faces
  std::vector<double> distance_;   // of each face from the last base
  std::vector<Halfedge> entry_;    // across which the way from there comes
  std::vector<Halfedge> best_;
  double length_ = (std::numeric_limits<double>::max)();
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_HANDLE_LOOP_FINDER_H

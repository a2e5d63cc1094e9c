// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_FILLED_PATCH_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_FILLED_PATCH_H

#include <CGAL/Tubular_meshing/Patches/Indexed_patch.h>
#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A patch whose holes, all loops but the longest, are filled by fans of triangles around their centers: a disk. The
 * patch's own points and triangles come first. One interior vertex is the pole, which goes to the plane's origin: the
 * center of the second longest loop, or of a disk, the vertex farthest from its border (−1 if that is next to it). */
struct Filled_patch {
  std::vector<Vector_3d> points;
  std::vector<Patch_triangle> triangles;
  std::vector<int> opposite;
  Outgoing_halfedges outgoing;
  std::size_t own_points = 0, own_triangles = 0;
  std::vector<std::vector<int>> loops; ///< of the patch
  std::size_t outer = 0;               ///< the longest one
  int pole = -1;
  std::vector<char> is_outer; ///< whether a vertex is on the outer loop

  explicit Filled_patch(const Indexed_patch& patch)
      : points(patch.points.begin(), patch.points.end())
      , triangles(patch.triangles)
      , own_points(points.size())
      , own_triangles(triangles.size())
      , loops(patch.loops) {
    if (loops.empty())
      throw Meshing_error("A closed surface cannot be mapped onto the plane; cut it first (cut_by_centerlines()).");
    choose_outer();
    for (std::size_t i = 0; i < loops.size(); ++i)
      if (i != outer)
        fill(loops[i]);
    opposite = opposite_halfedges(triangles);
    outgoing = Outgoing_halfedges(triangles, points.size());
    is_outer.assign(points.size(), 0);
    for (int v : loops[outer])
      is_outer[std::size_t(v)] = 1;
    check_disk();
    if (loops.size() == 1)
      choose_pole();
  }

  const std::vector<int>& outer_loop() const { return loops[outer]; }
  double length(int a, int b) const { return norm(points[std::size_t(a)] - points[std::size_t(b)]); }
  double length(const std::vector<int>& loop) const {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum += length(loop[i], loop[(i + 1) % loop.size()]);
    return sum;
  }

  // Of each vertex, along edges.
  std::vector<double> distances_from_outer() const {
    typedef std::pair<double, int> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::vector<double> distance(points.size(), (std::numeric_limits<double>::infinity)());
    for (int v : outer_loop()) {
      distance[std::size_t(v)] = 0;
      queue.emplace(0, v);
    }
    while (!queue.empty()) {
      const Entry e = queue.top();
      queue.pop();
      if (e.first > distance[std::size_t(e.second)])
        continue;
      for (const int* h = outgoing.begin(e.second); h != outgoing.end(e.second); ++h) {
        const int w = target_of(triangles, *h);
        const double d = e.first + length(e.second, w);
        if (d < distance[std::size_t(w)]) {
          distance[std::size_t(w)] = d;
          queue.emplace(d, w);
        }
      }
    }
    return distance;
  }

  // The vertices around an interior vertex, counterclockwise.
  std::vector<int> link(int v) const {
    std::vector<int> around;
    const int first = *outgoing.begin(v);
    int h = first;
    do {
      around.push_back(target_of(triangles, h));
      h = opposite[std::size_t(previous_halfedge(h))];
    } while (h != first);
    return around;
  }

  // −1 if there is none.
  int halfedge_between(int a, int b) const {
    for (const int* h = outgoing.begin(a); h != outgoing.end(a); ++h)
      if (target_of(triangles, *h) == b)
        return *h;
    return -1;
  }

private:
  // Also the pole of a patch with holes: the center that is added for the second longest loop.
  void choose_outer() {
    std::vector<std::pair<double, std::size_t>> by_length;
    for (std::size_t i = 0; i < loops.size(); ++i)
      by_length.emplace_back(-length(loops[i]), i);
    std::sort(by_length.begin(), by_length.end());
    outer = by_length[0].second;
    if (loops.size() > 1) {
      const std::size_t inner = by_length[1].second;
      pole = int(own_points + inner - (inner > outer ? 1 : 0));
    }
  }

  void fill(const std::vector<int>& loop) {
    const int center = int(points.size());
    Vector_3d sum;
    double weight = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i], b = loop[(i + 1) % loop.size()];
      triangles.push_back({b, a, center});
      const double l = length(a, b);
      sum += (l / 2) * (points[std::size_t(a)] + points[std::size_t(b)]);
      weight += l;
    }
    points.push_back(weight > 0 ? (1 / weight) * sum : points[std::size_t(loop[0])]);
  }

  // All of it in one piece, every border edge on the outer loop, and of Euler characteristic 1.
  void check_disk() const {
    std::size_t border = 0, reached = 0;
    for (int o : opposite)
      border += o < 0;
    const std::size_t edges = (opposite.size() + border) / 2;
    for (double d : distances_from_outer())
      reached += d < (std::numeric_limits<double>::infinity)();
    std::size_t on_outer = 0;
    for (char o : is_outer)
      on_outer += std::size_t(o);
    for (std::size_t i = 0; i < outer_loop().size(); ++i)
      if (!is_border(outer_loop()[i], outer_loop()[(i + 1) % outer_loop().size()]))
        throw Input_error("A loop of a patch is no border that has the patch on its left; take border_loops().");
    if (border != outer_loop().size() || on_outer != border || reached != points.size() ||
        points.size() + triangles.size() != edges + 1)
      throw Meshing_error("A patch of " + std::to_string(own_triangles) + " triangles and " +
                          std::to_string(loops.size()) +
                          " loops is no sphere with holes; cut it further (cut_by_centerlines()).");
  }

  bool is_border(int a, int b) const {
    const int h = halfedge_between(a, b);
    return h >= 0 && opposite[std::size_t(h)] < 0;
  }

  void choose_pole() {
    const std::vector<double> distance = distances_from_outer();
    for (int v = 0; v < int(points.size()); ++v)
      if (!is_outer[std::size_t(v)] && (pole < 0 || distance[std::size_t(v)] > distance[std::size_t(pole)]))
        pole = v;
    if (pole < 0)
      return;
    for (int v : link(pole))
      if (is_outer[std::size_t(v)]) {
        pole = -1;
        return;
      }
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_FILLED_PATCH_H

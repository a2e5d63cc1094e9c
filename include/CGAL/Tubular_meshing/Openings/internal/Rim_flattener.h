// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_RIM_FLATTENER_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_RIM_FLATTENER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Moves a rim, and the cap in it if there is one, onto a plane, and the wall behind along with it.
 *
 * All vertices move along the plane's normal, which for an upright wall is along the wall, so that the tube keeps its
 * shape. A rim vertex moves by its height h. The displacement of a wall vertex is that of the vertices between it and
 * the rim, averaged ring by ring, times a smooth step that ends at a distance of four times the largest |h|: with a
 * slope of at most 1.5/4 along the tube, the map of an upright wall has no folds. That none came about is checked all
 * the same, face by face.
 */
class Rim_flattener {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Halfedge_index Halfedge;
  typedef Surface::Face_index Face;

public:
  Rim_flattener(Surface& mesh, const Rim_plane& plane, const Opening_site& site)
      : mesh_(mesh)
      , plane_(plane)
      , cap_(site.cap.begin(), site.cap.end()) {
    for (Halfedge h : site.rim)
      rim_.push_back(mesh.target(h));
    for (Face f : site.cap)
      for (Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        move(v, plane.projection(mesh.point(v)));
    for (Vertex v : rim_)
      move(v, plane.projection(mesh.point(v)));
    displace_wall();
    find_faces();
  }

  /* False if faces would fold or degenerate; then nothing is moved. */
  bool flatten() {
    std::vector<Vector_3> before;
    for (Face f : faces_)
      before.push_back(area_vector(mesh_.halfedge(f), mesh_));
    std::vector<double> longest_before;
    for (Face f : faces_)
      longest_before.push_back(longest_squared_edge(f));
    swap_positions();
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (!stays_good(faces_[i], before[i], longest_before[i])) {
        swap_positions();
        return false;
      }
    return true;
  }

  /* Puts all vertices back where they were; a second call moves them again. */
  void swap_positions() {
    for (auto& m : moves_)
      std::swap(mesh_.point(m.first), m.second);
  }

private:
  void move(Vertex v, const Point_3& to) {
    if (moved_.insert(v).second)
      moves_.emplace_back(v, to);
  }

  // Dijkstra's algorithm from the rim.
  void displace_wall() {
    double largest = 0;
    for (Vertex v : rim_)
      largest = (std::max)(largest, std::abs(plane_.height(mesh_.point(v))));
    const double reach = 4 * largest;
    typedef std::pair<double, Vertex> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::unordered_map<Vertex, double> best, height; // height: of the settled ones, averaged
    for (Vertex v : rim_) {
      best[v] = 0;
      queue.emplace(0., v);
    }
    const std::unordered_set<Vertex> on_rim(rim_.begin(), rim_.end());
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > best[v] || height.count(v))
        continue;
      if (on_rim.count(v))
        height[v] = plane_.height(mesh_.point(v));
      else {
        height[v] = mean_height_around(v, height);
        move(v, mesh_.point(v) - height[v] * fade(d / reach) * plane_.normal());
      }
      for (Vertex w : CGAL::vertices_around_target(mesh_.halfedge(v), mesh_)) {
        const double through_v = d + point_distance(mesh_.point(v), mesh_.point(w));
        if (through_v >= reach || moved_.count(w) || mesh_.is_border(w))
          continue; // other openings, and the inside of the cap, are not touched
        const auto known = best.find(w);
        if (known == best.end() || through_v < known->second) {
          best[w] = through_v;
          queue.emplace(through_v, w);
        }
      }
    }
  }

  double mean_height_around(Vertex v, const std::unordered_map<Vertex, double>& height) const {
    double sum = 0, weights = 0;
    for (Vertex w : CGAL::vertices_around_target(mesh_.halfedge(v), mesh_)) {
      const auto settled = height.find(w);
      if (settled == height.end())
        continue;
      const double length = point_distance(mesh_.point(v), mesh_.point(w));
      const double weight = length > 0 ? 1 / length : 0;
      sum += weight * settled->second;
      weights += weight;
    }
    return weights > 0 ? sum / weights : 0;
  }

  static double fade(double t) { return 1 - t * t * (3 - 2 * t); }

  void find_faces() {
    std::unordered_set<Face> visited;
    for (const auto& m : moves_)
      for (Face f : CGAL::faces_around_target(mesh_.halfedge(m.first), mesh_))
        if (f != Surface::null_face() && visited.insert(f).second)
          faces_.push_back(f);
  }

  double longest_squared_edge(Face f) const {
    double longest = 0;
    for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
      longest = (std::max)(longest, (mesh_.point(mesh_.target(h)) - mesh_.point(mesh_.source(h))).squared_length());
    return longest;
  }

  // Turns by less than 60 degrees, and keeps a fifth of its height over its longest edge.
  bool stays_good(Face f, const Vector_3& before, double longest_before) const {
    const Vector_3 after = area_vector(mesh_.halfedge(f), mesh_);
    const double area_before = std::sqrt(before.squared_length()), area_after = std::sqrt(after.squared_length());
    const Vector_3& direction = cap_.count(f) ? plane_.normal() * area_before : before;
    return area_after > 0 && direction * after > 0.5 * area_before * area_after &&
           area_after * longest_before > 0.2 * area_before * longest_squared_edge(f);
  }

  Surface& mesh_;
  const Rim_plane& plane_;
  std::vector<Vertex> rim_;
  const std::unordered_set<Face> cap_;
  std::vector<std::pair<Vertex, Point_3>> moves_; // the positions that are not taken at the moment
  std::unordered_set<Vertex> moved_;
  std::vector<Face> faces_; // around moved vertices
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_RIM_FLATTENER_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WALL_BEHIND_LOOP_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WALL_BEHIND_LOOP_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* How the wall lies behind a border loop, out to twice the loop's radius (that of the
 * circle of its length): what tells the end of a tube from a hole in
 * its wall, even where the faces at the loop itself are crumpled. */
struct Wall_behind {
  double depth = 0;    ///< the mean depth under the loop's plane, in radii: 0.87 for a straight tube, 0 for a flat wall
  double flatness = 0; ///< the length of the mean normal: 0 for a tube, 1 for a flat wall
};

/* Integrates over the part of the wall that is connected to the loop and within reach, triangles bisected where they
 * are large against the reach. O(k) for k faces there. */
class Wall_surveyor {
  typedef Surface::Face_index Face;
  typedef std::array<Point_3, 3> Corners;

public:
  explicit Wall_surveyor(const Surface& mesh)
      : mesh_(mesh) {}

  Wall_behind survey(const Opening_site& loop) {
    center_ = loop.shape.center;
    const double radius = loop.shape.perimeter / (2 * CGAL_PI); // a slit's area says nothing of its length
    reach_ = 2 * radius;
    area_ = depth_ = 0;
    area_vector_ = Vector_3(0, 0, 0);
    normal_ = loop.shape.plane.normal();
    for (Face f : faces_within_reach(loop))
      add(f);
    Wall_behind wall;
    if (area_ > 0) {
      wall.depth = depth_ / (area_ * radius);
      wall.flatness = std::sqrt(area_vector_.squared_length()) / area_;
    }
    return wall;
  }

private:
  // Those at the loop, and those that are connected to them by edges within reach.
  std::vector<Face> faces_within_reach(const Opening_site& loop) const {
    std::vector<Face> faces;
    std::unordered_set<Face> seen = {Surface::null_face()};
    for (auto h : loop.rim)
      if (seen.insert(mesh_.face(mesh_.opposite(h))).second)
        faces.push_back(mesh_.face(mesh_.opposite(h)));
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (auto h : CGAL::halfedges_around_face(mesh_.halfedge(faces[i]), mesh_)) {
        const Face g = mesh_.face(mesh_.opposite(h));
        if (seen.count(g) == 0 && distance_to_edge(h) < reach_) {
          seen.insert(g);
          faces.push_back(g);
        }
      }
    return faces;
  }

  double distance_to_edge(Surface::Halfedge_index h) const {
    const Point_3 &p = mesh_.point(mesh_.source(h)), &q = mesh_.point(mesh_.target(h));
    const Vector_3 d = q - p, w = center_ - p;
    const double t = (std::max)(0., (std::min)(1., (w * d) / d.squared_length()));
    return std::sqrt((w - t * d).squared_length());
  }

  void add(Face f) {
    const auto h = mesh_.halfedge(f);
    std::vector<std::pair<Corners, int>> parts = {
        {{mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)), mesh_.point(mesh_.target(mesh_.next(h)))}, 0}};
    while (!parts.empty()) {
      const auto [t, depth] = parts.back();
      parts.pop_back();
      const Point_3 middle = CGAL::centroid(t[0], t[1], t[2]);
      const double distance = point_distance(middle, center_);
      const int longest = longest_side(t);
      const double size = point_distance(t[longest], t[(longest + 1) % 3]);
      if (distance - size > reach_)
        continue;
      if (size > 0.4 * reach_ && depth < 16) {
        const Point_3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
        const Point_3 m = CGAL::midpoint(a, b);
        parts.push_back({{a, m, c}, depth + 1});
        parts.push_back({{m, b, c}, depth + 1});
      } else if (distance < reach_) {
        const Vector_3 n = CGAL::cross_product(t[1] - t[0], t[2] - t[0]) / 2;
        const double area = std::sqrt(n.squared_length());
        area_ += area;
        area_vector_ = area_vector_ + n;
        depth_ += area * ((center_ - middle) * normal_);
      }
    }
  }

  static int longest_side(const Corners& t) {
    int longest = 0;
    for (int k = 1; k < 3; ++k)
      if (CGAL::squared_distance(t[k], t[(k + 1) % 3]) > CGAL::squared_distance(t[longest], t[(longest + 1) % 3]))
        longest = k;
    return longest;
  }

  const Surface& mesh_;
  Point_3 center_;
  Vector_3 normal_, area_vector_;
  double reach_ = 0, area_ = 0, depth_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WALL_BEHIND_LOOP_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_OPENING_RIM_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_OPENING_RIM_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The boundary between the wall and the cap of an opening, a closed polyline, and the centroid of its cap. */
struct Opening_rim {
  std::vector<Vector_3d> points;
  Vector_3d center, normal; // unit; the points turn counterclockwise about it
  double radius = 0;        // the mean distance of its points from the center

  explicit Opening_rim(std::vector<Vector_3d> rim)
      : points(std::move(rim)) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
      normal += twice_area(i);
    normal = normalized(normal);
    double area = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const double a = dot(normal, twice_area(i));
      center += (a / 3) * (points[0] + points[i] + points[i + 1]);
      area += a;
    }
    center = (1 / area) * center;
    for (const Vector_3d& p : points)
      radius += norm(p - center) / double(points.size());
  }

private:
  Vector_3d twice_area(std::size_t i) const { return cross(points[i] - points[0], points[i + 1] - points[0]); }
};

typedef std::map<int, Opening_rim> Opening_rims; // by the label of the cap

/* The rims between the wall and the caps. */
inline Opening_rims opening_rims(const Surface& surface, Face_patch_map patch) {
  std::map<int, std::map<Vertex, Vertex>> next;
  for (Halfedge h : surface.halfedges()) {
    const int label = patch[surface.face(h)];
    if (label != labels::wall && patch[surface.face(surface.opposite(h))] == labels::wall)
      next[label][surface.source(h)] = surface.target(h);
  }
  Opening_rims rims;
  for (const auto& [label, edges] : next) {
    std::vector<Vector_3d> points;
    const Vertex start = edges.begin()->first;
    Vertex v = start;
    do {
      points.push_back(Vector_3d(surface.point(v)));
      v = edges.at(v);
    } while (v != start);
    rims.emplace(label, Opening_rim(std::move(points)));
  }
  return rims;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_OPENING_RIM_H

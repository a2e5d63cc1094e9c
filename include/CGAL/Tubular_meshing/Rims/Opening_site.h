// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_OPENING_SITE_H
#define CGAL_TUBULAR_MESHING_RIMS_OPENING_SITE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/base/Sentence.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where an opening is in a mesh: its rim, and the faces of its cap if it has one. */
struct Opening_site {
  std::vector<Halfedge> rim; ///< in order, on the side of the cap: border halfedges, or halfedges of the cap's faces
  std::vector<Face> cap;     ///< empty for a border loop
  Rim_shape shape;

  bool is_open() const { return cap.empty(); }
};

inline std::string coordinates(const Point_3& p) {
  return place_of(p).str();
}

inline std::string vertex_name(Vertex v, const Surface& mesh) {
  return "vertex " + std::to_string(std::size_t(v)) + " " + coordinates(mesh.point(v));
}

inline std::vector<Point_3> rim_points(const std::vector<Halfedge>& rim, const Surface& mesh) {
  std::vector<Point_3> points;
  points.reserve(rim.size());
  for (auto h : rim)
    points.push_back(mesh.point(mesh.target(h)));
  return points;
}

inline Vector_3 area_vector(Halfedge h, const Surface& mesh) {
  const Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
                &c = mesh.point(mesh.target(mesh.next(h)));
  return CGAL::cross_product(b - a, c - a) / 2;
}

inline void check_tubular_surface(const Surface& mesh) {
  if (mesh.number_of_faces() == 0)
    throw Input_error("The surface has no triangles: give a triangulated tubular surface.");
  for (auto v : mesh.vertices()) {
    const Point_3& p = mesh.point(v);
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw Input_error("The surface has coordinates that are no finite numbers at " + vertex_name(v, mesh) +
                        ": remove or correct that vertex.");
  }
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    if (mesh.next(mesh.next(mesh.next(h))) != h)
      throw Input_error("Face " + std::to_string(std::size_t(f)) +
                        " of the surface is not a triangle: triangulate the surface first.");
  }
}

/* The border loops of any manifold mesh, in the order of their first halfedges: they may touch, and bound no area. */
inline std::vector<Opening_site> border_cycles(const Surface& mesh) {
  std::vector<Opening_site> loops;
  std::unordered_set<Halfedge> visited;
  for (Halfedge first : mesh.halfedges()) {
    if (!mesh.is_border(first) || visited.count(first))
      continue;
    Opening_site loop;
    for (Halfedge h = first; visited.insert(h).second; h = mesh.next(h))
      loop.rim.push_back(h);
    loop.shape = measure_rim(rim_points(loop.rim, mesh));
    loops.push_back(std::move(loop));
  }
  return loops;
}

/* The same, but loops that touch, or bound no area, are refused. */
inline std::vector<Opening_site> border_loops(const Surface& mesh) {
  std::vector<Opening_site> loops = border_cycles(mesh);
  std::unordered_set<Vertex> on_border;
  for (const Opening_site& loop : loops) {
    for (auto h : loop.rim)
      if (!on_border.insert(mesh.target(h)).second)
        throw Input_error("The border of the surface touches itself at " + vertex_name(mesh.target(h), mesh) +
                          ": separate the two sides there, or remove the triangles around that vertex.");
    if (!(loop.shape.radius > 0))
      throw Input_error("The border loop of " + std::to_string(loop.rim.size()) + " edges through " +
                        vertex_name(mesh.target(loop.rim.front()), mesh) +
                        " bounds no area: stitch the surface there.");
  }
  return loops;
}

/* One or two triangles missing in the middle of a smooth wall: a loop of three or four edges whose own normal is that
 * of the faces around. The end of a coarse tube may have as few edges, but its wall stands upright on the loop. */
inline bool is_pinhole(const Opening_site& loop, const Surface& mesh) {
  if (!loop.is_open() || loop.rim.size() > 4)
    return false;
  double alignment = 0;
  for (auto h : loop.rim) {
    const Vector_3 n = area_vector(mesh.opposite(h), mesh);
    const double length = std::sqrt(n.squared_length());
    if (length > 0)
      alignment += std::abs(n * loop.shape.plane.normal()) / length;
  }
  return alignment > 0.75 * double(loop.rim.size());
}

/* The volume that a surface bounds when its border loops are closed by fans around their centres; negative if the
 * faces' normals point into it. */
inline double closed_volume(const Surface& mesh, const std::vector<Opening_site>& loops) {
  const Point_3 o = mesh.point(*mesh.vertices().begin());
  double volume = 0;
  const auto add = [&](const Point_3& a, const Point_3& b, const Point_3& c) {
    volume += (a - o) * CGAL::cross_product(b - o, c - o) / 6;
  };
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    add(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
  }
  for (const Opening_site& loop : loops)
    for (auto h : loop.rim)
      add(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), loop.shape.center);
  return volume;
}

inline bool is_inside_out(const Surface& mesh, const std::vector<Opening_site>& loops) {
  return closed_volume(mesh, loops) < 0;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_OPENING_SITE_H

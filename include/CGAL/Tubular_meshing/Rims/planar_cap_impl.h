// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_PLANAR_CAP_IMPL_H
#define CGAL_TUBULAR_MESHING_RIMS_PLANAR_CAP_IMPL_H

#include <CGAL/Tubular_meshing/Rims/planar_cap.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE std::vector<Index_triangle>
triangulate_inside(const std::vector<Kernel::Point_2>& points,
                   const std::vector<std::array<std::size_t, 2>>& constraints) {
  typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel> Vertex_base;
  typedef CGAL::Constrained_triangulation_face_base_2<Kernel> Constrained_face_base;
  typedef CGAL::Triangulation_face_base_with_info_2<int, Kernel, Constrained_face_base> Face_base;
  typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base> Data_structure;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data_structure, CGAL::No_constraint_intersection_tag>
      Triangulation;

  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    vertices.push_back(triangulation.insert(points[i]));
    vertices.back()->info() = i;
  }
  for (const auto& c : constraints)
    triangulation.insert_constraint(vertices[c[0]], vertices[c[1]]);

  for (auto f : triangulation.all_face_handles())
    f->info() = 0;
  std::vector<Triangulation::Face_handle> outside = {triangulation.infinite_face()};
  outside[0]->info() = 1;
  while (!outside.empty()) {
    const Triangulation::Face_handle f = outside.back();
    outside.pop_back();
    for (int i = 0; i < 3; ++i)
      if (!f->is_constrained(i) && f->neighbor(i)->info() == 0) {
        f->neighbor(i)->info() = 1;
        outside.push_back(f->neighbor(i));
      }
  }
  std::vector<Index_triangle> triangles;
  for (auto f : triangulation.finite_face_handles())
    if (f->info() == 0)
      triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return triangles;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Index_triangle>
triangulate_polygon(const std::vector<Kernel::Point_2>& polygon) {
  if (!CGAL::is_simple_2(polygon.begin(), polygon.end(), Kernel()) ||
      CGAL::orientation_2(polygon.begin(), polygon.end(), Kernel()) != CGAL::COUNTERCLOCKWISE)
    return {};
  std::vector<std::array<std::size_t, 2>> sides;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sides.push_back({i, (i + 1) % polygon.size()});
  return triangulate_inside(polygon, sides);
}

CGAL_TUBULAR_MESHING_INLINE void remove_faces(const std::vector<Face>& faces, Surface& mesh) {
  for (auto f : faces)
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Face> fill_loop(const std::vector<Halfedge>& rim, const Rim_plane& plane,
                                                        Surface& mesh) {
  std::vector<Kernel::Point_2> polygon;
  for (auto h : rim) {
    const auto p = plane.in_plane(mesh.point(mesh.target(h)));
    polygon.emplace_back(p[0], p[1]);
  }
  std::vector<Vertex> vertices;
  for (auto h : rim)
    vertices.push_back(mesh.target(h));
  std::vector<Face> faces;
  for (const Index_triangle& t : triangulate_polygon(polygon)) {
    const auto f = mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    if (f == Surface::null_face()) {
      remove_faces(faces, mesh);
      return {};
    }
    faces.push_back(f);
  }
  return faces;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Halfedge> peel_ears(std::vector<Halfedge> rim, Surface& mesh) {
  auto face_behind = [&](Halfedge h) { return mesh.face(mesh.opposite(h)); };
  std::size_t size = rim.size(), steps_without_ear = 0;
  Halfedge h = rim[0];
  while (size > 3 && steps_without_ear <= size) {
    const Halfedge n = mesh.next(h);
    const Halfedge third = mesh.opposite(mesh.prev(mesh.opposite(n)));
    if (face_behind(h) != face_behind(n) || mesh.is_border(third)) {
      h = n;
      ++steps_without_ear;
      continue;
    }
    const Halfedge before = mesh.prev(h);
    CGAL::Euler::remove_face(mesh.opposite(h), mesh);
    h = mesh.prev(before);
    --size;
    steps_without_ear = 0;
  }
  rim.clear();
  for (Halfedge g : CGAL::halfedges_around_face(h, mesh))
    rim.push_back(g);
  return rim;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_PLANAR_CAP_IMPL_H

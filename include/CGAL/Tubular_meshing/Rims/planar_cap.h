// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_PLANAR_CAP_H
#define CGAL_TUBULAR_MESHING_RIMS_PLANAR_CAP_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Cap_kernel;
typedef std::array<std::size_t, 3> Index_triangle;

/* The constrained Delaunay triangulation of the inside of a polygon, as indices of its vertices, counterclockwise;
 * empty if the polygon is not simple and counterclockwise. Vertices on straight sides are used. O(n log n). */
inline std::vector<Index_triangle> triangulate_polygon(const std::vector<Cap_kernel::Point_2>& polygon) {
  typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Cap_kernel> Vertex_base;
  typedef CGAL::Constrained_triangulation_face_base_2<Cap_kernel> Constrained_face_base;
  typedef CGAL::Triangulation_face_base_with_info_2<int, Cap_kernel, Constrained_face_base> Face_base;
  typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base> Data_structure;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Cap_kernel, Data_structure, CGAL::No_constraint_intersection_tag>
      Triangulation;

  std::vector<Index_triangle> triangles;
  if (!CGAL::is_simple_2(polygon.begin(), polygon.end(), Cap_kernel()) ||
      CGAL::orientation_2(polygon.begin(), polygon.end(), Cap_kernel()) != CGAL::COUNTERCLOCKWISE)
    return triangles;
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    vertices.push_back(triangulation.insert(polygon[i]));
    vertices.back()->info() = i;
  }
  for (std::size_t i = 0; i < polygon.size(); ++i)
    triangulation.insert_constraint(vertices[i], vertices[(i + 1) % polygon.size()]);

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
  for (auto f : triangulation.finite_face_handles())
    if (f->info() == 0)
      triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return triangles;
}

inline void remove_faces(const std::vector<Surface::Face_index>& faces, CGAL::Surface_mesh<Point_3>& mesh) {
  for (auto f : faces)
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
}

/* Fills a border loop with the triangulation of its projection onto a plane. Returns no faces, and leaves the mesh as
 * it is, if the projection is not a simple polygon, or an edge that it needs is in the wall already. */
inline std::vector<Surface::Face_index> fill_loop(const std::vector<Surface::Halfedge_index>& rim,
                                                  const Rim_plane& plane, CGAL::Surface_mesh<Point_3>& mesh) {
  typedef CGAL::Surface_mesh<Point_3> Mesh;
  std::vector<Cap_kernel::Point_2> polygon;
  for (auto h : rim) {
    const auto p = plane.in_plane(mesh.point(mesh.target(h)));
    polygon.emplace_back(p[0], p[1]);
  }
  std::vector<typename Mesh::Vertex_index> vertices;
  for (auto h : rim)
    vertices.push_back(mesh.target(h));
  std::vector<typename Mesh::Face_index> faces;
  for (const Index_triangle& t : triangulate_polygon(polygon)) {
    const auto f = mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    if (f == Mesh::null_face()) {
      remove_faces(faces, mesh);
      return {};
    }
    faces.push_back(f);
  }
  return faces;
}

/* Removes triangles with two edges on the loop, the ears: once the rim is in a plane such a triangle lies in it too,
 * and on the cap. Returns the new loop; it keeps at least three edges. */
inline std::vector<Surface::Halfedge_index> peel_ears(std::vector<Surface::Halfedge_index> rim,
                                                      CGAL::Surface_mesh<Point_3>& mesh) {
  typedef Surface::Halfedge_index Halfedge;
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

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_RIMS_PLANAR_CAP_H

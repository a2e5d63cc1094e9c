// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WRAP_SURFACE_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WRAP_SURFACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Repair/internal/alpha_wrap.h>
#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/Rims/trim_by_plane.h>
#include <CGAL/Tubular_meshing/base/crossing_pairs.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Replaces a surface that cannot be repaired in place by an alpha wrap around it (Portaneri et al., Alpha wrapping with
 * an offset, 2022; CGAL's Alpha_wrap_3): the ends are closed by fans, the whole is wrapped with balls of a third of the
 * smallest end's radius, the wrap is drawn onto the surface again, by the offset it keeps, and cut open at the ends. */
class Surface_wrapper {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Face_index Face;

public:
  /* Takes the soup, with the fans in the ends; `reason` begins the sentence of an error. */
  Surface_wrapper(std::vector<Point_3> points, std::vector<Index_triangle> triangles, std::vector<Rim_shape> ends,
                  const std::string& reason)
      : points_(std::move(points))
      , triangles_(std::move(triangles))
      , ends_(std::move(ends))
      , reason_(reason) {}

  double alpha() const { return alpha_; }

  /* Replaces `mesh`. Throws Input_error if the wrap would be too large, or an end is not found on it. */
  void wrap(Surface& mesh, double smallest_radius) {
    alpha_ = smallest_radius / 3;
    offset_ = alpha_ / 15;
    check_size();
    mesh.clear();
    alpha_wrap(points_, triangles_, alpha_, offset_, mesh);
    draw_onto_surface(mesh);
    open_ends(mesh);
    mesh.collect_garbage();
  }

private:
  // A wrap has about 8 triangles a square of alpha.
  void check_size() const {
    double area = 0;
    for (const Index_triangle& t : triangles_)
      area += std::sqrt(
                  CGAL::cross_product(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]).squared_length()) /
              2;
    const double most_triangles = 4e5; // half a minute's work
    if (!(8 * area / (alpha_ * alpha_) < most_triangles))
      throw Input_error(reason_ +
                        ", and the surface is too large to be wrapped at the size of its smallest "
                        "opening, of radius " +
                        std::to_string(3 * alpha_) + ": repair it in another program, or cut it into parts.");
  }

  void draw_onto_surface(Surface& mesh) const {
    typedef Double_kernel::Triangle_3 Triangle;
    std::vector<Triangle> shapes;
    for (const Index_triangle& t : triangles_) {
      const Triangle s(to_double_point(points_[t[0]]), to_double_point(points_[t[1]]), to_double_point(points_[t[2]]));
      if (CGAL::cross_product(s[1] - s[0], s[2] - s[0]).squared_length() > 0)
        shapes.push_back(s);
    }
    const Nearest_tree<Triangle> tree(std::move(shapes));
    std::vector<Point_3> before(mesh.num_vertices());
    std::vector<bool> drawn(mesh.num_vertices(), false);
    for (Vertex v : mesh.vertices()) {
      before[std::size_t(v)] = mesh.point(v);
      const auto nearest = tree.nearest(to_double_point(mesh.point(v)));
      if (nearest.squared_distance < 4 * offset_ * offset_) {
        mesh.point(v) = Point_3(nearest.point.x(), nearest.point.y(), nearest.point.z());
        drawn[std::size_t(v)] = true;
      }
    }
    // where two sheets are drawn onto each other, both go back
    for (int round = 0; round < 20; ++round) {
      const Face_pairs pairs = crossing_pairs(mesh);
      if (pairs.empty())
        return;
      std::vector<Face> faces;
      for (const auto& pair : pairs) {
        faces.push_back(pair.first);
        faces.push_back(pair.second);
      }
      for (Face f : faces)
        for (Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
          for (Vertex w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
            if (drawn[std::size_t(w)] || drawn[std::size_t(v)]) {
              mesh.point(w) = before[std::size_t(w)];
              mesh.point(v) = before[std::size_t(v)];
            }
    }
    for (Vertex v : mesh.vertices())
      mesh.point(v) = before[std::size_t(v)];
  }

  void open_ends(Surface& mesh) const {
    const std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
    std::vector<Double_kernel::Triangle_3> shapes;
    for (Face f : faces) {
      const auto h = mesh.halfedge(f);
      shapes.emplace_back(to_double_point(mesh.point(mesh.source(h))), to_double_point(mesh.point(mesh.target(h))),
                          to_double_point(mesh.point(mesh.target(mesh.next(h)))));
    }
    const Nearest_tree<Double_kernel::Triangle_3> tree(std::move(shapes));
    for (const auto& end : ends_)
      if (!open(mesh, end, faces[tree.nearest(to_double_point(end.center)).index]))
        throw Input_error(reason_ + ", and the opening at " + coordinates(end.center) +
                          " is not found again on the wrap around it: cut the surface straight there, or clean it in "
                          "another program.");
  }

  // Cuts a little further in than where the end was, all that is connected to the face at its centre.
  bool open(Surface& mesh, const Rim_shape& end, Face face) const {
    if (mesh.is_removed(face))
      return false;
    for (double margin : {0.02, 0.1, 0.25, 0.5, 1.}) {
      const double depth = end.sag + margin * end.radius;
      const Point_3 origin = end.center - depth * end.plane.normal();
      for (Vertex v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
        if ((mesh.point(v) - origin) * end.plane.normal() > 0 &&
            trim_by_plane(mesh, origin, end.plane.normal(), std::vector<Vertex>{v}, 2 * (end.reach + depth)) !=
                Surface::null_halfedge())
          return true;
    }
    return false;
  }

  std::vector<Point_3> points_;
  std::vector<Index_triangle> triangles_;
  std::vector<Rim_shape> ends_;
  std::string reason_;
  double alpha_ = 0, offset_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WRAP_SURFACE_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_CUT_SURFACE_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_CUT_SURFACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A point of a curve that is going to be cut: a vertex, or a point on an edge; and the face that the curve enters. */
struct Curve_point {
  Vertex vertex;     // null for a point on an edge
  Halfedge halfedge; // the edge it is on
  double t;          // along the halfedge
  Face next_face;
};

/* A closed labelled surface while it is being cut: knows its rims and the curves cut so far, and which faces have come
 * from one of the original ones. */
class Cut_surface {
public:
  typedef std::vector<Curve_point> Curve;

  Cut_surface(Surface& mesh, Face_patch_map patch)
      : mesh_(mesh)
      , patch_(patch)
      , number_of_original_faces_(mesh.number_of_faces())
      , on_curve_(mesh.add_property_map<Edge, bool>("e:tubular_meshing_on_curve", false).first)
      , taken_(mesh.add_property_map<Vertex, bool>("v:tubular_meshing_taken", false).first) {
    for (Edge e : mesh.edges())
      if (is_wall(mesh.face(mesh.halfedge(e, 0))) != is_wall(mesh.face(mesh.halfedge(e, 1))))
        take(mesh.halfedge(e));
  }
  ~Cut_surface() {
    mesh_.remove_property_map(on_curve_);
    mesh_.remove_property_map(taken_);
  }
  Cut_surface(const Cut_surface&) = delete;
  Cut_surface& operator=(const Cut_surface&) = delete;

  Surface& mesh() const { return mesh_; }
  Vector_3d point(Vertex v) const { return Vector_3d(mesh_.point(v)); }
  std::array<Vector_3d, 3> corners(Face f) const {
    const Halfedge h = mesh_.halfedge(f);
    return {point(mesh_.source(h)), point(mesh_.target(h)), point(mesh_.target(mesh_.next(h)))};
  }
  int label(Face f) const { return patch_[f]; }
  bool is_wall(Face f) const { return label(f) == labels::wall; }
  /// Whether the edge is part of a rim or of a curve cut before.
  bool is_on_curve(Halfedge h) const { return on_curve_[mesh_.edge(h)]; }
  /// Whether a rim or a curve goes through the vertex.
  bool is_taken(Vertex v) const { return taken_[v]; }

  // The faces that an original face, by number, consists of now.
  std::vector<Face> parts(std::size_t original) const {
    const auto found = parts_.find(original);
    return found == parts_.end() ? std::vector<Face>(1, Face(Surface::size_type(original))) : found->second;
  }

  /* Splits the faces along a closed curve that enters each of them once, and keeps from passing near the curves there
   * are. Returns the curve's halfedges, in its direction. O(curve). */
  std::vector<Halfedge> cut(const Curve& curve) {
    std::vector<Vertex> vertices;
    for (const Curve_point& p : curve)
      vertices.push_back(p.vertex == Surface::null_vertex() ? split_edge(p.halfedge, p.t) : p.vertex);
    for (std::size_t i = 0; i < curve.size(); ++i)
      connect(vertices[i], vertices[(i + 1) % vertices.size()], curve[i].next_face);
    std::vector<Halfedge> halfedges;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      halfedges.push_back(mesh_.halfedge(vertices[i], vertices[(i + 1) % vertices.size()]));
      take(halfedges.back());
    }
    return halfedges;
  }

private:
  void take(Halfedge h) {
    on_curve_[mesh_.edge(h)] = true;
    taken_[mesh_.source(h)] = taken_[mesh_.target(h)] = true;
  }

  Vertex split_edge(Halfedge h, double t) {
    const Point_3 p = mesh_.point(mesh_.source(h)), q = mesh_.point(mesh_.target(h));
    const Halfedge first = CGAL::Euler::split_edge(h, mesh_);
    const Vertex v = mesh_.target(first);
    mesh_.point(v) = Point_3(p.x() + t * (q.x() - p.x()), p.y() + t * (q.y() - p.y()), p.z() + t * (q.z() - p.z()));
    return v;
  }

  // Puts an edge between two vertices of the face, and makes triangles of what it divides the face into.
  void connect(Vertex u, Vertex v, Face f) {
    if (mesh_.halfedge(u, v) != Surface::null_halfedge())
      return;
    const Halfedge diagonal = split_face(corner(f, u), corner(f, v));
    triangulate(mesh_.face(diagonal));
    triangulate(mesh_.face(mesh_.opposite(diagonal)));
  }

  // The halfedge of the face that ends in the vertex.
  Halfedge corner(Face f, Vertex v) const {
    Halfedge h = mesh_.halfedge(f);
    while (mesh_.target(h) != v)
      h = mesh_.next(h);
    return h;
  }

  Halfedge split_face(Halfedge a, Halfedge b) {
    const Face old = mesh_.face(a);
    const Halfedge diagonal = CGAL::Euler::split_face(a, b, mesh_);
    const Face one = mesh_.face(diagonal), other = mesh_.face(mesh_.opposite(diagonal));
    inherit(one == old ? other : one, old);
    return diagonal;
  }

  void inherit(Face child, Face parent) {
    patch_[child] = patch_[parent];
    const std::size_t original = std::size_t(parent) < number_of_original_faces_
                                     ? std::size_t(parent)
                                     : origin_[std::size_t(parent) - number_of_original_faces_];
    origin_.push_back(original); // faces are numbered as they are made
    std::vector<Face>& parts = parts_[original];
    if (parts.empty())
      parts.push_back(parent);
    parts.push_back(child);
  }

  // Of the two diagonals of a quadrangle, the one whose triangles have the larger least sine.
  void triangulate(Face f) {
    Halfedge h[4];
    h[0] = mesh_.halfedge(f);
    for (int i = 1; i < 4; ++i)
      h[i] = mesh_.next(h[i - 1]);
    if (mesh_.next(h[2]) == h[0])
      return;
    Vector_3d p[4];
    for (int i = 0; i < 4; ++i)
      p[i] = point(mesh_.target(h[i]));
    const double even = (std::min)(shape(p[0], p[1], p[2]), shape(p[2], p[3], p[0]));
    const double odd = (std::min)(shape(p[1], p[2], p[3]), shape(p[3], p[0], p[1]));
    even >= odd ? split_face(h[0], h[2]) : split_face(h[1], h[3]);
  }

  // Area over the square of the longest side.
  static double shape(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c) {
    const double longest = (std::max)({squared_norm(b - a), squared_norm(c - b), squared_norm(a - c)});
    return longest > 0 ? norm(cross(b - a, c - a)) / longest : 0;
  }

  Surface& mesh_;
  Face_patch_map patch_;
  const std::size_t number_of_original_faces_;
  Surface::Property_map<Edge, bool> on_curve_;
  Surface::Property_map<Vertex, bool> taken_;
  std::unordered_map<std::size_t, std::vector<Face>> parts_;
  std::vector<std::size_t> origin_; // of the new faces
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_CUT_SURFACE_H

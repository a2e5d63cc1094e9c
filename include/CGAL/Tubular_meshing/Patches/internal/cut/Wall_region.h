// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_WALL_REGION_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_WALL_REGION_H

#include <CGAL/Tubular_meshing/Patches/internal/cut/Cut_surface.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* What regions write on a surface; one at a time. */
struct Region_marks {
  explicit Region_marks(Surface& mesh)
      : mesh(mesh)
      , number(mesh.add_property_map<Face, int>("f:tubular_meshing_number", -1).first)
      , node(mesh.add_property_map<Halfedge, int>("h:tubular_meshing_node", -1).first) {}
  ~Region_marks() {
    mesh.remove_property_map(number);
    mesh.remove_property_map(node);
  }
  Region_marks(const Region_marks&) = delete;
  Region_marks& operator=(const Region_marks&) = delete;

  Surface& mesh;
  Surface::Property_map<Face, int> number;   ///< of a face in its region; −1 in no region
  Surface::Property_map<Halfedge, int> node; ///< of the corner at the halfedge's target
};

/* A connected part of the wall between curves, each of its boundaries shrunk to one point: a closed surface, of the
 * same genus. Its nodes are the boundaries, and the vertices off them; a vertex on a curve that has the region on both
 * sides is part of two nodes, so that they are looked up at corners. O(n) in the size of the region. */
class Wall_region {
public:
  Wall_region(const Cut_surface& surface, Region_marks& marks, Face seed)
      : surface_(surface)
      , mesh_(surface.mesh())
      , marks_(marks) {
    collect_faces(seed);
    number_boundaries();
    number_vertices();
  }
  ~Wall_region() {
    for (Face f : faces_)
      marks_.number[f] = -1;
  }
  Wall_region(const Wall_region&) = delete;
  Wall_region& operator=(const Wall_region&) = delete;

  const Surface& mesh() const { return mesh_; }
  const std::vector<Face>& faces() const { return faces_; }
  /// A halfedge of each edge off the curves.
  const std::vector<Halfedge>& edges() const { return edges_; }
  std::size_t number_of_nodes() const { return std::size_t(nodes_); }
  int genus() const { return (2 - (nodes_ - int(edges_.size()) + int(faces_.size()))) / 2; }

  std::size_t number(Face f) const { return std::size_t(marks_.number[f]); }
  int target(Halfedge h) const { return marks_.node[h]; }
  int source(Halfedge h) const { return marks_.node[mesh_.prev(h)]; }
  /// Whether a curve is there.
  bool is_boundary(Halfedge h) const { return surface_.is_on_curve(h); }
  bool is_on_boundary(Vertex v) const { return surface_.is_taken(v); }
  Vector_3d point(Vertex v) const { return surface_.point(v); }

private:
  void collect_faces(Face seed) {
    add_face(seed);
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(faces_[i]))) {
        marks_.node[h] = -1;
        if (is_boundary(h))
          continue;
        if (h < mesh_.opposite(h))
          edges_.push_back(h);
        if (marks_.number[mesh_.face(mesh_.opposite(h))] < 0)
          add_face(mesh_.face(mesh_.opposite(h)));
      }
  }

  void add_face(Face f) {
    marks_.number[f] = int(faces_.size());
    faces_.push_back(f);
  }

  void number_boundaries() {
    for (Face f : faces_)
      for (Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
        if (is_boundary(h) && marks_.node[h] < 0)
          follow_boundary(h, nodes_++);
  }

  void follow_boundary(Halfedge first, int node) {
    for (Halfedge h = first; marks_.node[h] < 0;) {
      marks_.node[h] = node;
      Halfedge out = mesh_.next(h);
      while (!is_boundary(out)) {
        marks_.node[mesh_.opposite(out)] = node;
        out = mesh_.next(mesh_.opposite(out));
      }
      h = out;
    }
  }

  void number_vertices() {
    for (Face f : faces_)
      for (Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
        if (marks_.node[h] < 0) {
          for (Halfedge g : mesh_.halfedges_around_target(h))
            marks_.node[g] = nodes_;
          ++nodes_;
        }
  }

  const Cut_surface& surface_;
  const Surface& mesh_;
  Region_marks& marks_;
  std::vector<Face> faces_;
  std::vector<Halfedge> edges_;
  int nodes_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_WALL_REGION_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_SURFACE_IMPROVER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_SURFACE_IMPROVER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_patch.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_smoother.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Sheet.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Triangles in space as a sheet, see Patch_sheet: places move to the nearest ones. Normals are those that they had. */
class Triangle_sheet final : public Sheet {
public:
  explicit Triangle_sheet(Nearest_tree<Double_kernel::Triangle_3> tree)
      : tree_(std::move(tree)) {}

  bool move(const Sheet_place& from, const Vector_3d& step, Sheet_place& to) const override {
    const double most_turn = 0.3; // cosine: not over to the other side of a gap
    const auto nearest = tree_.nearest(as<Double_kernel::Point_3>(from.point + step));
    const Double_kernel::Triangle_3& t = tree_.shape(nearest.index);
    const Vector_3d a(t[0]), n = cross(Vector_3d(t[1]) - a, Vector_3d(t[2]) - a);
    to = from;
    to.point = Vector_3d(nearest.point);
    return dot(n, from.normal) >= most_turn * norm(n);
  }

private:
  Nearest_tree<Double_kernel::Triangle_3> tree_;
};

/* The quads of a wall as a whole. Its first vertices are those on rims and of triangles, which stay; normals are the
 * means of the quads' own. */
struct Wall_quads {
  Quad_patch mesh;
  std::vector<Vertex> vertices;           // of the surface, for each of the mesh's
  std::vector<std::size_t> patch_of_quad; // of the cut

  explicit Wall_quads(const Remeshed_surface& result)
      : number_(std::size_t(result.surface.number_of_vertices()), -1) {
    const Surface& surface = result.surface;
    const auto is_quad_of_wall = [&](auto f) { return result.patch_of_face[f] >= 0 && surface.degree(f) == 4; };
    for (auto f : surface.faces())
      if (!is_quad_of_wall(f))
        for (Vertex v : surface.vertices_around_face(surface.halfedge(f)))
          number_of(v, surface);
    mesh.on_loops = mesh.places.size();
    for (auto f : surface.faces())
      if (is_quad_of_wall(f)) {
        add_quad(surface, f);
        patch_of_quad.push_back(std::size_t(result.patch_of_face[f]));
      }
    for (Sheet_place& p : mesh.places)
      p.normal = normalized(p.normal);
  }

private:
  int number_of(Vertex v, const Surface& surface) {
    int& n = number_[std::size_t(v)];
    if (n < 0) {
      Sheet_place place;
      place.point = Vector_3d(surface.point(v));
      n = mesh.add_vertex(place);
      vertices.push_back(v);
    }
    return n;
  }

  void add_quad(const Surface& surface, Face f) {
    Quad_patch::Quad q;
    std::size_t i = 0;
    for (Vertex v : surface.vertices_around_face(surface.halfedge(f)))
      q[i++] = number_of(v, surface);
    mesh.add_quad(q);
    const Vector_3d n = cross(mesh.point(q[2]) - mesh.point(q[0]), mesh.point(q[3]) - mesh.point(q[1]));
    for (int v : q)
      mesh.places[std::size_t(v)].normal += n;
  }

  std::vector<int> number_; // of the surface's vertices
};

/* Raises the worst quads of a wall. Within their patches, no better is possible, but across the curves there is:
 * vertices on curves move too, on the old surface; those on rims stay. */
class Quad_surface_improver {
public:
  Quad_surface_improver(Remeshed_surface& result, const Surface& old_surface, const Surface_cut& cut)
      : result_(result)
      , old_surface_(old_surface)
      , cut_(cut)
      , wall_(result) {}

  void run() {
    const int rounds = 8;
    std::vector<int> vertices;
    for (int q : quads_below(good_quality))
      vertices.insert(vertices.end(), wall_.mesh.quad(q).begin(), wall_.mesh.quad(q).end());
    if (vertices.empty())
      return;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const Triangle_sheet sheet(old_triangles(old_surface_, cut_, patches_below(good_quality)));
    Quad_smoother(wall_.mesh, sheet).raise_worst(vertices, good_quality, rounds);
    for (int v : vertices)
      result_.surface.point(wall_.vertices[std::size_t(v)]) = as<Point_3>(wall_.mesh.point(v));
  }

  // The patches with quads that turn over.
  std::vector<std::size_t> folded_patches() const { return marked(patches_below(0)); }

private:
  static constexpr double good_quality = 0.65; // three quads at a vertex have 2/3 at most

  std::vector<int> quads_below(double quality) const {
    std::vector<int> result;
    for (int q = 0; q < int(wall_.mesh.quads.size()); ++q)
      if (!(wall_.mesh.quality(q) > quality))
        result.push_back(q);
    return result;
  }
  std::vector<char> patches_below(double quality) const {
    std::vector<char> marks(cut_.patches.size(), 0);
    for (int q : quads_below(quality))
      marks[wall_.patch_of_quad[std::size_t(q)]] = 1;
    return marks;
  }

  Remeshed_surface& result_;
  const Surface& old_surface_;
  const Surface_cut& cut_;
  Wall_quads wall_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_SURFACE_IMPROVER_H

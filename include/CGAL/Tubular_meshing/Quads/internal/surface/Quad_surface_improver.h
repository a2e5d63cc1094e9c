// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_SURFACE_IMPROVER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_SURFACE_IMPROVER_H

#include <CGAL/Tubular_meshing/Operators/Surface_patch.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_patch.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_smoother.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Sheet.h>
#include <CGAL/Tubular_meshing/Surface/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Surface/internal/remeshing/old_triangles.h>
#include <CGAL/Tubular_meshing/internal/Nearest_tree.h>
#include <CGAL/Tubular_meshing/internal/Vector_3d.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Triangles in space as a sheet, see Patch_sheet: places move to the nearest ones. Normals are those that they had. */
class Triangle_sheet {
public:
  explicit Triangle_sheet(Nearest_tree<Double_kernel::Triangle_3> tree)
      : tree_(std::move(tree)) {}

  bool move(const Sheet_place& from, const Vector_3d& step, Sheet_place& to) const {
    const double most_turn = 0.3; // cosine: not over to the other side of a gap
    const Vector_3d p = from.point + step;
    const auto nearest = tree_.nearest({p.x, p.y, p.z});
    const Double_kernel::Triangle_3& t = tree_.shape(nearest.index);
    const Vector_3d a(t[0]), n = cross(Vector_3d(t[1]) - a, Vector_3d(t[2]) - a);
    to = from;
    to.point = Vector_3d(nearest.point);
    return dot(n, from.normal) >= most_turn * norm(n);
  }

private:
  Nearest_tree<Double_kernel::Triangle_3> tree_;
};

/* Raises the worst quads of a wall. Within their patches, no better is possible, but across the curves there is:
 * vertices on curves move too, on the old surface; those on rims stay. */
template <class Point_3> class Quad_surface_improver {
public:
  typedef CGAL::Surface_mesh<Point_3> Surface;
  typedef typename Surface::Vertex_index Vertex;

  Quad_surface_improver(Remeshed_surface<Point_3>& result, const Surface& old_surface, const Surface_cut<Point_3>& cut)
      : result_(result)
      , old_surface_(old_surface)
      , cut_(cut) {}

  void run() {
    const int rounds = 8;
    copy_wall();
    std::vector<char> patches(cut_.patches.size(), 0);
    std::vector<int> vertices;
    for (int q = 0; q < int(wall_.quads.size()); ++q)
      if (wall_.quality(q) < good_enough) {
        patches[std::size_t(patch_of_quad_[std::size_t(q)])] = 1;
        vertices.insert(vertices.end(), wall_.quad(q).begin(), wall_.quad(q).end());
      }
    if (vertices.empty())
      return;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const Triangle_sheet sheet(old_triangles(old_surface_, cut_, patches));
    Quad_smoother<Triangle_sheet>(wall_, sheet).raise_worst(vertices, good_enough, rounds);
    for (int v : vertices) {
      const Vector_3d& p = wall_.point(v);
      result_.surface.point(vertices_[std::size_t(v)]) = Point_3(p.x, p.y, p.z);
    }
  }

private:
  static constexpr double good_enough = 0.6;

  // Vertices of caps first: they stay.
  void copy_wall() {
    const Surface& surface = result_.surface;
    std::vector<int> number(std::size_t(surface.number_of_vertices()), -1);
    const auto add = [&](Vertex v) {
      int& n = number[std::size_t(v)];
      if (n >= 0)
        return;
      Sheet_place place;
      place.point = Vector_3d(surface.point(v));
      n = wall_.add_vertex(place);
      vertices_.push_back(v);
    };
    for (auto f : surface.faces())
      if (result_.patch_of_face[f] < 0)
        for (Vertex v : surface.vertices_around_face(surface.halfedge(f)))
          add(v);
    wall_.on_loops = wall_.places.size();
    for (auto f : surface.faces()) {
      if (result_.patch_of_face[f] < 0)
        continue;
      Quad_patch::Quad q;
      std::size_t i = 0;
      for (Vertex v : surface.vertices_around_face(surface.halfedge(f))) {
        add(v);
        q[i++] = number[std::size_t(v)];
      }
      wall_.add_quad(q);
      patch_of_quad_.push_back(result_.patch_of_face[f]);
      const Vector_3d n = cross(wall_.point(q[2]) - wall_.point(q[0]), wall_.point(q[3]) - wall_.point(q[1]));
      for (int v : q)
        wall_.places[std::size_t(v)].normal += n;
    }
    for (Sheet_place& p : wall_.places)
      p.normal = normalized(p.normal);
  }

  Remeshed_surface<Point_3>& result_;
  const Surface& old_surface_;
  const Surface_cut<Point_3>& cut_;
  Quad_patch wall_;
  std::vector<Vertex> vertices_;   // of the surface, for each of the wall's
  std::vector<int> patch_of_quad_; // of the cut
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_SURFACE_IMPROVER_H

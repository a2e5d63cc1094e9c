// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TRIANGLE_IMPROVER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TRIANGLE_IMPROVER_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/triangle_shapes.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Improves the few triangles that the plane left bad: where curves have kinks or nearly touch, patch by patch nothing
 * better is possible, but across the curves there is. Vertices move, on the surface, off their curves too, and edges
 * inside of patches are flipped; each step raises the worst quality of the triangles that it changes. */
class Triangle_improver {
public:
  typedef Nearest_tree<Double_kernel::Triangle_3> Tree;

  static constexpr double good_quality = 0.6; // gamma_T

  Triangle_improver(Surface& surface, const Triangle_shape& shape)
      : surface_(surface)
      , shape_(shape) {}

  std::vector<Face> bad_triangles() const {
    std::vector<Face> bad;
    for (Face f : surface_.faces())
      if (quality(f) < good_quality)
        bad.push_back(f);
    return bad;
  }

  /* `old_surface` has the triangles that are to be kept to, around the bad ones at least; may_move(vertex) and
   * may_flip(halfedge) tell what is left as it is. */
  void improve(std::vector<Face> bad, const Tree& old_surface, Function_view<bool(Vertex)> may_move,
               Function_view<bool(Halfedge)> may_flip) {
    const int most_rounds = 8;
    for (int round = 0; round < most_rounds && !bad.empty(); ++round) {
      bool changed = false;
      for (Face f : bad) {
        if (quality(f) >= good_quality)
          continue;
        const std::array<Halfedge, 3> sides = sides_of(f);
        for (Halfedge h : sides) // a flip may take the others away from f
          changed = (surface_.face(h) == f && may_flip(h) && flip(h)) || changed;
        for (Vertex v : vertices_around(f))
          changed = (may_move(v) && move(v, old_surface)) || changed;
      }
      if (!changed)
        return;
    }
  }

private:
  static constexpr double least_gain = 1e-3;
  static constexpr double most_turn = 0.7; // cosine of the angle that a triangle may be turned by in one step

  Vector_3d at(Vertex v) const { return Vector_3d(surface_.point(v)); }
  std::array<Halfedge, 3> sides_of(Face f) const {
    const Halfedge h = surface_.halfedge(f);
    return {h, surface_.next(h), surface_.prev(h)};
  }
  std::array<Vertex, 3> vertices_around(Face f) const {
    const auto h = sides_of(f);
    return {surface_.target(h[0]), surface_.target(h[1]), surface_.target(h[2])};
  }
  double quality(Face f) const {
    const auto v = vertices_around(f);
    return shape_.quality(at(v[0]), at(v[1]), at(v[2]));
  }
  static Vector_3d normal(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c) {
    return normalized(cross(b - a, c - a));
  }

  bool flip(Halfedge h) {
    const Halfedge g = surface_.opposite(h);
    const Vertex vc = surface_.target(surface_.next(h)), vd = surface_.target(surface_.next(g));
    if (surface_.halfedge(vc, vd) != Surface::null_halfedge())
      return false;
    const Vector_3d a = at(surface_.source(h)), b = at(surface_.target(h)), c = at(vc), d = at(vd);
    const double before = (std::min)(shape_.quality(a, b, c), shape_.quality(b, a, d));
    const double after = (std::min)(shape_.quality(a, d, c), shape_.quality(d, b, c));
    const Vector_3d n = normalized(normal(a, b, c) + normal(b, a, d));
    if (after < before + least_gain || dot(n, normal(a, d, c)) < most_turn || dot(n, normal(d, b, c)) < most_turn)
      return false;
    CGAL::Euler::flip_edge(h, surface_);
    return true;
  }

  // The star of v, as edges opposite to it, with the normals of its triangles.
  struct Ray {
    Vector_3d a, b, normal;
  };
  double worst(const Vector_3d& p) const {
    double q = 1;
    for (const Ray& r : star_)
      q = (std::min)(q, dot(r.normal, normal(p, r.a, r.b)) < most_turn ? 0 : shape_.quality(p, r.a, r.b));
    return q;
  }

  bool move(Vertex v, const Tree& old_surface) {
    const Vector_3d p = at(v);
    star_.clear();
    for (Halfedge h : surface_.halfedges_around_target(surface_.halfedge(v))) {
      const Vector_3d a = at(surface_.target(surface_.next(h))), b = at(surface_.source(h));
      star_.push_back({a, b, normal(p, a, b)});
    }
    const double before = worst(p);
    double best = before + least_gain;
    Vector_3d best_place;
    for (const Vector_3d& target : targets(p))
      for (double s : {1., 0.5, 0.25, 0.1}) {
        const Vector_3d x(old_surface.nearest(as<Double_kernel::Point_3>(p + s * (target - p))).point);
        const double after = worst(x);
        if (after > best) {
          best = after;
          best_place = x;
        }
      }
    if (best == before + least_gain)
      return false;
    surface_.point(v) = as<Point_3>(best_place);
    return true;
  }

  // The middle of the star; the mean of the apexes of equilateral triangles on its edges; each of these for a bad one.
  std::vector<Vector_3d> targets(const Vector_3d& p) const {
    std::vector<Vector_3d> result(2);
    const double n = double(star_.size());
    for (const Ray& r : star_) {
      const Vector_3d apex = shape_.apex(r.a, r.b, r.normal);
      result[0] += 1 / n * r.a;
      result[1] += 1 / n * apex;
      if (shape_.quality(p, r.a, r.b) < good_quality)
        result.push_back(apex);
    }
    return result;
  }

  Surface& surface_;
  const Triangle_shape& shape_;
  std::vector<Ray> star_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TRIANGLE_IMPROVER_H

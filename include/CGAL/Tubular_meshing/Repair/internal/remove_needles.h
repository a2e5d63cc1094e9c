// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REMOVE_NEEDLES_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REMOVE_NEEDLES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Removes triangles of which the height is below a thousandth of the longest side: those with a short side by
 * collapsing it, flat ones by flipping the longest side, or, where this is on a rim, by removing the triangle. Each of
 * these moves the surface by about a thousandth of an edge; what would turn a neighbour over is not done. O(n) for each
 * of at most ten passes. */
class Needle_remover {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Halfedge_index Halfedge;
  typedef Surface::Face_index Face;

public:
  static constexpr double least_flatness = 1e-3;

  explicit Needle_remover(Surface& mesh)
      : mesh_(mesh) {}

  std::vector<Face> find() const {
    std::vector<Face> needles;
    for (Face f : mesh_.faces())
      if (is_needle(f))
        needles.push_back(f);
    return needles;
  }

  /* How many are left. */
  std::size_t remove(std::vector<Face> needles) {
    for (int pass = 0; pass < 10 && !needles.empty(); ++pass) {
      std::size_t done = 0;
      for (Face f : needles)
        if (!mesh_.is_removed(f) && is_needle(f))
          done += remove(f);
      if (done == 0)
        break;
      mesh_.collect_garbage();
      needles = find();
    }
    return needles.size();
  }

private:
  double side(Halfedge h) const { return point_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h))); }

  static double flatness(const Point_3& a, const Point_3& b, const Point_3& c) {
    const double longest =
        (std::max)((b - a).squared_length(), (std::max)((c - b).squared_length(), (a - c).squared_length()));
    return longest > 0 ? std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / longest : 0;
  }

  bool is_needle(Face f) const {
    const Halfedge h = mesh_.halfedge(f);
    return flatness(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)),
                    mesh_.point(mesh_.target(mesh_.next(h)))) < least_flatness;
  }

  bool remove(Face f) {
    Halfedge shortest = mesh_.halfedge(f), longest = shortest;
    for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_)) {
      shortest = side(h) < side(shortest) ? h : shortest;
      longest = side(h) > side(longest) ? h : longest;
    }
    if (side(shortest) < 0.05 * side(longest) && collapse(shortest))
      return true;
    return flip(longest) || collapse(shortest);
  }

  bool collapse(Halfedge h) {
    const auto e = mesh_.edge(h);
    const Vertex from = mesh_.source(h), to = mesh_.target(h);
    if (!CGAL::Euler::does_satisfy_link_condition(e, mesh_) ||
        (mesh_.is_border(from) && mesh_.is_border(to) && !mesh_.is_border(e)))
      return false;
    if (is_end_of_small_loop(e))
      return false;
    // on a rim the point that stays is the rim's
    const Point_3 p = mesh_.is_border(from) && !mesh_.is_border(to) ? mesh_.point(from) : mesh_.point(to);
    if (turns_a_face(from, to, p) || turns_a_face(to, from, p))
      return false;
    mesh_.point(CGAL::Euler::collapse_edge(e, mesh_)) = p;
    return true;
  }

  // Whether the edge is on a border loop of three edges, which would come to nothing.
  bool is_end_of_small_loop(Surface::Edge_index e) const {
    for (int i = 0; i < 2; ++i) {
      const Halfedge h = mesh_.halfedge(e, i);
      if (mesh_.is_border(h) && mesh_.next(mesh_.next(mesh_.next(h))) == h)
        return true;
    }
    return false;
  }

  // Whether a face at v, but not at w, turns over when v moves to p.
  bool turns_a_face(Vertex v, Vertex w, const Point_3& p) const {
    for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_)) {
      if (mesh_.is_border(h))
        continue;
      const Vertex a = mesh_.source(h), b = mesh_.target(mesh_.next(h));
      if (a == w || b == w || is_needle(mesh_.face(h)))
        continue;
      const Point_3 &pa = mesh_.point(a), &pb = mesh_.point(b), &old = mesh_.point(v);
      const Vector_3 before = CGAL::cross_product(pb - old, pa - old), after = CGAL::cross_product(pb - p, pa - p);
      if (before * after < 0.5 * std::sqrt(before.squared_length() * after.squared_length()) ||
          flatness(pa, pb, p) < least_flatness)
        return true;
    }
    return false;
  }

  bool flip(Halfedge h) {
    const Halfedge o = mesh_.opposite(h);
    if (mesh_.is_border(o)) {
      if (mesh_.is_border(mesh_.target(mesh_.next(h))))
        return false; // the rim would touch itself
      CGAL::Euler::remove_face(h, mesh_);
      return true;
    }
    const Vertex a = mesh_.target(mesh_.next(h)), b = mesh_.target(mesh_.next(o));
    if (a == b || mesh_.halfedge(a, b) != Surface::null_halfedge())
      return false;
    const Point_3 &pa = mesh_.point(a), &pb = mesh_.point(b), &s = mesh_.point(mesh_.source(h)),
                  &t = mesh_.point(mesh_.target(h));
    const Vector_3 before = CGAL::cross_product(t - s, pa - s) + CGAL::cross_product(s - t, pb - t);
    const Vector_3 one = CGAL::cross_product(pb - s, pa - s), two = CGAL::cross_product(pa - t, pb - t);
    if (before * one <= 0 || before * two <= 0 ||
        (std::min)(flatness(s, pb, pa), flatness(t, pa, pb)) < flatness(s, t, pa))
      return false;
    CGAL::Euler::flip_edge(h, mesh_);
    return true;
  }

  Surface& mesh_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REMOVE_NEEDLES_H

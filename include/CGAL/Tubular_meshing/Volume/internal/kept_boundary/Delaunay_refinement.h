// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_DELAUNAY_REFINEMENT_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_DELAUNAY_REFINEMENT_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/interruption.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Adds points inside a mesh until no tetrahedron is larger than `size`, a length, allows, but for those that
 * only a point too near to the boundary could split: facets with a label, and all their vertices, stay [Shewchuk 1998].
 *
 * A tetrahedron too large is split by its circumcenter: the tetrahedra whose circumscribed spheres contain that point,
 * and which are reached from the first without crossing a labelled facet, make room for those between it and the facets
 * of the cavity. Predicates are exact, so that none is inverted. About linear in the number of tetrahedra made. */
class Delaunay_refinement {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  // `radius_bound`: the largest circumscribed radius, over the size there.
  Delaunay_refinement(Store& store, Length_function size, double radius_bound)
      : store_(store)
      , size_(size)
      , radius_bound_(radius_bound) {}

  // Returns the number of points added, which is `most` if there was no room for more.
  std::size_t operator()(std::size_t most) {
    const std::vector<Index> all = store_.tetrahedra();
    std::deque<Index> todo(all.begin(), all.end());
    std::size_t added = 0;
    Store::Index_list come;
    for (; !todo.empty() && added < most; todo.pop_front()) {
      check_interruption();
      const Index t = todo.front();
      if (!store_.is_alive(t) || !split(t, come))
        continue;
      ++added;
      todo.insert(todo.end(), come.begin(), come.end());
    }
    return added;
  }

private:
  // of a new point from vertices and labelled facets, over the size
  static constexpr double least_spacing = 0.7;
  static constexpr double least_height = 0.5;

  static Point_3 to_point(const Vector_3d& p) { return Point_3(p.x, p.y, p.z); }
  Point_3 point(Index v) const { return to_point(store_.point(v)); }

  // By its circumcenter or, where the boundary is in the way and coarser than the inside, by its middle.
  bool split(Index t, Store::Index_list& come) {
    const auto& w = store_[t].v;
    const Vector_3d& p = store_.point(w[0]);
    const Vector_3d a = store_.point(w[1]) - p, b = store_.point(w[2]) - p, c = store_.point(w[3]) - p;
    const Vector_3d middle = p + 0.25 * (a + b + c);
    const double h = size_(to_point(middle)), denominator = 2 * dot(a, cross(b, c));
    if (!(denominator > 0))
      return false;
    const Vector_3d to_center = (1 / denominator) * (squared_norm(a) * cross(b, c) + squared_norm(b) * cross(c, a) +
                                                     squared_norm(c) * cross(a, b));
    if (squared_norm(to_center) <= radius_bound_ * radius_bound_ * h * h)
      return false;
    return insert(p + to_center, t, 0, h, come) || insert(middle, t, least_spacing * h, h, come);
  }

  // Puts a point that is in the circumscribed sphere of t, and no nearer than `spacing` to other vertices.
  bool insert(const Vector_3d& x, Index t, double spacing, double h, Store::Index_list& come) {
    const Point_3 p = to_point(x);
    collect_cavity(p, t);
    if (!make_visible(p, t) || is_crowded(x, spacing) || encroaches(x, least_height * h))
      return false;
    store_.replace_by_star(cavity_, facets_, x, come);
    return true;
  }

  void collect_cavity(const Point_3& p, Index t) {
    cavity_.assign(1, t);
    for (std::size_t k = 0; k < cavity_.size(); ++k)
      for (int i = 0; i < 4; ++i) {
        const Index n = beyond(Store::facet(cavity_[k], i));
        if (n != Store::none && !is_in_cavity(n) && conflicts(p, n))
          cavity_.push_back(n);
      }
  }

  // The tetrahedron behind a facet that may be crossed.
  Index beyond(Index facet) const {
    const Index other = store_.other_side(facet);
    return other == Store::none || store_.label(facet) != 0 ? Store::none : Store::tetrahedron_of(other);
  }
  bool is_in_cavity(Index t) const { return std::find(cavity_.begin(), cavity_.end(), t) != cavity_.end(); }

  bool conflicts(const Point_3& p, Index t) const {
    const auto& v = store_[t].v;
    return Kernel().side_of_oriented_sphere_3_object()(point(v[0]), point(v[1]), point(v[2]), point(v[3]), p) ==
           ON_POSITIVE_SIDE;
  }

  /* Takes tetrahedra out of the cavity until p sees the inside of all of its facets: without the Delaunay property,
   * next to the boundary, it need not. False if the first one would have to go. */
  bool make_visible(const Point_3& p, Index t) {
    for (;;) {
      facets_.clear();
      Index hidden = Store::none;
      for (Index c : cavity_)
        for (int i = 0; i < 4; ++i) {
          const Index f = Store::facet(c, i), n = beyond(f);
          if (n != Store::none && is_in_cavity(n))
            continue;
          facets_.push_back(f);
          const auto w = store_.vertices(f);
          if (orientation(p, point(w[0]), point(w[1]), point(w[2])) != POSITIVE)
            hidden = c;
        }
      if (hidden == Store::none)
        return true;
      if (hidden == t)
        return false;
      cavity_.erase(std::find(cavity_.begin(), cavity_.end(), hidden));
    }
  }

  bool is_crowded(const Vector_3d& x, double spacing) const {
    for (Index f : facets_)
      for (Index v : store_.vertices(f))
        if (squared_norm(store_.point(v) - x) < spacing * spacing)
          return true;
    return false;
  }

  // Whether x is too near to a labelled facet of the cavity for a good tetrahedron: in the smallest sphere through its
  // vertices and, as the facet may be larger than what is wanted inside, below a height.
  bool encroaches(const Vector_3d& x, double height) const {
    for (Index f : facets_) {
      if (store_.label(f) == 0)
        continue;
      const auto w = store_.vertices(f);
      const Vector_3d& p = store_.point(w[0]);
      const Vector_3d a = store_.point(w[1]) - p, b = store_.point(w[2]) - p, n = cross(a, b);
      const Vector_3d to_center =
          (0.5 / squared_norm(n)) * (squared_norm(a) * cross(b, n) + squared_norm(b) * cross(n, a));
      if (squared_norm(x - p - to_center) < squared_norm(to_center) && std::abs(dot(x - p, n)) < height * norm(n))
        return true;
    }
    return false;
  }

  Store& store_;
  Length_function size_;
  double radius_bound_;

  // the cavity at hand
  std::vector<Index> cavity_;
  std::vector<Index> facets_; // each with its tetrahedron inside
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_DELAUNAY_REFINEMENT_H

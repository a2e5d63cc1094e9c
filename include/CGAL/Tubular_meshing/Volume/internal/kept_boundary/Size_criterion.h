// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_SIZE_CRITERION_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_SIZE_CRITERION_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Which tetrahedra of a mesh are too large: those with a circumscribed radius above a bound, over the size in their
 * middle. A size is asked for once at each vertex; where those of a tetrahedron's vertices are alike, the size in its
 * middle is their mean. Safe to ask from several threads. */
class Size_criterion {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  struct Excess {
    Vector_3d circumcenter, middle;
    double size;
  };

  Size_criterion(const Store& store, Length_function size, double radius_bound, int threads)
      : store_(store)
      , size_(size)
      , radius_bound_(radius_bound)
      , at_vertices_(store.number_of_vertices()) {
    for_each_range(at_vertices_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        at_vertices_[v] = size_at(store.point(Index(v)));
    });
  }

  double size_at(const Vector_3d& p) const { return size_(Point_3(p.x, p.y, p.z)); }

  // None if a tetrahedron is as small as it is to be, or is no more.
  std::optional<Excess> excess(Index t) const {
    if (!store_.is_alive(t))
      return std::nullopt;
    const Store::Vertices& w = store_[t].v;
    const Vector_3d& p = store_.point(w[0]);
    const Vector_3d a = store_.point(w[1]) - p, b = store_.point(w[2]) - p, c = store_.point(w[3]) - p;
    const Vector_3d middle = p + 0.25 * (a + b + c);
    const double size = size_inside(w, middle), denominator = 2 * dot(a, cross(b, c));
    if (!(denominator > 0))
      return std::nullopt;
    const Vector_3d to_center = (1 / denominator) * (squared_norm(a) * cross(b, c) + squared_norm(b) * cross(c, a) +
                                                     squared_norm(c) * cross(a, b));
    if (squared_norm(to_center) <= radius_bound_ * radius_bound_ * size * size)
      return std::nullopt;
    return Excess{p + to_center, middle, size};
  }

  // Of a new vertex.
  void set_size(Index v, double size) {
    if (v >= at_vertices_.size())
      at_vertices_.resize(v + 1);
    at_vertices_[v] = size;
  }

private:
  static constexpr double alike = 1.1;

  double size_inside(const Store::Vertices& v, const Vector_3d& middle) const {
    const double a = at_vertices_[v[0]], b = at_vertices_[v[1]], c = at_vertices_[v[2]], d = at_vertices_[v[3]];
    const double least = (std::min)((std::min)(a, b), (std::min)(c, d));
    const double most = (std::max)((std::max)(a, b), (std::max)(c, d));
    return most <= alike * least ? 0.25 * (a + b + c + d) : size_at(middle);
  }

  const Store& store_;
  Length_function size_;
  double radius_bound_;
  std::vector<double> at_vertices_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_SIZE_CRITERION_H

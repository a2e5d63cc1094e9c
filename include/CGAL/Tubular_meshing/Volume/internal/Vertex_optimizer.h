// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_VERTEX_OPTIMIZER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_VERTEX_OPTIMIZER_H

#include <CGAL/Tubular_meshing/Volume/internal/Shape_energy.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Moves vertices, topology fixed, down the shape energy of the elements around them, by Newton steps with backtracking:
 * no element is ever inverted. Vertices inside the volume move freely; those inside one patch of the surface move in
 * its tangent plane, those on a rim between two patches along it, and are brought back by `Projection`,
 *   Vector_3d to_patch(const Vector_3d& p, std::int32_t patch): the nearest point of that patch,
 *   Vector_3d to_rim(const Vector_3d& p, std::int32_t patch, std::int32_t other): of the rim between two (patch <
 * other); those where three or more patches meet stay, and so does what it says is fixed,
 *   bool is_fixed(const Vector_3d& p, int dimension): a vertex on a patch (2) or on a rim (1).
 *
 * Vertices are visited color by color, no two of a color sharing a tetrahedron, so that the result is the same for any
 * number of threads.
 */
template <class Projection> class Vertex_optimizer {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  Vertex_optimizer(Store& store, const Projection& project, int threads)
      : store_(store)
      , project_(project)
      , threads_(threads) {
    collect_stars();
    color();
  }

  // One visit to each vertex.
  void sweep() {
    for (std::size_t c = 0; c + 1 < color_begin_.size(); ++c) {
      const std::size_t begin = color_begin_[c];
      for_each_range(color_begin_[c + 1] - begin, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
          relocate(by_color_[begin + k]);
      });
    }
  }

  // Whether v lies on the given patches and no others.
  bool is_on(Index v, const std::vector<std::int32_t>& patches) const {
    const Location& at = location_[v];
    return at.dimension + patches.size() == 3 && std::equal(patches.begin(), patches.end(), at.patch);
  }

  // Moves v to p, if no element around it gets worse than `least`, or than the worst is now.
  bool move_to(Index v, const Vector_3d& p, double least) {
    const Vector_3d old = store_.point(v);
    const Normals normals = surface_normals(v);
    const double required = (std::min)(least, worst_quality(v));
    store_.move(v, p);
    Shape_energy there;
    if (energy(v, p, normals, false, there) && worst_quality(v) >= required)
      return true;
    store_.move(v, old);
    return false;
  }

private:
  // The patches that meet at a vertex: none inside the volume, one on a patch, two on a rim.
  struct Location {
    std::int32_t patch[2] = {0, 0};
    std::uint8_t dimension = 3; // of the space in which the vertex may move

    void add(std::int32_t label) {
      const int known = 3 - dimension;
      if (dimension == 0 || patch[0] == label || patch[1] == label)
        return;
      --dimension;
      if (known < 2)
        patch[known] = label;
      if (known == 1 && patch[0] > patch[1])
        std::swap(patch[0], patch[1]);
    }
  };
  typedef std::array<Vector_3d, 2> Normals; // of the patches at a vertex

  static constexpr double triangle_weight = 3; // about twice as many tetrahedra as triangles meet at a surface vertex

  void collect_stars() {
    const Index n = store_.number_of_vertices();
    star_begin_.assign(n + 1, 0);
    location_.assign(n, Location());
    for (Index t = 0; t < store_.number_of_slots(); ++t) {
      if (!store_.is_alive(t))
        continue;
      for (int i = 0; i < 4; ++i) {
        ++star_begin_[store_[t].v[i] + 1];
        if (store_[t].label[i] == 0)
          continue;
        for (int c : Store::facet_corners(i))
          location_[store_[t].v[c]].add(store_[t].label[i]);
      }
    }
    for (Index v = 0; v < n; ++v)
      if (location_[v].dimension < 3 && project_.is_fixed(store_.point(v), location_[v].dimension))
        location_[v].dimension = 0;
    for (Index v = 0; v < n; ++v)
      star_begin_[v + 1] += star_begin_[v];
    star_.resize(star_begin_[n]);
    std::vector<Index> next(star_begin_.begin(), star_begin_.end() - 1);
    for (Index t = 0; t < store_.number_of_slots(); ++t)
      if (store_.is_alive(t))
        for (int i = 0; i < 4; ++i)
          star_[next[store_[t].v[i]]++] = Store::facet(t, i);
  }

  // Greedy coloring in the order of the vertices.
  void color() {
    const Index n = store_.number_of_vertices();
    std::vector<std::uint8_t> color_of(n, 255);
    std::size_t colors = 0;
    std::vector<Index> used(256, Store::none);
    for (Index v = 0; v < n; ++v) {
      if (location_[v].dimension == 0 || star_begin_[v] == star_begin_[v + 1])
        continue;
      for (Index s = star_begin_[v]; s < star_begin_[v + 1]; ++s)
        for (Index w : store_[Store::tetrahedron_of(star_[s])].v)
          if (color_of[w] != 255)
            used[color_of[w]] = v;
      std::size_t c = 0;
      while (c < 254 && used[c] == v)
        ++c;
      color_of[v] = std::uint8_t(c);
      colors = (std::max)(colors, c + 1);
    }
    color_begin_.assign(colors + 1, 0);
    for (Index v = 0; v < n; ++v)
      if (color_of[v] != 255)
        ++color_begin_[color_of[v] + 1];
    for (std::size_t c = 0; c < colors; ++c)
      color_begin_[c + 1] += color_begin_[c];
    by_color_.resize(color_begin_[colors]);
    std::vector<std::size_t> next(color_begin_.begin(), color_begin_.end());
    for (Index v = 0; v < n; ++v)
      if (color_of[v] != 255)
        by_color_[next[color_of[v]]++] = v;
  }

  void relocate(Index v) {
    const Location& at = location_[v];
    const Vector_3d old = store_.point(v);
    const Normals normals = surface_normals(v);
    Shape_energy here;
    if (!energy(v, old, normals, true, here))
      return;
    Vector_3d step = at.dimension == 3   ? newton_step(here.hessian, here.gradient)
                     : at.dimension == 2 ? tangential_step(here, normals[0])
                                         : step_along(here, normalized(cross(normals[0], normals[1])));
    for (int attempt = 0; attempt < 4; ++attempt, step = 0.4 * step) {
      const Vector_3d moved = old + step, p = project(moved, at);
      // a projection longer than the step has landed on another part of the surface
      if (at.dimension < 3 && squared_norm(p - moved) > squared_norm(step))
        continue;
      Shape_energy there;
      if (energy(v, p, normals, false, there) && there.value < here.value) {
        store_.move(v, p);
        return;
      }
    }
  }

  Vector_3d project(const Vector_3d& p, const Location& at) const {
    return at.dimension == 3   ? p
           : at.dimension == 2 ? project_.to_patch(p, at.patch[0])
                               : project_.to_rim(p, at.patch[0], at.patch[1]);
  }

  bool energy(Index v, const Vector_3d& x, const Normals& normals, bool with_derivatives, Shape_energy& e) const {
    const Location& at = location_[v];
    for (Index s = star_begin_[v]; s < star_begin_[v + 1]; ++s) {
      const auto& tet = store_[Store::tetrahedron_of(star_[s])];
      const int i = Store::opposite_of(star_[s]);
      const auto& c = Store::facet_corners(i);
      if (!e.add_tetrahedron(x, store_.point(tet.v[c[0]]), store_.point(tet.v[c[1]]), store_.point(tet.v[c[2]]),
                             with_derivatives))
        return false;
      if (at.dimension == 3)
        continue;
      for (int j = 0; j < 4; ++j) {
        if (j == i || tet.label[j] == 0)
          continue;
        const auto edge = facet_edge(tet, i, j);
        if (!e.add_triangle(x, edge.first, edge.second, normals[tet.label[j] != at.patch[0]], triangle_weight,
                            with_derivatives))
          return false;
      }
    }
    return true;
  }

  // Of the tetrahedra around v, and of the triangles, which count for less as their range is higher.
  double worst_quality(Index v) const {
    double worst = 1;
    for (Index s = star_begin_[v]; s < star_begin_[v + 1]; ++s) {
      const auto& tet = store_[Store::tetrahedron_of(star_[s])];
      const auto& w = tet.v;
      worst = (std::min)(
          worst, tetrahedron_gamma(store_.point(w[0]), store_.point(w[1]), store_.point(w[2]), store_.point(w[3])));
      const int i = Store::opposite_of(star_[s]);
      for (int j = 0; j < 4; ++j)
        if (j != i && tet.label[j] != 0) {
          const auto edge = facet_edge(tet, i, j);
          worst = (std::min)(worst, 0.6 * triangle_gamma(store_.point(v), edge.first, edge.second));
        }
    }
    return worst;
  }

  // The two other vertices of the facet opposite to corner j, in the facet's order after corner i.
  std::pair<Vector_3d, Vector_3d> facet_edge(const Store::Tetrahedron& tet, int i, int j) const {
    const auto& f = Store::facet_corners(j);
    const int k = f[0] == i ? 0 : f[1] == i ? 1 : 2;
    return {store_.point(tet.v[f[(k + 1) % 3]]), store_.point(tet.v[f[(k + 2) % 3]])};
  }

  Normals surface_normals(Index v) const {
    const Location& at = location_[v];
    Normals sum;
    if (at.dimension == 3)
      return sum;
    for (Index s = star_begin_[v]; s < star_begin_[v + 1]; ++s) {
      const auto& tet = store_[Store::tetrahedron_of(star_[s])];
      const int i = Store::opposite_of(star_[s]);
      for (int j = 0; j < 4; ++j)
        if (j != i && tet.label[j] != 0) {
          const auto edge = facet_edge(tet, i, j);
          sum[tet.label[j] != at.patch[0]] += cross(edge.first - store_.point(v), edge.second - store_.point(v));
        }
    }
    return {normalized(sum[0]), normalized(sum[1])};
  }

  static Vector_3d newton_step(Symmetric_matrix_3d h, const Vector_3d& g) {
    // Cholesky's factors; where the Hessian is not definite, along the gradient with the trace as curvature
    const double trace = h.xx + h.yy + h.zz;
    const double floor = 1e-6 * trace;
    const double a = h.xx, b = h.xy / a, c = h.xz / a;
    const double d = h.yy - b * h.xy, e = (h.yz - b * h.xz) / d;
    const double f = h.zz - c * h.xz - e * e * d;
    if (!(a > floor && d > floor && f > floor))
      return (-1 / (std::max)(std::abs(trace), (std::numeric_limits<double>::min)())) * g;
    const double y0 = -g.x, y1 = -g.y - b * y0, y2 = -g.z - c * y0 - e * y1;
    const double z = y2 / f, y = y1 / d - e * z, x = y0 / a - b * y - c * z;
    return {x, y, z};
  }

  static Vector_3d tangential_step(const Shape_energy& e, const Vector_3d& n) {
    const Vector_3d axis = std::abs(n.x) < 0.6 ? Vector_3d(1, 0, 0) : Vector_3d(0, 1, 0);
    const Vector_3d u = normalized(cross(n, axis)), v = cross(n, u);
    const Vector_3d hu = e.hessian * u, hv = e.hessian * v;
    const double a = dot(hu, u), b = dot(hu, v), d = dot(hv, v), g0 = dot(e.gradient, u), g1 = dot(e.gradient, v);
    const double det = a * d - b * b;
    if (!(a > 0 && det > 1e-9 * a * a))
      return (-1 / (std::max)(std::abs(a) + std::abs(d), (std::numeric_limits<double>::min)())) * (g0 * u + g1 * v);
    return ((b * g1 - d * g0) / det) * u + ((b * g0 - a * g1) / det) * v;
  }

  static Vector_3d step_along(const Shape_energy& e, const Vector_3d& t) {
    const double slope = dot(e.gradient, t), curvature = std::abs(dot(e.hessian * t, t));
    return curvature > 0 ? (-slope / curvature) * t : Vector_3d();
  }

  Store& store_;
  const Projection& project_;
  int threads_;

  std::vector<Index> star_begin_, star_; // the facets opposite to each vertex
  std::vector<Location> location_;       // of each vertex
  std::vector<std::size_t> color_begin_;
  std::vector<Index> by_color_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_VERTEX_OPTIMIZER_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_VERTEX_OPTIMIZER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_VERTEX_OPTIMIZER_H

#include <CGAL/Tubular_meshing/Volume/internal/Colored_stars.h>
#include <CGAL/Tubular_meshing/Volume/internal/Shape_energy.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

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
    locate();
    stars_.build(store, [this](Index v) { return location_[v].dimension != 0; });
  }

  /* Moves the apexes of pyramids, and no other vertices, down the energy of the tetrahedra around them and of the
   * pyramids themselves: neither are inverted. The apex of pyramid k is vertex `pyramids.vertices[0][4] + k`. */
  Vertex_optimizer(Store& store, const Projection& project, const Element_block<5>& pyramids, int threads)
      : store_(store)
      , project_(project)
      , threads_(threads)
      , pyramids_(&pyramids)
      , location_(store.number_of_vertices()) {
    if (pyramids.empty())
      return;
    stars_.build(store_, [this](Index v) { return v >= first_apex() && v - first_apex() < pyramids_->size(); });
  }

  // One visit to each vertex.
  void sweep() {
    stars_.for_each_movable(
        threads_, [this](Index v) { relocate(v); }, [] {});
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

  void locate() {
    const Index n = store_.number_of_vertices();
    location_.assign(n, Location());
    for (Index t = 0; t < store_.number_of_slots(); ++t)
      for (int i = 0; i < 4; ++i)
        if (store_.is_alive(t) && store_[t].label[i] != 0)
          for (int c : Store::facet_corners(i))
            location_[store_[t].v[c]].add(store_[t].label[i]);
    for (Index v = 0; v < n; ++v)
      if (location_[v].dimension < 3 && project_.is_fixed(store_.point(v), location_[v].dimension))
        location_[v].dimension = 0;
  }

  void relocate(Index v) {
    const Location& at = location_[v];
    const Vector_3d old = store_.point(v);
    const Normals normals = surface_normals(v);
    Shape_energy here;
    if (!energy(v, old, normals, true, here))
      return;
    const Vector_3d step = at.dimension == 3 ? newton_step(here.hessian, here.gradient)
                           : at.dimension == 2
                               ? tangential_step(here.hessian, here.gradient, normals[0])
                               : step_along(here.hessian, here.gradient, normalized(cross(normals[0], normals[1])));
    backtrack(step, [&](const Vector_3d& s) {
      const Vector_3d moved = old + s, p = project(moved, at);
      // a projection longer than the step has landed on another part of the surface
      if (at.dimension < 3 && squared_norm(p - moved) > squared_norm(s))
        return false;
      Shape_energy there;
      if (!energy(v, p, normals, false, there) || !(there.value < here.value))
        return false;
      store_.move(v, p);
      return true;
    });
  }

  Vector_3d project(const Vector_3d& p, const Location& at) const {
    return at.dimension == 3   ? p
           : at.dimension == 2 ? project_.to_patch(p, at.patch[0])
                               : project_.to_rim(p, at.patch[0], at.patch[1]);
  }

  bool energy(Index v, const Vector_3d& x, const Normals& normals, bool with_derivatives, Shape_energy& e) const {
    const Location& at = location_[v];
    if (pyramids_ != nullptr && !add_pyramid(pyramids_->vertices[v - first_apex()], x, with_derivatives, e))
      return false;
    const Store::Facet_vertices* f = stars_.vertices_of_facets(v);
    for (Index s : stars_.facets(v)) {
      if (!e.add_tetrahedron(x, store_.point((*f)[0]), store_.point((*f)[1]), store_.point((*f)[2]),
                             with_derivatives) ||
          (at.dimension < 3 && !add_triangles(s, x, at, normals, with_derivatives, e)))
        return false;
      ++f;
    }
    return true;
  }

  // Those of the surface, at a vertex of it.
  bool add_triangles(Index facet_of_star, const Vector_3d& x, const Location& at, const Normals& normals,
                     bool with_derivatives, Shape_energy& e) const {
    bool positive = true;
    store_.for_each_labelled_facet(facet_of_star, [&](Index facet, Index a, Index b) {
      const Vector_3d& normal = normals[store_.label(facet) != at.patch[0]];
      positive =
          positive && e.add_triangle(x, store_.point(a), store_.point(b), normal, triangle_weight, with_derivatives);
    });
    return positive;
  }

  Index first_apex() const { return pyramids_->vertices.front()[4]; }
  // That of the four tetrahedra of a pyramid's corners, which cover it twice and hence count half.
  bool add_pyramid(const Element_block<5>::Element& base, const Vector_3d& x, bool with_derivatives,
                   Shape_energy& e) const {
    for (std::size_t i = 0; i < 4; ++i)
      if (!e.add_tetrahedron(x, store_.point(base[(i + 1) % 4]), store_.point(base[i]), store_.point(base[(i + 3) % 4]),
                             with_derivatives))
        return false;
    e.scale(0.5);
    return true;
  }

  // Of the tetrahedra around v, and of the triangles, which count for less as their range is higher.
  double worst_quality(Index v) const {
    double worst = 1;
    for (Index s : stars_.facets(v)) {
      worst = (std::min)(worst, gamma_of(store_, store_[Store::tetrahedron_of(s)].v));
      store_.for_each_labelled_facet(s, [&](Index, Index a, Index b) {
        worst = (std::min)(worst, 0.6 * triangle_gamma(store_.point(v), store_.point(a), store_.point(b)));
      });
    }
    return worst;
  }

  Normals surface_normals(Index v) const {
    const Location& at = location_[v];
    Normals sum;
    if (at.dimension == 3)
      return sum;
    const Vector_3d& p = store_.point(v);
    for (Index s : stars_.facets(v))
      store_.for_each_labelled_facet(s, [&](Index facet, Index a, Index b) {
        sum[store_.label(facet) != at.patch[0]] += cross(store_.point(a) - p, store_.point(b) - p);
      });
    return {normalized(sum[0]), normalized(sum[1])};
  }

  Store& store_;
  const Projection& project_;
  int threads_;
  const Element_block<5>* pyramids_ = nullptr; // those of which the apexes move, if it is these

  Colored_stars stars_;
  std::vector<Location> location_; // of each vertex
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_VERTEX_OPTIMIZER_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_APEX_OPTIMIZER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_APEX_OPTIMIZER_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/Colored_stars.h>
#include <CGAL/Tubular_meshing/Volume/internal/Shape_energy.h>

#include <cstddef>

namespace CGAL::Tubular_meshing::internal {

/* Moves the apexes of pyramids down the shape energy of the tetrahedra around them and of the pyramids themselves, by
 * Newton steps with backtracking: neither is ever inverted. The energy of a pyramid is that of the four tetrahedra of
 * its corners, which cover it twice and hence count half. Apexes are visited color by color, see Vertex_optimizer. */
class Apex_optimizer {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  // The apex of pyramid k is vertex `pyramids.vertices[0][4] + k`.
  Apex_optimizer(Store& store, const Element_block<5>& pyramids, int threads)
      : store_(store)
      , pyramids_(pyramids)
      , first_apex_(pyramids.empty() ? 0 : pyramids.vertices.front()[4])
      , threads_(threads) {
    if (!pyramids.empty())
      stars_.build(store, [this](Index v) { return v >= first_apex_ && v - first_apex_ < pyramids_.size(); });
  }

  // One visit to each apex.
  void sweep() {
    stars_.for_each_movable(
        threads_, [this](Index v) { relocate(v); }, [] {});
  }

private:
  void relocate(Index v) {
    const Vector_3d old = store_.point(v);
    Shape_energy here;
    if (!energy(v, old, true, here))
      return;
    backtrack(newton_step(here.hessian, here.gradient), [&](const Vector_3d& step) {
      Shape_energy there;
      if (!energy(v, old + step, false, there) || !(there.value < here.value))
        return false;
      store_.move(v, old + step);
      return true;
    });
  }

  bool energy(Index v, const Vector_3d& x, bool with_derivatives, Shape_energy& e) const {
    const auto& base = pyramids_.vertices[v - first_apex_];
    for (std::size_t i = 0; i < 4; ++i)
      if (!e.add_tetrahedron(x, store_.point(base[(i + 1) % 4]), store_.point(base[i]), store_.point(base[(i + 3) % 4]),
                             with_derivatives))
        return false;
    e.scale(0.5);
    for (Index s : stars_.facets(v)) {
      const auto f = store_.vertices(s);
      if (!e.add_tetrahedron(x, store_.point(f[0]), store_.point(f[1]), store_.point(f[2]), with_derivatives))
        return false;
    }
    return true;
  }

  Store& store_;
  const Element_block<5>& pyramids_;
  Index first_apex_;
  int threads_;
  Colored_stars stars_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_APEX_OPTIMIZER_H

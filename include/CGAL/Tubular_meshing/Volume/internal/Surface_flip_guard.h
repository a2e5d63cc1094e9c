// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_SURFACE_FLIP_GUARD_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_SURFACE_FLIP_GUARD_H

#include <CGAL/Tubular_meshing/Volume/internal/Patch_projection.h>

#include <algorithm>
#include <cstdint>

namespace CGAL::Tubular_meshing::internal {

/* Says whether a flip on the surface keeps the surface's shape: it may neither fold it nor take it away from the
 * surface it approximates. */
class Surface_flip_guard {
public:
  typedef Tetrahedron_store::Index Index;

  Surface_flip_guard(const Tetrahedron_store& store, const Patch_projection& projection)
      : store_(store)
      , projection_(projection) {}

  // May the edge ab between the facets abc and abd of a patch become the edge cd?
  bool operator()(Index a, Index b, Index c, Index d, std::int32_t patch) const {
    const Vector_3d p = store_.point(a), q = store_.point(b), r = store_.point(c), s = store_.point(d);
    const double before = cosine(cross(q - p, r - p), cross(p - q, s - q));
    const double after = cosine(cross(s - r, p - r), cross(r - s, q - s));
    if (after < 0.8 && after < before)
      return false;
    const double deviation = off_surface(0.5 * (r + s), patch);
    return deviation <= (std::max)(0.1 * norm(s - r), off_surface(0.5 * (p + q), patch));
  }

private:
  static double cosine(const Vector_3d& m, const Vector_3d& n) {
    const double product = norm(m) * norm(n);
    return product > 0 ? dot(m, n) / product : -1;
  }
  double off_surface(const Vector_3d& p, std::int32_t patch) const { return norm(projection_.to_patch(p, patch) - p); }

  const Tetrahedron_store& store_;
  const Patch_projection& projection_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_SURFACE_FLIP_GUARD_H

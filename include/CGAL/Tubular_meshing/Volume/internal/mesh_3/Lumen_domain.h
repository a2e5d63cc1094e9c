// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_LUMEN_DOMAIN_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_LUMEN_DOMAIN_H

#include <CGAL/Tubular_meshing/Volume/internal/mesh_3/Watched_size.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>

namespace CGAL::Tubular_meshing::internal {

/* Mesh_3's domain for a lumen. It reports to the size field how often it is cut: where a surface crosses itself, Mesh_3
 * may choose one facet again and again without a new point, and then asks for no size, but cuts the domain each time. */
class Lumen_domain : public Polyhedral_mesh_domain_with_features_3<Kernel, Surface> {
  typedef Polyhedral_mesh_domain_with_features_3<Kernel, Surface> Base;

public:
  struct Construct_intersection {
    template <class Query> Base::Intersection operator()(const Query& query) const {
      size->note_intersection();
      return intersection(query);
    }
    Base::Construct_intersection intersection;
    const Watched_size* size;
  };

  Lumen_domain(const Surface& surface, const Watched_size& size)
      : Base(surface)
      , size_(&size) {}

  Construct_intersection construct_intersection_object() const {
    return {Base::construct_intersection_object(), size_};
  }

private:
  const Watched_size* size_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_LUMEN_DOMAIN_H

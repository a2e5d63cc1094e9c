// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_FACET_TURNING_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_FACET_TURNING_H

#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstdint>

namespace CGAL::Tubular_meshing::internal {

/* Whether facets of a surface may be replaced by others inside the same rim: those around a vertex that moves or goes,
 * those at an edge that is split. Whatever happens inside the rim, their vector area stays, and none of them may turn
 * far from it. A bound on how far a facet turns in one step would not do: by and by it would turn over. On a curved
 * surface a vertex can slide across the opposite edge of a thin facet, and no tetrahedron is inverted.
 *
 * Facets are of one surface if they have the same label and are seen from the same region. */
class Facet_turning {
public:
  // A facet that goes, by its normal, as long as its area, twice.
  void add(std::int32_t label, std::int32_t region, const Vector_3d& normal) {
    const auto known = find(label, region);
    if (known == areas_.end())
      areas_.push_back({label, region, normal});
    else
      known->area += normal;
  }

  // May a facet with the normal `before` become one with the normal `after`, both of any length? Once all are added.
  bool allows(std::int32_t label, std::int32_t region, const Vector_3d& before, const Vector_3d& after) const {
    const Vector_3d& area = find(label, region)->area;
    const double length = norm(after), length_before = norm(before), along = dot(after, area);
    if (dot(before, after) < least_cosine * length * length_before)
      return false;
    // where it is turned further already, as at a crease, it may not turn any further
    return along >= least_cosine * length * norm(area) || along * length_before >= dot(before, area) * length;
  }

private:
  static constexpr double least_cosine = 0.8;

  struct Area {
    std::int32_t label, region;
    Vector_3d area;
  };
  typedef boost::container::small_vector<Area, 3> Areas;

  Areas::const_iterator find(std::int32_t label, std::int32_t region) const {
    return std::find_if(areas_.begin(), areas_.end(),
                        [=](const Area& a) { return a.label == label && a.region == region; });
  }
  Areas::iterator find(std::int32_t label, std::int32_t region) {
    return std::find_if(areas_.begin(), areas_.end(),
                        [=](const Area& a) { return a.label == label && a.region == region; });
  }

  Areas areas_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_FACET_TURNING_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVER_IN_DELAUNAY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVER_IN_DELAUNAY_H

#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Boundary_in_delaunay.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Recovered_boundary.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline double volume_of(const std::vector<Vector_3d>& points,
                        const std::vector<std::array<std::uint32_t, 4>>& tetrahedra) {
  double volume = 0;
  for (const auto& t : tetrahedra)
    volume += std::abs(signed_volume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]));
  return volume;
}

/* Fills the cavities around what is missing, all at once. recover(boundary, recovered): whether it could. False if they
 * did not get full. */
template <class Recover>
bool fill_cavities(const Cavities& cavities, std::size_t number_of_points, const Recover& recover,
                   Recovered_boundary& recovered) {
  Recovered_boundary filling;
  if (!recover(cavities.boundary, filling))
    return false;
  std::vector<Vector_3d> points = cavities.boundary.points;
  points.insert(points.end(), filling.inner_points.begin(), filling.inner_points.end());
  const double volume = volume_of(cavities.boundary.points, cavities.tetrahedra);
  const double rounding = 1e-9;
  if (std::abs(volume_of(points, filling.tetrahedra) - volume) > rounding * volume)
    return false; // what is between several cavities was filled, too
  for (auto& t : filling.tetrahedra) {
    for (std::uint32_t& v : t)
      v = v < cavities.vertex.size() ? cavities.vertex[v]
                                     : std::uint32_t(number_of_points + v - cavities.vertex.size());
    recovered.tetrahedra.push_back(t);
  }
  recovered.inner_points = std::move(filling.inner_points);
  return true;
}

/* Fills the convex hull of a closed surface with the Delaunay tetrahedra of its points. Where its triangles are small
 * compared with the vessel, few of them are not among their facets [Amenta, Choi, Dey, Leekha 2002]: the tetrahedra that
 * these cross are a cavity, which `recover(boundary, recovered)` fills. False, if so many are missing, or a cavity cannot
 * be filled, that the surface has to be recovered as a whole. */
template <class Recover>
bool recover_in_delaunay(const Boundary_arrays& boundary, int threads, const Recover& recover,
                         Recovered_boundary& recovered) {
  Boundary_in_delaunay delaunay(boundary, threads);
  if (!delaunay.has_all_points() || !delaunay.has_most_triangles())
    return false;
  const Cavities cavities = delaunay.cavities();
  recovered.tetrahedra = delaunay.tetrahedra_outside_cavities();
  return cavities.tetrahedra.empty() || fill_cavities(cavities, boundary.points.size(), recover, recovered);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVER_IN_DELAUNAY_H

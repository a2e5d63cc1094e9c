// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_IMPL_H

#include <CGAL/Tubular_meshing/Patches/pieces/Chart.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Peak_finder.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

CGAL_TUBULAR_MESHING_INLINE std::vector<Plane_point> Patch_chart::hidden_places() const {
  const double prominence = 16; // of an area: there, sizes are a quarter of those on the way
  std::vector<double> density(map_.number_of_vertices(), -1);
  for (int t = 0; t < int(map_.number_of_triangles()); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      double& d = density[std::size_t(map_.patch().triangles[std::size_t(t)][i])];
      if (d >= 0)
        continue;
      Patch_location at;
      at.triangle = t;
      at.barycentric = {{0, 0, 0}};
      at.barycentric[i] = 1;
      d = std::sqrt((std::max)(metric_(at).determinant(), 0.));
    }
  std::vector<Point_2> places;
  for (int v : Peak_finder(density, map_.patch().triangles, map_.patch().loops).find(prominence))
    places.push_back(map_.uv(v));
  return places;
}

CGAL_TUBULAR_MESHING_INLINE Cap_chart::Cap_chart(const std::vector<Point_3>& rim, Metric metric)
    : metric_(metric)
    , origin_(rim.front()) {
  Vector_3d normal, reach;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vector_3d a = Vector_3d(rim[i]) - origin_, b = Vector_3d(rim[(i + 1) % rim.size()]) - origin_;
    normal += cross(a, b);
    if (squared_norm(a) > squared_norm(reach))
      reach = a;
  }
  normal = normalized(normal);
  first_ = normalized(reach - dot(reach, normal) * normal);
  second_ = cross(normal, first_);
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_CHART_IMPL_H

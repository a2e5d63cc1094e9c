// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_LOCAL_RADIUS_H
#define CGAL_TUBULAR_MESHING_LAYERS_LOCAL_RADIUS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>

namespace CGAL::Tubular_meshing::internal {

// The local radius as a function of a point: it is one already, or the radius of centerlines.
template <class LocalRadius> auto radius_function(const LocalRadius& radius) {
  return [&radius](const Point_3& p) { return radius(p); };
}
inline auto radius_function(const Centerline_field& centerlines) {
  return [&centerlines](const Point_3& p) { return centerlines.radius(p); };
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_LOCAL_RADIUS_H

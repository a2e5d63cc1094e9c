// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_POLYGONS_H
#define CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_POLYGONS_H

#include <CGAL/Tubular_meshing/Plane/Plane_store.h>
#include <CGAL/Tubular_meshing/Plane/Plane_triangulation.h>

#include <optional>
#include <string>

namespace CGAL::Tubular_meshing::internal {

/* The constrained Delaunay triangulation of what lies inside the first polygon and outside the others, without new
 * vertices; vertices are numbered as the points come. None if the polygons do not bound a domain, as they touch each
 * other, say; `problem` is a sentence on it then. O(n log n). */
std::optional<Plane_store> triangulate_polygons(const Plane_polygons& polygons, std::string& problem);

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Plane/triangulate_polygons_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_POLYGONS_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_MESHABLE_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_MESHABLE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/crossing_pairs.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* What no mesher can do with: a surface in pieces, or one that intersects itself. Named here, with its place, rather
 * than by a mesher that fails or never ends. */
inline void check_no_crossings(const CGAL::Surface_mesh<Point_3>& surface) {
  const Face_pairs crossings = crossing_pairs(surface);
  if (!crossings.empty())
    throw Input_error("The surface intersects itself: " + std::to_string(crossings.size()) +
                      " pairs of its triangles cross, one of them at " +
                      place_of(surface.point(surface.target(surface.halfedge(crossings.front().first)))) +
                      "; repair it there, or let repair_surface() do it.");
}

inline void check_one_piece(CGAL::Surface_mesh<Point_3>& surface) {
  typedef Surface::Face_index Face;
  auto piece = surface.add_property_map<Face, std::size_t>("f:tubular_meshing_piece").first;
  const std::size_t pieces = CGAL::Polygon_mesh_processing::connected_components(surface, piece);
  std::vector<std::size_t> size(pieces, 0);
  Face stray;
  for (Face f : surface.faces())
    ++size[piece[f]];
  const auto largest = std::size_t(std::max_element(size.begin(), size.end()) - size.begin());
  for (Face f : surface.faces())
    if (piece[f] != largest) {
      stray = f;
      break;
    }
  surface.remove_property_map(piece);
  if (pieces > 1)
    throw Input_error("The surface is in " + std::to_string(pieces) + " pieces, one of them at " +
                      place_of(surface.point(surface.target(surface.halfedge(stray)))) +
                      ": keep one connected wall, or let repair_surface() choose it.");
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_MESHABLE_H

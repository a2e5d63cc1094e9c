// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_CROSSING_PAIRS_IMPL_H
#define CGAL_TUBULAR_MESHING_BASE_CROSSING_PAIRS_IMPL_H

#include <CGAL/Tubular_meshing/base/Crossing_suspects.h>
#include <CGAL/Tubular_meshing/base/crossing_pairs.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <iterator>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE Face_pairs crossing_pairs(const std::vector<Surface::Face_index>& faces,
                                                      const Surface& surface) {
  Face_pairs pairs;
  const std::vector<Surface::Face_index> suspects = Crossing_suspects(faces, surface).faces();
  if (suspects.empty())
    return pairs;
  Polygon_mesh_processing::self_intersections(suspects, surface, std::back_inserter(pairs));
  for (auto& pair : pairs)
    if (pair.second < pair.first)
      std::swap(pair.first, pair.second);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

CGAL_TUBULAR_MESHING_INLINE Face_pairs crossing_pairs(const Surface& surface) {
  return crossing_pairs(std::vector<Surface::Face_index>(surface.faces_begin(), surface.faces_end()), surface);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_CROSSING_PAIRS_IMPL_H

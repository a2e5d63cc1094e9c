// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_FOLLOW_BLIND_VESSELS_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_FOLLOW_BLIND_VESSELS_IMPL_H

#include <CGAL/Tubular_meshing/Patches/follow_blind_vessels.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Blind_vessel_finder.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Cut_surface.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <vector>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE std::vector<Vertex> tips_of_blind_vessels(Surface& surface, Face_patch_map patch,
                                                                      const Centerline_graph& graph) {
  const Cut_surface uncut(surface, patch);
  std::vector<Vertex> tips;
  for (const auto& vessel : Blind_vessel_finder(uncut, graph).find())
    tips.push_back(vessel.tip);
  return tips;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_FOLLOW_BLIND_VESSELS_IMPL_H

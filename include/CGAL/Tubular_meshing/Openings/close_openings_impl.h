// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_CLOSE_OPENINGS_IMPL_H
#define CGAL_TUBULAR_MESHING_OPENINGS_CLOSE_OPENINGS_IMPL_H

#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/internal/Opening_closer.h>
#include <CGAL/Tubular_meshing/Openings/internal/opening_sites.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE std::vector<int> close_openings(Surface& surface, std::vector<Opening>& openings) {
  check_tubular_surface(surface);
  Surface_sites sites = turn_outward_and_find_sites(openings, surface);

  // Labels are kept with the faces until no more of them come and go.
  auto label = surface.add_property_map<Surface::Face_index, int>("f:tubular_meshing_label", labels::wall).first;
  Opening_closer closer(surface);
  for (auto& pinhole : sites.pinholes)
    closer.fill(pinhole);
  for (std::size_t i = 0; i < openings.size(); ++i) {
    Opening_site& site = sites.openings[i];
    closer.close(site);
    for (auto f : site.cap)
      label[f] = openings[i].patch;
    set_shape(openings[i], site.shape, false);
  }
  if (surface.has_garbage())
    surface.collect_garbage();
  std::vector<int> result;
  result.reserve(surface.number_of_faces());
  for (auto f : surface.faces())
    result.push_back(label[f]);
  surface.remove_property_map(label);
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_CLOSE_OPENINGS_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_RIM_POLYLINES_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_RIM_POLYLINES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/property_map.h>

#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

struct Rim_polyline {
  std::vector<Point_3> points; // where closed, the first comes again at the end
  std::set<int> patches;       // the two that meet in it
};

// The closed polylines in which a cap meets the wall.
template <class FacePatchMap>
std::vector<Rim_polyline> rim_polylines(const Surface& surface, const FacePatchMap& patch) {
  typedef Surface::Halfedge_index Halfedge;
  const auto label = [&](Halfedge h) { return get(patch, surface.face(h)); };
  const auto is_rim = [&](Halfedge h) { return label(h) != label(surface.opposite(h)); };
  std::vector<Rim_polyline> rims;
  std::vector<bool> seen(surface.number_of_halfedges(), false);
  for (Halfedge start : surface.halfedges()) {
    // walked on the caps' side, so that each rim comes once
    if (seen[start] || label(start) == labels::wall || !is_rim(start))
      continue;
    Rim_polyline rim = {{surface.point(surface.source(start))}, {label(start), label(surface.opposite(start))}};
    Halfedge h = start;
    do {
      seen[h] = true;
      rim.points.push_back(surface.point(surface.target(h)));
      h = surface.next(h);
      while (!is_rim(h))
        h = surface.next(surface.opposite(h));
    } while (h != start);
    rims.push_back(std::move(rim));
  }
  return rims;
}

struct Rim_points_map {
  typedef Rim_polyline key_type;
  typedef std::vector<Point_3> value_type;
  typedef const value_type& reference;
  typedef boost::readable_property_map_tag category;
  friend reference get(const Rim_points_map&, const Rim_polyline& rim) { return rim.points; }
};

struct Rim_patches_map {
  typedef Rim_polyline key_type;
  typedef std::set<int> value_type;
  typedef const value_type& reference;
  typedef boost::readable_property_map_tag category;
  friend reference get(const Rim_patches_map&, const Rim_polyline& rim) { return rim.patches; }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_RIM_POLYLINES_H

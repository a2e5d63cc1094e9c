// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_OPENING_SITES_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_OPENING_SITES_H

#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/crease_ends.h>
#include <CGAL/Tubular_meshing/Rims/flat_ends.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline void set_shape(Opening& opening, const Rim_shape& shape, bool inside_out) {
  opening.center = shape.center;
  opening.normal = inside_out ? -shape.plane.normal() : shape.plane.normal();
  opening.area = shape.area;
  opening.perimeter = shape.perimeter;
  opening.radius = shape.radius;
}

// Sites by the first coordinate of their centres, to look openings up in.
class Site_index {
public:
  void insert(const Opening_site& site) { by_x_.emplace(site.shape.center.x(), site); }

  /* The site whose centre is that of the opening but for rounding, taken out of the index; false if there is none. */
  bool take(const Opening& opening, Opening_site& site) {
    const double tolerance = 1e-3 * opening.radius;
    auto nearest = by_x_.end();
    for (auto i = by_x_.lower_bound(opening.center.x() - tolerance);
         i != by_x_.end() && i->first <= opening.center.x() + tolerance; ++i)
      if (point_distance(i->second.shape.center, opening.center) <= tolerance &&
          std::abs(i->second.shape.radius - opening.radius) <= tolerance &&
          (nearest == by_x_.end() || point_distance(i->second.shape.center, opening.center) <
                                         point_distance(nearest->second.shape.center, opening.center)))
        nearest = i;
    if (nearest == by_x_.end())
      return false;
    site = std::move(nearest->second);
    by_x_.erase(nearest);
    return true;
  }

  bool empty() const { return by_x_.empty(); }
  const Opening_site& front() const { return by_x_.begin()->second; }

private:
  std::multimap<double, Opening_site> by_x_;
};

// The sites of the openings, in their order. Flat ends are searched for with ever other criteria, as when they were
// found.
inline std::vector<Opening_site> sites_of(const std::vector<Opening>& openings, const std::vector<Opening_site>& loops,
                                          const Surface& surface) {
  std::vector<Opening_site> sites(openings.size());
  std::vector<std::size_t> missing, still_missing;
  Site_index index;
  for (const auto& loop : loops)
    index.insert(loop);
  for (std::size_t i = 0; i < openings.size(); ++i)
    if (!index.take(openings[i], sites[i]))
      missing.push_back(i);
  if (!index.empty())
    throw Input_error("The border loop at " + coordinates(index.front().shape.center) +
                      " is not one of the openings that were given: pass all that find_openings() returns.");
  if (missing.empty())
    return sites;
  Flat_end_finder finder(surface, false);
  for (const Flat_end_criteria& criteria : possible_flat_ends()) {
    Site_index flat_ends;
    for (const auto& end : finder.find(criteria))
      flat_ends.insert(end);
    still_missing.clear();
    for (std::size_t i : missing)
      if (!flat_ends.take(openings[i], sites[i]))
        still_missing.push_back(i);
    missing.swap(still_missing);
    if (missing.empty())
      return sites;
  }
  Site_index creased_ends;
  for (const auto& end : find_crease_ends(surface, false, sites))
    creased_ends.insert(end);
  still_missing.clear();
  for (std::size_t i : missing)
    if (!creased_ends.take(openings[i], sites[i]))
      still_missing.push_back(i);
  if (still_missing.empty())
    return sites;
  throw Input_error("The surface has no opening at " + coordinates(openings[still_missing[0]].center) +
                    ": pass what find_openings() returns for this surface.");
}

/* Where the openings are in a surface that has been turned outward, and the holes of its wall. */
struct Surface_sites {
  std::vector<Opening_site> openings, pinholes;
};

/* Turns the surface outward, and finds the sites of the openings, in their order. */
inline Surface_sites turn_outward_and_find_sites(const std::vector<Opening>& openings, Surface& surface) {
  Surface_sites result;
  std::vector<Opening_site> loops = border_loops(surface);
  if (is_inside_out(surface, loops)) {
    CGAL::Polygon_mesh_processing::reverse_face_orientations(surface);
    loops = border_loops(surface);
  }
  const auto first_pinhole =
      std::stable_partition(loops.begin(), loops.end(), [&](const auto& loop) { return !is_pinhole(loop, surface); });
  result.pinholes.assign(first_pinhole, loops.end());
  loops.erase(first_pinhole, loops.end());
  result.openings = sites_of(openings, loops, surface);
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_OPENING_SITES_H

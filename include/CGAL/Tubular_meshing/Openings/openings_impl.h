// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_OPENINGS_IMPL_H
#define CGAL_TUBULAR_MESHING_OPENINGS_OPENINGS_IMPL_H

#include <CGAL/Tubular_meshing/Openings/internal/match_centerlines.h>
#include <CGAL/Tubular_meshing/Openings/internal/opening_sites.h>
#include <CGAL/Tubular_meshing/Openings/internal/order_openings.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/crease_ends.h>
#include <CGAL/Tubular_meshing/Rims/flat_ends.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline double median_radius(const std::vector<Opening_site>& sites) {
  std::vector<double> radii;
  for (const auto& site : sites)
    radii.push_back(site.shape.radius);
  if (radii.empty())
    return 0;
  std::nth_element(radii.begin(), radii.begin() + radii.size() / 2, radii.end());
  return radii[radii.size() / 2];
}

// Matches the loops to ends of the graph, and adds the flat ends that ends without a loop lead to.
inline std::vector<Centerline_ends::End> match_to_graph(const Surface& surface, const Centerline_graph& graph,
                                                        bool inside_out, std::vector<Opening_site>& sites) {
  Flat_end_finder finder(surface, inside_out);
  const double radius = sites.empty() ? median_radius(finder.find(possible_flat_ends()[0])) : median_radius(sites);
  Centerline_ends ends(graph, radius);
  if (ends.ends().empty())
    return ends.ends();
  ends.match(sites, 0, inside_out);
  for (const Flat_end_criteria& criteria : possible_flat_ends()) {
    if (ends.all_matched())
      break;
    std::vector<Opening_site> extended = sites;
    for (auto& flat_end : finder.find(criteria))
      extended.push_back(std::move(flat_end));
    ends.match(extended, sites.size(), inside_out);
    ends.keep_matched(extended, sites.size());
    sites.swap(extended);
  }
  if (!ends.all_matched()) {
    std::vector<Opening_site> extended = sites;
    for (auto& creased_end : find_crease_ends(surface, inside_out, sites))
      extended.push_back(std::move(creased_end));
    ends.match(extended, sites.size(), inside_out);
    ends.keep_matched(extended, sites.size());
    sites.swap(extended);
  }
  const std::string number = std::to_string(ends.ends().size());
  if (sites.empty())
    throw Input_error("The surface is closed, and none of the " + number +
                      " ends of the centerlines lies at a flat end of it: open the surface at its ends or cap them "
                      "flat, and check that these are its centerlines, in the same unit.");
  if (ends.none_matched())
    throw Input_error("None of the " + number + " ends of the centerlines lies near one of the " +
                      std::to_string(sites.size()) +
                      " openings of the surface: check that these are the centerlines of this surface, in the same "
                      "unit.");
  return ends.ends();
}

inline std::size_t choose_inlet(const std::vector<Opening>& openings, const Find_openings_options& options) {
  if (options.inlet) {
    const Point_3& p = *options.inlet;
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw Parameter_error("The point of the inlet, " + coordinates(p) + ", has to have finite coordinates.");
    return nearest_opening(openings, p);
  }
  const std::size_t root = options.centerline_graph ? options.centerline_graph->root() : Opening::no_branch;
  for (std::size_t i = 0; i < openings.size(); ++i)
    if (root != Opening::no_branch && openings[i].node == root)
      return i;
  return largest_opening(openings);
}

// From a point to an opening's rim and cap.
inline double distance_to_site(const Point_3& p, const Opening_site& site, const Surface& surface) {
  double least = point_distance(p, site.shape.center);
  for (Face f : site.cap)
    for (Vertex v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      least = (std::min)(least, point_distance(p, surface.point(v)));
  return least;
}

// Of the sites, takes those out that are to stay closed.
inline void leave_blind_ends(const std::vector<Point_3>& blind_ends, const Surface& surface,
                             std::vector<Opening_site>& sites) {
  for (const Point_3& p : blind_ends) {
    auto nearest = sites.end();
    double least = 1; // radius
    for (auto site = sites.begin(); site != sites.end(); ++site) {
      const double d = distance_to_site(p, *site, surface) / site->shape.radius;
      if (d <= least) {
        least = d;
        nearest = site;
      }
    }
    if (nearest == sites.end())
      continue; // a round end, or none
    if (!nearest->is_open())
      sites.erase(nearest);
    else
      throw Input_error("The end at " + coordinates(p) +
                        " is to stay closed, but the surface is open there: have that hole filled.");
  }
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Opening> find_unordered_openings(const Surface& surface,
                                                                         const Find_openings_options& options) {
  check_tubular_surface(surface);
  std::vector<Opening_site> sites = border_loops(surface);
  const bool inside_out = is_inside_out(surface, sites);
  sites.erase(std::remove_if(sites.begin(), sites.end(), [&](const auto& site) { return is_pinhole(site, surface); }),
              sites.end());

  std::vector<Centerline_ends::End> ends;
  if (options.centerline_graph)
    ends = match_to_graph(surface, *options.centerline_graph, inside_out, sites);
  if (ends.empty()) {
    for (auto& flat_end : Flat_end_finder(surface, inside_out).find(certain_flat_end()))
      sites.push_back(std::move(flat_end));
    for (auto& creased_end : find_crease_ends(surface, inside_out, sites))
      sites.push_back(std::move(creased_end));
    leave_blind_ends(options.blind_ends, surface, sites);
  }

  std::vector<Opening> openings(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
    set_shape(openings[i], sites[i].shape, inside_out);
  for (const auto& end : ends)
    if (end.site != Centerline_ends::none) {
      openings[end.site].branch = end.branch;
      openings[end.site].node = end.node;
    }
  return openings;
}

CGAL_TUBULAR_MESHING_INLINE void order_from_inlet(std::vector<Opening>& openings,
                                                  const Find_openings_options& options) {
  if (!openings.empty())
    order_openings(openings, choose_inlet(openings, options));
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Opening> find_any_openings(const Surface& surface,
                                                                   const Find_openings_options& options) {
  std::vector<Opening> openings = find_unordered_openings(surface, options);
  order_from_inlet(openings, options);
  return openings;
}

CGAL_TUBULAR_MESHING_INLINE void check_not_closed(const std::vector<Opening>& openings) {
  if (openings.empty())
    throw Input_error("The surface is closed and has no flat ends, so that nothing can flow through it: open it where "
                      "vessels begin and end, cap these ends flat, have round ends cut open, or give the points "
                      "(seeds) at which they are.");
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Opening> find_openings(const Surface& surface,
                                                               const Find_openings_options& options) {
  std::vector<Opening> openings = find_any_openings(surface, options);
  check_not_closed(openings);
  return openings;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_OPENINGS_IMPL_H

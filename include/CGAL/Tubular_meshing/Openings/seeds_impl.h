// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_SEEDS_IMPL_H
#define CGAL_TUBULAR_MESHING_OPENINGS_SEEDS_IMPL_H

#include <CGAL/Tubular_meshing/Openings/internal/Tip_finder.h>
#include <CGAL/Tubular_meshing/Openings/internal/order_openings.h>
#include <CGAL/Tubular_meshing/Openings/seeds.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE void order_openings_or_seeds(std::vector<Opening>& openings,
                                                         const std::vector<Point_3>& seeds,
                                                         Find_openings_options options) {
  if (seeds.empty())
    check_not_closed(openings);
  else
    options.inlet = seeds.front();
  for (const Point_3& p : seeds)
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw Parameter_error("The seed " + coordinates(p) + " has to have finite coordinates.");
  order_from_inlet(openings, options);
}

// Within an opening's rim, also where that is an ellipse, or the point was picked a little outside.
inline bool lies_at(const Point_3& seed, const Opening& opening) {
  const double reach = 1.5 * opening.radius;
  return (seed - opening.center).squared_length() <= reach * reach;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<std::pair<Point_3, int>>
ends_of_lines(const std::vector<Opening>& openings, const std::vector<Point_3>& seeds, bool one_will_do) {
  std::vector<std::pair<Point_3, int>> ends;
  for (const Opening& o : openings)
    ends.emplace_back(o.center, o.patch);
  for (std::size_t i = 0; i < seeds.size(); ++i)
    if (openings.empty() || !lies_at(seeds[i], openings[nearest_opening(openings, seeds[i])])) {
      ends.emplace_back(seeds[i], int(labels::wall));
      if (i == 0)
        std::rotate(ends.begin(), ends.end() - 1, ends.end());
    }
  if (ends.size() < 2 && !one_will_do)
    throw Input_error("The vessels have one end only, at " + coordinates(ends.front().first) +
                      ", so that nothing can flow through them: open the surface where they end, give the points "
                      "(seeds) at which they do, have round ends cut open, or allow a single opening.");
  return ends;
}

CGAL_TUBULAR_MESHING_INLINE Point_3 farthest_point(const Surface& surface, const Face_patch_map& patch, int opening) {
  std::vector<Surface::Vertex_index> source;
  for (auto f : surface.faces())
    if (patch[f] == opening)
      for (auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
        source.push_back(v);
  return surface.point(Tip_finder(surface).farthest_from(source));
}

CGAL_TUBULAR_MESHING_INLINE std::vector<std::size_t> nodes_at(const Centerline_graph& graph,
                                                              const std::vector<Opening>& openings) {
  std::vector<std::size_t> ends, found;
  for (std::size_t n = 0; n < graph.nodes().size(); ++n)
    if (graph.nodes()[n].is_end() || n == graph.root()) // several may leave a wide inlet
      ends.push_back(n);
  for (const Opening& o : openings) {
    const auto away = [&](std::size_t n) {
      return (graph.points()[graph.nodes()[n].point] - o.center).squared_length();
    };
    const auto nearest =
        std::min_element(ends.begin(), ends.end(), [&](std::size_t m, std::size_t n) { return away(m) < away(n); });
    const bool is_there = nearest != ends.end() && away(*nearest) <= o.radius * o.radius;
    found.push_back(is_there ? *nearest : Opening::no_branch);
  }
  return found;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_SEEDS_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_CUT_ROUND_ENDS_IMPL_H
#define CGAL_TUBULAR_MESHING_OPENINGS_CUT_ROUND_ENDS_IMPL_H

#include <CGAL/Tubular_meshing/Openings/cut_round_ends.h>
#include <CGAL/Tubular_meshing/Openings/internal/Round_end_cutter.h>
#include <CGAL/Tubular_meshing/Openings/internal/Vessel_ends.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Rims/crease_ends.h>
#include <CGAL/Tubular_meshing/Rims/flat_ends.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline Round_end_report report_of(const Vessel_ends::End& end, const char* reason) {
  return {false, end.shape.center(), end.shape.radius(), reason};
}

// The capped ends that would be openings if they were not to stay closed.
inline std::vector<Round_end_report> kept_caps(const Surface& surface, const std::vector<Point_3>& blind_ends) {
  if (blind_ends.empty())
    return {};
  Find_openings_options but_for_blind_ends;
  but_for_blind_ends.blind_ends = blind_ends;
  const std::vector<Opening> openings = find_any_openings(surface, but_for_blind_ends);
  std::vector<Round_end_report> kept;
  for (const Opening& o : find_any_openings(surface, Find_openings_options()))
    if (std::none_of(openings.begin(), openings.end(),
                     [&](const Opening& p) { return point_distance(o.center, p.center) < 1e-6 * o.radius; }))
      kept.push_back({false, o.center, o.radius, "kept"});
  return kept;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Round_end_report> cut_round_ends(Surface& surface,
                                                                         const Cut_round_ends_options& options) {
  Vessel_ends ends(surface);
  ends.find(options);
  Round_end_cutter cutter(surface);
  std::vector<Round_end_report> reports;
  for (const Vessel_ends::End& end : ends.ends()) {
    if (!end.is_named && !options.all_round_ends)
      continue;
    if (!end.is_named && (end.is_kept || end.is_sac)) {
      reports.push_back(report_of(end, end.is_kept ? "kept" : "sac"));
      continue;
    }
    Round_end_report cut;
    if (cutter.cut(end.shape, end.tip, end.is_named, cut))
      reports.push_back(cut);
    else if (const auto at_wall = end.is_named ? ends.cap_at(end.named_by) : std::nullopt;
             at_wall && cutter.cut(at_wall->shape, at_wall->tip, true, cut))
      reports.push_back(cut);
    else if (end.is_named)
      throw Input_error("The vessel's end at " + coordinates(end.shape.center()) +
                        " cannot be cut open by a plane across it: cut the surface open there.");
    else
      reports.push_back(report_of(end, "cannot be cut"));
  }
  if (surface.has_garbage())
    surface.collect_garbage();
  return reports;
}

// Whether programs or persons have closed ends by domes: then some may meet the wall in a crease, and others go over into
// it smoothly.
inline bool has_creased_ends(const Surface& surface, const std::vector<Opening>& openings) {
  if (openings.empty() || !CGAL::is_closed(surface))
    return false;
  const bool inside_out = is_inside_out(surface, {});
  for (const Opening_site& site :
       find_crease_ends(surface, inside_out, Flat_end_finder(surface, inside_out).find(certain_flat_end())))
    for (const Opening& o : openings)
      if (point_distance(site.shape.center, o.center) < 1e-6 * o.radius)
        return true;
  return false;
}

// What is to be cut of a surface with these openings.
inline Cut_round_ends_options ends_to_open(const Surface& surface, const std::vector<Point_3>& points,
                                           const std::vector<Point_3>& blind_ends,
                                           const std::vector<Opening>& openings) {
  Cut_round_ends_options options;
  options.blind_ends = blind_ends;
  options.all_round_ends = points.empty() && (openings.empty() || has_creased_ends(surface, openings));
  for (const Point_3& p : points)
    if (std::none_of(openings.begin(), openings.end(),
                     [&](const Opening& o) { return point_distance(p, o.center) <= 1.5 * o.radius; }))
      options.ends_to_cut.push_back(p);
  return options;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<Round_end_report>
open_round_ends(Surface& surface, const std::vector<Point_3>& points, const std::vector<Point_3>& blind_ends,
                std::optional<std::vector<Opening>>& openings) {
  Find_openings_options but_for_blind_ends;
  but_for_blind_ends.blind_ends = blind_ends;
  openings = find_unordered_openings(surface, but_for_blind_ends);
  const Cut_round_ends_options options = ends_to_open(surface, points, blind_ends, *openings);
  if (!options.all_round_ends && options.ends_to_cut.empty())
    return kept_caps(surface, blind_ends); // of every surface with openings
  openings.reset();
  return cut_round_ends(surface, options);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_CUT_ROUND_ENDS_IMPL_H

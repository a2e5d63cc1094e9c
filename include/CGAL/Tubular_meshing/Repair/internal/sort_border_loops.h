// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SORT_BORDER_LOOPS_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SORT_BORDER_LOOPS_H

#include <CGAL/Tubular_meshing/Repair/Repair_report.h>
#include <CGAL/Tubular_meshing/Repair/internal/report_orientation.h>
#include <CGAL/Tubular_meshing/Repair/internal/wall_holes.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The border loops of a surface, by what they are. */
struct Border_loops {
  std::vector<Opening_site> openings, possible_openings, pinholes;
  std::vector<Opening_site> chosen_holes; ///< to be filled, as the user says
};

/* Whether a point was meant for a loop: it is within the rim, or was picked a little outside. */
inline bool is_at(const Point_3& p, const Opening_site& loop) {
  return point_distance(p, loop.shape.center) <= 1.5 * loop.shape.radius;
}

inline std::size_t nearest_loop(const Point_3& p, const std::vector<Opening_site>& loops) {
  return std::size_t(std::min_element(loops.begin(), loops.end(),
                                      [&](const Opening_site& a, const Opening_site& b) {
                                        return CGAL::squared_distance(a.shape.center, p) <
                                               CGAL::squared_distance(b.shape.center, p);
                                      }) -
                     loops.begin());
}

/* The loops nearest to the points, which are to be filled. */
inline std::vector<bool> chosen_loops(const std::vector<Opening_site>& loops, const std::vector<Point_3>& points) {
  std::vector<bool> chosen(loops.size(), false);
  for (const Point_3& p : points) {
    const std::size_t i = loops.empty() ? 0 : nearest_loop(p, loops);
    if (loops.empty() || point_distance(p, loops[i].shape.center) > 2 * loops[i].shape.reach)
      throw Input_error("No loop of the border is near the point " + coordinates(p) +
                        ", at which a hole is to be "
                        "filled" +
                        (loops.empty() ? std::string(": the surface is closed.")
                                       : ": the nearest is at " + coordinates(loops[i].shape.center) + ", of radius " +
                                             short_number(loops[i].shape.radius) + "."));
    chosen[i] = true;
  }
  return chosen;
}

/* Sorts the loops of a mesh that is turned outward; what the user says of them counts first. */
inline Border_loops sort_border_loops(const Surface& mesh, const std::vector<Point_3>& filled_holes,
                                      const std::vector<Point_3>& kept_openings) {
  Border_loops sorted;
  Loop_classifier classifier(mesh);
  std::vector<Opening_site> loops = border_cycles(mesh);
  const std::vector<bool> chosen = chosen_loops(loops, filled_holes);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    Opening_site& loop = loops[i];
    if (chosen[i]) {
      sorted.chosen_holes.push_back(std::move(loop));
      continue;
    }
    const bool is_kept = loop.shape.radius > 0 && std::any_of(kept_openings.begin(), kept_openings.end(),
                                                              [&](const Point_3& p) { return is_at(p, loop); });
    const Loop_kind kind = is_kept ? Loop_kind::opening : classifier.classify(loop);
    if (kind == Loop_kind::torn_wall)
      throw Input_error("The wall is torn at " + coordinates(loop.shape.center) + ": the hole there, of radius " +
                        short_number(loop.shape.radius) +
                        ", is too large to be closed by guessing, and too thin or too bent for the opening of a "
                        "vessel. Have it filled, by its place, or cut the vessel open there.");
    (kind == Loop_kind::pinhole            ? sorted.pinholes
     : kind == Loop_kind::possible_opening ? sorted.possible_openings
                                           : sorted.openings)
        .push_back(std::move(loop));
  }
  return sorted;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SORT_BORDER_LOOPS_H

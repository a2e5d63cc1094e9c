// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_REPAIR_REPORT_H
#define CGAL_TUBULAR_MESHING_REPAIR_REPAIR_REPORT_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingRepair
 *
 * What repair_surface() may find wrong with a surface, and what it does about it. */
enum class Surface_defect {
  duplicate_points,    ///< points of equal coordinates, merged
  duplicate_triangles, ///< triangles with the same three corners, all but one removed
  collapsed_triangles, ///< triangles with two equal corners, removed
  nonmanifold_edges,   ///< edges of more than two triangles: the fins and membranes that end there are removed
  nonmanifold_points,  ///< points at which the surface touches itself, doubled
  seam_gaps,           ///< borders that nearly coincide, sewn together
  turned_triangles,    ///< triangles against the orientation of their neighbours, turned
  inside_out,          ///< a surface whose normals point into the lumen, turned
  islands,             ///< components that are no vessels, or more than were wanted, removed
  crossing_parts,      ///< vessels that crossed each other, united
  parts_inside,        ///< components inside of another one, removed
  needle_triangles,    ///< triangles of (nearly) no area, collapsed or flipped away
  pinholes,            ///< holes of the wall, small against the local radius, filled
  filled_holes,        ///< larger ones, filled as asked for
  possible_openings,   ///< loops that may be openings or holes, taken for openings: reported only
  spikes,              ///< vertices thrown far out of the wall around them, put back into it
  self_intersections,  ///< triangles that cross each other, smoothed or replaced
  folds,               ///< edges at which the surface turns back on itself, smoothed or replaced
  handles,             ///< where vessels split and rejoin, or touch and are fused: reported only
  noise,               ///< the surface was smoothed, as asked for
  wrapped              ///< the surface was replaced by an alpha wrap around it
};

/*! The name of a defect, as in JSON: `"pinholes"`. */
inline std::string name_of(Surface_defect defect) {
  static const char* const names[] = {"duplicate_points",
                                      "duplicate_triangles",
                                      "collapsed_triangles",
                                      "nonmanifold_edges",
                                      "nonmanifold_points",
                                      "seam_gaps",
                                      "turned_triangles",
                                      "inside_out",
                                      "islands",
                                      "crossing_parts",
                                      "parts_inside",
                                      "needle_triangles",
                                      "pinholes",
                                      "filled_holes",
                                      "possible_openings",
                                      "spikes",
                                      "self_intersections",
                                      "folds",
                                      "handles",
                                      "noise",
                                      "wrapped"};
  return names[std::size_t(defect)];
}

/*! Whether a finding is but a note: the shape and the openings of the surface are as they were. */
inline bool is_note(Surface_defect defect) {
  return defect == Surface_defect::duplicate_points || defect == Surface_defect::inside_out ||
         defect == Surface_defect::handles || defect == Surface_defect::possible_openings;
}

/*! One kind of repair that was done. For JSON: `name_of(defect)`, `count`, `size`, and `place` if `has_place`. */
struct Repair {
  Surface_defect defect;
  std::size_t count = 0; ///< of the points, triangles, edges, gaps, holes, islands or handles concerned
  double size = 0;       ///< the largest extent concerned, in the unit of the surface; 0 if it has none
  bool has_place = false;
  Point_3 place;        ///< of the first or largest one, if `has_place`
  std::string sentence; ///< what was done, for the person at the keyboard
};

/*! \ingroup PkgTubularMeshingRepair
 *
 * What repair_surface() has done, in the order in which it was done. */
struct Repair_report {
  std::vector<Repair> repairs;

  /// Whether nothing was wrong: then the surface is as it was read.
  bool empty() const { return repairs.empty(); }

  /// How many of a kind there were.
  std::size_t count(Surface_defect defect) const {
    std::size_t n = 0;
    for (const auto& r : repairs)
      n += r.defect == defect ? r.count : 0;
    return n;
  }

  /// One sentence a repair, one line each.
  std::string text() const {
    std::string lines;
    for (const auto& r : repairs)
      lines += r.sentence + "\n";
    return lines;
  }

  void add(Surface_defect defect, std::size_t count, double size, const std::string& sentence) {
    Repair r;
    r.defect = defect;
    r.count = count;
    r.size = size;
    r.sentence = sentence;
    repairs.push_back(r);
  }
  void add(Surface_defect defect, std::size_t count, double size, const std::string& sentence, const Point_3& place) {
    add(defect, count, size, sentence);
    repairs.back().has_place = true;
    repairs.back().place = place;
  }
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_REPAIR_REPAIR_REPORT_H

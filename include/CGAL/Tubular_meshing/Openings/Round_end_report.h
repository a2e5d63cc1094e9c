// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_ROUND_END_REPORT_H
#define CGAL_TUBULAR_MESHING_OPENINGS_ROUND_END_REPORT_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingOpenings
 *
 * The options of cut_round_ends(): its named parameters of the same names. */
struct Cut_round_ends_options {
  std::vector<Point_3> ends_to_cut; ///< points: the vessel's end nearest to each is cut open
  std::vector<Point_3> blind_ends;  ///< points: the vessel's end nearest to each stays as it is
  bool all_round_ends = true;       ///< whether those are cut that no point names

  Cut_round_ends_options() = default;
  template <class NamedParameters>
  explicit Cut_round_ends_options(const NamedParameters& np)
      : ends_to_cut(internal::choose(np, internal_np::ends_to_cut, std::vector<Point_3>()))
      , blind_ends(internal::choose(np, internal_np::blind_ends, std::vector<Point_3>()))
      , all_round_ends(internal::choose(np, internal_np::all_round_ends, true)) {}
};

/*! \ingroup PkgTubularMeshingOpenings
 *
 * What cut_round_ends() has done with the end of a vessel. */
struct Round_end_report {
  bool is_cut;
  Point_3 center;     ///< of the new opening; of the last ball in the end, if it is not cut
  double radius;      ///< of the vessel there
  std::string reason; ///< why it is not cut: "sac", "kept", "cannot be cut"
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_OPENINGS_ROUND_END_REPORT_H

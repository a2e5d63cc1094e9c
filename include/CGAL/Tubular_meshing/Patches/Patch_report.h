// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PATCH_REPORT_H
#define CGAL_TUBULAR_MESHING_PATCHES_PATCH_REPORT_H

#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPatches
 *
 * How a surface was cut into patches and these were mapped onto the plane: what went as it should, and where another
 * way had to be taken.
 */
struct Patch_report {
  std::map<Patch_kind, std::size_t> kinds;                ///< number of patches of each kind
  std::map<Parameterization_method, std::size_t> methods; ///< number of patches mapped by each method
  double largest_aspect_ratio = 0;                        ///< of a patch: length over mean diameter
  std::size_t moved_cuts = 0;        ///< disks that were moved or tilted, as they did not close where they were wanted
  std::size_t handle_cuts = 0;       ///< cuts round handles of the wall through which no disk goes
  std::size_t refined_patches = 0;   ///< patches and caps meshed finer than asked for: they met themselves or
                                     ///< others, or had triangles that were turned over
  std::size_t smoothed_places = 0;   ///< where faces met each other at any size, and were smoothed
  std::vector<std::string> problems; ///< what the cut could not do, a sentence each

  std::size_t number_of_patches() const {
    std::size_t n = 0;
    for (const auto& k : kinds)
      n += k.second;
    return n;
  }
  /// The number of patches for which the conformal map alone was no bijection.
  std::size_t number_of_fallbacks() const {
    const auto conformal = methods.find(Parameterization_method::conformal);
    return number_of_patches() - (conformal == methods.end() ? 0 : conformal->second);
  }
};

/*! \ingroup PkgTubularMeshingPatches
 * The report on a cut and the parameterizations of its patches. */
inline Patch_report patch_report(const Surface_cut& cut, const std::vector<Patch_parameterization>& maps) {
  Patch_report report;
  for (const auto& patch : cut.patches) {
    ++report.kinds[patch.kind];
    report.largest_aspect_ratio = (std::max)(report.largest_aspect_ratio, patch.aspect_ratio());
  }
  for (const auto& map : maps)
    ++report.methods[map.method()];
  report.moved_cuts = cut.moved_cuts;
  report.handle_cuts = cut.handle_cuts;
  for (const auto& problem : cut.problems)
    report.problems.push_back(problem.message());
  return report;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_PATCH_REPORT_H

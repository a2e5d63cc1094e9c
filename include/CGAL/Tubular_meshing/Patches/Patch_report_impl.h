// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PATCH_REPORT_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_PATCH_REPORT_IMPL_H

#include <CGAL/Tubular_meshing/Patches/Patch_report.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <algorithm>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE Patch_report patch_report(const Surface_cut& cut,
                                                      const std::vector<Patch_parameterization>& maps) {
  Patch_report report;
  for (const auto& patch : cut.patches) {
    ++report.kinds[patch.kind];
    report.largest_aspect_ratio = (std::max)(report.largest_aspect_ratio, patch.aspect_ratio());
  }
  for (const auto& map : maps)
    ++report.methods[map.method()];
  report.moved_cuts = cut.moved_cuts;
  for (const auto& problem : cut.problems)
    report.problems.push_back(problem.message());
  return report;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_PATCH_REPORT_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_MESH_REPORT_IMPL_H
#define CGAL_TUBULAR_MESHING_QUALITY_MESH_REPORT_IMPL_H

#include <CGAL/Tubular_meshing/Quality/Mesh_check_impl.h>
#include <CGAL/Tubular_meshing/Quality/internal/Finite_volumes.h>
#include <CGAL/Tubular_meshing/Quality/internal/Matched_faces.h>
#include <CGAL/Tubular_meshing/Quality/mesh_report.h>
#include <CGAL/Tubular_meshing/Quality/quality_report_impl.h>
#include <CGAL/Tubular_meshing/Quality/validity_report_impl.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <cstddef>

namespace CGAL::Tubular_meshing::internal {

// The one beside the other, as parts of each are done by one thread.
CGAL_TUBULAR_MESHING_INLINE Mesh_report mesh_report_on(int threads, const Mixed_mesh& mesh, const Mesh_check& check) {
  const bool is_known = check.is_of(mesh, threads);
  const Matched_faces matched = is_known ? Matched_faces(mesh, check.impl_->matched)
                                         : Matched_faces(mesh, cells::Face_buckets::with_facets, threads);
  Mesh_report report;
  for_each_task(2, threads, [&](std::size_t which) {
    if (which == 1) {
      Finite_volumes volumes(matched, threads);
      report.quality = Quality_reporter(mesh, nullptr, threads).report(volumes);
    } else if (is_known) {
      report.validity = check.validity();
      report.validity.inverted_cells = number_of_inverted_cells(mesh, threads); // points may have moved
    } else {
      report.validity = validity_of(matched, threads);
    }
  });
  return report;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUALITY_MESH_REPORT_IMPL_H

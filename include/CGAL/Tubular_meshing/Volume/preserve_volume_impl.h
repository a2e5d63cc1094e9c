// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_PRESERVE_VOLUME_IMPL_H
#define CGAL_TUBULAR_MESHING_VOLUME_PRESERVE_VOLUME_IMPL_H

#include <CGAL/Tubular_meshing/Volume/internal/preserving/Boundary_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Input_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Shift_holder.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Wall_shifter.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/hold_shifts_back.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/shifts_of_all.h>
#include <CGAL/Tubular_meshing/Volume/preserve_volume.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline std::map<int, double> opening_areas(const Surface& surface, Face_patch_map patch) {
  std::map<int, Vector_3d> areas;
  for (auto f : surface.faces())
    if (patch[f] != labels::wall) {
      const auto h = surface.halfedge(f);
      const Vector_3d origin(surface.point(surface.target(h)));
      for (auto g : surface.halfedges_around_face(h))
        areas[patch[f]] += 0.5 * cross(Vector_3d(surface.point(surface.source(g))) - origin,
                                       Vector_3d(surface.point(surface.target(g))) - origin);
    }
  std::map<int, double> result;
  for (const auto& a : areas)
    result[a.first] = norm(a.second);
  return result;
}

inline Shift_holder wanted_shifts(const Surface& mesh, Face_patch_map patch, const Input_surface& input, int threads) {
  const std::vector<Vector_3d> to = Wall_shifter(mesh, patch, input, threads).run();
  std::vector<Vector_3d> from, shift;
  for (auto v : mesh.vertices()) {
    from.emplace_back(mesh.point(v));
    shift.push_back(to[std::size_t(v)] - from.back());
  }
  return Shift_holder(std::move(from), std::move(shift));
}

inline void describe(const Surface& mesh, Face_patch_map patch, const Shift_holder& shifts,
                     Preserve_volume_report& report) {
  report.volume = enclosed_volume(mesh);
  report.area = opening_areas(mesh, patch);
  report.largest_shift = shifts.largest();
  report.held_back = shifts.number_held_back();
}

CGAL_TUBULAR_MESHING_INLINE Preserve_volume_report preserve_volume(Surface& mesh, Face_patch_map mesh_patch,
                                                                   const Surface& input, Face_patch_map input_patch,
                                                                   const Preserve_volume_options& options) {
  const Input_surface truth(input, input_patch, options.number_of_threads);
  Preserve_volume_report report;
  report.input_volume = truth.volume();
  report.volume_before = enclosed_volume(mesh);
  Shift_holder shifts = wanted_shifts(mesh, mesh_patch, truth, options.number_of_threads);
  move_without_crossings(mesh, shifts, options.number_of_threads);
  describe(mesh, mesh_patch, shifts, report);
  return report;
}

CGAL_TUBULAR_MESHING_INLINE Preserve_volume_report preserve_volume(Mixed_mesh& mesh, const Surface& input,
                                                                   Face_patch_map input_patch, Length_function radius,
                                                                   const Preserve_volume_options& options) {
  const Input_surface truth(input, input_patch, options.number_of_threads);
  Boundary_surface boundary(mesh);
  Preserve_volume_report report;
  report.input_volume = truth.volume();
  report.volume_before = enclosed_volume(boundary.surface);
  Shift_holder of_boundary = wanted_shifts(boundary.surface, boundary.patch, truth, options.number_of_threads);
  move_without_crossings(boundary.surface, of_boundary, options.number_of_threads);
  Shift_holder shifts = shifts_of_all(mesh, boundary, of_boundary, truth, radius, options.number_of_threads);
  keep_cells(mesh, Kept_of_cells(), options.number_of_threads, shifts);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    mesh.points[i] = shifts.point(i);
  boundary.follow(mesh);
  describe(boundary.surface, boundary.patch, shifts, report);
  report.held_back += of_boundary.number_held_back();
  return report;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_PRESERVE_VOLUME_IMPL_H

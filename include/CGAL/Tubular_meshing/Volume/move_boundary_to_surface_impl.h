// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_MOVE_BOUNDARY_TO_SURFACE_IMPL_H
#define CGAL_TUBULAR_MESHING_VOLUME_MOVE_BOUNDARY_TO_SURFACE_IMPL_H

#include <CGAL/Tubular_meshing/Volume/internal/preserving/Boundary_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Input_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Shift_holder.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/hold_shifts_back.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/shifts_of_all.h>
#include <CGAL/Tubular_meshing/Volume/move_boundary_to_surface.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where the vertices of a mesh's boundary are to go. */
class Surface_seeker {
public:
  Surface_seeker(const Boundary_surface& boundary, const Input_surface& input)
      : input_(input)
      , vertices_(boundary.surface.number_of_vertices()) {
    const Surface& s = boundary.surface;
    for (auto v : s.vertices())
      vertices_[std::size_t(v)].point = Vector_3d(s.point(v));
    for (auto f : s.faces()) {
      const bool is_wall = boundary.patch[f] == labels::wall;
      for (auto h : s.halfedges_around_face(s.halfedge(f))) {
        Vertex& v = vertices_[std::size_t(s.target(h))];
        if (!is_wall) {
          v.opening = v.opening == 0 || v.opening == boundary.patch[f] ? boundary.patch[f] : between_openings;
          continue;
        }
        v.is_on_wall = true;
        const Vector_3d before = Vector_3d(s.point(s.source(h))) - v.point;
        const Vector_3d after = Vector_3d(s.point(s.target(s.next(h)))) - v.point;
        v.normal += cross(after, before);
        v.reach = (std::max)({v.reach, norm(before), norm(after)});
      }
    }
  }

  /* The shifts of all vertices, 0 of those that stay. */
  std::vector<Vector_3d> shifts(int threads, std::size_t& not_found) {
    std::vector<Vector_3d> result(vertices_.size());
    std::vector<char> is_lost(vertices_.size(), 0);
    for_each_range(vertices_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        if (!vertices_[i].is_on_wall || vertices_[i].opening == between_openings)
          continue;
        const std::optional<Vector_3d> place = place_of_vertex(vertices_[i]);
        is_lost[i] = !place;
        if (place)
          result[i] = *place - vertices_[i].point;
      }
    });
    not_found = std::size_t(std::count(is_lost.begin(), is_lost.end(), 1));
    return result;
  }

private:
  static constexpr int between_openings = -1;

  struct Vertex {
    Vector_3d point, normal; // the latter of any length
    double reach = 0;
    int opening = 0; // whose facets it is on, or 0
    bool is_on_wall = false;
  };

  std::optional<Vector_3d> place_of_vertex(const Vertex& v) const {
    if (v.opening == 0)
      return input_.nearest_on_wall(v.point, normalized(v.normal), v.reach);
    const Input_surface::Opening* o = input_.opening(v.opening);
    return o == nullptr ? std::nullopt : Input_surface::nearest_on_rim(*o, v.point, v.reach);
  }

  const Input_surface& input_;
  std::vector<Vertex> vertices_;
};

CGAL_TUBULAR_MESHING_INLINE Move_boundary_to_surface_report
move_boundary_to_surface(Mixed_mesh& mesh, const Surface& input, Face_patch_map input_patch, Length_function radius,
                         const Move_boundary_to_surface_options& options) {
  const Input_surface truth(input, input_patch, options.number_of_threads);
  Boundary_surface boundary(mesh);
  Move_boundary_to_surface_report report;
  std::vector<Vector_3d> from;
  for (auto v : boundary.surface.vertices())
    from.emplace_back(boundary.surface.point(v));
  Shift_holder of_boundary(std::move(from),
                           Surface_seeker(boundary, truth).shifts(options.number_of_threads, report.not_found));
  move_without_crossings(boundary.surface, of_boundary, options.number_of_threads);
  Shift_holder shifts = shifts_of_all(mesh, boundary, of_boundary, truth, radius, options.number_of_threads);
  // Cells that are flattened are optimized afterwards, where they can be: they need not be good here.
  Kept_of_cells kept;
  kept.volume = 0.05;
  kept.shape = false;
  keep_cells(mesh, kept, options.number_of_threads, shifts);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    mesh.points[i] = shifts.point(i);
  report.largest_shift = shifts.largest();
  report.held_back = shifts.number_held_back() + of_boundary.number_held_back();
  return report;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_MOVE_BOUNDARY_TO_SURFACE_IMPL_H

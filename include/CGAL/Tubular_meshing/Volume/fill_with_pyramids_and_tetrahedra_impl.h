// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_PYRAMIDS_AND_TETRAHEDRA_IMPL_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_PYRAMIDS_AND_TETRAHEDRA_IMPL_H

#include <CGAL/Tubular_meshing/Volume/fill_with_pyramids_and_tetrahedra.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Filled_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/optimize_inside.h>
#include <CGAL/Tubular_meshing/Volume/internal/pyramids/Size_near_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/pyramids/crown_quads.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE void check_keeps_boundary(Volume_mesher mesher) {
  if (mesher == Volume_mesher::mesh_3)
    throw Meshing_error(
        "The tetrahedra between pyramids need a mesher that keeps their sides: build this program where CMake finds "
        "TetGen (libtet1.5-dev), or CGAL 6.1 or later, and choose one of these.");
}

inline Element_block<5> pyramids_on(const Element_block<4>& quads, std::size_t first_apex) {
  Element_block<5> pyramids;
  pyramids.reserve(quads.size());
  for (std::size_t k = 0; k < quads.size(); ++k) {
    const auto& q = quads.vertices[k]; // counterclockwise from outside, the pyramid's base from inside
    pyramids.push_back({q[0], q[3], q[2], q[1], std::uint32_t(first_apex + k)}, labels::lumen);
  }
  return pyramids;
}

// Fills what the pyramids leave with tetrahedra. Where pyramids meet, which make_room() leaves to chance in the
// narrowest gaps only, they make way for each other, and it is tried again.
inline void fill_between_pyramids(Crowned_surface& crowned, Length_function size, const Boundary_recovery& recovery,
                                  const Filling_limits& limits, Filled_surface& result) {
  const auto fill = [&] { return result.fill(crowned.surface(), crowned.patch(), size, recovery, limits); };
  std::optional<Sentence> failure = fill();
  if (failure && crowned.make_way())
    failure = fill();
  if (failure)
    throw Meshing_error(*failure);
}

CGAL_TUBULAR_MESHING_INLINE void
fill_with_pyramids_and_tetrahedra(const Surface& surface, Face_patch_map patch, Length_function size, Mixed_mesh& mesh,
                                  const Fill_with_pyramids_and_tetrahedra_options& options) {
  check_keeps_boundary(options.volume_mesher);
  Mixed_mesh boundary;
  surface_to_mixed_mesh(surface, patch, boundary);
  Crowned_surface crowned = crown_quads(boundary, options.split_quads);

  const Filling_limits limits(options, crowned.surface(), "repair the surface, or mesh it finer");
  Filled_surface filling;
  const Size_near_surface graded(size, boundary);
  fill_between_pyramids(crowned, graded, recovery_by(options.volume_mesher), limits, filling);
  Element_block<5> pyramids = pyramids_on(boundary.quads, boundary.points.size());
  optimize_inside(filling.tetrahedra(), options.optimization_passes, options.number_of_threads, pyramids);
  Mixed_mesh result;
  filling.write_to(result);
  result.pyramids = std::move(pyramids);
  result.triangles = std::move(boundary.triangles);
  result.quads = std::move(boundary.quads);
  mesh = std::move(result);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_PYRAMIDS_AND_TETRAHEDRA_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_REQUESTS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_REQUESTS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Size_requests.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <string>

namespace CGAL::Tubular_meshing::internal {

/* Requests that would do nothing are mistakes: a branch that is not there, a ball outside of the lumen. */
inline void check_requests(const Size_requests& requests, const Tubular_model& model) {
  const std::size_t branches = model.centerlines.branches().size();
  for (const Size_requests::Branch& b : requests.branches)
    if (b.branch >= branches)
      throw Parameter_error("There is no branch " + std::to_string(b.branch) + " to refine: there are " +
                            std::to_string(branches) + ", counted from 0.");
  if (requests.balls.empty())
    return;
  const Wall_distance wall(model.surface, model.patch, labels::wall);
  const Centerline_field centerlines(model.centerlines);
  for (const Size_requests::Ball& b : requests.balls) {
    const Point_3 on_wall = wall.closest_point(b.center), on_line = centerlines.descriptors(on_wall).point;
    const bool outside = squared_distance(b.center, on_line) > squared_distance(on_wall, on_line);
    if (outside && squared_distance(b.center, on_wall) > b.radius * b.radius)
      throw Parameter_error(Sentence("The ball at ") + place_of(b.center) +
                            " in which the mesh is to be refined does not reach the lumen: check its place and "
                            "radius.");
  }
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_REQUESTS_H

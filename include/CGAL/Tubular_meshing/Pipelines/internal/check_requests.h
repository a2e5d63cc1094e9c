// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_REQUESTS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_REQUESTS_H

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Size_requests.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Side_of_triangle_mesh.h>

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
  const Wall_distance distance(model.surface);
  const Side_of_triangle_mesh<Surface, Kernel> side(model.surface);
  for (const Size_requests::Ball& b : requests.balls)
    if (side(b.center) == ON_UNBOUNDED_SIDE && distance(b.center) > b.radius)
      throw Parameter_error(Sentence("The ball at ") + place_of(b.center) +
                            " in which the mesh is to be refined does not reach the lumen: check its place and "
                            "radius.");
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_REQUESTS_H

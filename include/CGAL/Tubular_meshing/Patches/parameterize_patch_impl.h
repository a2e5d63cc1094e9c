// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZE_PATCH_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZE_PATCH_IMPL_H

#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Edge_halver.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Filled_patch.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Patch_mapper.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

inline void check_patch(const Indexed_patch& patch) {
  for (std::size_t i = 0; i < patch.points.size(); ++i) {
    const Vector_3d p(patch.points[i]);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw Input_error("Point " + std::to_string(i) + " of a patch is not finite; correct or remove it.");
  }
  const int n = int(patch.points.size());
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    const auto& t = patch.triangles[i];
    for (int v : t)
      if (v < 0 || v >= n)
        throw Input_error("Triangle " + std::to_string(i) + " of a patch has the vertex " + std::to_string(v) +
                          ", but there are " + std::to_string(n) + " points; correct the triangle.");
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      throw Input_error("Triangle " + std::to_string(i) + " of a patch has the same vertex twice; remove it.");
  }
  for (const auto& loop : patch.loops) {
    if (loop.size() < 3)
      throw Input_error("A loop of a patch has " + std::to_string(loop.size()) + " vertices; it needs three or more.");
    for (int v : loop)
      if (v < 0 || v >= n)
        throw Input_error("A loop of a patch has the vertex " + std::to_string(v) + ", but there are " +
                          std::to_string(n) + " points; take border_loops().");
  }
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Patch_parameterization parameterize_patch(Indexed_patch patch,
                                                                      Parameterization_method first_method) {
  internal::check_patch(patch);
  internal::Divided_patch divided(std::move(patch));
  const std::size_t most_triangles = 1000 + 8 * divided.patch.triangles.size();
  for (int most_divisions = 6;; --most_divisions) {
    const internal::Filled_patch filled(divided.patch);
    internal::Patch_mapper mapper(filled);
    mapper.map_conformally();
    const std::vector<char> wide = mapper.wide_halfedges();
    if (!wide.empty() && most_divisions > 0 && filled.own_triangles < most_triangles) {
      internal::Edge_halver(divided).run(filled.opposite, wide);
      continue;
    }
    const Parameterization_method method = mapper.make_bijective(first_method);
    std::vector<Eigen::Vector2d> uv(mapper.uv().begin(), mapper.uv().begin() + std::ptrdiff_t(filled.own_points));
    return Patch_parameterization(std::move(divided), std::move(uv), method, mapper.number_of_flips());
  }
}

namespace internal {

CGAL_TUBULAR_MESHING_INLINE std::vector<Patch_parameterization>
parameterize_patches(const Surface& surface, const Surface_cut& cut, const Parameterize_patches_options& options) {
  std::vector<Patch_parameterization> result(cut.patches.size());
  for_each_task(cut.patches.size(), options.number_of_threads, [&](std::size_t i) {
    result[i] = parameterize_patch(make_indexed_patch(surface, cut.patches[i], cut.curves));
  });
  return result;
}

} // namespace internal

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZE_PATCH_IMPL_H

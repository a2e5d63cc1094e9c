// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZE_PATCH_H
#define CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZE_PATCH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/Indexed_patch.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Filled_patch.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Patch_mapper.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Edge_halver.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
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

/*! \ingroup PkgTubularMeshingRef
 *
 * Maps a patch, a sphere with one hole or more, onto the plane (section 2.3 of the paper): one to one, and conformally
 * where that is possible.
 *
 * - *Tubes* (two loops) go onto a ring: exp(h + iθ), with h harmonic and constant on both loops and θ its conjugate,
 *   each one sparse symmetric system of finite elements. However long the tube is, triangles keep their shapes, and
 *   coordinates their relative precision.
 * - *Junctions* (more loops) likewise: the longest loop is the outer circle, the second longest the inner one, and the
 *   others are filled by fans of triangles first, which are left out afterwards.
 * - *Disks* (one loop) go onto the unit disk: the ring without the triangles around an inner vertex tells where the
 *   border goes on the circle, and coordinates are harmonic inside.
 *
 * Edges of tubes and junctions that reach further than an eighth of the way around, or as far along, are halved first:
 * on triangles that wide, no linear map is near the conformal one. The surface stays what it is.
 *
 * Then every triangle must be counterclockwise in the plane, decided exactly, and no loop may meet itself; which makes
 * the map a bijection. Where triangles are very obtuse or tubes have few sides, some may be flipped. Then the vertices
 * around them are moved into means of their neighbours (mean value coordinates). If that fails, all vertices inside of
 * the circle are, with holes filled, by cotangent weights bounded from below, by mean value coordinates, or by equal
 * weights; and at last by weights under which long blind branches, which shrink exponentially, do so less. Each of
 * these is a bijection in exact arithmetic, as the circle is convex (M. S. Floater, *One-to-one piecewise linear
 * mappings over triangulations*, Math. Comp. 72, 2003). The result says which method was taken.
 *
 * About O(n^1.5). Several threads may call it at once, for different patches or the same one.
 *
 * \param patch its loops must be all of its border: those of border_loops()
 * \param first_method the method to begin with; those before it are left out
 *
 * \throws Input_error if the triangles are no oriented manifold, or refer to points that are not there
 * \throws Meshing_error if the patch is closed or no sphere with holes, or no method gives a bijection in floating
 *   point arithmetic
 */
inline Patch_parameterization
parameterize_patch(Indexed_patch patch, Parameterization_method first_method = Parameterization_method::conformal) {
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

/*! \ingroup PkgTubularMeshingRef
 *
 * Maps all patches of a cut surface onto the plane, each by parameterize_patch() of its make_indexed_patch(): loop i of
 * a parameterization is the patch's loop i, and the input triangle i its face i.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{threads that map patches at the same time; 0: as many as
 * there are cores} \cgalParamDefault{0} \cgalParamNEnd \cgalNamedParamsEnd
 *
 * \returns one parameterization a patch, the same for any number of threads
 *
 * \throws Input_error, Meshing_error as parameterize_patch() does
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Patch_parameterization>
parameterize_patches(const CGAL::Surface_mesh<Point_3>& surface, const Surface_cut& cut,
                     const NamedParameters& np = CGAL::parameters::default_values()) {
  std::vector<Patch_parameterization> result(cut.patches.size());
  internal::for_each_task(
      cut.patches.size(), internal::choose(np, internal_np::number_of_threads, 0),
      [&](std::size_t i) { result[i] = parameterize_patch(make_indexed_patch(surface, cut.patches[i], cut.curves)); });
  return result;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZE_PATCH_H

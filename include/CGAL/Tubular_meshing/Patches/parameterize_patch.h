// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZE_PATCH_H
#define CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZE_PATCH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/Indexed_patch.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <vector>

namespace CGAL::Tubular_meshing {
/*! \ingroup PkgTubularMeshingPatches
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
Patch_parameterization parameterize_patch(Indexed_patch patch,
                                          Parameterization_method first_method = Parameterization_method::conformal);

/*! \ingroup PkgTubularMeshingPatches
 * The named parameters of parameterize_patches(). */
struct Parameterize_patches_options {
  int number_of_threads = 0; ///< 0: as many as there are cores

  Parameterize_patches_options() = default;
  template <class NamedParameters>
  explicit Parameterize_patches_options(const NamedParameters& np)
      : number_of_threads(internal::choose(np, internal_np::number_of_threads, 0)) {}
};

namespace internal {
std::vector<Patch_parameterization> parameterize_patches(const Surface& surface, const Surface_cut& cut,
                                                         const Parameterize_patches_options& options);
} // namespace internal

/*! \ingroup PkgTubularMeshingPatches
 *
 * Maps all patches of a cut surface onto the plane, each by parameterize_patch() of its make_indexed_patch(): loop i of
 * a parameterization is the patch's loop i, and the input triangle i its face i.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{threads that map patches at the same time; 0: as many as there are cores}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \returns one parameterization a patch, the same for any number of threads
 *
 * \throws Input_error, Meshing_error as parameterize_patch() does
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Patch_parameterization>
parameterize_patches(const Surface& surface, const Surface_cut& cut,
                     const NamedParameters& np = CGAL::parameters::default_values()) {
  return internal::parameterize_patches(surface, cut, Parameterize_patches_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/parameterize_patch_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZE_PATCH_H

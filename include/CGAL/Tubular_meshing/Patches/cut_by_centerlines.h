// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_CUT_BY_CENTERLINES_H
#define CGAL_TUBULAR_MESHING_PATCHES_CUT_BY_CENTERLINES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL::Tubular_meshing {
/*! \ingroup PkgTubularMeshingPatches
 * The named parameters of cut_by_centerlines(). */
struct Cut_by_centerlines_options {
  double aspect_ratio = 4; ///< the largest one of a patch, length over mean diameter; 1 or more

  Cut_by_centerlines_options() = default;
  template <class NamedParameters>
  explicit Cut_by_centerlines_options(const NamedParameters& np)
      : aspect_ratio(internal::choose(np, internal_np::aspect_ratio, 4.)) {}
};

namespace internal {
/* `clearance`: by how many radii of a branch its cuts are farther from junctions than where its tube begins. */
Surface_cut cut_by_centerlines(Surface& surface, const Centerline_graph& graph, Face_patch_map patch,
                               const Cut_by_centerlines_options& options, double clearance = 0);
} // namespace internal

/*! \ingroup PkgTubularMeshingPatches
 *
 * The cut operator (Algorithm 2 and section 2.3 of the paper): cuts the wall of a tree by disks across its branches
 * into patches that can be mapped onto the plane, each of moderate aspect ratio.
 *
 * - *Where.* Each branch is cut off its junctions where its own tube begins: about where its centerline leaves the ball
 *   inscribed at the bifurcation, at the first disk that is not widened by the junction any more. Branches are then
 *   divided into parts, equally long in local diameters, of aspect ratio length / (min radius + max radius) ≤ 4. A
 *   branch no longer than its junctions stays with them, if their patch is not too long then; two bifurcations close to
 * each other are parted by one cut, or share their junction. Cycles of the graph are cut twice at least.
 * - *How.* A disk is perpendicular to the centerline. It is bounded by that closed curve of its plane's section with
 *   the surface that goes round the centerline; the curve is followed from triangle to triangle, and only triangles on
 *   it are divided. Where it passes an edge within a quarter of an end, it goes through the vertex instead, so that no
 *   slivers arise. Vertices do not move, and new ones are on edges: the shape stays what it is.
 * - *Handles.* A patch of positive genus that is left is cut round its handles until it is planar: along level curves of
 *   harmonic functions, which are smooth and never part the patch, \cgalCite{erickson2005} finding the handles. It then
 *   lies on both sides of the curve.
 * - *When it cannot.* A disk is refused if its curve runs over a cap, meets another cut, or goes round other
 *   centerlines than its own. It is then moved along the branch, or tilted, until it is not. What fails still is
 *   listed in the result, with its place.
 *
 * Junctions have three loops or more; tubes, with or without an aneurysm's sac, have two; blind ends have one, and are
 * disks. Whether every patch is a sphere with its holes is verified, and listed if not. So are vessels that have no
 * centerline, as those that end blind do unless they are given a seed: they stay with the patch that they leave.
 *
 * The result does not depend on the unit, the position or the direction of the surface, but for rounding.
 *
 * O(n log n) in the sizes of the surface and the graph, for search trees, and O(sections) for the disks tried, about a
 * dozen for each cut: no cut looks at the whole surface. A cut round a handle takes O(n log n) in the size of its patch,
 * and one sparse linear system.
 *
 * \param surface a closed triangle mesh, turned outwards: that of a Tubular_model. Its faces are divided; garbage, if
 *   it has some, is collected before, which changes descriptors. Gets the property map `f:surface_patch`.
 *   The result refers to it: a mesh of another type is to be copied into a Surface first, by `CGAL::copy_face_graph()`
 * \param graph its centerlines, with their radii, the ends at the openings: those of a Tubular_model
 * \param patch a property map from face to int: `labels::wall`, or the label of the face's opening. New faces get the
 *   label of the face that they are part of
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{aspect_ratio}
 *     \cgalParamDescription{the largest aspect ratio of a patch, length over mean diameter, 1 or more}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{4}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \returns patches, their curves, and what could not be done
 *
 * \throws Input_error if the surface is not closed or has no wall, or the graph is empty or lacks radii
 * \throws Parameter_error if the aspect ratio is less than 1
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
Surface_cut cut_by_centerlines(Surface& surface, const Centerline_graph& graph, Face_patch_map patch,
                               const NamedParameters& np = CGAL::parameters::default_values()) {
  return internal::cut_by_centerlines(surface, graph, patch, Cut_by_centerlines_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_CUT_BY_CENTERLINES_H

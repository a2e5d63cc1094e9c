// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_PATCHES_H
#define CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_PATCHES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <type_traits>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuads
 *
 * The options of quadrangulate_patches(): its named parameters. */
struct Quadrangulate_patches_options {
  bool quad_caps = false;
  int number_of_threads = 0;

  Quadrangulate_patches_options() = default;
  template <class NamedParameters>
  explicit Quadrangulate_patches_options(const NamedParameters& np)
      : quad_caps(internal::choose(np, internal_np::quad_caps, false))
      , number_of_threads(internal::choose(np, internal_np::number_of_threads, 0)) {}
};

namespace internal {

Remeshed_surface quadrangulate_patches(const Surface& surface, const Surface_cut& cut,
                                       const std::vector<Patch_parameterization>& maps, Length_function size,
                                       const Quadrangulate_patches_options& options);

/* The same, with the points of some curves as they are given: those of the others are empty. Along the rims among them,
 * the quads' vertices are these points; each patch needs an even number on its loops. */
Remeshed_surface quadrangulate_patches(const Surface& surface, const Surface_cut& cut,
                                       const std::vector<Patch_parameterization>& maps, Length_function size,
                                       const Quadrangulate_patches_options& options,
                                       const std::vector<std::vector<Curve_position>>& given);

/* Measures the shapes of the wall's quads in the surface's report, as when they have moved. */
void measure_quads(Remeshed_surface& surface);

} // namespace internal

/*! \ingroup PkgTubularMeshingQuads
 *
 * meshes a cut surface again, with quads alone (section 2.5 of the paper): its wall; caps get triangles, unless quads
 * are wanted there too.
 *
 * Annular patches are covered by structured grids, see elliptic_grid(), with the same even number of points all along a
 * branch, see quadrangulate_annular_patches(). The other patches, junctions first of all, and those whose grids would
 * fold, get unstructured quads: points are packed along a field of crosses that follows the loops,
 * \cgalCite{remacle2013}, their triangles are recombined, see recombine_triangles(), and cleaned up, locally and by
 * one-defect remeshing, \cgalCite{bunin2006}; vertices are moved on the surface for better quads. Curves' points stay,
 * but where quads beside them are bad.
 *
 * As patches share the points of their curves, the result is conforming. It is closed, manifold, turned outward, and
 * free of self-intersections, whichever diagonal its quads are split by; where pieces would meet themselves or each
 * other, they are meshed again with smaller sizes. Quads are convex: their corners turn the way that the surface does.
 *
 * \param surface the surface that was cut
 * \param cut its patches, see cut_by_centerlines()
 * \param maps their parameterizations, see parameterize_patches()
 * \param size a function object: the wanted length of edges at a `Point_3`, such as a Centerline_sizing_field. Several
 *   threads call it at once
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{quad_caps}
 *     \cgalParamDescription{whether caps are made of quads, too}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{threads that mesh patches at the same time; 0: as many as there are cores. The result does
 *       not depend on it}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \returns the surface with the labels of its patches; its member `quads` is the report on them
 *
 * About O(n log n) in the number of quads, and that of vertices on curves.
 *
 * \throws Input_error if there is not one parameterization a patch
 * \throws Meshing_error if a patch cannot be meshed by quads, or they meet each other even where they are eight times
 *   finer, or this program was built without LEMON, see has_lemon()
 */
template <class SizingField, class NamedParameters = CGAL::parameters::Default_named_parameters>
Remeshed_surface quadrangulate_patches(const Surface& surface, const Surface_cut& cut,
                                       const std::vector<Patch_parameterization>& maps, const SizingField& size,
                                       const NamedParameters& np = CGAL::parameters::default_values()) {
  return internal::quadrangulate_patches(surface, cut, maps, internal::Field_at_point<SizingField>(size),
                                         Quadrangulate_patches_options(np));
}

/*! \ingroup PkgTubularMeshingQuads
 *
 * The same for a closed, labelled surface and its centerlines: cuts it, maps its patches, and meshes them, with the
 * mesh size h = 2 π r / N of a Centerline_sizing_field.
 *
 * \param surface a model of `MutableFaceGraph`, of triangles, closed. It is cut: its faces are divided. What is no
 *   Surface is replaced by a copy
 * \param patch a property map from its faces to `int`: `labels::wall`, or the label of an opening
 * \param graph its centerlines with their radii
 * \param np an optional sequence of named parameters: those of Centerline_sizing_field, of cut_by_centerlines(), and of
 *   the other overload
 *
 * \throws Input_error, Meshing_error, Parameter_error as these do
 */
template <class FaceGraph, class FacePatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
Remeshed_surface quadrangulate_patches(FaceGraph& surface, FacePatchMap patch, const Centerline_graph& graph,
                                       const NamedParameters& np = CGAL::parameters::default_values()) {
  if constexpr (internal::is_core_surface<FaceGraph, NamedParameters> &&
                std::is_same<FacePatchMap, Face_patch_map>::value) {
    const Centerline_sizing_field size(Centerline_field(graph), Wall_distance(surface, patch, labels::wall), np);
    const Surface_cut cut = cut_by_centerlines(surface, graph, patch, np);
    return quadrangulate_patches(surface, cut, parameterize_patches(surface, cut, np), size, np);
  } else {
    Labelled_surface copy = internal::labelled_copy(surface, patch, np);
    Remeshed_surface result = quadrangulate_patches(copy.surface, copy.patch, graph, np);
    internal::copy_from_core(copy.surface, copy.patch, surface, patch, np);
    return result;
  }
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quads/quadrangulate_patches_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUADS_QUADRANGULATE_PATCHES_H

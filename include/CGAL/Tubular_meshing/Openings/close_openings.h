// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_CLOSE_OPENINGS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_CLOSE_OPENINGS_H

#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* The labels of the faces, in the order of the faces. */
std::vector<int> close_openings(Surface& surface, std::vector<Opening>& openings);

} // namespace internal

/*!
 * \ingroup PkgTubularMeshingOpenings
 *
 * The close-volume operator (section 2.3 of the paper): closes a tubular surface by planar caps, and labels its faces.
 *
 * - A border loop that sags by at most a fifth of its radius is moved onto the mean plane of its vertices, along the
 *   plane's normal; the displacement fades out in the wall within four times its size. Triangles with two edges on
 *   the loop are removed before.
 * - Where the loop sags more, or where moving it would fold a triangle or make the surface intersect itself, the tube
 *   is trimmed by a parallel plane as much further in as needed, at first 5 % of the radius below the loop's lowest
 *   vertex. If that is in vain, as the loop is too ragged to have a direction, by a plane across the wall behind it.
 * - The planar rim is filled with its constrained Delaunay triangulation: no vertex is added, straight and non-convex
 *   rims are fine.
 * - Caps that the surface has already are moved onto their mean plane, and keep their triangles. If these would fold,
 *   the cap is replaced.
 * - A triangle or two missing in a smooth wall (see find_openings()) are filled as they are, as wall.
 *
 * Afterwards the surface is closed, its faces are oriented outwards (all are reversed, if they were not), each cap is
 * planar up to rounding (about 1e-15 of the largest coordinate), and `openings` describe the caps: centre, normal,
 * area, perimeter and radius are those of the polygon that is the cap. Their order, labels and ends do not change.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph`; a Surface is changed in place
 * \tparam FacePatchMap a model of `WritablePropertyMap` from the faces of the mesh to `int`
 *
 * \param surface a triangle mesh, manifold, as given to find_openings(). Descriptors are not kept, as garbage is
 *   collected; property maps of a Surface are, with default values for new elements.
 * \param openings what find_openings() has returned for this surface
 * \param patch receives labels::wall, or the label of the face's opening
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices of `surface`}
 *     \cgalParamType{a model of `ReadWritePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error as find_openings() does, and if the openings are not those of the surface
 * \throws Meshing_error if an opening cannot be closed without folding the wall. A Surface is then partly closed.
 *
 * Complexity: a linear pass over the surface, and O(k log k) in the number of faces within about a radius of openings.
 */
template <class TriangleMesh, class FacePatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
void close_openings(TriangleMesh& surface, std::vector<Opening>& openings, FacePatchMap patch,
                    const NamedParameters& np = CGAL::parameters::default_values()) {
  if constexpr (internal::is_core_surface<TriangleMesh, NamedParameters>) {
    const std::vector<int> labels = internal::close_openings(surface, openings);
    auto label = labels.begin();
    for (auto f : surface.faces())
      put(patch, f, *label++);
  } else {
    Labelled_surface closed;
    internal::copy_to_core(surface, closed.surface, np);
    close_openings(closed.surface, openings, closed.patch);
    internal::copy_from_core(closed.surface, closed.patch, surface, patch, np);
  }
}

} // namespace Tubular_meshing
} // namespace CGAL

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Openings/close_openings_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_OPENINGS_CLOSE_OPENINGS_H

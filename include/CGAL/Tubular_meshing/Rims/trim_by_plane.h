// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_TRIM_BY_PLANE_H
#define CGAL_TUBULAR_MESHING_RIMS_TRIM_BY_PLANE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/*
 * Cuts the part off a triangulated surface that lies above a plane and is connected to a set of vertices, and leaves a
 * planar border there: the way to give an opening an exactly planar rim, and to open a closed end.
 *
 * What goes is everything that the seed reaches through vertices with a positive height over the plane, whatever else
 * the plane crosses elsewhere. Small islands below the plane within that part (noise, a folded rim) go with it. Only
 * the triangles that the plane crosses there are split. Where the plane crosses an edge within a tenth of its length
 * from one of its vertices, that vertex is moved to the crossing instead, unless this would turn or flatten a triangle,
 * so that no slivers arise. All vertices of the new border have a height over the plane of rounding size, about
 * 1e-16 x the largest coordinate.
 *
 * Nothing is changed, and a null halfedge is returned, if the cut would not be one simple closed loop, in particular
 * - if a seed is below the plane, unless it is on the border and nearer to it than a tenth of its shortest edge (it is
 *   then moved onto the plane),
 * - if a border other than the seed's would be cut or removed (the plane's upper side leads to another opening),
 * - if the part to remove reaches farther than `reach` from `origin`,
 * - if the plane cuts that part in several loops that do not enclose small islands.
 *
 * If the border of the seed lies in the plane already, no face is changed and a halfedge of it is returned.
 *
 * Removed elements are only marked as such: call `mesh.collect_garbage()` after the last of a series of cuts.
 * New vertices and faces have the default values of all property maps. Indices of elements that remain are stable,
 * but a halfedge of a split edge may be either of its parts.
 *
 * \param mesh a triangle mesh, manifold; what is outside the part that goes and its rim is neither read nor changed
 * \param origin a point of the plane
 * \param normal its normal, of any length; the side it points to is removed
 * \param seeds vertices of the side to remove; for an opening, all vertices of its border
 * \param reach how far from `origin` the part to remove may reach, in the unit of the mesh
 * \return a border halfedge of the new loop, or `null_halfedge()`
 *
 * Complexity: linear in the number of faces removed and split (expected, as it hashes).
 */
Halfedge trim_by_plane(Surface& mesh, const Point_3& origin, const Vector_3& normal, const std::vector<Vertex>& seeds,
                       double reach = (std::numeric_limits<double>::infinity)());

/* As above; the seeds are the vertices of the border that `seed` is on, or its target if it is not a border halfedge.
 */
Halfedge trim_by_plane(Surface& mesh, const Point_3& origin, const Vector_3& normal, Halfedge seed,
                       double reach = (std::numeric_limits<double>::infinity)());

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Rims/trim_by_plane_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_RIMS_TRIM_BY_PLANE_H

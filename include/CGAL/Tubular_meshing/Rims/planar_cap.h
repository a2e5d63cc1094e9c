// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_PLANAR_CAP_H
#define CGAL_TUBULAR_MESHING_RIMS_PLANAR_CAP_H

#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Triangle_soup.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The triangles of the constrained Delaunay triangulation of some points of the plane, as indices, counterclockwise,
 * that are not reached from outside without crossing a constraint. Constraints must not cross. O(n log n). */
std::vector<Index_triangle> triangulate_inside(const std::vector<Kernel::Point_2>& points,
                                               const std::vector<std::array<std::size_t, 2>>& constraints);

/* The constrained Delaunay triangulation of the inside of a polygon, as indices of its vertices, counterclockwise;
 * empty if the polygon is not simple and counterclockwise. Vertices on straight sides are used. O(n log n). */
std::vector<Index_triangle> triangulate_polygon(const std::vector<Kernel::Point_2>& polygon);

void remove_faces(const std::vector<Face>& faces, Surface& mesh);

/* Fills a border loop with the triangulation of its projection onto a plane. Returns no faces, and leaves the mesh as
 * it is, if the projection is not a simple polygon, or an edge that it needs is in the wall already. */
std::vector<Face> fill_loop(const std::vector<Halfedge>& rim, const Rim_plane& plane, Surface& mesh);

/* Removes triangles with two edges on the loop, the ears: once the rim is in a plane such a triangle lies in it too,
 * and on the cap. Returns the new loop; it keeps at least three edges. */
std::vector<Halfedge> peel_ears(std::vector<Halfedge> rim, Surface& mesh);

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Rims/planar_cap_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_RIMS_PLANAR_CAP_H

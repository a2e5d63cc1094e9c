// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INDEXED_PATCH_H
#define CGAL_TUBULAR_MESHING_PATCHES_INDEXED_PATCH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>

#include <array>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPatches
 *
 * A patch of a surface on its own: points, triangles that are counterclockwise seen from outside, and the loops that
 * bound it, each in the order in which the patch is on the left of one who walks along it outside.
 */
struct Indexed_patch {
  std::vector<Point_3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::vector<int>> loops;
};

/*! \ingroup PkgTubularMeshingPatches
 *
 * The loops that bound a set of triangles, in the order of their smallest vertices, each from its smallest vertex on.
 * O(n log n).
 *
 * \throws Input_error if an edge has more than two triangles, or a vertex is on the border twice
 */
std::vector<std::vector<int>> border_loops(const Indexed_patch& patch);

/*! \ingroup PkgTubularMeshingPatches
 *
 * Some faces of a surface as an Indexed_patch, with its border_loops(). Triangle i is `faces[i]`, points are in the
 * order of the surface's vertices. O(n log n) in the size of the patch. Several threads may call it at once.
 *
 * \param surface of triangles
 * \param faces some of its faces
 * \param vertices if given, gets the surface's vertex of each point
 */
Indexed_patch make_indexed_patch(const Surface& surface, const std::vector<Surface::Face_index>& faces,
                                 std::vector<Surface::Vertex_index>* vertices = nullptr);

/*! \ingroup PkgTubularMeshingPatches
 *
 * A patch of a Surface_cut as an Indexed_patch, whose loop i is `patch.loops[i]`. Loops begin with their curve's first
 * vertex, whatever their direction is: edge i of a curve is edge i of the loop that has the patch on the curve's left,
 * and edge n − 1 − i, the other way round, of the loop that has it on the right. Where the patch is on both sides of a
 * curve, it is open there: the curve's vertices are there twice, those on its right after all others.
 */
Indexed_patch make_indexed_patch(const Surface& surface, const Surface_patch& patch,
                                 const std::vector<Cut_curve>& curves,
                                 std::vector<Surface::Vertex_index>* vertices = nullptr);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/Indexed_patch_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_INDEXED_PATCH_H

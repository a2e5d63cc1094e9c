// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INDEXED_PATCH_H
#define CGAL_TUBULAR_MESHING_PATCHES_INDEXED_PATCH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * A patch of a surface on its own: points, triangles that are counterclockwise seen from outside, and the loops that
 * bound it, each in the order in which the patch is on the left of one who walks along it outside.
 */
struct Indexed_patch {
  std::vector<Point_3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::vector<int>> loops;
};

/*! \ingroup PkgTubularMeshingRef
 *
 * The loops that bound a set of triangles, in the order of their smallest vertices, each from its smallest vertex on.
 * O(n log n).
 *
 * \throws Input_error if an edge has more than two triangles, or a vertex is on the border twice
 */
inline std::vector<std::vector<int>> border_loops(const Indexed_patch& patch) {
  const std::vector<int> opposite = internal::opposite_halfedges(patch.triangles);
  std::vector<int> successor(patch.points.size(), -1);
  for (int h = 0; h < int(opposite.size()); ++h) {
    if (opposite[std::size_t(h)] >= 0)
      continue;
    int& after = successor[std::size_t(internal::source_of(patch.triangles, h))];
    if (after >= 0)
      throw Input_error("The border of a patch passes vertex " +
                        std::to_string(internal::source_of(patch.triangles, h)) +
                        " of the patch twice; repair the surface first (repair_surface()).");
    after = internal::target_of(patch.triangles, h);
  }
  std::vector<std::vector<int>> loops;
  for (int v = 0; v < int(successor.size()); ++v) {
    if (successor[std::size_t(v)] < 0)
      continue;
    loops.emplace_back();
    for (int w = v; successor[std::size_t(w)] >= 0;) {
      loops.back().push_back(w);
      const int after = successor[std::size_t(w)];
      successor[std::size_t(w)] = -1;
      w = after;
    }
  }
  return loops;
}

/*! \ingroup PkgTubularMeshingRef
 *
 * Some faces of a surface as an Indexed_patch, with its border_loops(). Triangle i is `faces[i]`, points are in the
 * order of the surface's vertices. O(n log n) in the size of the patch. Several threads may call it at once.
 *
 * \param surface of triangles
 * \param faces some of its faces
 * \param vertices if given, gets the surface's vertex of each point
 */
inline Indexed_patch make_indexed_patch(const CGAL::Surface_mesh<Point_3>& surface,
                                        const std::vector<Surface::Face_index>& faces,
                                        std::vector<Surface::Vertex_index>* vertices = nullptr) {
  typedef Surface::Vertex_index Vertex;
  std::vector<Vertex> own;
  own.reserve(3 * faces.size());
  for (auto f : faces)
    for (Vertex v : surface.vertices_around_face(surface.halfedge(f)))
      own.push_back(v);
  if (own.size() != 3 * faces.size())
    throw Input_error("A patch has faces that are no triangles; triangulate the surface first.");

  const std::vector<Vertex> corners = own;
  std::sort(own.begin(), own.end());
  own.erase(std::unique(own.begin(), own.end()), own.end());
  Indexed_patch patch;
  patch.triangles.resize(faces.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    patch.triangles[i / 3][i % 3] = int(std::lower_bound(own.begin(), own.end(), corners[i]) - own.begin());
  for (Vertex v : own)
    patch.points.push_back(surface.point(v));
  patch.loops = border_loops(patch);
  if (vertices)
    *vertices = std::move(own);
  return patch;
}

/*! \ingroup PkgTubularMeshingRef
 *
 * A patch of a Surface_cut as an Indexed_patch, whose loop i is `patch.loops[i]`. Loops begin with their curve's first
 * vertex, whatever their direction is: edge i of a curve is edge i of the loop that has the patch on the curve's left,
 * and edge n − 1 − i, the other way round, of the loop that has it on the right.
 */
inline Indexed_patch make_indexed_patch(const CGAL::Surface_mesh<Point_3>& surface, const Surface_patch& patch,
                                        const std::vector<Cut_curve>& curves,
                                        std::vector<Surface::Vertex_index>* vertices = nullptr) {
  typedef Surface::Vertex_index Vertex;
  std::vector<Vertex> own;
  Indexed_patch result = make_indexed_patch(surface, patch.faces, &own);
  result.loops.clear();
  for (const Patch_loop& loop : patch.loops) {
    std::vector<int> along;
    for (Vertex v : curves[loop.curve].vertices)
      along.push_back(int(std::lower_bound(own.begin(), own.end(), v) - own.begin()));
    if (!loop.forward)
      std::reverse(along.begin() + 1, along.end());
    result.loops.push_back(along);
  }
  if (vertices)
    *vertices = std::move(own);
  return result;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_INDEXED_PATCH_H

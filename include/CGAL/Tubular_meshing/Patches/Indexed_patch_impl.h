// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INDEXED_PATCH_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_INDEXED_PATCH_IMPL_H

#include <CGAL/Tubular_meshing/Patches/Indexed_patch.h>
#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE std::vector<std::vector<int>> border_loops(const Indexed_patch& patch) {
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

CGAL_TUBULAR_MESHING_INLINE Indexed_patch make_indexed_patch(const Surface& surface,
                                                             const std::vector<Surface::Face_index>& faces,
                                                             std::vector<Surface::Vertex_index>* vertices) {
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

namespace internal {

/* Opens a patch along a curve that has it on both sides: its triangles on the curve's right get vertices of their own,
 * from `first` on in the curve's order. O(n log n) in the triangles at the curve. */
inline void open_along(const Surface& surface, const std::vector<Face>& faces, const Cut_curve& curve, int first,
                       Indexed_patch& patch) {
  const std::size_t n = curve.halfedges.size();
  for (std::size_t i = 0; i < n; ++i) {
    patch.points.push_back(surface.point(curve.vertices[i]));
    const Halfedge last = surface.opposite(curve.halfedges[(i + n - 1) % n]);
    for (Halfedge h = surface.opposite(curve.halfedges[i]);; h = surface.opposite(surface.next(h))) {
      const auto f = std::size_t(std::lower_bound(faces.begin(), faces.end(), surface.face(h)) - faces.begin());
      std::size_t corner = 0; // triangles begin at the target of their face's halfedge
      for (Halfedge g = surface.halfedge(faces[f]); g != h; g = surface.next(g))
        ++corner;
      patch.triangles[f][corner] = first + int(i);
      if (surface.next(h) == last)
        break;
    }
  }
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Indexed_patch make_indexed_patch(const Surface& surface, const Surface_patch& patch,
                                                             const std::vector<Cut_curve>& curves,
                                                             std::vector<Surface::Vertex_index>* vertices) {
  typedef Surface::Vertex_index Vertex;
  std::vector<Vertex> own;
  Indexed_patch result = make_indexed_patch(surface, patch.faces, &own);
  result.loops.clear();
  const std::size_t n = own.size();
  for (const Patch_loop& loop : patch.loops) {
    const Cut_curve& curve = curves[loop.curve];
    std::vector<int> along;
    const auto is_there = [&](const Patch_loop& other) { return other.curve == loop.curve && other.forward; };
    if (!loop.forward && std::any_of(patch.loops.begin(), patch.loops.end(), is_there)) { // the patch is on both sides
      const int first = int(own.size());
      internal::open_along(surface, patch.faces, curve, first, result);
      own.insert(own.end(), curve.vertices.begin(), curve.vertices.end());
      along.resize(curve.vertices.size());
      std::iota(along.begin(), along.end(), first);
    } else {
      for (Vertex v : curve.vertices)
        along.push_back(int(std::lower_bound(own.begin(), own.begin() + std::ptrdiff_t(n), v) - own.begin()));
    }
    if (!loop.forward)
      std::reverse(along.begin() + 1, along.end());
    result.loops.push_back(along);
  }
  if (vertices)
    *vertices = std::move(own);
  return result;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_INDEXED_PATCH_IMPL_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_OLD_TRIANGLES_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_OLD_TRIANGLES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The triangles of the marked patches of a cut surface, and of their neighbours, to move vertices on. */
inline Nearest_tree<Double_kernel::Triangle_3> old_triangles(const Surface& surface, const Surface_cut& cut,
                                                             const std::vector<char>& is_marked) {
  std::vector<char> is_near = is_marked;
  for (std::size_t k = 0; k < cut.patches.size(); ++k)
    if (is_marked[k])
      for (const Patch_loop& loop : cut.patches[k].loops)
        if (loop.neighbour != Cut_curve::none)
          is_near[loop.neighbour] = 1;
  std::vector<Double_kernel::Triangle_3> triangles;
  for (std::size_t k = 0; k < cut.patches.size(); ++k)
    if (is_near[k])
      for (auto f : cut.patches[k].faces) {
        const auto h = surface.halfedge(f);
        triangles.emplace_back(to_double_point(surface.point(surface.source(h))),
                               to_double_point(surface.point(surface.target(h))),
                               to_double_point(surface.point(surface.target(surface.next(h)))));
      }
  return Nearest_tree<Double_kernel::Triangle_3>(std::move(triangles));
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_OLD_TRIANGLES_H

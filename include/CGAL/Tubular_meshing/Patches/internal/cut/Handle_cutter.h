// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_HANDLE_CUTTER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_HANDLE_CUTTER_H

#include <CGAL/Tubular_meshing/Patches/internal/cut/Circular_function.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Cut_surface.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Handle_loop_finder.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Level_curves.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Section_snapper.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Wall_region.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Cuts handles that disks have left: of each region of positive genus, round a short loop, until all are planar. The
 * loop tells the handle; the curve that is cut is the best level curve of a function that grows round the handle: it is
 * smooth, and where the mesh has edges does not show. Such a curve leaves a region in one piece, which lies on both
 * sides of it. */
class Handle_cutter {
public:
  explicit Handle_cutter(Cut_surface& surface)
      : surface_(surface)
      , snapper_(surface)
      , marks_(surface.mesh()) {}

  /* O(n) in the faces of the surface, and O(n log n), but for one sparse linear system, in those of a region with
   * handles for each of them. */
  void run() {
    for (Face seed : seeds_of_handles())
      for (bool more = true; more;)
        more = cut_once(seed);
  }

  /* The curves, closed. */
  const std::vector<std::vector<Halfedge>>& cuts() const { return cuts_; }

private:
  // A face of each region of positive genus.
  std::vector<Face> seeds_of_handles() {
    std::vector<Face> seeds;
    std::vector<bool> done(surface_.mesh().number_of_faces(), false);
    for (Face f : surface_.mesh().faces()) {
      if (done[f] || !surface_.is_wall(f))
        continue;
      const Wall_region region(surface_, marks_, f);
      for (Face g : region.faces())
        done[g] = true;
      if (region.genus() > 0)
        seeds.push_back(f);
    }
    return seeds;
  }

  // False if there is no handle, or no curve that can be cut.
  bool cut_once(Face seed) {
    const std::size_t levels = 64;
    std::vector<Level_curve> curves;
    {
      const Wall_region region(surface_, marks_, seed);
      if (region.genus() == 0)
        return false;
      const Circular_function function(region, Handle_loop_finder(region).find());
      if (!function.is_solved())
        return false;
      curves = Level_curves(region, function).find(levels);
    }
    Cut_surface::Curve curve;
    for (const Level_curve& c : curves)
      if (snapper_.snap(c.crossings, c.mean_radius(), curve)) {
        cuts_.push_back(surface_.cut(curve));
        return true;
      }
    return false;
  }

  Cut_surface& surface_;
  Section_snapper snapper_;
  Region_marks marks_;
  std::vector<std::vector<Halfedge>> cuts_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_HANDLE_CUTTER_H

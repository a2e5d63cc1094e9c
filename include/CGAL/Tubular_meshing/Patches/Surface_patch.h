// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_SURFACE_PATCH_H
#define CGAL_TUBULAR_MESHING_PATCHES_SURFACE_PATCH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPatches
 *
 * A closed curve of the cut surface on which patches end: a cut across a branch, a cut round a handle, or the rim of an
 * opening. The patches on its two sides know it by the same index. One patch may be on both sides, and then has the
 * curve twice: as two loops.
 *
 * Seen from outside, `left_patch` is on the left of one who walks along it. On the left of a cut is the part of the
 * branch that is nearer to the branch's source. On the left of a rim is the wall, on its right the cap.
 */
struct Cut_curve {
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::vector<Surface::Halfedge_index> halfedges; ///< in order, closed, their faces on the left
  std::vector<Surface::Vertex_index> vertices;    ///< `vertices[i]` is the source of `halfedges[i]`
  std::size_t left_patch = none;
  std::size_t right_patch = none; ///< `none` for a rim
  std::size_t branch = none;      ///< of the centerline graph; `none` for a cut round a handle, and for the rim of an
                                  ///< opening without a branch
  double abscissa = 0;            ///< on the branch
  int opening = 0;                ///< for a rim, the label of its cap's facets; 0 for a cut

  bool is_rim() const { return opening != 0; }
};

/*! \ingroup PkgTubularMeshingPatches
 * What a patch is, by the number of its loops. */
enum class Patch_kind {
  closed,  ///< no loop: a surface without openings, uncut
  disk,    ///< one loop: a blind end
  annular, ///< two loops: a tube, with or without a sac
  junction ///< three or more loops
};

/*! \ingroup PkgTubularMeshingPatches
 * One boundary of a patch. */
struct Patch_loop {
  std::size_t curve;     ///< index of the Cut_curve
  bool forward;          ///< whether the patch is on the curve's left
  std::size_t neighbour; ///< the patch on the other side, or the same; `Cut_curve::none` if that is a cap
};

/*! \ingroup PkgTubularMeshingPatches
 *
 * A part of the wall between cuts, small enough in length to be mapped onto the plane.
 */
struct Surface_patch {
  Patch_kind kind = Patch_kind::closed;
  std::vector<Surface::Face_index> faces; ///< in ascending order
  std::vector<Patch_loop> loops;          ///< by ascending index of their curves
  std::vector<std::size_t> branches;      ///< of the centerline graph, which have a part in the patch
  double length = 0;        ///< of a tube: of its centerline. Of a junction: of the longest way downstream from one
                            ///< end to another, or the distance between two ends, if one is greater
  double mean_diameter = 0; ///< the mean of the least and the greatest diameter, 2 r(x_c), on its centerlines
  int euler_characteristic = 0;

  /// η = length / mean diameter
  double aspect_ratio() const {
    return mean_diameter > 0 ? length / mean_diameter : (std::numeric_limits<double>::infinity)();
  }

  /// Whether it is a sphere with as many holes as it has loops: an annulus, if these are two.
  bool is_sphere_with_holes() const { return euler_characteristic == 2 - int(loops.size()); }
};

/*! \ingroup PkgTubularMeshingPatches
 * Something that cut_by_centerlines() could not do, and where. */
struct Cut_problem {
  enum Kind {
    too_long,       ///< a patch whose aspect ratio is greater than wanted, as no disk divides it
    wrong_topology, ///< a patch that is no sphere with holes
    no_centerline   ///< a patch with a vessel that ends blind, longer than wide, or that joins branches, but has no
                    ///< centerline: give compute_centerlines() a seed there
  };

  Kind kind;
  Point_3 point;      ///< on the centerlines; for a vessel without one, its tip on the wall
  std::size_t branch; ///< the branch, or one of the patch's
  std::size_t patch;  ///< the patch concerned

  /// A sentence for people.
  std::string message() const {
    const char* const what[] = {"No disk divides a patch that is too long", "A patch is no sphere with holes",
                                "A vessel has no centerline, and is not cut: give a seed at its end"};
    return std::string(what[kind]) + "; branch " + std::to_string(branch) + ", patch " + std::to_string(patch) +
           ", near (" + std::to_string(point.x()) + ", " + std::to_string(point.y()) + ", " +
           std::to_string(point.z()) + ").";
  }
};

/*! \ingroup PkgTubularMeshingPatches
 *
 * What cut_by_centerlines() makes of a surface: patches, numbered along the centerlines from their root, and the curves
 * between them. Its descriptors are those of the surface, which must not change while they are used.
 */
struct Surface_cut {
  Face_patch_map
      patch_of_face; ///< the face's index in `patches`, −1 on caps: property map `f:surface_patch` of the surface
  std::vector<Surface_patch> patches;
  std::vector<Cut_curve> curves; ///< cuts, along the centerlines, then cuts round handles, then rims
  std::vector<Cut_problem> problems;
  std::size_t handle_cuts = 0;              ///< curves round handles through which no disk goes
  std::size_t moved_cuts = 0;               ///< disks that were moved off the place wanted, or tilted, to close
  std::vector<std::size_t> merged_branches; ///< whole parts of junctions: too short for a cut, or no disk closes

  /// Whether every patch is as it should be.
  bool is_valid() const { return problems.empty(); }
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_SURFACE_PATCH_H

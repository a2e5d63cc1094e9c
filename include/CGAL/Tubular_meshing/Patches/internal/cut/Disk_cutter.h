// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_DISK_CUTTER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_DISK_CUTTER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Branch_curve.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Cut_surface.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Section_finder.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Section_snapper.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A disk across a branch: where, how tilted (0: not), and the perimeter of its section; infinite, if it cannot be cut.
 */
struct Disk {
  double abscissa = 0;
  int tilt = 0;
  double perimeter = (std::numeric_limits<double>::infinity)();

  bool is_cuttable() const { return perimeter < (std::numeric_limits<double>::infinity)(); }
  bool operator<(const Disk& d) const { return perimeter < d.perimeter; }
};

/* A cut that has been made. */
struct Branch_cut {
  std::size_t branch;
  double abscissa;
  std::vector<Halfedge> halfedges; // with the side of the branch's source on their left
};

/* Tries disks across the branches, cuts the surface along them, and keeps account of the cuts. */
class Disk_cutter {
public:
  static constexpr int number_of_tilts = 17;

  Disk_cutter(Cut_surface& surface, const Centerline_graph& graph)
      : surface_(surface)
      , graph_(graph)
      , finder_(surface, graph)
      , snapper_(surface)
      , cuts_of_branch_(graph.branches().size()) {}

  const Centerline_graph& graph() const { return graph_; }
  Branch_curve axis(size_type branch) const { return Branch_curve(graph_, branch); }
  const std::vector<Branch_cut>& cuts() const { return cuts_; }

  // The numbers of a branch's cuts, by abscissa.
  const std::vector<size_type>& cuts_of(size_type branch) const { return cuts_of_branch_[branch]; }
  double abscissa_of(size_type cut) const { return cuts_[cut].abscissa; }

  // The disk at a place. O(its section).
  Disk probe(size_type branch, double abscissa, int tilt = 0) {
    Disk disk{abscissa, tilt};
    if (find_curve(branch, disk))
      disk.perimeter = section_.perimeter();
    return disk;
  }

  // The disk of least perimeter of all that are tilted.
  Disk probe_tilted(size_type branch, double abscissa) {
    Disk best{abscissa};
    for (int tilt = 1; tilt < number_of_tilts; ++tilt)
      best = (std::min)(best, probe(branch, abscissa, tilt));
    return best;
  }

  // Its perimeter over that of the largest circle about the centerline: 1 for a round tube.
  double roundness(size_type branch, const Disk& disk) const {
    return disk.perimeter / (2 * CGAL_PI * axis(branch).radius(disk.abscissa));
  }

  // False if it is no cuttable disk, or no longer, the surface having been cut since it was tried.
  bool cut(size_type branch, const Disk& disk) {
    if (!disk.is_cuttable() || !find_curve(branch, disk))
      return false;
    cuts_.push_back(Branch_cut{branch, disk.abscissa, surface_.cut(curve_)});
    std::vector<size_type>& cuts = cuts_of_branch_[branch];
    cuts.insert(std::upper_bound(cuts.begin(), cuts.end(), disk.abscissa,
                                 [this](double s, size_type c) { return s < cuts_[c].abscissa; }),
                cuts_.size() - 1);
    return true;
  }

private:
  // Further, and it is no disk across the branch any more.
  static constexpr double reach = 8; // radii

  bool find_curve(size_type branch, const Disk& disk) {
    const Branch_curve a = axis(branch);
    const Section_plane plane(a.point(disk.abscissa), normal(a, disk));
    return finder_.find(plane, reach * a.radius(disk.abscissa), section_) && snapper_.snap(section_, curve_);
  }

  /* The tangent, or a direction tilted off it by 20 or 40 degrees to one of eight sides; which sides, the direction
   * towards the root tells, as coordinate axes would make the result depend on the surface's position. */
  Vector_3d normal(const Branch_curve& a, const Disk& disk) const {
    const Vector_3d t = a.tangent(disk.abscissa);
    if (disk.tilt == 0)
      return t;
    const Vector_3d to_root = Vector_3d(graph_.points()[graph_.nodes()[graph_.root()].point]) - a.point(disk.abscissa);
    const Vector_3d side = to_root - dot(to_root, t) * t;
    const bool has_side = squared_norm(side) > 1e-12 * squared_norm(to_root);
    const Vector_3d u = has_side ? normalized(side) : Section_plane(Vector_3d(), t).direction(0), v = cross(t, u);
    const double degree = CGAL_PI / 180, angle = (disk.tilt <= 8 ? 20 : 40) * degree, turn = 45 * degree * disk.tilt;
    return std::cos(angle) * t + std::sin(angle) * (std::cos(turn) * u + std::sin(turn) * v);
  }

  Cut_surface& surface_;
  const Centerline_graph& graph_;
  Section_finder finder_;
  Section_snapper snapper_;
  std::vector<Branch_cut> cuts_;
  std::vector<std::vector<size_type>> cuts_of_branch_;
  Plane_section section_; // of the last disk tried, and its curve: kept for their memory
  Cut_surface::Curve curve_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_DISK_CUTTER_H

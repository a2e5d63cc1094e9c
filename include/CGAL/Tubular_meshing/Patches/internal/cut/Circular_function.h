// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_CIRCULAR_FUNCTION_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_CIRCULAR_FUNCTION_H

#include <CGAL/Tubular_meshing/Patches/internal/cut/Wall_region.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Laplace_system.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A harmonic function on a region that grows by 1 round the handle: its values are angles, in whole turns. Where the
 * given loop leads across an edge, the function jumps by one. It is constant on each boundary of the region.
 *
 * Its level curves are closed and smooth. None of them parts the region: the function grows across the curve
 * everywhere, so that something flows through it, which a part beyond could not let out. About O(n^1.5). */
class Circular_function {
public:
  /* `loop`: halfedges that are crossed one after the other, as Handle_loop_finder finds them. */
  Circular_function(const Wall_region& region, const std::vector<Halfedge>& loop)
      : region_(region)
      , mesh_(region.mesh())
      , jump_(3 * region.faces().size(), 0)
      , values_(Laplace_system::Columns::Zero(Eigen::Index(region.number_of_nodes()), 1)) {
    for (Halfedge h : loop) {
      jump_[corner(h)] = 1;
      jump_[corner(mesh_.opposite(h))] = -1;
    }
    is_solved_ = solve();
  }

  bool is_solved() const { return is_solved_; }
  double at_source(Halfedge h) const { return values_(region_.source(h), 0); }
  double at_target(Halfedge h) const { return values_(region_.target(h), 0); }
  /// How much it grows along a halfedge.
  double growth(Halfedge h) const { return at_target(h) - at_source(h) + jump(h); }
  int jump(Halfedge h) const { return jump_[corner(h)]; }

private:
  std::size_t corner(Halfedge h) const {
    const Face f = mesh_.face(h);
    const Halfedge first = mesh_.halfedge(f);
    return 3 * region_.number(f) + (h == first ? 0 : h == mesh_.next(first) ? 1 : 2);
  }

  bool solve() {
    std::vector<Weighted_edge> edges;
    Laplace_system::Columns flow = Laplace_system::Columns::Zero(values_.rows(), 1);
    for (Halfedge h : region_.edges()) {
      const int a = region_.source(h), b = region_.target(h);
      if (a == b)
        continue;
      const double w = weight(h);
      edges.push_back(Weighted_edge{a, b, w, w});
      flow(a, 0) += w * jump(h);
      flow(b, 0) -= w * jump(h);
    }
    std::vector<char> is_fixed(region_.number_of_nodes(), 0);
    is_fixed[0] = 1;
    return Laplace_system(edges, is_fixed).solve(flow, values_) && values_.allFinite();
  }

  // Positive, so that there are no extrema.
  double weight(Halfedge h) const {
    const double least = 0.01, most = 100;
    return (std::min)((std::max)((cotangent_beyond(h) + cotangent_beyond(mesh_.opposite(h))) / 2, least), most);
  }

  double cotangent_beyond(Halfedge h) const {
    const Vector_3d o = region_.point(mesh_.target(mesh_.next(h)));
    const Vector_3d a = region_.point(mesh_.source(h)) - o, b = region_.point(mesh_.target(h)) - o;
    const double s = norm(cross(a, b)), c = dot(a, b), bound = 1e3;
    return std::abs(c) < bound * s ? c / s : c > 0 ? bound : -bound;
  }

  const Wall_region& region_;
  const Surface& mesh_;
  std::vector<int> jump_; // of the halfedges of faces
  Laplace_system::Columns values_;
  bool is_solved_ = false;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_CIRCULAR_FUNCTION_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SKELETON_H
#define CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SKELETON_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingGenerators
 *
 * What a generated tubular surface is made from, and the truth to compare results with: nodes, and between them
 * branches, which are polylines with a radius at each point, sampled finely enough to pass for smooth curves.
 *
 * A node where a single branch begins or ends is an opening; the others are junctions. Branches run away from the
 * inlet. The graph may have loops.
 */
struct Tubular_skeleton {
  struct Branch {
    std::size_t source, target;  ///< nodes
    std::vector<Point_3> points; ///< two or more, from node to node
    std::vector<double> radius;  ///< one a point
  };

  /// The end of a tube: a disk across the centerline.
  struct End {
    std::size_t node, branch;
    Point_3 center;
    Vector_3 normal; ///< unit, out of the tube
    double radius;
  };

  std::vector<Point_3> nodes;
  std::vector<Branch> branches;
  std::size_t inlet = 0; ///< a node

  std::size_t number_of_branches() const { return branches.size(); }

  /// The number of branches that begin or end at each node.
  std::vector<std::size_t> degrees() const;

  std::size_t number_of_openings() const;

  /// Independent loops of a connected skeleton: 0 for a tree, 1 for a circle of Willis.
  std::size_t number_of_loops() const { return branches.size() + 1 - nodes.size(); }

  /// The ends of the tubes, the inlet first, the others by node.
  std::vector<End> ends() const;

  /*! Adds a branch along a curve, cut into equal parameter steps of about a quarter of the radius.
   * \param source, target nodes
   * \param curve from [0, 1] to points; its ends are the two nodes
   * \param radius from [0, 1] to radii */
  void add_branch(std::size_t source, std::size_t target, internal::Function_view<Point_3(double)> curve,
                  internal::Function_view<double(double)> radius);
};

/*! \ingroup PkgTubularMeshingGenerators
 *
 * Checks what the generators need: each branch has two or more distinct consecutive points and as many positive finite
 * radii, its ends are its nodes, and the inlet is an end.
 * \exception Input_error with a sentence that names the branch
 */
void check_skeleton(const Tubular_skeleton& skeleton);

/*! \ingroup PkgTubularMeshingGenerators
 *
 * The centerlines of a skeleton as VMTK writes them: one polyline from the inlet to each outlet, so that they overlap
 * upstream, each with points of its own. A skeleton with loops gives one polyline a branch.
 *
 * Complexity: linear in the size of the result.
 */
Centerline_polylines centerlines_of(const Tubular_skeleton& skeleton);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SKELETON_H

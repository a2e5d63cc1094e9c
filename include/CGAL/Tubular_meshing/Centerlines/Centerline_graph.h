// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_GRAPH_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_GRAPH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * Centerlines as they come from a file: polylines that may overlap, be cut into single segments, or lack radii.
 */
struct Centerline_polylines {
  std::vector<Point_3> points;
  std::vector<double> radius;                  ///< one a point, or empty: MaximumInscribedSphereRadius
  std::vector<std::vector<std::size_t>> lines; ///< indices of points, two or more a line
};

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * The branches of a vessel or airway tree (Algorithm 1 of the paper): a graph whose nodes are bifurcations and ends,
 * and whose edges, the branches, are polylines with a radius at each point. A tree is the usual case; loops (a bypass,
 * the circle of Willis) are allowed, and so are several components.
 *
 * Branches that meet share the index of the point where they do. All of a graph's lengths are in the unit of its
 * points. build_centerline_graph() makes one from the polylines of a file.
 */
class Centerline_graph {
public:
  typedef Tubular_meshing::Point_3 Point_3;
  typedef std::size_t size_type;
  typedef std::vector<size_type> Polyline; ///< indices of points

  /// A polyline between two nodes, directed away from the root.
  struct Branch {
    Polyline points;                 ///< its points in order, those of the two nodes included
    size_type source, target;        ///< nodes
    double length;                   ///< of the polyline
    double min_radius, max_radius;   ///< over its points
    std::vector<size_type> parents;  ///< branches that end where this one begins
    std::vector<size_type> children; ///< branches that begin where this one ends
    std::vector<double> abscissa;    ///< one a point: length of the polyline from its source
  };

  /// A bifurcation (degree three or more) or an end (degree one). The one node of a closed curve has its only branch
  /// twice.
  struct Node {
    size_type point;
    std::vector<size_type> branches; ///< that begin or end here
    bool is_end() const { return branches.size() == 1; }
  };

  /// An empty graph.
  Centerline_graph() {}

  /*! The graph of the given branches, directed away from node 0, the first point of the first branch. Nodes are the
   * points at which branches begin or end, numbered in the order in which the branches mention them. O(n).
   *
   * \param points, radii one radius a point; points that no branch uses are kept
   * \param branches indices of two or more points each
   * \throws Input_error if sizes do not fit, or an index is out of range */
  Centerline_graph(std::vector<Point_3> points, std::vector<double> radii, std::vector<Polyline> branches);

  const std::vector<Point_3>& points() const { return points_; }
  const std::vector<double>& radii() const { return radii_; }
  const std::vector<Branch>& branches() const { return branches_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  /// The node from which branches are directed; meaningless for an empty graph.
  size_type root() const { return root_; }
  bool empty() const { return branches_.empty(); }

  /// The number of nodes of degree one.
  size_type number_of_ends() const;

  /// The sum of the branches' lengths.
  double length() const;

  /// length / (min radius + max radius): the η of Algorithm 2, which cuts branches until it is at most 4.
  double aspect_ratio(size_type branch) const;

  /// Replaces the radii, one a point, and the branches' minima and maxima. O(n). \throws Input_error if sizes differ
  void set_radii(std::vector<double> radii);

  /*! Re-roots the graph: directs every branch away from `node` by breadth-first search, and fills `parents` and
   * `children`. A branch that closes a loop is directed away from whichever of its nodes is found first. A component
   * that does not contain `node` is directed away from its end of largest radius. O(n) in the points turned.
   * \throws Input_error if there is no such node */
  void direct_from(size_type node);

  /*! The same for several components: each that contains one of the nodes is directed away from it; the first is the
   * root. \throws Input_error if there is no such node, or none at all */
  void direct_from(const std::vector<size_type>& nodes);

  /// Whether indices, directions, lengths and links of all parts agree with each other. O(n).
  bool is_consistent() const;

private:
  void add_branch(Polyline polyline, std::unordered_map<size_type, size_type>& node_at);
  size_type node_of(size_type point, std::unordered_map<size_type, size_type>& node_at);
  double distance(size_type p, size_type q) const;
  void measure_lengths(Branch& b) const;
  void measure_radii(Branch& b) const;
  void reverse(Branch& b) const;
  void direct_component(size_type start, std::vector<bool>& node_found, std::vector<bool>& branch_done);
  std::vector<size_type> nodes_by_eligibility() const;
  void link_branches();
  size_type point_of(size_type node) const { return nodes_[node].point; }
  bool is_consistent(size_type i) const;

  std::vector<Point_3> points_;
  std::vector<double> radii_;
  std::vector<Branch> branches_;
  std::vector<Node> nodes_;
  size_type root_ = 0;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_GRAPH_H

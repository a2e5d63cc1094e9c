// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_GRAPH_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_GRAPH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * Centerlines as they come from a file: polylines that may overlap, be cut into single segments, or lack radii.
 */
struct Centerline_polylines {
  std::vector<Point_3> points;
  std::vector<double> radius;                  ///< one a point, or empty: MaximumInscribedSphereRadius
  std::vector<std::vector<std::size_t>> lines; ///< indices of points, two or more a line
};

/*! \ingroup PkgTubularMeshingRef
 *
 * The branches of a vessel or airway tree (Algorithm 1 of the paper): a graph whose nodes are bifurcations and ends,
 * and whose edges, the branches, are polylines with a radius at each point. A tree is the usual case; loops (a bypass,
 * the circle of Willis) are allowed, and so are several components.
 *
 * Branches that meet share the index of the point where they do. All of a graph's lengths are in the unit of its
 * points. build_centerline_graph() makes one from the polylines of a file.
 *
 * \tparam Point_3 a model of `Point_3` with Cartesian coordinates
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
  Centerline_graph(std::vector<Point_3> points, std::vector<double> radii, std::vector<Polyline> branches)
      : points_(std::move(points)) {
    set_radii(std::move(radii));
    std::unordered_map<size_type, size_type> node_at;
    branches_.reserve(branches.size());
    for (Polyline& polyline : branches)
      add_branch(std::move(polyline), node_at);
    if (!nodes_.empty())
      direct_from(0);
  }

  const std::vector<Point_3>& points() const { return points_; }
  const std::vector<double>& radii() const { return radii_; }
  const std::vector<Branch>& branches() const { return branches_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  /// The node from which branches are directed; meaningless for an empty graph.
  size_type root() const { return root_; }
  bool empty() const { return branches_.empty(); }

  /// The number of nodes of degree one.
  size_type number_of_ends() const {
    return std::count_if(nodes_.begin(), nodes_.end(), [](const Node& n) { return n.is_end(); });
  }

  /// The sum of the branches' lengths.
  double length() const {
    double sum = 0;
    for (const Branch& b : branches_)
      sum += b.length;
    return sum;
  }

  /// length / (min radius + max radius): the η of Algorithm 2, which cuts branches until it is at most 4.
  double aspect_ratio(size_type branch) const {
    const Branch& b = branches_[branch];
    const double diameter = b.min_radius + b.max_radius;
    return diameter > 0 ? b.length / diameter : (std::numeric_limits<double>::infinity)();
  }

  /// Replaces the radii, one a point, and the branches' minima and maxima. O(n). \throws Input_error if sizes differ
  void set_radii(std::vector<double> radii) {
    if (radii.size() != points_.size())
      throw Input_error("The centerlines have " + std::to_string(points_.size()) + " points but " +
                        std::to_string(radii.size()) + " radii; give one radius a point.");
    radii_ = std::move(radii);
    for (Branch& b : branches_)
      measure_radii(b);
  }

  /*! Re-roots the graph: directs every branch away from `node` by breadth-first search, and fills `parents` and
   * `children`. A branch that closes a loop is directed away from whichever of its nodes is found first. A component
   * that does not contain `node` is directed away from its end of largest radius. O(n) in the points turned.
   * \throws Input_error if there is no such node */
  void direct_from(size_type node) {
    if (node >= nodes_.size())
      throw Input_error("The centerlines have no node " + std::to_string(node) + "; they have " +
                        std::to_string(nodes_.size()) + ".");
    root_ = node;
    std::vector<bool> node_found(nodes_.size(), false), branch_done(branches_.size(), false);
    direct_component(node, node_found, branch_done);
    for (size_type other : nodes_by_eligibility())
      if (!node_found[other])
        direct_component(other, node_found, branch_done);
    link_branches();
  }

  /// Whether indices, directions, lengths and links of all parts agree with each other. O(n).
  bool is_consistent() const {
    for (size_type i = 0; i < branches_.size(); ++i)
      if (!is_consistent(i))
        return false;
    for (const Node& n : nodes_)
      for (size_type b : n.branches)
        if (b >= branches_.size() || (point_of(branches_[b].source) != n.point && //
                                      point_of(branches_[b].target) != n.point))
          return false;
    return radii_.size() == points_.size() && (empty() || root_ < nodes_.size());
  }

private:
  void add_branch(Polyline polyline, std::unordered_map<size_type, size_type>& node_at) {
    const size_type index = branches_.size();
    if (polyline.size() < 2)
      throw Input_error("Branch " + std::to_string(index) + " of the centerlines has fewer than two points.");
    for (size_type p : polyline)
      if (p >= points_.size())
        throw Input_error("Branch " + std::to_string(index) + " of the centerlines refers to point " +
                          std::to_string(p) + ", but there are only " + std::to_string(points_.size()) + " points.");
    Branch b;
    b.points = std::move(polyline);
    b.source = node_of(b.points.front(), node_at);
    b.target = node_of(b.points.back(), node_at);
    nodes_[b.source].branches.push_back(index);
    nodes_[b.target].branches.push_back(index);
    measure_lengths(b);
    measure_radii(b);
    branches_.push_back(std::move(b));
  }

  size_type node_of(size_type point, std::unordered_map<size_type, size_type>& node_at) {
    const auto inserted = node_at.insert(std::make_pair(point, nodes_.size()));
    if (inserted.second)
      nodes_.push_back(Node{point, {}});
    return inserted.first->second;
  }

  double distance(size_type p, size_type q) const {
    return std::sqrt(CGAL::to_double((points_[q] - points_[p]).squared_length()));
  }

  void measure_lengths(Branch& b) const {
    b.abscissa.assign(b.points.size(), 0);
    for (size_type i = 1; i < b.points.size(); ++i)
      b.abscissa[i] = b.abscissa[i - 1] + distance(b.points[i - 1], b.points[i]);
    b.length = b.abscissa.back();
  }

  void measure_radii(Branch& b) const {
    b.min_radius = b.max_radius = radii_[b.points.front()];
    for (size_type p : b.points) {
      b.min_radius = (std::min)(b.min_radius, radii_[p]);
      b.max_radius = (std::max)(b.max_radius, radii_[p]);
    }
  }

  void reverse(Branch& b) const {
    std::reverse(b.points.begin(), b.points.end());
    std::swap(b.source, b.target);
    measure_lengths(b);
  }

  void direct_component(size_type start, std::vector<bool>& node_found, std::vector<bool>& branch_done) {
    std::vector<size_type> queue(1, start);
    node_found[start] = true;
    for (size_type head = 0; head < queue.size(); ++head)
      for (size_type i : nodes_[queue[head]].branches) {
        if (branch_done[i])
          continue;
        branch_done[i] = true;
        Branch& b = branches_[i];
        if (b.source != queue[head])
          reverse(b);
        if (!node_found[b.target]) {
          node_found[b.target] = true;
          queue.push_back(b.target);
        }
      }
  }

  // Where to begin in components without the root: ends first, wide ones first.
  std::vector<size_type> nodes_by_eligibility() const {
    std::vector<size_type> order(nodes_.size());
    for (size_type i = 0; i < order.size(); ++i)
      order[i] = i;
    std::stable_sort(order.begin(), order.end(), [this](size_type a, size_type b) {
      if (nodes_[a].is_end() != nodes_[b].is_end())
        return nodes_[a].is_end();
      return radii_[nodes_[a].point] > radii_[nodes_[b].point];
    });
    return order;
  }

  void link_branches() {
    for (Branch& b : branches_) {
      b.parents.clear();
      b.children.clear();
    }
    for (size_type n = 0; n < nodes_.size(); ++n)
      for (size_type i : nodes_[n].branches)
        for (size_type j : nodes_[n].branches)
          if (i != j && branches_[i].target == n && branches_[j].source == n) {
            branches_[i].children.push_back(j);
            branches_[j].parents.push_back(i);
          }
  }

  size_type point_of(size_type node) const { return nodes_[node].point; }

  bool is_consistent(size_type i) const {
    const Branch& b = branches_[i];
    if (b.points.size() < 2 || b.abscissa.size() != b.points.size() || b.source >= nodes_.size() ||
        b.target >= nodes_.size() || point_of(b.source) != b.points.front() || point_of(b.target) != b.points.back())
      return false;
    for (size_type c : b.children)
      if (c >= branches_.size() || branches_[c].source != b.target)
        return false;
    for (size_type p : b.parents)
      if (p >= branches_.size() || branches_[p].target != b.source)
        return false;
    for (size_type p : b.points)
      if (p >= points_.size() || !(radii_[p] >= b.min_radius && radii_[p] <= b.max_radius))
        return false;
    return std::is_sorted(b.abscissa.begin(), b.abscissa.end()) && b.abscissa.back() == b.length;
  }

  std::vector<Point_3> points_;
  std::vector<double> radii_;
  std::vector<Branch> branches_;
  std::vector<Node> nodes_;
  size_type root_ = 0;
};

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_GRAPH_H

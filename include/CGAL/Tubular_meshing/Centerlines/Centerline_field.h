// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_FIELD_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_FIELD_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * The two descriptors of section 2.2, at any point of space: the local radius at the nearest point of the centerlines,
 * and the triad axis (e_t, e_n, e_bn), with the branch and the abscissa where they were found.
 *
 * Built in O(n log n) for a graph of n points, of which it keeps what it needs; a query is O(log n) near the
 * centerlines, allocates nothing, and is safe from several threads. Copies share the search tree.
 */
class Centerline_field {
public:
  typedef Tubular_meshing::Point_3 Point_3;
  typedef Tubular_meshing::Vector_3 Vector_3;
  typedef Centerline_graph Graph;
  typedef std::size_t size_type;

  /// What the centerlines are like where they are nearest to a point.
  struct Descriptors {
    Point_3 point;     ///< x_c, the nearest point of the centerlines
    size_type branch;  ///< index in Graph::branches()
    size_type segment; ///< of the branch: between its points `segment` and `segment` + 1
    double abscissa;   ///< of x_c, from the branch's source
    double radius;     ///< r(x_c), linear between points
    double distance;   ///< from the point to x_c
  };

  /// Three unit vectors, perpendicular to each other: e_bn = e_t × e_n.
  struct Frame {
    Vector_3 e_t;  ///< along the branch, towards its target
    Vector_3 e_n;  ///< away from the centerline
    Vector_3 e_bn; ///< around it
  };

  /*! \throws Input_error if the graph is empty */
  explicit Centerline_field(const Graph& graph);

  /// The number of segments searched.
  size_type number_of_segments() const;

  /// The local radius r(x_c) at the point of the centerlines nearest to `x`.
  double radius(const Point_3& x) const;

  Descriptors descriptors(const Point_3& x) const;

  /*! The same, faster where `hint` is a segment near `x`; it becomes the one found, for the next of many points in a row.
   * Segments are numbered through all branches; any number will do to begin with. */
  Descriptors descriptors(const Point_3& x, size_type& hint) const;

  /*! The triad axis at `x`. e_t is interpolated along the branch; e_n is x − x_c made perpendicular to e_t, and on the
   * centerline itself a normal that turns as little as possible along the tree \cgalCite{wang2008}. */
  Frame frame(const Point_3& x) const;

  /// Both, from one search.
  std::pair<Descriptors, Frame> descriptors_and_frame(const Point_3& x) const;

private:
  class Impl;
  std::shared_ptr<const Impl> impl_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_FIELD_H

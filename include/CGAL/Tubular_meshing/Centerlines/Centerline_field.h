// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_FIELD_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_FIELD_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/branch_axes.h>
#include <CGAL/Tubular_meshing/Centerlines/graph_segments.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Kernel_traits.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * The two descriptors of section 2.2, at any point of space: the local radius at the nearest point of the centerlines,
 * and the triad axis (e_t, e_n, e_bn), with the branch and the abscissa where they were found.
 *
 * Built in O(n log n) for a graph of n points, of which it keeps what it needs; a query is O(log n) near the
 * centerlines, allocates nothing, and is safe from several threads. Copies share the search tree.
 *
 * \tparam Point_3 a model of `Point_3`
 */
class Centerline_field {
public:
  typedef Tubular_meshing::Point_3 Point_3;
  typedef typename Kernel_traits<Point_3>::Kernel::Vector_3 Vector_3;
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
  explicit Centerline_field(const Graph& graph) {
    if (graph.empty())
      throw Input_error("There are no centerlines; radius and direction of the vessels cannot be told without them.");
    internal::Graph_segments<Graph> all(graph);
    places_ = std::move(all.places);
    tree_ = internal::Nearest_tree<Segment>(std::move(all.segments));
    const internal::Branch_axes<Graph> axes(graph);
    ends_.reserve(2 * places_.size());
    for (const Place& place : places_)
      for (size_type i : {place.segment, place.segment + 1}) {
        const typename Graph::Branch& b = graph.branches()[place.branch];
        ends_.push_back(End{axes.tangents(place.branch)[i], axes.normals(place.branch)[i], graph.radii()[b.points[i]],
                            b.abscissa[i]});
      }
  }

  /// The number of segments searched.
  size_type number_of_segments() const { return places_.size(); }

  /// The local radius r(x_c) at the point of the centerlines nearest to `x`.
  double radius(const Point_3& x) const {
    const Location l = locate(internal::to_double_point(x));
    return (1 - l.t) * ends_[2 * l.index].radius + l.t * ends_[2 * l.index + 1].radius;
  }

  Descriptors descriptors(const Point_3& x) const { return descriptors(locate(internal::to_double_point(x))); }

  /*! The triad axis at `x`. e_t is interpolated along the branch; e_n is x − x_c made perpendicular to e_t, and on the
   * centerline itself a normal that turns as little as possible along the tree \cgalCite{wang2008}. */
  Frame frame(const Point_3& x) const {
    const Double_point q = internal::to_double_point(x);
    return frame(q, locate(q));
  }

  /// Both, from one search.
  std::pair<Descriptors, Frame> descriptors_and_frame(const Point_3& x) const {
    const Double_point q = internal::to_double_point(x);
    const Location l = locate(q);
    return std::make_pair(descriptors(l), frame(q, l));
  }

private:
  typedef internal::Double_kernel::Point_3 Double_point;
  typedef internal::Double_kernel::Vector_3 Double_vector;
  typedef internal::Double_kernel::Segment_3 Segment;
  typedef typename internal::Graph_segments<Graph>::Place Place;

  // One end of a segment, as its branch sees it: at a bifurcation, each branch has its own direction.
  struct End {
    Double_vector tangent, normal;
    double radius, abscissa;
  };

  struct Location {
    size_type index;
    double t; // along the segment, 0 to 1
    Double_point point;
    double distance;
  };

  Location locate(const Double_point& q) const {
    const auto found = tree_.nearest(q);
    // a point without a nearest segment has coordinates that are not numbers: any answer is as good, none may crash
    const size_type i = found.index < tree_.size() ? found.index : 0;
    const Segment& s = tree_.shape(i);
    const Double_vector d = s.target() - s.source();
    const double length2 = d.squared_length();
    const double t = length2 > 0 ? (found.point - s.source()) * d / length2 : 0;
    return Location{i, (std::min)(1., (std::max)(0., t)), found.point, std::sqrt(found.squared_distance)};
  }

  Descriptors descriptors(const Location& l) const {
    const End &a = ends_[2 * l.index], &b = ends_[2 * l.index + 1];
    return Descriptors{Point_3(l.point.x(), l.point.y(), l.point.z()),
                       places_[l.index].branch,
                       places_[l.index].segment,
                       (1 - l.t) * a.abscissa + l.t * b.abscissa,
                       (1 - l.t) * a.radius + l.t * b.radius,
                       l.distance};
  }

  Frame frame(const Double_point& q, const Location& l) const {
    const End &a = ends_[2 * l.index], &b = ends_[2 * l.index + 1];
    const Double_vector t = internal::unit((1 - l.t) * a.tangent + l.t * b.tangent, a.tangent);
    const double on_centerline = 1e-9; // of the radius: below, x − x_c has no direction but rounding's
    const double radius = (1 - l.t) * a.radius + l.t * b.radius;
    Double_vector n = internal::rejected(q - l.point, t);
    if (!(n.squared_length() > on_centerline * on_centerline * radius * radius))
      n = internal::rejected((1 - l.t) * a.normal + l.t * b.normal, t);
    n = internal::unit(n, internal::any_perpendicular(t));
    // once more: a short n, nearly along t, loses its last digits above
    n = internal::unit(internal::rejected(n, t), n);
    return Frame{vector(t), vector(n), vector(CGAL::cross_product(t, n))};
  }

  static Vector_3 vector(const Double_vector& v) { return Vector_3(v.x(), v.y(), v.z()); }

  internal::Nearest_tree<Segment> tree_;
  std::vector<Place> places_;
  std::vector<End> ends_; // two a segment
};

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_FIELD_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_FIELD_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_FIELD_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/graph_segments.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/branch_axes.h>
#include <CGAL/Tubular_meshing/base/Corner_tree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing {

class Centerline_field::Impl {
public:
  typedef internal::Double_kernel::Point_3 Double_point;

  struct Location {
    size_type index;
    double t; // along the segment, 0 to 1
    Double_point point;
    double distance;
  };

  explicit Impl(const Graph& graph) {
    internal::Graph_segments all(graph);
    places_ = std::move(all.places);
    tree_ = internal::Corner_tree<Segment>(all.segments);
    const internal::Branch_axes axes(graph);
    ends_.reserve(2 * places_.size());
    for (const Place& place : places_)
      for (size_type i : {place.segment, place.segment + 1}) {
        const Graph::Branch& b = graph.branches()[place.branch];
        ends_.push_back(End{axes.tangents(place.branch)[i], axes.normals(place.branch)[i], graph.radii()[b.points[i]],
                            b.abscissa[i]});
      }
  }

  size_type number_of_segments() const { return places_.size(); }

  double radius(const Location& l) const {
    return (1 - l.t) * ends_[2 * l.index].radius + l.t * ends_[2 * l.index + 1].radius;
  }

  Location locate(const Double_point& q) const { return locate(q, number_of_segments()); }
  Location locate(const Double_point& q, size_type hint) const {
    const auto found = tree_.nearest_from(hint, q, (std::numeric_limits<double>::infinity)());
    // a point without a nearest segment has coordinates that are not numbers: any answer is as good, none may crash
    const size_type i = found.index < tree_.size() ? found.index : 0;
    const Segment s = tree_.shape(i);
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

private:
  typedef internal::Double_kernel::Vector_3 Double_vector;
  typedef internal::Double_kernel::Segment_3 Segment;
  typedef internal::Graph_segments::Place Place;

  // One end of a segment, as its branch sees it: at a bifurcation, each branch has its own direction.
  struct End {
    Double_vector tangent, normal;
    double radius, abscissa;
  };

  static Vector_3 vector(const Double_vector& v) { return Vector_3(v.x(), v.y(), v.z()); }

  internal::Corner_tree<Segment> tree_;
  std::vector<Place> places_;
  std::vector<End> ends_; // two a segment
};

CGAL_TUBULAR_MESHING_INLINE Centerline_field::Centerline_field(const Graph& graph) {
  if (graph.empty())
    throw Input_error("There are no centerlines; radius and direction of the vessels cannot be told without them.");
  impl_ = std::make_shared<const Impl>(graph);
}

CGAL_TUBULAR_MESHING_INLINE Centerline_field::size_type Centerline_field::number_of_segments() const {
  return impl_->number_of_segments();
}

CGAL_TUBULAR_MESHING_INLINE double Centerline_field::radius(const Point_3& x) const {
  return impl_->radius(impl_->locate(internal::to_double_point(x)));
}

CGAL_TUBULAR_MESHING_INLINE Centerline_field::Descriptors Centerline_field::descriptors(const Point_3& x) const {
  return impl_->descriptors(impl_->locate(internal::to_double_point(x)));
}

CGAL_TUBULAR_MESHING_INLINE Centerline_field::Descriptors Centerline_field::descriptors(const Point_3& x,
                                                                                        size_type& hint) const {
  const Impl::Location found = impl_->locate(internal::to_double_point(x), hint);
  hint = found.index;
  return impl_->descriptors(found);
}

CGAL_TUBULAR_MESHING_INLINE Centerline_field::Frame Centerline_field::frame(const Point_3& x) const {
  const Impl::Double_point q = internal::to_double_point(x);
  return impl_->frame(q, impl_->locate(q));
}

CGAL_TUBULAR_MESHING_INLINE std::pair<Centerline_field::Descriptors, Centerline_field::Frame>
Centerline_field::descriptors_and_frame(const Point_3& x) const {
  const Impl::Double_point q = internal::to_double_point(x);
  const Impl::Location l = impl_->locate(q);
  return std::make_pair(impl_->descriptors(l), impl_->frame(q, l));
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CENTERLINE_FIELD_IMPL_H

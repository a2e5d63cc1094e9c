// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_IN_METRIC_H
#define CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_IN_METRIC_H

#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Plane/Frontal_delaunay.h>
#include <CGAL/Tubular_meshing/Plane/Metric_plane.h>
#include <CGAL/Tubular_meshing/Plane/Plane_flips.h>
#include <CGAL/Tubular_meshing/Plane/Plane_size_control.h>
#include <CGAL/Tubular_meshing/Plane/Plane_smoothing.h>
#include <CGAL/Tubular_meshing/Plane/Point_insertion.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_polygons.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * A triangulated domain of the plane. The first points are those of the polygons that bound it, in their order, each
 * point as it was given; those inside follow. Triangles are counterclockwise. */
template <class Point_2> struct Plane_triangulation {
  std::vector<Point_2> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

namespace internal {

// The points that the caller wants, into the few triangles that there are yet. One on the boundary, or outside, is
// none.
template <class Plane> void insert_given_points(Plane& plane, const std::vector<Plane_point>& points) {
  Point_insertion<Plane> insertion(plane);
  for (const Plane_point& p : points) {
    const auto place = insertion.find(p);
    if (place.half_edge != Plane_store::none)
      insertion.insert(place, plane.node_at(p));
  }
}

// Points from the front inwards; again, where edges turn out to be too long after all.
template <class Plane> void insert_points(Plane& plane, const std::vector<Plane_point>& given) {
  const int most_rounds = 4;
  Plane_flips<Plane>(plane).make_delaunay();
  insert_given_points(plane, given);
  Plane_size_control<Plane> sizes(plane);
  std::size_t added = 1;
  for (int round = 0; round < most_rounds && added > 0; ++round) {
    Frontal_delaunay<Plane>(plane).run();
    added = sizes.split_long_edges();
  }
}

template <class Plane> void optimize_plane(Plane& plane, int passes) {
  const int sweeps = 3;
  Plane_flips<Plane> flips(plane);
  Plane_size_control<Plane> sizes(plane);
  for (int pass = 0; pass < passes; ++pass) {
    sizes.remove_crowded_vertices();
    flips.improve();
    Plane_smoothing<Plane> smoothing(plane);
    for (int k = 0; k < sweeps; ++k)
      smoothing.sweep();
    flips.improve();
  }
}

template <class Point_2, class Plane, class PolygonRange>
Plane_triangulation<Point_2> triangulation_of(const Plane& plane, const PolygonRange& polygons) {
  Plane_triangulation<Point_2> result;
  for (const auto& polygon : polygons)
    result.points.insert(result.points.end(), std::begin(polygon), std::end(polygon));
  const Plane_store& store = plane.store;
  std::vector<std::size_t> number(plane.nodes.size());
  for (Plane_store::Index v = 0; v < plane.nodes.size(); ++v)
    if (store.is_on_boundary(v)) {
      number[v] = v;
    } else if (store.is_vertex_alive(v)) {
      number[v] = result.points.size();
      result.points.emplace_back(plane.nodes[v].point.x(), plane.nodes[v].point.y());
    }
  for (Plane_store::Index t = 0; t < store.number_of_triangles(); ++t)
    if (store.is_alive(t))
      result.triangles.push_back(
          {number[store.origin(3 * t)], number[store.origin(3 * t + 1)], number[store.origin(3 * t + 2)]});
  return result;
}

template <class PointRange> std::vector<Plane_point> plane_points(const PointRange& points) {
  std::vector<Plane_point> result;
  for (const auto& p : points)
    result.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  return result;
}

template <class PolygonRange> Plane_polygons plane_polygons(const PolygonRange& polygons) {
  Plane_polygons result;
  for (const auto& polygon : polygons)
    result.push_back(plane_points(polygon));
  return result;
}

// A function of the caller's points as a function of ours.
template <class Point_2, class Function> auto on_plane_points(const Function& f) {
  if constexpr (std::is_same<Function, No_embedding>::value)
    return f;
  else
    return [&f](const Plane_point& p) { return f(Point_2(p.x(), p.y())); };
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * triangulates a domain of the plane with edges of length one, and triangles close to equilateral, in a given metric.
 *
 * An isotropic metric \f$ I / h^2(u) \f$ gives triangles of size h; the metric (11) that a parameterization induces
 * gives triangles that are of the wanted size and shape on the surface; an anisotropic one gives stretched triangles.
 *
 * Points are inserted by the frontal Delaunay method, \cgalCite{rebay1993}, generalized to a metric: triangles whose
 * circumradius is small enough are accepted, and the largest triangle beside an accepted one, or on the boundary, gets
 * a point at the apex of the equilateral triangle on their common edge, or at its circumcentre where that is nearer.
 * Lengths are (10), with sizes growing geometrically along an edge, so that places come out right where the metric
 * changes much from one end of an edge to the other. Passes of optimization follow: vertices that are too close are
 * removed, edges are flipped for the better worst quality, vertices inside are moved towards the apexes of the
 * equilateral triangles around them; no step lowers the worst quality \f$ \gamma_T \f$ (12) around it but the removal
 * of a crowded vertex, which leaves 0.7 at least, or what there was. Quality is measured in the mean metric of a
 * triangle's corners, or, if an embedding is given, on the triangle in space.
 *
 * The edges of the polygons are kept: they should have a length of about one in the metric. Where they are much
 * shorter, sizes grow gradually from theirs; where they are longer, triangles beside them are larger. Angles between
 * them that are acute in the metric give triangles as bad as the angle, but valid.
 *
 * The metric is asked for at points in the closed domain only: some four to seven times a triangle. Sizes should not
 * change by more than a factor of two or so over an edge: the mesh follows a sudden change, but with worse triangles,
 * and a spot that is finer than its surroundings, and smaller than their size, may pass unseen: give a point in it.
 *
 * O(n log n) in the number of triangles; 10<sup>5</sup> take about half a second. The result depends on the arguments
 * alone. Predicates are exact: triangles are positively oriented whatever the metric.
 *
 * \tparam PolygonRange a range of ranges of `Point_2`, a model of `Kernel::Point_2` for a kernel over `double`
 * \tparam MetricField_2 a function object with `Metric_tensor_2 operator()(const Point_2&) const`
 *
 * \param polygons the boundary, simple polygons of either orientation, without their first point repeated: the outer
 *        one first, then the holes. They must not touch
 * \param metric the metric, symmetric positive definite, in the inverse squares of lengths
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{embedding} \cgalParamDescription{a function object that gives, for a `Point_2`, the point in space
 *     (anything with `x()`, `y()` and `z()`) on the surface of which the plane is a parameterization: flips and moves
 *     are then judged by \f$ \gamma_T \f$ of the triangles in space. Give it with the metric induced by an isotropic
 *     size only} \cgalParamDefault{none} \cgalParamNEnd
 *   \cgalParamNBegin{interior_points} \cgalParamDescription{a `std::vector<Point_2>`: points to begin with, inside,
 *     where the metric is much finer than around. They may be moved later on} \cgalParamDefault{none} \cgalParamNEnd
 *   \cgalParamNBegin{optimization_passes} \cgalParamDescription{number of passes} \cgalParamDefault{2} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if there is no polygon, if one has fewer than three points, coordinates that are not finite or
 * all its points on a line, if polygons touch or cross, or if a hole is not inside the outer polygon and outside the
 * other holes \throws Parameter_error if the metric is not symmetric positive definite and finite somewhere, if it asks
 * for more than some 10<sup>8</sup> triangles, or if the number of passes is negative
 */
template <class PolygonRange, class MetricField_2, class NamedParameters = CGAL::parameters::Default_named_parameters>
auto triangulate_in_metric(const PolygonRange& polygons, const MetricField_2& metric,
                           const NamedParameters& np = CGAL::parameters::default_values()) {
  typedef typename std::decay<decltype(*std::begin(*std::begin(polygons)))>::type Point_2;
  const auto embedding = CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::embedding),
                                                            internal::No_embedding());
  const int passes = internal::choose(np, internal_np::optimization_passes, 2);
  if (passes < 0)
    throw Parameter_error("The number of optimization passes must not be negative, but is " + std::to_string(passes) +
                          ".");
  const auto field = internal::on_plane_points<Point_2>(metric);
  const auto image = internal::on_plane_points<Point_2>(embedding);
  typedef internal::Metric_plane<std::decay_t<decltype(field)>, std::decay_t<decltype(image)>> Plane;

  const internal::Plane_polygons rings = internal::plane_polygons(polygons);
  Plane plane(internal::Polygon_triangulator(rings).store(), rings, field, image);
  const auto given = internal::choose(np, internal_np::interior_points, std::vector<Point_2>());
  internal::insert_points(plane, internal::plane_points(given));
  internal::optimize_plane(plane, passes);
  return internal::triangulation_of<Point_2>(plane, polygons);
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_IN_METRIC_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_IN_METRIC_H
#define CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_IN_METRIC_H

#include <CGAL/Tubular_meshing/Plane/Plane_triangulation.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPlane
 *
 * What triangulate_in_metric() may be given beside the domain and the metric: its named parameters of the same names.
 */
struct Triangulate_in_metric_options {
  int optimization_passes = 2; ///< not negative

  Triangulate_in_metric_options() = default;
  template <class NamedParameters>
  explicit Triangulate_in_metric_options(const NamedParameters& np)
      : optimization_passes(internal::choose(np, internal_np::optimization_passes, 2)) {}
};

namespace internal {

/* triangulate_in_metric(), with points to begin with, under an embedding unless that is null. None if the polygons do
 * not bound a domain, as they touch each other, say; `problem` is a sentence on it then. */
std::optional<Plane_triangulation<Plane_point>> mesh_plane(const Plane_polygons& polygons, Plane_field metric,
                                                           const Plane_embedding* embedding,
                                                           const std::vector<Plane_point>& interior_points,
                                                           const Triangulate_in_metric_options& options,
                                                           std::string& problem);

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

} // namespace internal

/*! \ingroup PkgTubularMeshingPlane
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
 * \tparam PolygonRange a range of ranges of `Point_2`, a model of `Kernel::Point_2`; coordinates are taken as doubles
 * \tparam MetricField_2 a function object with `Metric_tensor_2 operator()(const Point_2&) const`
 *
 * \param polygons the boundary, simple polygons of either orientation, without their first point repeated: the outer
 *        one first, then the holes. They must not touch
 * \param metric the metric, symmetric positive definite, in the inverse squares of lengths
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{embedding}
 *     \cgalParamDescription{the surface of which the plane is a parameterization: flips and moves are then judged by
 *       \f$ \gamma_T \f$ of the triangles in space. Give it with the metric induced by an isotropic size only}
 *     \cgalParamType{a function object that gives, for a `Point_2`, the point in space: anything with `x()`, `y()` and
 *       `z()`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{interior_points}
 *     \cgalParamDescription{points to begin with, inside, where the metric is much finer than around. They may be moved
 *       later on}
 *     \cgalParamType{`std::vector<Point_2>`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{optimization_passes}
 *     \cgalParamDescription{number of passes}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{2}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if there is no polygon, if one has fewer than three points, coordinates that are not finite or
 * all its points on a line, if polygons touch or cross, or if a hole is not inside the outer polygon and outside the
 * other holes
 * \throws Parameter_error if the metric is not symmetric positive definite and finite somewhere, if it asks
 * for more than some 10<sup>8</sup> triangles, or if the number of passes is negative
 */
template <class PolygonRange, class MetricField_2, class NamedParameters = CGAL::parameters::Default_named_parameters>
auto triangulate_in_metric(const PolygonRange& polygons, const MetricField_2& metric,
                           const NamedParameters& np = CGAL::parameters::default_values()) {
  using internal::Plane_point;
  typedef typename std::decay<decltype(*std::begin(*std::begin(polygons)))>::type Point_2;
  const auto field = [&](const Plane_point& p) { return metric(Point_2(p.x(), p.y())); };
  const auto given = internal::choose(np, internal_np::interior_points, std::vector<Point_2>());
  const auto mesh = [&](const internal::Plane_embedding* embedding) {
    std::string problem;
    auto result = internal::mesh_plane(internal::plane_polygons(polygons), field, embedding,
                                       internal::plane_points(given), Triangulate_in_metric_options(np), problem);
    if (!result)
      throw Input_error(problem);
    return *std::move(result);
  };
  const auto embedding = CGAL::parameters::get_parameter(np, internal_np::embedding);
  Plane_triangulation<Plane_point> core;
  if constexpr (std::is_same<std::decay_t<decltype(embedding)>, CGAL::internal_np::Param_not_found>::value) {
    core = mesh(nullptr);
  } else {
    const auto image = [&](const Plane_point& p) {
      return internal::Vector_3d(internal::to_core(embedding(Point_2(p.x(), p.y()))));
    };
    const internal::Plane_embedding view(image);
    core = mesh(&view);
  }
  if constexpr (std::is_same<Point_2, Plane_point>::value) {
    return core;
  } else {
    Plane_triangulation<Point_2> result;
    for (const auto& polygon : polygons)
      result.points.insert(result.points.end(), std::begin(polygon), std::end(polygon));
    for (std::size_t i = result.points.size(); i < core.points.size(); ++i)
      result.points.emplace_back(core.points[i].x(), core.points[i].y());
    result.triangles = std::move(core.triangles);
    return result;
  }
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Plane/triangulate_in_metric_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_IN_METRIC_H

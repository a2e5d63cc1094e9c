// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_METRIC_FIELD_H
#define CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_METRIC_FIELD_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Fields/internal/Boundary_layer_sizes.h>
#include <CGAL/Tubular_meshing/Fields/internal/Layer_octree.h>
#include <CGAL/Tubular_meshing/Fields/internal/Wall_frames.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * The anisotropic metric of section 2.4: flat elements along the wall, which thicken inward from a first height by a
 * given growth, are long where the vessel is straight, and become isotropic in its core.
 *
 * - Across the wall the size is that of (4), \f$ h_n = h_n^0 + (r-1) d \f$ at the distance d from the wall, until the
 *   core's size is reached.
 * - Along the centerline and around it, the sizes at the wall are those of (5), N_p points on a circle of the
 *   surface's curvature in that direction. They change with d by (6) up to the layer's thickness δ, and never exceed
 *   the bound (9) of the smoothing ratio β. From δ to the local radius they pass over to the core's size, and on the
 * way exceed it by no more than β from one element to the next.
 * - In the core the size is 2 π r / N, in all directions, of the Centerline_sizing_field; its radius r, that of an
 *   aneurysm's sac included, is also the one to which δ and \f$ h_n^0 \f$ are relative.
 * - The normal direction e_n is that of the wall, which is that of x − x_c in a tube, and is right in a sac or at a
 *   junction too; it is averaged over a quarter of `smoothing_radius`. e_t is the centerline's direction, made
 *   perpendicular to it; e_bn is perpendicular to both.
 * Curvatures are those of compute_curvatures(), by absolute value in (5) and (9), with their sign in (6).
 *
 * Where the nearest branch or the nearest part of the wall changes, tensors are blended in the logarithmic sense, over
 * a fifth of a radius at the wall and half a radius inside: the metric is continuous in all of space, and positive
 * definite everywhere. Caps are no walls: the layer runs on to the openings.
 *
 * The field is sampled once, in O(n log n) for n faces and leaves of an octree; afterwards it depends on nothing that
 * it was built from. A query is O(log n), takes about a microsecond, allocates nothing, and is safe from several
 * threads. Copies are deep but for the wall's search tree.
 *
 * \cgalModels `MetricField_3`
 *
 * \tparam Point_3 a model of `Point_3`
 */
class Centerline_metric_field {
public:
  typedef Tubular_meshing::Point_3 Point_3;

  /*!
   * \tparam TriangleMesh a model of `FaceListGraph` with points of type `Point_3`
   * \param surface the lumen's surface, turned outward, its caps included or not
   * \param patches a readable property map from its faces to `int`; those of labels::wall are the wall
   * \param centerlines with the radii measured on this surface, as in a Tubular_model
   * \param np an optional sequence of named parameters among the ones listed below, and CGAL's `vertex_point_map`
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{boundary_layer_thickness} \cgalParamDescription{δ, relative to the local radius; above 0, at
   * most 1} \cgalParamDefault{0.3} \cgalParamNEnd \cgalParamNBegin{first_height} \cgalParamDescription{\f$ h_n^0 \f$,
   * the normal size at the wall, relative to the local radius; above 0} \cgalParamDefault{a twentieth of
   * `boundary_layer_thickness`} \cgalParamNEnd \cgalParamNBegin{growth} \cgalParamDescription{r, the ratio of
   * successive normal sizes; at least 1} \cgalParamDefault{1.3} \cgalParamNEnd \cgalParamNBegin{smoothing_ratio}
   * \cgalParamDescription{β, the largest ratio of two adjacent edges; at least 1, which allows no anisotropy at all}
   * \cgalParamDefault{1.5} \cgalParamNEnd \cgalParamNBegin{curvature_points} \cgalParamDescription{N_p, the number of
   * points on a full circle of the surface's curvature; at least 3} \cgalParamDefault{20} \cgalParamNEnd
   *   \cgalParamNBegin{points_per_circumference} \cgalParamDescription{N, which gives the core's size; at least 3}
   *     \cgalParamDefault{`curvature_points`} \cgalParamNEnd
   *   \cgalParamNBegin{max_anisotropy} \cgalParamDescription{largest ratio of the sizes at a point; at least 1}
   *     \cgalParamDefault{100} \cgalParamNEnd
   *   \cgalParamNBegin{min_size, max_size} \cgalParamDescription{limits of all sizes, lengths} \cgalParamDefault{0 and
   *     infinity} \cgalParamNEnd
   *   \cgalParamNBegin{gradation} \cgalParamDescription{of the core's sizes, see Centerline_sizing_field}
   *     \cgalParamDefault{1.3} \cgalParamNEnd
   *   \cgalParamNBegin{smoothing_radius} \cgalParamDescription{of curvatures, see compute_curvatures()}
   *     \cgalParamDefault{0.4} \cgalParamNEnd
   *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{0 takes all cores; the field is the same on any number}
   *     \cgalParamDefault{0} \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws Parameter_error if one of these is out of its range
   * \throws Input_error if there is no wall, or if there are no centerlines
   */
  template <class TriangleMesh, class FacePatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
  Centerline_metric_field(const TriangleMesh& surface, const FacePatchMap& patches, const Centerline_graph& centerlines,
                          const NamedParameters& np = CGAL::parameters::default_values())
      : sizes_(parameters_from(np)) {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    auto vpm = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                get_const_property_map(CGAL::vertex_point, surface));
    const int threads = internal::choose(np, internal_np::number_of_threads, 0);
    const double points = sizes_.parameters().core_points;
    const Centerline_field lines(centerlines);
    const Centerline_sizing_field size(lines, Wall_distance(surface, patches, labels::wall, np),
                                       parameters::points_per_circumference(points)
                                           .gradation(internal::choose(np, internal_np::gradation, 1.3))
                                           .number_of_threads(threads));
    const auto radius = [&](const auto& p) { return size(Point_3(p.x(), p.y(), p.z())) * points / (2 * CGAL_PI); };

    std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
    internal::Indexed_wall wall(
        surface, vpm, [&](auto f) { return int(get(patches, f)) == labels::wall; }, vertices);
    const auto at = [&](internal::Indexed_wall::Index v) { return get(vpm, vertices[v]); };
    const internal::Wall_frames frames(
        std::move(wall), [&](internal::Indexed_wall::Index v) { return radius(internal::to_double_point(at(v))); },
        [&](internal::Indexed_wall::Index v) {
          const auto e = lines.frame(at(v)).e_t;
          return internal::Vector_3d(CGAL::to_double(e.x()), CGAL::to_double(e.y()), CGAL::to_double(e.z()));
        },
        sizes_.parameters().smoothing_radius, threads);
    octree_ = internal::Layer_octree(frames, radius, threads);
    wall_ = frames.tree();
  }

  /// The metric at a point; outside of the surface too. A point whose coordinates are not numbers has some metric.
  Metric_tensor_3 operator()(const Point_3& p) const {
    const internal::Double_kernel::Point_3 q = internal::to_double_point(p);
    const internal::Layer_octree::State s = octree_(q.x(), q.y(), q.z());
    const auto h = sizes_(s, distance(q, s));
    // the exponential of -2 (ln h_n e_n e_nᵀ + ln h_t e_t e_tᵀ + ln h_bn e_bn e_bnᵀ), the three dyads of sum one
    const Metric_tensor_3 log_sizes = h.log_across * Metric_tensor_3() + (h.log_normal - h.log_across) * s.across_wall +
                                      (h.log_along - h.log_across) * s.along;
    return (-2 * log_sizes).exp();
  }

  /// The local radius at a point: that of the vessel, or of the sac of an aneurysm; continuous.
  double radius(const Point_3& p) const {
    const internal::Double_kernel::Point_3 q = internal::to_double_point(p);
    return octree_(q.x(), q.y(), q.z()).radius;
  }

  /// The distance from a point to the wall; caps do not count.
  double distance_to_wall(const Point_3& p) const {
    return std::sqrt(wall_.nearest(internal::to_double_point(p)).squared_distance);
  }

  /// The number of leaves of the octree on which the field is sampled.
  std::size_t number_of_leaves() const { return octree_.number_of_leaves(); }

private:
  /* Within the layer to the last digit, for the first layer is a hundredth of the radius high; where nothing depends
   * much on it, by interpolation; in between a mixture. */
  double distance(const internal::Double_kernel::Point_3& q, const internal::Layer_octree::State& s) const {
    const double layer = sizes_.parameters().thickness * s.radius, blend = 0.15 * s.radius;
    const double x = (s.distance - layer) / blend;
    if (x >= 1)
      return s.distance;
    // a face nearby gives the search a bound, which is seldom far from the result
    const double bound = squared_distance(internal::projection(wall_.shape(s.near_face), q), q);
    const double d = std::sqrt((std::min)(bound, wall_.nearest(q, bound).squared_distance));
    return x <= 0 ? d : d + x * x * (3 - 2 * x) * (s.distance - d);
  }

  template <class NamedParameters>
  static internal::Boundary_layer_parameters parameters_from(const NamedParameters& np) {
    internal::Boundary_layer_parameters p;
    p.thickness = internal::choose(np, internal_np::boundary_layer_thickness, 0.3);
    p.first_height = internal::choose(np, internal_np::first_height, p.thickness / 20);
    p.growth = internal::choose(np, internal_np::growth, 1.3);
    p.smoothing_ratio = internal::choose(np, internal_np::smoothing_ratio, 1.5);
    p.curvature_points = internal::choose(np, internal_np::curvature_points, 20.);
    p.core_points = internal::choose(np, internal_np::points_per_circumference, p.curvature_points);
    p.max_anisotropy = internal::choose(np, internal_np::max_anisotropy, 100.);
    p.min_size = internal::choose(np, internal_np::min_size, 0.);
    p.max_size = internal::choose(np, internal_np::max_size, (std::numeric_limits<double>::infinity)());
    p.smoothing_radius = internal::choose(np, internal_np::smoothing_radius, 0.4);
    p.check();
    return p;
  }

  internal::Boundary_layer_sizes sizes_;
  internal::Layer_octree octree_;
  internal::Nearest_tree<internal::Double_kernel::Triangle_3> wall_;
};

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_METRIC_FIELD_H

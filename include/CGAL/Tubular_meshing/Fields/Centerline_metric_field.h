// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_METRIC_FIELD_H
#define CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_METRIC_FIELD_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Fields/curvature.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingFields
 *
 * The options of Centerline_metric_field: its named parameters.
 */
struct Centerline_metric_field_options {
  double boundary_layer_thickness = 0.3;
  double first_height = boundary_layer_thickness / 20;
  double growth = 1.3;
  double smoothing_ratio = 1.5;
  double curvature_points = 20;
  double points_per_circumference = curvature_points;
  double max_anisotropy = 100;
  double min_size = 0;
  double max_size = (std::numeric_limits<double>::infinity)();
  double gradation = 1.3;
  double smoothing_radius = 0.4;
  int number_of_threads = 0;

  Centerline_metric_field_options() = default;
  template <class NamedParameters> explicit Centerline_metric_field_options(const NamedParameters& np) {
    using internal::choose;
    boundary_layer_thickness = choose(np, internal_np::boundary_layer_thickness, boundary_layer_thickness);
    first_height = choose(np, internal_np::first_height, boundary_layer_thickness / 20);
    growth = choose(np, internal_np::growth, growth);
    smoothing_ratio = choose(np, internal_np::smoothing_ratio, smoothing_ratio);
    curvature_points = choose(np, internal_np::curvature_points, curvature_points);
    points_per_circumference = choose(np, internal_np::points_per_circumference, curvature_points);
    max_anisotropy = choose(np, internal_np::max_anisotropy, max_anisotropy);
    min_size = choose(np, internal_np::min_size, min_size);
    max_size = choose(np, internal_np::max_size, max_size);
    gradation = choose(np, internal_np::gradation, gradation);
    smoothing_radius = choose(np, internal_np::smoothing_radius, smoothing_radius);
    number_of_threads = choose(np, internal_np::number_of_threads, number_of_threads);
  }
};

/*! \ingroup PkgTubularMeshingFields
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
 * threads. Copies share what it is sampled on.
 *
 * \cgalModels `MetricField_3`
 */
class Centerline_metric_field {
public:
  typedef Tubular_meshing::Point_3 Point_3;

  /*!
   * \tparam TriangleMesh a model of `FaceListGraph`, of any kernel
   * \param surface the lumen's surface, turned outward, its caps included or not
   * \param patches a readable property map from its faces to `int`; those of labels::wall are the wall
   * \param centerlines with the radii measured on this surface, as in a Tubular_model
   * \param np an optional sequence of named parameters among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{boundary_layer_thickness}
   *     \cgalParamDescription{δ, relative to the local radius; above 0, at most 1}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{0.3}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{first_height}
   *     \cgalParamDescription{\f$ h_n^0 \f$, the normal size at the wall, relative to the local radius; above 0}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{a twentieth of `boundary_layer_thickness`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{growth}
   *     \cgalParamDescription{r, the ratio of successive normal sizes; at least 1}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{1.3}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{smoothing_ratio}
   *     \cgalParamDescription{β, the largest ratio of two adjacent edges; at least 1, which allows no anisotropy at
   *       all}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{1.5}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{curvature_points}
   *     \cgalParamDescription{N_p, the number of points on a full circle of the surface's curvature; at least 3}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{20}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{points_per_circumference}
   *     \cgalParamDescription{N, which gives the core's size; at least 3}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`curvature_points`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{max_anisotropy}
   *     \cgalParamDescription{largest ratio of the sizes at a point; at least 1}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{100}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{min_size}
   *     \cgalParamDescription{lower limit of all sizes, a length}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{0}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{max_size}
   *     \cgalParamDescription{upper limit of all sizes, a length}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{infinity}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{gradation}
   *     \cgalParamDescription{of the core's sizes, see Centerline_sizing_field}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{1.3}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{smoothing_radius}
   *     \cgalParamDescription{of curvatures, see compute_curvatures()}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{0.4}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{number_of_threads}
   *     \cgalParamDescription{0 takes all cores; the field is the same on any number}
   *     \cgalParamType{`int`}
   *     \cgalParamDefault{0}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_point_map}
   *     \cgalParamDescription{the points of the surface's vertices}
   *     \cgalParamType{a readable property map from its vertices to points}
   *     \cgalParamDefault{`get(CGAL::vertex_point, surface)`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws Parameter_error if one of these is out of its range
   * \throws Input_error if there is no wall, or if there are no centerlines
   */
  template <class TriangleMesh, class FacePatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
  Centerline_metric_field(const TriangleMesh& surface, const FacePatchMap& patches, const Centerline_graph& centerlines,
                          const NamedParameters& np = CGAL::parameters::default_values()) {
    std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
    build(internal::indexed_triangles(
              surface, [&](auto f) { return int(get(patches, f)) == labels::wall; }, np, vertices),
          centerlines, Centerline_metric_field_options(np));
  }

  /*! The same, with options in a struct. */
  Centerline_metric_field(const Surface& surface, Face_patch_map patches, const Centerline_graph& centerlines,
                          const Centerline_metric_field_options& options) {
    std::vector<Surface::Vertex_index> vertices;
    build(internal::indexed_triangles(
              surface, [&](Surface::Face_index f) { return patches[f] == labels::wall; },
              CGAL::parameters::default_values(), vertices),
          centerlines, options);
  }

  /// The metric at a point; outside of the surface too. A point whose coordinates are not numbers has some metric.
  Metric_tensor_3 operator()(const Point_3& p) const;

  /// The local radius at a point: that of the vessel, or of the sac of an aneurysm; continuous.
  double radius(const Point_3& p) const;

  /// The distance from a point to the wall; caps do not count.
  double distance_to_wall(const Point_3& p) const;

  /// The number of leaves of the octree on which the field is sampled.
  std::size_t number_of_leaves() const;

private:
  void build(const internal::Indexed_triangles& wall, const Centerline_graph& centerlines,
             const Centerline_metric_field_options& options);

  class Impl;
  std::shared_ptr<const Impl> impl_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_METRIC_FIELD_H

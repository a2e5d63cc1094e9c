// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_H
#define CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_H

#include <CGAL/Tubular_meshing/Fields/Wall_samples.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesh_estimate.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher_options.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 *
 * About how many cells a mesh will have, as Mesher::estimate() tells it, of a model that needs no centerlines: the local
 * radius is that at some places of the wall, see wall_samples(). It takes a tenth of the time of centerlines and mesh
 * sizes, on a surface of 400,000 triangles 0.3 s, and is for a first look at surfaces so large; its numbers differ from
 * those of Mesher::estimate() by some hundredths, see `benchmark/results.md`. On surfaces of eight vertices round a vessel, or
 * fewer, there are no radii to be had in this way: the number comes out far too small, and a sentence among the fallbacks of
 * the estimate says so.
 */
class Sampled_estimator {
public:
  /*! Whether it can be told of such a mesh: not with sizes that are asked for at places or branches. */
  static bool can_estimate(const Mesher_options& options) { return options.size.size_requests.empty(); }

  /*! \param model kept by reference; of make_model_without_centerlines()
   * \param np as of Mesher */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Sampled_estimator(const Tubular_model& model, const NamedParameters& np = CGAL::parameters::default_values())
      : Sampled_estimator(model, Mesher_options(np)) {}
  Sampled_estimator(const Tubular_model& model, const Mesher_options& options);

  void set_points_per_circumference(double points) { options_.set_points(points, given_); }
  double points_per_circumference() const { return options_.size.points_per_circumference; }

  /*! The length of the vessels is that of the wall's area by the circumference there. Whether there can be blocks of
   * hexahedra is not looked into: it is taken that there are.
   * \exception Parameter_error if can_estimate() is false */
  Mesh_estimate estimate(Mesh_type type, Surface_elements elements = Surface_elements::triangles) const;

private:
  // The mesh sizes at the samples, limited in their growth; and in between these.
  std::vector<double> sizes(double least, double largest) const;
  Lumen_integrals integrals(const std::vector<double>& sizes, double layer_thickness) const;
  void add_metric(Lumen_integrals& integrals) const;
  // What a function of the distance from the wall and the radius gives over a column of the lumen, over all of it.
  template <class Column> double over_lumen(const Column& column) const;
  std::size_t nearest_sample(const Point_3& p) const;
  bool is_coarse() const;

  const Tubular_model& model_;
  Mesher_options options_, given_;
  std::vector<Wall_sample> samples_;
  double volume_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Pipelines/Sampled_estimator_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_H

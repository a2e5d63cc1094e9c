// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_H
#define CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_H

#include <CGAL/Tubular_meshing/Fields/Wall_samples.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesh_estimate.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher_options.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 *
 * About how many cells a mesh will have, as Mesher::estimate() tells it, of a model that needs no centerlines: the local
 * radius is that at some places of the wall, see wall_samples(). It takes a tenth of the time of centerlines and mesh
 * sizes, on a surface of 400,000 triangles 0.3 s, and is for a first look at surfaces so large; its numbers differ from
 * those of Mesher::estimate() by some hundredths, see `benchmark/results.md`.
 */
class Sampled_estimator {
public:
  /*! Whether it can be told of such a mesh: not where the mesh follows the centerlines (of anisotropic elements, and in
   * blocks), and not with sizes that are asked for at places or branches. */
  static bool can_estimate(Mesh_type type, Surface_elements elements, const Mesher_options& options);

  /*! \param model kept by reference; of make_model_without_centerlines()
   * \param np as of Mesher */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Sampled_estimator(const Tubular_model& model, const NamedParameters& np = CGAL::parameters::default_values())
      : Sampled_estimator(model, Mesher_options(np)) {}
  Sampled_estimator(const Tubular_model& model, const Mesher_options& options);

  void set_points_per_circumference(double points) { options_.size.points_per_circumference = points; }
  double points_per_circumference() const { return options_.size.points_per_circumference; }

  /*! The length of the vessels is that of the wall's area by the circumference there.
   * \exception Parameter_error if can_estimate() is false */
  Mesh_estimate estimate(Mesh_type type, Surface_elements elements = Surface_elements::triangles) const;

private:
  // The mesh sizes at the samples, limited in their growth.
  std::vector<double> sizes() const;
  Lumen_integrals integrals(const std::vector<double>& sizes, double layer_thickness) const;

  const Tubular_model& model_;
  Mesher_options options_;
  std::vector<Wall_sample> samples_;
  double volume_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Pipelines/Sampled_estimator_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PIPELINES_SAMPLED_ESTIMATOR_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_SAMPLED_METRIC_H
#define CGAL_TUBULAR_MESHING_FIELDS_SAMPLED_METRIC_H

#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/Wall_samples.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingFields
 *
 * The sizes of Centerline_metric_field at some places of a lumen's wall, and inward from them, without centerlines: the
 * direction along the vessel is that to which the wall's normals are perpendicular, within a radius; curvatures are averaged
 * as there, but at these places only. For counts of elements; there is no field between the places.
 *
 * O(n) in the wall's triangles, 1 µs each, and 0.1 ms each sample.
 */
class Sampled_metric {
public:
  struct Sizes {
    double normal, along, across; ///< across the wall; along it and the vessel; along it and round the vessel
  };

  /*! \param surface the lumen, closed, turned outward
   * \param patch the labels of its faces: those that are not labels::wall are caps, and no wall
   * \param samples of the same surface
   * \param radii of each the radius that sizes in the vessel's core go with
   * \param options lengths in the unit of the surface
   * \exception Parameter_error if one of the options is out of its range */
  Sampled_metric(const Surface& surface, const Face_patch_map& patch, const std::vector<Wall_sample>& samples,
                 const std::vector<double>& radii, const Centerline_metric_field_options& options);

  /*! At a distance from the wall, from a sample inward; O(1). */
  Sizes operator()(std::size_t sample, double distance) const;

private:
  class Impl;
  std::shared_ptr<const Impl> impl_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Fields/Sampled_metric_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_FIELDS_SAMPLED_METRIC_H

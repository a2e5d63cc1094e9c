// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_REFINED_METRIC_FIELD_H
#define CGAL_TUBULAR_MESHING_FIELDS_REFINED_METRIC_FIELD_H

#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <utility>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingFields
 *
 * A metric with requests on sizes (Size_requests): at each point the sizes in all directions are divided by the factor
 * by which one isotropic size field, with the requests, is smaller than another, without. Both are graded, so that the
 * metric is as continuous as before.
 *
 * \cgalModels `MetricField_3`
 */
class Refined_metric_field {
public:
  typedef Tubular_meshing::Point_3 Point_3;

  Refined_metric_field(Centerline_metric_field metric, Centerline_sizing_field without, Centerline_sizing_field with)
      : metric_(std::move(metric))
      , without_(std::move(without))
      , with_(std::move(with)) {}

  Metric_tensor_3 operator()(const Point_3& p) const {
    const double factor = without_(p) / with_(p);
    return (factor * factor) * metric_(p);
  }

private:
  Centerline_metric_field metric_;
  Centerline_sizing_field without_, with_;
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_FIELDS_REFINED_METRIC_FIELD_H

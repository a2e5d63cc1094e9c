// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by Doxygen only.

/*! \ingroup PkgTubularMeshingConcepts
 * \cgalConcept
 *
 * A Riemannian metric in space: at each point the sizes that a mesh's elements are to have there, and their directions.
 *
 * Whatever takes a metric field evaluates it at the vertices of meshes, millions of times and from several threads, and
 * expects of it that
 * - it is a function: the same point always has the same metric;
 * - it is positive definite wherever it is asked for, `Metric_tensor_3::is_valid()`: on the closed domain, and outside
 *   as far away as the surface of a mesh may be from that of the domain;
 * - it changes gradually: from one element to the next by no more than the ratio that neighbouring elements are to have.
 *   Where it jumps no mesh can follow it.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Tubular_meshing::Centerline_metric_field}
 * \cgalHasModelsEnd
 *
 * A user's own field is a class of a few lines:
 * \code
 * struct Shock {
 *   typedef Kernel::Point_3 Point_3;
 *   CGAL::Tubular_meshing::Metric_tensor_3 operator()(const Point_3& p) const { // fine across the plane x = 0
 *     const double h = 0.01 + 0.2 * std::abs(p.x());
 *     return {1 / (h * h), 0, 0, 25, 0, 25};
 *   }
 * };
 * \endcode
 */
class MetricField_3 {
public:
  /// `CGAL::Tubular_meshing::Point_3`, or a type that is constructible from it and from three coordinates.
  typedef unspecified_type Point_3;

  /// The metric at `p`. Safe to call from several threads.
  CGAL::Tubular_meshing::Metric_tensor_3 operator()(const Point_3& p) const;
};

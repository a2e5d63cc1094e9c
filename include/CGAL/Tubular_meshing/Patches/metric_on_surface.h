// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_METRIC_ON_SURFACE_H
#define CGAL_TUBULAR_MESHING_PATCHES_METRIC_ON_SURFACE_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>

namespace CGAL::Tubular_meshing {

/*! \addtogroup PkgTubularMeshingRef
 * @{
 * \name Metrics of space in a plane
 *
 * Two ways to restrict a Metric_tensor_3 M to a plane. Both are equal where the plane's normal is a direction of M, as
 * it is for all isotropic ones. They take constant time and throw nothing. */
///@{

/*! The section: the lengths that vectors of the plane have in M. It is what a mesh of that very plane is to be made by,
 * such as a cap.
 *
 * \param m positive definite
 * \param a,b unit vectors along the plane, perpendicular to each other: the axes of the result */
template <class Vector_3>
Metric_tensor_2 metric_section(const Metric_tensor_3& m, const Vector_3& a, const Vector_3& b) {
  return {m.squared_length(a), m.dot(a, b), m.squared_length(b)};
}

/*! The shadow: a vector has the length of the shortest one that the plane's normal projects onto it, so that the unit
 * ball is the projection of that of M, \f$ (T^T M^{-1} T)^{-1} \f$ for T = (a, b).
 *
 * This is what a surface is to be meshed by whose normal is meant to be a direction of M, but is so by and large only,
 * as those of facets are. In a boundary layer the size across is much less than those along the wall: of a section,
 * tilted by the angle φ, it would make a size of \f$ h_n / \sin φ \f$; the shadow changes by a factor cos φ, however
 * thin the layer.
 *
 * \param m positive definite
 * \param a,b unit vectors along the plane, perpendicular to each other: the axes of the result */
template <class Vector_3>
Metric_tensor_2 metric_shadow(const Metric_tensor_3& m, const Vector_3& a, const Vector_3& b) {
  const Metric_tensor_3::Vector n(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  // the Schur complement: the least of |v + s n| over s, squared, is a quadratic form of v too
  const double an = m.dot(a, n), bn = m.dot(b, n), nn = m.squared_length(n);
  return {m.squared_length(a) - an * an / nn, m.dot(a, b) - an * bn / nn, m.squared_length(b) - bn * bn / nn};
}

///@}
/*! @} */

namespace internal {

// A metric of space, as a caller gives it.
typedef Function_view<Metric_tensor_3(const Point_3&)> Metric_function;

} // namespace internal

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_METRIC_ON_SURFACE_H

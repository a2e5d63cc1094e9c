// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_SHAPE_MEASURES_H
#define CGAL_TUBULAR_MESHING_QUALITY_SHAPE_MEASURES_H

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Tubular_meshing {

namespace internal {

// eq. (16)
inline double tetrahedron_Q(const std::array<Vector_3d, 4>& p, const std::array<Metric_tensor_3, 4>& metric) {
  const Metric_tensor_3 mean = 0.25 * (metric[0] + metric[1] + metric[2] + metric[3]);
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      sum += mean.squared_length(p[i] - p[j]);
  const double volume = std::abs(signed_volume(p[0], p[1], p[2], p[3])) * mean.density();
  return volume > 0 ? sum * std::sqrt(sum) / (regular_tetrahedron_ratio * volume)
                    : (std::numeric_limits<double>::infinity)();
}

} // namespace internal

/*! \addtogroup PkgTubularMeshingRef
 * @{
 * \name Shape measures of single elements
 *
 * The measures by which the paper judges its meshes, eq. (12)-(17). Points are of any type with `x()`, `y()`, `z()`
 * convertible to `double`; the numbering of an element's vertices is that of `Mixed_mesh`. All take constant time and
 * throw nothing; a degenerate element has the worst value of its measure. */
///@{

/*! \f$ \gamma_T \f$ of (12): twice the ratio of inscribed to circumscribed radius; 1 is equilateral, 0 degenerate. */
template <class Point> double triangle_gamma(const Point& p, const Point& q, const Point& r) {
  typedef internal::Vector_3d V;
  return internal::triangle_gamma(V(p), V(q), V(r));
}

/*! \f$ \gamma_\tau \f$ of (13): \f$ 2\sqrt 6 \f$ times the ratio of inscribed radius to longest edge; 1 is regular, 0
 * flat, negative inverted. */
template <class Point> double tetrahedron_gamma(const Point& p, const Point& q, const Point& r, const Point& s) {
  typedef internal::Vector_3d V;
  return internal::tetrahedron_gamma(V(p), V(q), V(r), V(s));
}

/*! \f$ \eta_q \f$ of (14), from the interior angles of a quadrilateral: 1 is a rectangle, 0 has a straight angle. */
template <class Point> double quad_eta(const std::array<Point, 4>& p) {
  typedef internal::Vector_3d V;
  return internal::quad_eta({V(p[0]), V(p[1]), V(p[2]), V(p[3])});
}

/*! \f$ \zeta_H \f$ of (15), the equiangular skewness over the six faces of a hexahedron: 1 is a brick, 0 flat. */
template <class Point> double hexahedron_zeta(const std::array<Point, 8>& p) {
  typedef internal::Vector_3d V;
  return internal::hexahedron_zeta({V(p[0]), V(p[1]), V(p[2]), V(p[3]), V(p[4]), V(p[5]), V(p[6]), V(p[7])});
}

/*! The scaled Jacobian of a hexahedron: the smallest Jacobian at its eight corners, each divided by the lengths of the
 * three edges there; 1 is a brick, 0 has a flat corner, negative is inverted. */
template <class Point> double hexahedron_jacobian(const std::array<Point, 8>& p) {
  typedef internal::Vector_3d V;
  return internal::scaled_jacobian<8>({V(p[0]), V(p[1]), V(p[2]), V(p[3]), V(p[4]), V(p[5]), V(p[6]), V(p[7])});
}

/*! The smallest Jacobian at the corners of a pyramid's base, each divided by the lengths of the three edges there:
 * \f$ \sqrt{1/2} \f$ on a square where the sides are equilateral, 0 flat, negative inverted. */
template <class Point> double pyramid_jacobian(const std::array<Point, 5>& p) {
  typedef internal::Vector_3d V;
  return internal::scaled_jacobian<5>({V(p[0]), V(p[1]), V(p[2]), V(p[3]), V(p[4])});
}

/*! The smallest Jacobian at the corners of a prism, each divided by the lengths of the three edges there: \f$
 * \sqrt{3/4} \f$ where the sides are upright on equilateral triangles, 0 flat, negative inverted. */
template <class Point> double prism_jacobian(const std::array<Point, 6>& p) {
  typedef internal::Vector_3d V;
  return internal::scaled_jacobian<6>({V(p[0]), V(p[1]), V(p[2]), V(p[3]), V(p[4]), V(p[5])});
}

/*! \f$ Q_\tau \f$ of (16), with the mean of the metrics at the four vertices, scaled to 1 for a regular tetrahedron of
 * the metric; infinite for a flat one. A metric is given as xx, xy, xz, yy, yz, zz.
 */
template <class Point>
double tetrahedron_Q(const std::array<Point, 4>& p, const std::array<std::array<double, 6>, 4>& metric) {
  typedef internal::Vector_3d V;
  typedef Metric_tensor_3 M;
  return internal::tetrahedron_Q({V(p[0]), V(p[1]), V(p[2]), V(p[3])},
                                 {M(metric[0]), M(metric[1]), M(metric[2]), M(metric[3])});
}

/*! The length (10) of a segment, the metric varying linearly between its ends: Metric_tensor_3::edge_length_linear().
 */
template <class Point>
double metric_length(const Point& p, const Point& q, const std::array<double, 6>& at_p,
                     const std::array<double, 6>& at_q) {
  typedef internal::Vector_3d V;
  return Metric_tensor_3::edge_length_linear(V(q) - V(p), Metric_tensor_3(at_p), Metric_tensor_3(at_q));
}

///@}
/*! @} */

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUALITY_SHAPE_MEASURES_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_SHAPE_ENERGY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_SHAPE_ENERGY_H

#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/newton_steps.h>

#include <cmath>

namespace CGAL::Tubular_meshing::internal {

/* The sum of the shape measures Q of the elements around a vertex, as a function of the vertex's position, with its
 * gradient and Hessian. For a tetrahedron Q is the inverse measure of eq. (16) in the identity metric, S^{3/2} / V with
 * S the sum of the squared edges; for a triangle it is S / area; both are 1 for a regular element and go to infinity
 * for a flat one, so that descending the sum never inverts an element. Where S is quadratic and V is linear in the
 * position, the derivatives are exact; a triangle's area is taken in its own plane.
 */
struct Shape_energy {
  double value = 0;
  Vector_3d gradient;
  Symmetric_matrix_3d hessian;

  // The tetrahedron of x and the facet abc, counterclockwise from outside. False if it is inverted.
  bool add_tetrahedron(const Vector_3d& x, const Vector_3d& a, const Vector_3d& b, const Vector_3d& c,
                       bool with_derivatives) {
    const Vector_3d u = a - x, v = b - x, w = c - x;
    const double six_v = dot(u, cross(v, w));
    if (six_v <= 0)
      return false;
    const double s = squared_norm(u) + squared_norm(v) + squared_norm(w) + squared_norm(a - b) + squared_norm(b - c) +
                     squared_norm(c - a);
    const double root = std::sqrt(s), k = 6 / (regular_tetrahedron_ratio * six_v);
    const double q = k * s * root;
    value += q;
    if (!with_derivatives)
      return true;
    const Vector_3d ds = -2. * (u + v + w), dv = (-1 / six_v) * cross(b - a, c - a); // dv = ∇V / V
    gradient += k * 1.5 * root * ds;
    gradient += -q * dv;
    hessian.add_diagonal(k * 9 * root);
    hessian.add_product(k * 0.75 / root, ds, ds);
    hessian.add_product(-2 * k * 1.5 * root, ds, dv);
    hessian.add_product(2 * q, dv, dv);
    return true;
  }

  void scale(double weight) {
    value *= weight;
    gradient = weight * gradient;
    hessian.scale(weight);
  }

  // The triangle of x and the edge ab, whose unit normal was `normal`; times a weight.
  bool add_triangle(const Vector_3d& x, const Vector_3d& a, const Vector_3d& b, const Vector_3d& normal, double weight,
                    bool with_derivatives) {
    const Vector_3d u = a - x, v = b - x;
    const double two_a = dot(cross(u, v), normal);
    if (two_a <= 0)
      return false;
    const double s = squared_norm(u) + squared_norm(v) + squared_norm(a - b);
    const double k = weight / (2 * std::sqrt(3.) * two_a), q = k * s;
    value += q;
    if (!with_derivatives)
      return true;
    const Vector_3d ds = -2. * (u + v), da = (1 / two_a) * cross(normal, b - a);
    gradient += k * ds;
    gradient += -q * da;
    hessian.add_diagonal(4 * k);
    hessian.add_product(-2 * k, ds, da);
    hessian.add_product(2 * q, da, da);
    return true;
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_SHAPE_ENERGY_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_STAR_ENERGY_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_STAR_ENERGY_H

#include <CGAL/Tubular_meshing/base/newton_steps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::array<Vector_3d, 8> Hexahedron_points;
typedef std::array<double, 3> Axis_lengths; // of a hexahedron's edges 01, 03, 04, and of those opposite to them

/* The corner at the other end of a hexahedron's edge, by corner and axis (01, 03 and 04 are the axes); and the sign of
 * the three edges of a corner in this order. */
constexpr int hexahedron_neighbor[8][3] = {{1, 3, 4}, {0, 2, 5}, {3, 1, 6}, {2, 0, 7},
                                           {5, 7, 0}, {4, 6, 1}, {7, 5, 2}, {6, 4, 3}};
constexpr double hexahedron_corner_sign[8] = {1, -1, 1, -1, -1, 1, -1, 1};

/* How bad corners are, and how the bad count against the others. A corner's edges, in units of their target lengths, are
 * the columns of J W⁻¹: with s the sum of their squares and D their determinant it counts ((s/3)^{3/2} / χ(D))^power,
 * where χ(D) = (D + √(ε² + D²)) / 2 is D without ε, and positive for any D with it. A corner of a brick counts 1. */
struct Corner_penalty {
  int power = 1;      // 1, 2, 4 or 8
  double epsilon = 0; // 0: corners with D <= 0 count without bound

  double operator()(double s, double determinant) const {
    if (epsilon == 0 && !(determinant > 0))
      return (std::numeric_limits<double>::infinity)();
    const double x = chi(determinant);
    return raised(s * s * s / (27 * x * x));
  }
  double chi(double determinant) const {
    if (epsilon == 0)
      return determinant;
    const double root = std::sqrt(epsilon * epsilon + determinant * determinant);
    return determinant > 0 ? (determinant + root) / 2 : epsilon * epsilon / (2 * (root - determinant));
  }
  // χ' / χ
  double chi_slope(double determinant) const {
    return 1 / (epsilon == 0 ? determinant : std::sqrt(epsilon * epsilon + determinant * determinant));
  }
  // of the square of the measure: no root is taken but for power 1
  double raised(double squared) const {
    if (power == 1)
      return std::sqrt(squared);
    for (int p = 2; p < power; p *= 2)
      squared *= squared;
    return squared;
  }
};

/* The energy of the corners around a vertex that have a part in it, as a function of the vertex's displacement d. In d
 * each corner's D is linear and its s is quadratic with a multiple of the identity, so that a corner is nine numbers,
 * from which values and exact derivatives follow for any d. Without ε, the sum is convex. */
class Star_energy {
public:
  void clear() {
    terms_.clear();
    shortest2_ = (std::numeric_limits<double>::infinity)();
    longest2_ = 0;
  }

  // The four corners of a hexahedron in which its vertex c has a part.
  void add_hexahedron(const Hexahedron_points& p, int c, const Axis_lengths& inverse) {
    const int* next = hexahedron_neighbor[c];
    std::array<Vector_3d, 3> own;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector_3d e = p[std::size_t(next[i])] - p[std::size_t(c)];
      const double length2 = squared_norm(e);
      shortest2_ = (std::min)(shortest2_, length2);
      longest2_ = (std::max)(longest2_, length2);
      own[i] = inverse[i] * e;
    }
    add_own(own, hexahedron_corner_sign[c], inverse);
    for (std::size_t i = 0; i < 3; ++i)
      add_neighbor(p, next[i], i, -1. * own[i], inverse);
  }

  double value(const Vector_3d& d, const Corner_penalty& penalty) const {
    double sum = 0;
    for (const Term& t : terms_)
      sum += penalty(t.square(d), t.determinant + dot(t.slope, d));
    return sum;
  }

  // The least D.
  double least_determinant() const {
    double least = (std::numeric_limits<double>::infinity)();
    for (const Term& t : terms_)
      least = (std::min)(least, t.determinant);
    return least;
  }

  struct Derivatives {
    double value = 0;
    Vector_3d gradient;
    Symmetric_matrix_3d hessian; // without the part of χ'', and so positive semidefinite
  };
  Derivatives derivatives(const Vector_3d& d, const Corner_penalty& penalty) const {
    Derivatives sum;
    const double p = penalty.power;
    for (const Term& t : terms_) {
      const double s = t.square(d), determinant = t.determinant + dot(t.slope, d);
      const double f = penalty(s, determinant), r = penalty.chi_slope(determinant);
      const Vector_3d u = t.linear + (2 * t.quadratic) * d;
      const Vector_3d g = (1.5 / s) * u - r * t.slope; // of the logarithm of the measure
      sum.value += f;
      sum.gradient += (p * f) * g;
      sum.hessian.add_diagonal(3 * p * f * t.quadratic / s);
      sum.hessian.add_square(p * p * f, g);
      sum.hessian.add_square(-1.5 * p * f / (s * s), u);
      sum.hessian.add_square(p * f * r * r, t.slope);
    }
    return sum;
  }

  // Of the edges at the vertex.
  double squared_shortest_edge() const { return shortest2_; }
  double squared_longest_edge() const { return longest2_; }

private:
  struct Term {
    double determinant; // D(0)
    Vector_3d slope;    // of D
    double square_0;    // s(0)
    Vector_3d linear;   // s = s(0) + linear · d + quadratic d²
    double quadratic;

    double square(const Vector_3d& d) const { return square_0 + dot(linear, d) + quadratic * squared_norm(d); }
  };

  void add_own(const std::array<Vector_3d, 3>& a, double sign, const Axis_lengths& inverse) {
    const Vector_3d bc = cross(a[1], a[2]), ca = cross(a[2], a[0]), ab = cross(a[0], a[1]);
    Term t;
    t.determinant = sign * dot(a[0], bc);
    t.slope = -sign * (inverse[0] * bc + inverse[1] * ca + inverse[2] * ab);
    t.square_0 = squared_norm(a[0]) + squared_norm(a[1]) + squared_norm(a[2]);
    t.linear = -2. * (inverse[0] * a[0] + inverse[1] * a[1] + inverse[2] * a[2]);
    t.quadratic = inverse[0] * inverse[0] + inverse[1] * inverse[1] + inverse[2] * inverse[2];
    terms_.push_back(t);
  }

  // The corner q at the other end of the edge of axis i, which is `edge` as seen from there.
  void add_neighbor(const Hexahedron_points& p, int q, std::size_t i, const Vector_3d& edge,
                    const Axis_lengths& inverse) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Vector_3d& at = p[std::size_t(q)];
    const Vector_3d b = inverse[j] * (p[std::size_t(hexahedron_neighbor[q][j])] - at);
    const Vector_3d c = inverse[k] * (p[std::size_t(hexahedron_neighbor[q][k])] - at);
    const Vector_3d normal = hexahedron_corner_sign[q] * cross(b, c);
    Term t;
    t.determinant = dot(edge, normal);
    t.slope = inverse[i] * normal;
    t.square_0 = squared_norm(edge) + squared_norm(b) + squared_norm(c);
    t.linear = (2 * inverse[i]) * edge;
    t.quadratic = inverse[i] * inverse[i];
    terms_.push_back(t);
  }

  std::vector<Term> terms_;
  double shortest2_ = 0, longest2_ = 0;
};

/* The means of a hexahedron's parallel edges. */
inline Axis_lengths mean_edge_lengths(const Hexahedron_points& p) {
  Axis_lengths lengths = {0, 0, 0};
  for (int c = 0; c < 8; ++c)
    for (std::size_t i = 0; i < 3; ++i) {
      const int other = hexahedron_neighbor[c][i];
      if (c < other)
        lengths[i] += norm(p[std::size_t(other)] - p[std::size_t(c)]) / 4;
    }
  return lengths;
}

/* The least D of a hexahedron's corners, and the sum of what they count. */
struct Hexahedron_energy {
  double least_determinant = (std::numeric_limits<double>::infinity)(), value = 0;
};
inline Hexahedron_energy hexahedron_energy(const Hexahedron_points& p, const Axis_lengths& inverse,
                                           const Corner_penalty& penalty) {
  Hexahedron_energy result;
  for (std::size_t c = 0; c < 8; ++c) {
    std::array<Vector_3d, 3> a;
    double s = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = inverse[i] * (p[std::size_t(hexahedron_neighbor[c][i])] - p[c]);
      s += squared_norm(a[i]);
    }
    const double determinant = hexahedron_corner_sign[c] * dot(a[0], cross(a[1], a[2]));
    result.least_determinant = (std::min)(result.least_determinant, determinant);
    result.value += penalty(s, determinant);
  }
  return result;
}

/* scaled_jacobian() of a hexahedron, each edge's length taken once. */
inline double least_scaled_jacobian(const Hexahedron_points& p) {
  std::array<std::array<Vector_3d, 3>, 8> edges;
  for (std::size_t c = 0; c < 8; ++c)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t other = std::size_t(hexahedron_neighbor[c][i]);
      if (c > other)
        continue;
      edges[c][i] = normalized(p[other] - p[c]);
      edges[other][i] = -1. * edges[c][i];
    }
  double least = 1;
  for (std::size_t c = 0; c < 8; ++c)
    least = (std::min)(least, hexahedron_corner_sign[c] * dot(edges[c][0], cross(edges[c][1], edges[c][2])));
  return least;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_STAR_ENERGY_H

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_ELEMENT_MEASURES_H
#define CGAL_TUBULAR_MESHING_BASE_ELEMENT_MEASURES_H

#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Tubular_meshing::internal {

constexpr double pi = 3.14159265358979323846;

// (Σ e²)^{3/2} / V of a regular tetrahedron: makes eq. (16) one there.
constexpr double regular_tetrahedron_ratio = 124.70765814495915;

// Positive when 0,1,2 turns counterclockwise seen from 3.
inline double signed_volume(const Vector_3d& p0, const Vector_3d& p1, const Vector_3d& p2, const Vector_3d& p3) {
  return dot(cross(p1 - p0, p2 - p0), p3 - p0) / 6;
}

// eq. (12): twice the ratio of inscribed to circumscribed radius.
inline double triangle_gamma(const Vector_3d& p, const Vector_3d& q, const Vector_3d& r) {
  const double a = norm(q - r), b = norm(r - p), c = norm(p - q);
  const double product = a * b * c;
  const double area = norm(cross(q - p, r - p)) / 2;
  return product > 0 ? 16 * area * area / (product * (a + b + c)) : 0;
}

// eq. (13): 2√6 times the ratio of inscribed radius to longest edge; negative for an inverted tetrahedron.
inline double tetrahedron_gamma(const Vector_3d& p0, const Vector_3d& p1, const Vector_3d& p2, const Vector_3d& p3) {
  const Vector_3d a = p1 - p0, b = p2 - p0, c = p3 - p0;
  const Vector_3d ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
  const double six_volumes = dot(ab, c);
  const double two_areas = norm(ab) + norm(bc) + norm(ca) + norm(ab + bc + ca);
  const double longest = (std::max)({squared_norm(a), squared_norm(b), squared_norm(c), squared_norm(a - b),
                                     squared_norm(b - c), squared_norm(c - a)});
  return longest > 0 && two_areas > 0 ? 4.898979485566356 * six_volumes / (two_areas * std::sqrt(longest)) : 0;
}

// The angle at q between p and r, in radians.
inline double angle(const Vector_3d& p, const Vector_3d& q, const Vector_3d& r) {
  const Vector_3d u = p - q, v = r - q;
  return std::atan2(norm(cross(u, v)), dot(u, v));
}

// Smallest and largest interior angle of a quadrilateral, in radians.
inline std::array<double, 2> angle_range(const std::array<Vector_3d, 4>& p) {
  std::array<double, 2> range = {pi, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = angle(p[(i + 3) % 4], p[i], p[(i + 1) % 4]);
    range = {(std::min)(range[0], a), (std::max)(range[1], a)};
  }
  return range;
}

// eq. (14)
inline double quad_eta(const std::array<Vector_3d, 4>& p) {
  const auto range = angle_range(p);
  return (std::max)(0., 1 - (2 / pi) * (std::max)(pi / 2 - range[0], range[1] - pi / 2));
}

// eq. (15), over the angles of the six faces
inline double hexahedron_zeta(const std::array<Vector_3d, 8>& p) {
  double smallest = pi, largest = 0;
  for (const auto& f : Cell_topology<8>::quads()) {
    const auto range = angle_range({p[f[0]], p[f[1]], p[f[2]], p[f[3]]});
    smallest = (std::min)(smallest, range[0]);
    largest = (std::max)(largest, range[1]);
  }
  return 1 - (std::max)(largest - pi / 2, pi / 2 - smallest) / (pi / 2);
}

// The smallest scaled Jacobian at the corners of a cell that have one.
template <std::size_t N> double scaled_jacobian(const std::array<Vector_3d, N>& p) {
  double smallest = 1;
  for (const Corner& c : Cell_topology<N>::corners()) {
    const Vector_3d u = p[c[1]] - p[c[0]], v = p[c[2]] - p[c[0]], w = p[c[3]] - p[c[0]];
    const double lengths = norm(u) * norm(v) * norm(w);
    smallest = (std::min)(smallest, lengths > 0 ? dot(cross(u, v), w) / lengths : 0);
  }
  return smallest;
}

// At the corners of the base.
inline double pyramid_jacobian(const std::array<Vector_3d, 5>& p) {
  return scaled_jacobian(p);
}

// At the six corners.
inline double prism_jacobian(const std::array<Vector_3d, 6>& p) {
  return scaled_jacobian(p);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_ELEMENT_MEASURES_H

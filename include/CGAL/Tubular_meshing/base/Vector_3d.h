// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_VECTOR_3D_H
#define CGAL_TUBULAR_MESHING_BASE_VECTOR_3D_H

#include <cmath>

namespace CGAL::Tubular_meshing::internal {

/* Three doubles: positions and vectors inside the mesh optimizers, where compact arrays and inlined arithmetic matter
 * and no kernel's predicate is needed. */
struct Vector_3d {
  double x = 0, y = 0, z = 0;

  Vector_3d() = default;
  Vector_3d(double x, double y, double z)
      : x(x)
      , y(y)
      , z(z) {}
  template <class P>
  explicit Vector_3d(const P& p)
      : x(p.x())
      , y(p.y())
      , z(p.z()) {}

  double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  Vector_3d& operator+=(const Vector_3d& v) {
    x += v.x;
    y += v.y;
    z += v.z;
    return *this;
  }
};

inline Vector_3d operator+(const Vector_3d& a, const Vector_3d& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector_3d operator-(const Vector_3d& a, const Vector_3d& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector_3d operator*(double s, const Vector_3d& v) {
  return {s * v.x, s * v.y, s * v.z};
}
// As a point or a vector of a kernel.
template <class P> P as(const Vector_3d& v) {
  return P(v.x, v.y, v.z);
}
inline double dot(const Vector_3d& a, const Vector_3d& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector_3d cross(const Vector_3d& a, const Vector_3d& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double squared_norm(const Vector_3d& v) {
  return dot(v, v);
}
inline double norm(const Vector_3d& v) {
  return std::sqrt(dot(v, v));
}
inline Vector_3d normalized(const Vector_3d& v) {
  const double n = norm(v);
  return n > 0 ? (1 / n) * v : v;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_VECTOR_3D_H

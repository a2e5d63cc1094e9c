// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_ENERGY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_ENERGY_H

#include <CGAL/Tubular_meshing/Volume/internal/remeshing/metric_quality.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/newton_steps.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Tubular_meshing::internal {

// The same quantity of four tetrahedra, with which the processor calculates at the same time.
typedef Eigen::Array<double, 4, 1> Lanes;

struct Vector_lanes {
  Lanes x, y, z;
  friend Vector_lanes operator+(const Vector_lanes& u, const Vector_lanes& v) {
    return {u.x + v.x, u.y + v.y, u.z + v.z};
  }
  friend Vector_lanes operator-(const Vector_lanes& u, const Vector_lanes& v) {
    return {u.x - v.x, u.y - v.y, u.z - v.z};
  }
  friend Vector_lanes operator-(const Vector_lanes& u, const Vector_3d& p) { return {u.x - p.x, u.y - p.y, u.z - p.z}; }
  friend Lanes dot(const Vector_lanes& u, const Vector_lanes& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
  friend Vector_lanes cross(const Vector_lanes& u, const Vector_lanes& v) {
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  }
  Lanes magnitude() const { return x.abs() + y.abs() + z.abs(); }
};

struct Symmetric_lanes {
  Lanes xx, xy, xz, yy, yz, zz;

  Vector_lanes operator*(const Vector_lanes& v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
  }
  Lanes squared_length(const Vector_lanes& v) const { return dot(v, *this * v); }
  // By elimination, as of Metric_tensor_3.
  Lanes determinant() const {
    const Lanes p = xx * yy - xy * xy, q = xx * yz - xy * xz, r = xx * zz - xz * xz;
    return (p * r - q * q) / xx;
  }
};

/* Four facets opposite to a vertex, counterclockwise from outside: their corners, and the sums of the metrics there. Where
 * there are fewer, the last of them fill the rest, with the weight 0. */
struct Four_facets {
  Vector_lanes a, b, c;
  Symmetric_lanes metrics;
  Lanes weight;

  void set(int k, const Metric_point& p, const Metric_point& q, const Metric_point& r) {
    const auto put = [k](Vector_lanes& to, const Vector_3d& x) {
      to.x[k] = x.x;
      to.y[k] = x.y;
      to.z[k] = x.z;
    };
    put(a, p.position);
    put(b, q.position);
    put(c, r.position);
    const Metric_tensor_3 sum = p.metric + q.metric + r.metric;
    metrics.xx[k] = sum.xx;
    metrics.xy[k] = sum.xy;
    metrics.xz[k] = sum.xz;
    metrics.yy[k] = sum.yy;
    metrics.yz[k] = sum.yz;
    metrics.zz[k] = sum.zz;
    weight[k] = 1;
  }
  // Of k facets, the rest.
  void fill(int k) {
    for (int n = k; n < 4; ++n) {
      for (Vector_lanes* v : {&a, &b, &c})
        for (Lanes* x : {&v->x, &v->y, &v->z})
          (*x)[n] = (*x)[k - 1];
      for (Lanes* m : {&metrics.xx, &metrics.xy, &metrics.xz, &metrics.yy, &metrics.yz, &metrics.zz})
        (*m)[n] = (*m)[k - 1];
      weight[n] = 0;
    }
  }
};

/* What is to be small around a vertex, as a function of its position: of each tetrahedron its Q, eq. (16), and how far
 * its edges are from unit length, s + 1/s with s their mean square; in a boundary layer the height as well. Q goes to
 * infinity for a flat tetrahedron: descending the sum never inverts one. Derivatives hold the metrics fixed. */
struct Metric_energy {
  static constexpr double size_weight = 1;
  static constexpr double height_weight = 8; // some six of the two dozen tetrahedra have to do with it
  static constexpr double height_bound = 2;

  double value = 0;
  Vector_3d gradient;
  Symmetric_matrix_3d hessian;
  double size2; // the square of the unit length

  explicit Metric_energy(double size2 = 1)
      : size2(size2) {}

  /* The tetrahedra that the vertex spans with these facets, each in its mean metric. False if one of them is inverted;
   * without derivatives, as of a place to go to, also if it is flat but for rounding, see is_positive(). */
  template <bool With_derivatives> bool add(const Four_facets& f, const Metric_point& x) {
    const Vector_lanes u = f.a - x.position, v = f.b - x.position, w = f.c - x.position, normal = cross(v, w);
    const Lanes volume = dot(u, normal);
    const Lanes least = With_derivatives ? Lanes::Zero() : Lanes(1000 * rounding(u, v, w, x.position));
    if (!(volume > least).all())
      return false;
    const Metric_tensor_3& m = x.metric;
    const Symmetric_lanes mean = {0.25 * (f.metrics.xx + m.xx), 0.25 * (f.metrics.xy + m.xy),
                                  0.25 * (f.metrics.xz + m.xz), 0.25 * (f.metrics.yy + m.yy),
                                  0.25 * (f.metrics.yz + m.yz), 0.25 * (f.metrics.zz + m.zz)};
    const Lanes density = (2 * mean.determinant().max(0.)).sqrt(), d = density * volume;
    const Vector_lanes sum = u + v + w, mean_sum = mean * sum;
    const Lanes s =
        (4 * (mean.squared_length(u) + mean.squared_length(v) + mean.squared_length(w)) - dot(sum, mean_sum)) *
        (1. / 6);
    const Lanes root = s.sqrt(), over_d = 1 / d, over_s = 1 / s, q = s * root * over_d;
    value += (f.weight * (q + size_weight * (s * (1 / size2) + size2 * over_s))).sum();
    if constexpr (With_derivatives)
      add_derivatives(f.weight, mean, mean_sum, cross(v - u, w - u), density, root, over_d, over_s, q);
    return d.minCoeff() > 0;
  }

  /* The height h of the vertex above a facet of which the layer is to be as high as the metric's size across it:
   * s = h + 1/h - 2, in that size. A regular tetrahedron is somewhat lower, and where facets meet at an angle that the
   * metric does not know of, tetrahedra are much higher. Where they cannot but be so, that must not cost all of their
   * shape: what counts is s / (1 + s/b), b at most. `n`: the facet's normal, `to_facet`: from the vertex to the facet.
   */
  bool add_height(const Vector_3d& n, const Vector_3d& to_facet, const Metric_tensor_3& at_facet,
                  bool with_derivatives) {
    const double scale = at_facet.length(n) / std::sqrt(size2), h = scale * dot(n, to_facet);
    if (!(h > 0))
      return false;
    const double s = h + 1 / h - 2, share = 1 / (1 + s / height_bound);
    value += height_weight * share * s;
    if (!with_derivatives)
      return true;
    // by h; the negative part of the second derivative is left out
    const Vector_3d dh = -scale * n;
    gradient += height_weight * share * share * (1 - 1 / (h * h)) * dh;
    hessian.add_product(height_weight * share * share * 2 / (h * h * h), dh, dh);
    return true;
  }

private:
  // Of the determinants of u, v, w, edges from p.
  static Lanes rounding(const Vector_lanes& u, const Vector_lanes& v, const Vector_lanes& w, const Vector_3d& p) {
    const Lanes lu = u.magnitude(), lv = v.magnitude(), lw = w.magnitude();
    const double lp = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
    return std::numeric_limits<double>::epsilon() * (lp + lu + lv + lw) * (lu * lv + lv * lw + lw * lu);
  }

  // `area`: the normal of the facets, as long as their area, twice
  void add_derivatives(const Lanes& weight, const Symmetric_lanes& mean, const Vector_lanes& mean_sum,
                       const Vector_lanes& area, const Lanes& density, const Lanes& root, const Lanes& over_d,
                       const Lanes& over_s, const Lanes& q) {
    const Lanes over_s2 = over_s * over_s, root_over_d = root * over_d;
    // by s and by d; s is quadratic with the Hessian `mean`, d is linear
    const Lanes f_s = weight * (1.5 * root_over_d + size_weight * (1 / size2 - size2 * over_s2));
    const Lanes f_d = -weight * q * over_d;
    const Lanes f_ss = weight * (0.75 * root_over_d * over_s + 2 * size_weight * size2 * over_s2 * over_s);
    const Lanes f_sd = -1.5 * weight * root_over_d * over_d, f_dd = 2 * weight * q * over_d * over_d;
    const Lanes third = Lanes::Constant(-1. / 3), minus = -density;
    const Vector_lanes ds = {third * mean_sum.x, third * mean_sum.y, third * mean_sum.z};
    const Vector_lanes dd = {minus * area.x, minus * area.y, minus * area.z};
    gradient +=
        Vector_3d((f_s * ds.x + f_d * dd.x).sum(), (f_s * ds.y + f_d * dd.y).sum(), (f_s * ds.z + f_d * dd.z).sum());
    // an indefinite part of the Hessian of s is left out
    const Lanes f_m = f_s.max(0.);
    const Vector_lanes p = {f_ss * ds.x + f_sd * dd.x, f_ss * ds.y + f_sd * dd.y, f_ss * ds.z + f_sd * dd.z};
    const Vector_lanes r = {f_sd * ds.x + f_dd * dd.x, f_sd * ds.y + f_dd * dd.y, f_sd * ds.z + f_dd * dd.z};
    hessian.xx += (f_m * mean.xx + p.x * ds.x + r.x * dd.x).sum();
    hessian.xy += (f_m * mean.xy + p.x * ds.y + r.x * dd.y).sum();
    hessian.xz += (f_m * mean.xz + p.x * ds.z + r.x * dd.z).sum();
    hessian.yy += (f_m * mean.yy + p.y * ds.y + r.y * dd.y).sum();
    hessian.yz += (f_m * mean.yz + p.y * ds.z + r.y * dd.z).sum();
    hessian.zz += (f_m * mean.zz + p.z * ds.z + r.z * dd.z).sum();
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_ENERGY_H

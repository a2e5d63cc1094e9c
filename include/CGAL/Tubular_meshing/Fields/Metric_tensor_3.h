// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_METRIC_TENSOR_3_H
#define CGAL_TUBULAR_MESHING_FIELDS_METRIC_TENSOR_3_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/internal/Symmetric_eigen_solver_3.h>
#include <CGAL/Tubular_meshing/Fields/internal/symmetric_functions_3.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingFields
 *
 * A symmetric 3×3 tensor, positive definite when it is the metric of a mesh: a vector e has the length
 * \f$ \sqrt{e^T M e} \f$, and the size h in the direction of a unit eigenvector belongs to the eigenvalue
 * \f$ 1/h^2 \f$. The unit of M is that of one over a length squared.
 *
 * Six doubles and nothing else: trivially copyable, and laid out as in the point array `metric` of our files. Vectors
 * may be of any type with `operator[]`: of a CGAL kernel over doubles, of Eigen, an array. All functions take constant
 * time and throw nothing; logarithm and exponential take 0.1 µs, those that decompose (sizes, intersection, …) about
 * half a microsecond, the others a few multiplications.
 */
class Metric_tensor_3 {
public:
  typedef internal::Vector_3d Vector; ///< three doubles, `x`, `y` and `z`

  double xx = 1, xy = 0, xz = 0, yy = 1, yz = 0, zz = 1;

  /// The sizes, the smallest one first, and the unit vectors along which they hold, perpendicular to each other.
  struct Eigen_system {
    std::array<double, 3> sizes;
    std::array<Vector, 3> directions;
  };

  /// The identity: size one in all directions.
  Metric_tensor_3() = default;
  Metric_tensor_3(double xx, double xy, double xz, double yy, double yz, double zz)
      : xx(xx)
      , xy(xy)
      , xz(xz)
      , yy(yy)
      , yz(yz)
      , zz(zz) {}
  explicit Metric_tensor_3(const std::array<double, 6>& c)
      : Metric_tensor_3(c[0], c[1], c[2], c[3], c[4], c[5]) {}

  /// The same size `h` in all directions.
  static Metric_tensor_3 isotropic(double h) {
    const double s = 1 / (h * h);
    return {s, 0, 0, s, 0, s};
  }

  /// (3): size `h[i]` in the direction `axes[i]`; the axes are unit vectors perpendicular to each other.
  template <class Vector_3>
  static Metric_tensor_3 from_sizes(const std::array<double, 3>& h, const std::array<Vector_3, 3>& axes) {
    return from_eigenvalues({1 / (h[0] * h[0]), 1 / (h[1] * h[1]), 1 / (h[2] * h[2])}, axes);
  }

  /// The tensor with given eigenvalues along unit vectors that are perpendicular to each other.
  template <class Vector_3>
  static Metric_tensor_3 from_eigenvalues(const std::array<double, 3>& l, const std::array<Vector_3, 3>& axes) {
    Metric_tensor_3 m(0, 0, 0, 0, 0, 0);
    for (int i = 0; i < 3; ++i)
      m += l[i] * dyad(axes[i]);
    return m;
  }

  /// v vᵀ, of rank one.
  template <class Vector_3> static Metric_tensor_3 dyad(const Vector_3& v) {
    return {v[0] * v[0], v[0] * v[1], v[0] * v[2], v[1] * v[1], v[1] * v[2], v[2] * v[2]};
  }

  /// From the upper triangle of a matrix with `operator()(row, column)`, as Eigen::Matrix3d.
  template <class Matrix> static Metric_tensor_3 from_matrix(const Matrix& m) {
    return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
  }
  template <class Matrix> Matrix to_matrix() const {
    Matrix m;
    m(0, 0) = xx;
    m(1, 1) = yy;
    m(2, 2) = zz;
    m(0, 1) = m(1, 0) = xy;
    m(0, 2) = m(2, 0) = xz;
    m(1, 2) = m(2, 1) = yz;
    return m;
  }
  /// xx xy xz yy yz zz
  std::array<double, 6> components() const { return {xx, xy, xz, yy, yz, zz}; }

  bool is_finite() const { // one test for six: NaN and infinity survive the multiplication by zero
    return (xx + xy + xz + yy + yz + zz) * 0. == 0.;
  }

  /// Whether it is finite and positive definite, with more than rounding to spare.
  bool is_valid() const {
    const double margin = 1e-15; // of the pivots of Cholesky's factorization
    if (!is_finite() || !(xx > 0))
      return false;
    const double p = yy - xy * xy / xx, q = yz - xy * xz / xx;
    if (!(p > margin * yy))
      return false;
    return zz - xz * xz / xx - q * q / p > margin * zz;
  }

  /// The determinant of a metric, by elimination: cofactors lose twice as many digits where sizes differ much.
  double determinant() const {
    const double p = xx * yy - xy * xy, q = xx * yz - xy * xz, r = xx * zz - xz * xz;
    return (p * r - q * q) / xx;
  }

  /// Elements of the metric's unit size in a unit of volume: the square root of the determinant.
  double density() const { return std::sqrt((std::max)(determinant(), 0.)); }

  Metric_tensor_3 inverse() const {
    const double s = 1 / determinant();
    return {s * (yy * zz - yz * yz), s * (xz * yz - xy * zz), s * (xy * yz - xz * yy),
            s * (xx * zz - xz * xz), s * (xy * xz - xx * yz), s * (xx * yy - xy * xy)};
  }

  /// \f$ a^T M b \f$; the metric (11) of a surface x(u, v) is made of its values for \f$ x_{,u} \f$ and \f$ x_{,v} \f$.
  template <class V, class W> double dot(const V& a, const W& b) const {
    return a[0] * (xx * b[0] + xy * b[1] + xz * b[2]) + a[1] * (xy * b[0] + yy * b[1] + yz * b[2]) +
           a[2] * (xz * b[0] + yz * b[1] + zz * b[2]);
  }
  template <class V> double squared_length(const V& e) const {
    return xx * e[0] * e[0] + yy * e[1] * e[1] + zz * e[2] * e[2] +
           2 * (xy * e[0] * e[1] + xz * e[0] * e[2] + yz * e[1] * e[2]);
  }
  template <class V> double length(const V& e) const { return std::sqrt((std::max)(squared_length(e), 0.)); }

  /// The size in the direction of a vector of any length but zero: |e| over its length in the metric.
  template <class V> double size_along(const V& e) const {
    return std::sqrt((e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) / squared_length(e));
  }

  /*! \name The length (10) of an edge
   * It depends on how the metric varies between the edge's ends, of which there are two readings. Each is integrated in
   * closed form. They agree where the metric is constant, and differ by 8 % where the size doubles along the edge.
   *
   * What fills or remeshes a surface measures by edge_length(), of tangential metrics in the plane; so do
   * Metric_criteria_3 and metric_surface_report(). anisotropic_tetrahedral_remeshing() works by edge_length_linear(),
   * which costs no logarithm, and its meshes are judged by it: metric_length() and the efficiency (17) of
   * quality_report(). */
  ///@{
  /*! The size grows geometrically from a point with metric `m0` to one with metric `m1`:
   * \f$ (l_1 - l_0) / \ln(l_1/l_0) \f$. */
  template <class V> static double edge_length(const V& e, const Metric_tensor_3& m0, const Metric_tensor_3& m1) {
    const double l0 = m0.length(e), l1 = m1.length(e), ratio = l1 / l0, d = ratio - 1;
    if (std::abs(d) < 1e-3) // the logarithmic mean by its series, where the quotient cancels; error d⁴/38
      return l0 * (1 + d * (1 / 2. - d * (1 / 12. - d / 24)));
    return d < (std::numeric_limits<double>::max)() && ratio > 0 ? l0 * d / std::log(ratio) : (l0 + l1) / 2;
  }

  /*! The metric varies linearly: \f$ \frac 2 3 (l_0^2 + l_0 l_1 + l_1^2) / (l_0 + l_1) \f$. */
  template <class V>
  static double edge_length_linear(const V& e, const Metric_tensor_3& m0, const Metric_tensor_3& m1) {
    const double s = m0.squared_length(e), t = m1.squared_length(e);
    const double l = std::sqrt((std::max)(s, 0.)), m = std::sqrt((std::max)(t, 0.));
    return l + m > 0 ? 2. / 3 * (s + l * m + t) / (l + m) : 0;
  }
  ///@}

  /// Sizes and directions. For an isotropic tensor the directions are the coordinate axes.
  Eigen_system eigen_system() const {
    const internal::Symmetric_eigen_solver_3 s(components());
    Eigen_system result;
    const std::array<int, 3> order = s.descending_order();
    for (int i = 0; i < 3; ++i) {
      result.sizes[i] = 1 / std::sqrt(s.values()[order[i]]);
      result.directions[i] = s.direction(order[i]);
    }
    return result;
  }
  /// The sizes, the smallest one first.
  std::array<double, 3> sizes() const { return eigen_system().sizes; }
  /// The largest size over the smallest.
  double anisotropy() const {
    const std::array<double, 3> h = sizes();
    return h[2] / h[0];
  }

  /// The tensor with the same directions whose eigenvalues are a function of those of this one.
  template <class Function> Metric_tensor_3 with_eigenvalues(const Function& f) const {
    const internal::Symmetric_eigen_solver_3 s(components());
    const std::array<double, 3>& l = s.values();
    return from_eigenvalues({f(l[0]), f(l[1]), f(l[2])},
                            std::array<Vector, 3>{s.direction(0), s.direction(1), s.direction(2)});
  }

  /*! The matrix logarithm: symmetric, but no metric. Logarithms form a vector space, in which metrics are added,
   * weighted and interpolated; exp() leads back \cgalCite{arsigny2006}. */
  Metric_tensor_3 log() const {
    std::array<double, 6> fast;
    if (internal::fast_logarithm(components(), fast))
      return Metric_tensor_3(fast);
    return with_eigenvalues([](double l) { return std::log((std::max)(l, (std::numeric_limits<double>::min)())); });
  }
  Metric_tensor_3 exp() const {
    std::array<double, 6> fast;
    if (internal::fast_exponential(components(), fast))
      return Metric_tensor_3(fast);
    return with_eigenvalues([](double l) { return std::exp(l); });
  }

  /*! The log-Euclidean mean \f$ \exp((1-t) \log M_0 + t \log M_1) \f$: interpolates sizes geometrically, and is
   * positive definite whenever both are. */
  static Metric_tensor_3 interpolate(const Metric_tensor_3& m0, const Metric_tensor_3& m1, double t) {
    return ((1 - t) * m0.log() + t * m1.log()).exp();
  }

  /// The same of many metrics: `weights` are as many as `metrics`, not negative, and their sum is not zero.
  template <class MetricRange, class WeightRange>
  static Metric_tensor_3 interpolate(const MetricRange& metrics, const WeightRange& weights) {
    Metric_tensor_3 sum(0, 0, 0, 0, 0, 0);
    double total = 0;
    auto w = std::begin(weights);
    for (const Metric_tensor_3& m : metrics) {
      sum += double(*w) * m.log();
      total += *w++;
    }
    return ((1 / total) * sum).exp();
  }

  /*! The intersection: the metric of the largest ellipsoid that shares the conjugate axes of both unit ellipsoids and
   * lies in both. Its sizes are nowhere larger than those of `a` or `b`. By simultaneous reduction: with
   * \f$ A = L L^T \f$ and \f$ L^{-1} B L^{-T} = V \Lambda V^T \f$ it is
   * \f$ L V \max(1, \Lambda) V^T L^T \f$. */
  static Metric_tensor_3 intersection(const Metric_tensor_3& a, const Metric_tensor_3& b) {
    return combination(a, b, [](double l) { return (std::max)(l, 1.); });
  }

  /*! What this metric allows at a distance: its sizes grown along the vector e by the rate at which, in a mesh of unit
   * edges, neighbouring edges have the ratio β. A mesh is graded if every metric is its own intersection with those of
   * its neighbours, grown.
   *
   * \param e from this metric's point to the other
   * \param beta at least 1; 1 allows no growth at all
   * \param physical 0: all sizes grow by the same factor, 1 + l ln β with l the length of e in the metric, so that the
   *   ratio of sizes is kept; 1: each size h grows by |e| ln β, so that far away the metric is isotropic; in between,
   *   the product of powers of both that Alauzet \cgalCite{alauzet2010} recommends, with 1/8
   */
  template <class V> Metric_tensor_3 grown(const V& e, double beta, double physical = 1. / 8) const {
    const double rate = std::log(beta), in_metric = 1 + rate * length(e);
    if (physical <= 0)
      return (1 / (in_metric * in_metric)) * *this;
    const double step = rate * std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
    const double scale = std::pow(in_metric, -2 * (1 - physical));
    return with_eigenvalues([&](double l) {
      return scale * l * std::pow(1 + step * std::sqrt((std::max)(l, 0.)), -2 * physical); //
    });
  }

  /// One step of gradation along an edge: each end is intersected with the other one grown(); e leads from m0 to m1.
  template <class V>
  static void limit_growth(const V& e, Metric_tensor_3& m0, Metric_tensor_3& m1, double beta,
                           double physical = 1. / 8) {
    const Metric_tensor_3 from_0 = m0.grown(e, beta, physical), from_1 = m1.grown(e, beta, physical);
    m0 = intersection(m0, from_1);
    m1 = intersection(m1, from_0);
  }

  /// The metric of which all sizes are limited to an interval, along the same directions.
  Metric_tensor_3 clamped(double min_size, double max_size) const {
    const double largest = 1 / (min_size * min_size), smallest = 1 / (max_size * max_size);
    return with_eigenvalues([&](double l) { return (std::min)((std::max)(l, smallest), largest); });
  }

  Metric_tensor_3& operator+=(const Metric_tensor_3& m) {
    xx += m.xx;
    xy += m.xy;
    xz += m.xz;
    yy += m.yy;
    yz += m.yz;
    zz += m.zz;
    return *this;
  }
  friend Metric_tensor_3 operator+(Metric_tensor_3 a, const Metric_tensor_3& b) { return a += b; }
  friend Metric_tensor_3 operator-(const Metric_tensor_3& a, const Metric_tensor_3& b) {
    return {a.xx - b.xx, a.xy - b.xy, a.xz - b.xz, a.yy - b.yy, a.yz - b.yz, a.zz - b.zz};
  }
  friend Metric_tensor_3 operator*(double s, const Metric_tensor_3& m) {
    return {s * m.xx, s * m.xy, s * m.xz, s * m.yy, s * m.yz, s * m.zz};
  }
  friend bool operator==(const Metric_tensor_3& a, const Metric_tensor_3& b) {
    return a.components() == b.components();
  }
  friend bool operator!=(const Metric_tensor_3& a, const Metric_tensor_3& b) { return !(a == b); }

private:
  // The tensor that shares the conjugate axes of a and b; along each, a's coefficient times f(b's over a's).
  template <class Function>
  static Metric_tensor_3 combination(const Metric_tensor_3& a, const Metric_tensor_3& b, const Function& f) {
    // a = L Lᵀ; the rows of the inverse of L are r0, r1, r2
    const double l00 = std::sqrt(a.xx), l10 = a.xy / l00, l20 = a.xz / l00;
    const double l11 = std::sqrt(a.yy - l10 * l10), l21 = (a.yz - l20 * l10) / l11;
    const double l22 = std::sqrt(a.zz - l20 * l20 - l21 * l21);
    const Vector r0(1 / l00, 0, 0), r1(-l10 / (l00 * l11), 1 / l11, 0);
    const Vector r2((l10 * l21 - l20 * l11) / (l00 * l11 * l22), -l21 / (l11 * l22), 1 / l22);
    const Metric_tensor_3 reduced(b.squared_length(r0), b.dot(r0, r1), b.dot(r0, r2), b.squared_length(r1),
                                  b.dot(r1, r2), b.squared_length(r2));
    const internal::Symmetric_eigen_solver_3 s(reduced.components());
    Metric_tensor_3 result(0, 0, 0, 0, 0, 0);
    for (int i = 0; i < 3; ++i) {
      const Vector v = s.direction(i);
      result += f(s.values()[i]) * dyad(Vector(l00 * v.x, l10 * v.x + l11 * v.y, l20 * v.x + l21 * v.y + l22 * v.z));
    }
    return result;
  }
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_FIELDS_METRIC_TENSOR_3_H

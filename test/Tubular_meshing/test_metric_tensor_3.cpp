// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Metric tensors in space, against closed forms and against Eigen.

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Fields/internal/metric_simplices.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

namespace {

typedef CGAL::Tubular_meshing::Metric_tensor_3 Metric;
typedef Eigen::Vector3d Vector;
typedef std::array<Vector, 3> Axes;

static_assert(std::is_trivially_copyable<Metric>::value && sizeof(Metric) == 6 * sizeof(double), "not compact");

class Metric_tensor_3 : public ::testing::Test {
protected:
  std::mt19937 random{7};

  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
  Vector vector() { return Vector(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)); }
  Axes axes() {
    const Eigen::Matrix3d q =
        Eigen::HouseholderQR<Eigen::Matrix3d>((Eigen::Matrix3d() << vector(), vector(), vector()).finished())
            .householderQ();
    return {q.col(0), q.col(1), q.col(2)};
  }
  // sizes over `decades` orders of magnitude
  Metric metric(double decades) {
    const auto size = [&] { return std::pow(10., uniform(-decades / 2, decades / 2)); };
    return Metric::from_sizes<Vector>({size(), size(), size()}, axes());
  }
};

void expect_near(const Metric& a, const Metric& b, double relative) {
  const double scale = std::abs(b.xx) + std::abs(b.yy) + std::abs(b.zz);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(a.components()[i], b.components()[i], relative * scale) << i;
}

TEST_F(Metric_tensor_3, From_sizes_has_them_along_its_axes) {
  for (int i = 0; i < 200; ++i) {
    const Axes e = axes();
    const std::array<double, 3> h = {uniform(0.1, 1), uniform(1, 10), uniform(10, 100)};
    const Metric m = Metric::from_sizes(h, e);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(m.length(h[k] * e[k]), 1, 1e-10);
      EXPECT_NEAR(m.size_along(Vector(-7 * e[k])), h[k], 1e-10 * h[k]);
    }
    EXPECT_NEAR(m.dot(e[0], e[1]), 0, 1e-12 / (h[0] * h[0]));
    EXPECT_NEAR(m.determinant() * std::pow(h[0] * h[1] * h[2], 2), 1, 1e-9);
    EXPECT_NEAR(m.density() * h[0] * h[1] * h[2], 1, 1e-9);
    const Metric::Eigen_system s = m.eigen_system();
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(s.sizes[k], h[k], 1e-10 * h[k]);
      EXPECT_NEAR(std::abs(Vector(s.directions[k].x, s.directions[k].y, s.directions[k].z).dot(e[k])), 1, 1e-12);
    }
    EXPECT_NEAR(m.anisotropy(), h[2] / h[0], 1e-9 * h[2] / h[0]);
  }
}

TEST_F(Metric_tensor_3, Eigenvalues_keep_their_digits_across_twelve_orders) {
  // aligned with the axes up to a rotation in one plane: nothing is lost in the entries, nor may be in the eigenvalues
  const double c = std::cos(1e-7), s = std::sin(1e-7);
  const Axes e = {Vector(c, s, 0), Vector(-s, c, 0), Vector(0, 0, 1)};
  const Metric m = Metric::from_sizes<Vector>({1e6, 1, 1e-3}, e);
  EXPECT_NEAR(m.sizes()[0], 1e-3, 1e-14);
  EXPECT_NEAR(m.sizes()[1], 1, 1e-11);
  EXPECT_NEAR(m.sizes()[2], 1e6, 1);
}

TEST_F(Metric_tensor_3, Isotropic_and_degenerate_eigenvalues_are_decomposed) {
  for (const std::array<double, 3>& h : {std::array<double, 3>{2, 2, 2}, {1, 2, 2}, {1, 1, 2}, {1, 1 + 1e-14, 1}}) {
    const Metric m = Metric::from_sizes(h, axes());
    const Metric::Eigen_system s = m.eigen_system();
    expect_near(Metric::from_sizes(s.sizes, s.directions), m, 1e-14);
  }
  EXPECT_EQ(Metric::isotropic(3).sizes(), (std::array<double, 3>{3, 3, 3}));
}

TEST_F(Metric_tensor_3, Converts_from_and_to_eigen_and_cgal) {
  const Metric m = metric(1);
  const Eigen::Matrix3d a = m.to_matrix<Eigen::Matrix3d>();
  EXPECT_EQ(Metric::from_matrix(a), m);
  EXPECT_EQ(Metric(m.components()), m);
  const Vector v = vector();
  EXPECT_NEAR(m.squared_length(v), v.dot(a * v), 1e-12 * a.norm());
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3 Cgal_vector;
  EXPECT_EQ(m.length(v), m.length(Cgal_vector(v[0], v[1], v[2])));
  EXPECT_EQ(m.length(v), m.length(Metric::Vector(v[0], v[1], v[2])));
  expect_near(Metric::from_matrix(Eigen::Matrix3d(a.inverse())), m.inverse(), 1e-12);
}

TEST_F(Metric_tensor_3, Validity_is_positive_definiteness) {
  EXPECT_TRUE(Metric().is_valid());
  EXPECT_TRUE(Metric::isotropic(1e-9).is_valid());
  EXPECT_TRUE(Metric::isotropic(1e9).is_valid());
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 6; ++i)
    for (double bad : {nan, inf, -inf}) {
      std::array<double, 6> c = Metric().components();
      c[i] = bad;
      EXPECT_FALSE(Metric(c).is_valid()) << i << " " << bad;
    }
  EXPECT_FALSE(Metric(0, 0, 0, 0, 0, 0).is_valid());
  EXPECT_FALSE(Metric(-1, 0, 0, -1, 0, 1).is_valid()); // of positive determinant
  EXPECT_FALSE(Metric(1, 2, 0, 1, 0, 1).is_valid());
  EXPECT_FALSE(Metric(1, 0, 1, 1, 0, 1).is_valid()); // singular
  EXPECT_FALSE(Metric::isotropic(0).is_valid());
  for (int i = 0; i < 200; ++i) {
    const std::array<double, 3> l = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    const bool positive = l[0] > 0 && l[1] > 0 && l[2] > 0;
    EXPECT_EQ(Metric::from_eigenvalues(l, axes()).is_valid(), positive);
  }
  for (int i = 0; i < 200; ++i)
    EXPECT_TRUE(metric(6).is_valid());
}

TEST_F(Metric_tensor_3, Logarithm_and_exponential_are_inverse) {
  for (int i = 0; i < 200; ++i) {
    const Metric m = metric(4);
    expect_near(m.log().exp(), m, 1e-11);
    EXPECT_NEAR(m.log().xx + m.log().yy + m.log().zz, std::log(m.determinant()), 1e-7);
  }
  expect_near(Metric::isotropic(std::exp(-2.)).log(), 4 * Metric(), 1e-15);
}

TEST_F(Metric_tensor_3, Logarithm_and_exponential_are_those_of_the_eigenvalues) {
  // over all ways in which they are computed, coinciding and nearly coinciding sizes among them
  for (int i = 0; i < 3000; ++i) {
    const double spread = uniform(0, 5);
    std::array<double, 3> l = {uniform(-spread, spread), uniform(-spread, spread), uniform(-spread, spread)};
    if (i % 3 > 0)
      l[1] = l[0] + (i % 3 - 1) * std::pow(10., uniform(-17, -1));
    if (i % 5 == 0)
      l[2] = l[1];
    const Axes e = axes();
    const Metric log = Metric::from_eigenvalues(l, e);
    const Metric exp = Metric::from_eigenvalues({std::exp(l[0]), std::exp(l[1]), std::exp(l[2])}, e);
    expect_near(log.exp(), exp, 1e-13);
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(exp.log().components()[k], log.components()[k], 1e-10);
  }
}

TEST_F(Metric_tensor_3, Interpolates_sizes_geometrically) {
  const Axes e = axes();
  const Metric a = Metric::from_sizes<Vector>({1, 2, 3}, e), b = Metric::from_sizes<Vector>({4, 2, 0.3}, e);
  const Metric c = Metric::from_sizes<Vector>({2, 2, std::sqrt(0.9)}, e);
  expect_near(Metric::interpolate(a, b, 0.5), c, 1e-12);
  expect_near(Metric::interpolate(std::vector<Metric>{a, b}, std::vector<double>{3, 3}), c, 1e-12);
  expect_near(Metric::interpolate(a, b, 0), a, 1e-12);
  expect_near(Metric::interpolate(a, b, 1), b, 1e-12);
  // of determinants too, whatever the axes
  for (int i = 0; i < 100; ++i) {
    const Metric m = metric(2), n = metric(2);
    EXPECT_NEAR(std::log(Metric::interpolate(m, n, 0.25).determinant()),
                0.75 * std::log(m.determinant()) + 0.25 * std::log(n.determinant()), 1e-8);
  }
}

TEST_F(Metric_tensor_3, Intersection_of_parallel_axes_is_the_minimum) {
  const Axes e = axes();
  const Metric a = Metric::from_sizes<Vector>({1, 2, 3}, e), b = Metric::from_sizes<Vector>({4, 1, 0.3}, e);
  expect_near(Metric::intersection(a, b), Metric::from_sizes<Vector>({1, 1, 0.3}, e), 1e-14);
}

TEST_F(Metric_tensor_3, Intersection_lies_in_both_and_touches) {
  for (int i = 0; i < 300; ++i) {
    const Metric a = metric(2), b = metric(2), c = Metric::intersection(a, b);
    ASSERT_TRUE(c.is_valid());
    expect_near(Metric::intersection(b, a), c, 1e-9);
    expect_near(Metric::intersection(a, c), c, 1e-9);
    for (int k = 0; k < 20; ++k) {
      const Vector v = vector();
      EXPECT_GE(c.length(v), (std::max)(a.length(v), b.length(v)) * (1 - 1e-9));
    }
    // c = a or c = b along each of the conjugate axes: det(c - a) = det(c - b) = 0 in a's measure
    const Eigen::Matrix3d A = a.to_matrix<Eigen::Matrix3d>(), B = b.to_matrix<Eigen::Matrix3d>();
    Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> solver(B, A);
    for (int k = 0; k < 3; ++k) {
      const Vector v = solver.eigenvectors().col(k);
      EXPECT_NEAR(c.length(v), (std::max)(a.length(v), b.length(v)), 1e-7 * c.length(v));
    }
  }
}

TEST_F(Metric_tensor_3, Length_of_an_edge_is_exact_where_sizes_grow_geometrically) {
  const Vector e(3, -4, 12);
  EXPECT_NEAR(Metric::edge_length(e, Metric::isotropic(2), Metric::isotropic(2)), 6.5, 1e-14);
  for (double h : {2.001, 2.1, 4., 1e3, 1e-3}) {
    // by quadrature of 13 / (2 (h/2)^t)
    const int n = 20000;
    double sum = 0;
    for (int i = 0; i < n; ++i)
      sum += 6.5 * std::pow(h / 2, -(i + 0.5) / n) / n;
    EXPECT_NEAR(Metric::edge_length(e, Metric::isotropic(2), Metric::isotropic(h)), sum, 1e-7 * sum) << h;
    EXPECT_NEAR(Metric::edge_length(e, Metric::isotropic(h), Metric::isotropic(2)), sum, 1e-7 * sum) << h;
  }
  // across the change from series to quotient
  for (double d = 1e-9; d < 0.1; d *= 1.3) {
    const double exact = 6.5 * d / std::log1p(d);
    EXPECT_NEAR(Metric::edge_length(e, Metric::isotropic(2), Metric::isotropic(2 / (1 + d))), exact, 1e-12 * exact);
  }
  EXPECT_EQ(Metric::edge_length(Vector(0, 0, 0), Metric(), Metric()), 0);
}

TEST_F(Metric_tensor_3, Grows_no_faster_than_beta) {
  // along a row of points one unit edge apart the sizes are in the ratio β where growth starts, whatever the space
  const double beta = 1.5, h = 0.1;
  for (double physical : {0., 0.125, 1.}) {
    const Metric grown = Metric::isotropic(h).grown(Vector(0, 0, h), beta, physical);
    EXPECT_NEAR(grown.sizes()[0], h * (1 + std::log(beta)), 1e-14);
    EXPECT_EQ(Metric::isotropic(h).grown(Vector(0, 0, h), 1, physical), Metric::isotropic(h));
  }
  const Axes e = axes();
  const Metric flat = Metric::from_sizes<Vector>({1, 1, 0.01}, e);
  const Vector step = 0.7 * e[2];
  // in the metric's measure the ratio of sizes is kept, in space all sizes grow by the same length
  EXPECT_NEAR(flat.grown(step, beta, 0).anisotropy(), 100, 1e-8);
  EXPECT_NEAR(flat.grown(step, beta, 1).sizes()[0], 0.01 + 0.7 * std::log(beta), 1e-12);
  EXPECT_NEAR(flat.grown(step, beta, 1).sizes()[2], 1 + 0.7 * std::log(beta), 1e-12);
}

TEST_F(Metric_tensor_3, Limits_the_growth_of_a_shock) {
  const Metric fine = Metric::isotropic(0.1), coarse = Metric::isotropic(10);
  Metric a = fine, b = coarse;
  const Vector e(0, 1, 0);
  Metric::limit_growth(e, a, b, 1.5);
  expect_near(a, fine, 1e-15);
  EXPECT_NEAR(b.sizes()[0], 0.1 + std::log(1.5), 1e-12);
  Metric::limit_growth(e, b, a, 1.5); // a second time nothing changes
  EXPECT_NEAR(b.sizes()[0], 0.1 + std::log(1.5), 1e-12);
  expect_near(a, fine, 1e-15);
}

TEST_F(Metric_tensor_3, Clamps_sizes) {
  const Axes e = axes();
  expect_near(Metric::from_sizes<Vector>({0.01, 1, 100}, e).clamped(0.1, 10),
              Metric::from_sizes<Vector>({0.1, 1, 10}, e), 1e-13);
}

TEST_F(Metric_tensor_3, Circumradius_of_a_simplex_is_that_of_its_image) {
  // M = AᵀA: in the metric, points have the distances of their images under A
  namespace internal = CGAL::Tubular_meshing::internal;
  typedef internal::Vector_3d Vec;
  const std::array<Vector, 4> regular = {Vector(1, 1, 1), Vector(1, -1, -1), Vector(-1, 1, -1), Vector(-1, -1, 1)};
  const double edge = std::sqrt(8.);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d a = (Eigen::Matrix3d() << vector(), vector(), vector()).finished();
    if (std::abs(a.determinant()) < 0.05)
      continue;
    const Metric m = Metric::from_matrix(Eigen::Matrix3d(a.transpose() * a));
    std::array<Vec, 4> p;
    for (int k = 0; k < 4; ++k) {
      const Vector q = a.inverse() * regular[k] / edge;
      p[k] = Vec(q[0] + 5, q[1] - 3, q[2]);
    }
    EXPECT_NEAR(internal::metric_circumradius(p, m), std::sqrt(6.) / 4, 1e-9);
    EXPECT_NEAR(internal::metric_circumradius(std::array<Vec, 3>{p[0], p[1], p[2]}, m), 1 / std::sqrt(3.), 1e-9);
    EXPECT_NEAR(internal::longest_edge(p, std::array<Metric, 4>{m, m, m, m}), 1, 1e-9);
    expect_near(internal::mean_metric(std::array<Metric, 4>{m, 2 * m, 3 * m, 2 * m}), 2 * m, 1e-14);
  }
  const std::array<Vec, 4> flat = {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0), Vec(1, 1, 0)};
  EXPECT_TRUE(std::isinf(internal::metric_circumradius(flat, Metric())));
  EXPECT_TRUE(std::isinf(internal::metric_circumradius(std::array<Vec, 3>{flat[0], flat[1], Vec(2, 0, 0)}, Metric())));
}

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Remeshing to a metric, on cubes and tubes whose volume, sides and metric are known in closed form.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/shape_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing.h>
#include <CGAL/Tubular_meshing/Volume/internal/Speculation.h>
#include <CGAL/number_utils.h>

#include "grid_of_tetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef CGAL::Tubular_meshing::Mixed_mesh Mesh;
typedef CGAL::Tubular_meshing::Metric_tensor_3 Metric;
namespace tubular = CGAL::Tubular_meshing;
using tubular::internal::Metric_point;
using tubular::internal::Tetrahedron_store;
using tubular::internal::Vector_3d;
typedef std::function<Metric(const Point&)> Field;

const double pi = std::acos(-1.);

// A grid mapped from the unit cube.
template <class Map, class Label> Mesh make_grid(int nx, int ny, int nz, const Map& map, const Label& label) {
  return grid_of_tetrahedra(
      {nx, ny, nz}, [&](int i, int j, int k) { return map(double(i) / nx, double(j) / ny, double(k) / nz); }, label);
}

// The unit cube, its sides labelled 1 to 6.
Mesh make_cube(int n) {
  return make_grid(
      n, n, n, [](double x, double y, double z) { return Point(x, y, z); },
      [](int axis, int end) { return 1 + 2 * axis + end; });
}

// A cylinder of radius 0.5 and length 3 along z: the wall 1, and the ends 2 and 3.
Mesh make_tube(int n) {
  return make_grid(
      n, n, 3 * n,
      [](double x, double y, double z) {
        const double u = 2 * x - 1, v = 2 * y - 1;
        return Point(u * std::sqrt(1 - v * v / 2) / 2, v * std::sqrt(1 - u * u / 2) / 2, 3 * z);
      },
      [](int axis, int end) { return axis < 2 ? 1 : 2 + end; });
}

Metric sizes(double a, double b, double c, const Vector_3d& u = {1, 0, 0}, const Vector_3d& v = {0, 1, 0},
             const Vector_3d& w = {0, 0, 1}) {
  return Metric::from_sizes(std::array<double, 3>{a, b, c}, std::array<Vector_3d, 3>{u, v, w});
}

double volume_of(const Mesh& m, const std::array<std::uint32_t, 4>& t) {
  return tubular::internal::signed_volume(Vector_3d(m.points[t[0]]), Vector_3d(m.points[t[1]]),
                                          Vector_3d(m.points[t[2]]), Vector_3d(m.points[t[3]]));
}
double volume(const Mesh& m, int region = 0) {
  double v = 0;
  for (std::size_t i = 0; i < m.tetrahedra.size(); ++i)
    if (region == 0 || m.tetrahedra.label[i] == region)
      v += volume_of(m, m.tetrahedra.vertices[i]);
  return v;
}
double area(const Mesh& m, int patch) {
  double a = 0;
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    if (m.triangles.label[i] == patch) {
      const auto& t = m.triangles.vertices[i];
      a += norm(cross(Vector_3d(m.points[t[1]]) - Vector_3d(m.points[t[0]]),
                      Vector_3d(m.points[t[2]]) - Vector_3d(m.points[t[0]]))) /
           2;
    }
  return a;
}

// ∫ √det M over the mesh, by midpoints of a subdivision, over the volume of the regular tetrahedron.
double ideal_number(const Mesh& m, const Field& field) {
  double sum = 0;
  const int n = 6;
  for (const auto& t : m.tetrahedra.vertices) {
    double density = 0;
    int samples = 0;
    for (int a = 0; a < n; ++a)
      for (int b = 0; a + b < n; ++b)
        for (int c = 0; a + b + c < n; ++c, ++samples) {
          const double w[4] = {(a + 0.25) / n, (b + 0.25) / n, (c + 0.25) / n, 1 - (a + b + c + 0.75) / n};
          Vector_3d x;
          for (int i = 0; i < 4; ++i)
            x += w[i] * Vector_3d(m.points[t[i]]);
          density += field(Point(x.x, x.y, x.z)).density();
        }
    sum += volume_of(m, t) * density / samples;
  }
  return sum / (std::sqrt(2.) / 12);
}

Mesh remeshed(Mesh m, const Field& field, int threads = 1) {
  tubular::anisotropic_tetrahedral_remeshing(m, field, tubular::parameters::number_of_threads(threads));
  return m;
}

void expect_valid(const Mesh& m, double expected_volume, double tolerance = 1e-9) {
  const auto r = tubular::validity_report(m);
  EXPECT_TRUE(r.is_valid()) << r.defects();
  EXPECT_NEAR(volume(m), expected_volume, tolerance * expected_volume);
}

// What Table III asks for, and the number of elements.
void expect_unit_mesh(const Mesh& m, double ideal) {
  const auto q = tubular::quality_report(m);
  EXPECT_GE(q.efficiency, 0.87);
  EXPECT_LE(q.Q_tau.mean(), 1.4);
  EXPECT_LE(q.Q_tau.max(), 8);
  EXPECT_GE(q.Q_tau.share_below(3), 0.985);
  EXPECT_NEAR(double(m.tetrahedra.size()) / ideal, 1, 0.15);
}

TEST(Metric_quality, IsThatOfTheReport) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 50; ++round) {
    std::array<Metric_point, 4> v;
    std::array<Vector_3d, 4> p;
    std::array<std::array<double, 6>, 4> metric;
    for (int i = 0; i < 4; ++i) {
      const Vector_3d a(uniform(random), uniform(random), uniform(random));
      v[i] = {{uniform(random), uniform(random), uniform(random)}, Metric::isotropic(0.5) + 9. * Metric::dyad(a)};
      p[i] = v[i].position;
      metric[i] = v[i].metric.components();
    }
    const double q = tubular::internal::metric_quality(v[0], v[1], v[2], v[3]);
    EXPECT_NEAR(1 / std::abs(q), tubular::tetrahedron_Q(p, metric), 1e-9 / std::abs(q));
    EXPECT_EQ(q > 0, tubular::internal::signed_volume(p[0], p[1], p[2], p[3]) > 0);
    EXPECT_NEAR(tubular::internal::metric_length(v[0], v[1]), tubular::metric_length(p[0], p[1], metric[0], metric[1]),
                1e-3);
  }
}

TEST(Metric_quality, OfRegularElementsIsOne) {
  // a regular tetrahedron of unit edges, stretched as the metric is
  const std::array<Vector_3d, 4> corner = {Vector_3d(0, 0, 0), Vector_3d(1, 0, 0), Vector_3d(0.5, std::sqrt(0.75), 0),
                                           Vector_3d(0.5, std::sqrt(1 / 12.), std::sqrt(2 / 3.))};
  std::array<Metric_point, 4> v;
  for (int i = 0; i < 4; ++i)
    v[i] = {{0.01 * corner[i].x, corner[i].y, 7 * corner[i].z}, sizes(0.01, 1, 7)};
  EXPECT_NEAR(tubular::internal::metric_quality(v[0], v[1], v[2], v[3]), 1, 1e-12);
  EXPECT_NEAR(tubular::internal::metric_quality(v[0], v[1], v[3]), 1, 1e-12);
  EXPECT_NEAR(tubular::internal::metric_length(v[1], v[3]), 1, 1e-12);
}

TEST(Metric_energy, DerivativesAreThoseOfItsValue) {
  const Metric mean = sizes(0.3, 1, 2, normalized(Vector_3d(1, 1, 0)), normalized(Vector_3d(-1, 1, 0)));
  const Vector_3d a(1, 0.1, 0), b(0.2, 1, 0.1), c(0.1, 0.2, 1.2), x(0.05, -0.1, 0.02);
  const auto value = [&](const Vector_3d& p) {
    tubular::internal::Metric_energy e;
    EXPECT_TRUE(e.add(a - p, b - p, c - p, mean, false));
    return e.value;
  };
  tubular::internal::Metric_energy e;
  ASSERT_TRUE(e.add(a - x, b - x, c - x, mean, true));
  const double h = 1e-4;
  const Vector_3d axes[3] = {{h, 0, 0}, {0, h, 0}, {0, 0, h}};
  const double gradient[3] = {e.gradient.x, e.gradient.y, e.gradient.z};
  const double diagonal[3] = {e.hessian.xx, e.hessian.yy, e.hessian.zz};
  for (int i = 0; i < 3; ++i) {
    const double up = value(x + axes[i]), down = value(x - axes[i]);
    EXPECT_NEAR((up - down) / (2 * h), gradient[i], 1e-5 * (1 + std::abs(gradient[i])));
    EXPECT_NEAR((up + down - 2 * value(x)) / (h * h), diagonal[i], 1e-4 * (1 + std::abs(diagonal[i])));
  }
  const double mixed = (value(x + axes[0] + axes[1]) - value(x + axes[0] - axes[1]) - value(x - axes[0] + axes[1]) +
                        value(x - axes[0] - axes[1])) /
                       (4 * h * h);
  EXPECT_NEAR(mixed, e.hessian.xy, 1e-4 * (1 + std::abs(mixed)));
}

TEST(Metric_energy, OfHeightsIsLeastAtTheSizeAcross) {
  const Vector_3d n = normalized(Vector_3d(1, 2, 2));
  const Metric m = sizes(0.01, 1, 2, n, normalized(Vector_3d(2, 1, -2)), normalized(Vector_3d(2, -2, 1)));
  const auto at = [&](double height, bool with_derivatives = false) {
    tubular::internal::Metric_energy e;
    EXPECT_TRUE(e.add_height(n, height * n + Vector_3d(0, 0.3, -0.3), m, with_derivatives));
    return e;
  };
  const double scale = 100, d = 1e-4;
  for (double h : {0.3, 0.8, 1., 1.5, 4.}) {
    const auto e = at(h / scale, true);
    const double up = at((h - d) / scale).value, down = at((h + d) / scale).value; // moving along n brings it nearer
    EXPECT_NEAR((up - down) / (2 * d), dot(e.gradient, n) / scale, 1e-5 * (1 + std::abs(dot(e.gradient, n)) / scale));
    EXPECT_NEAR(norm(cross(e.gradient, n)), 0, 1e-9 * scale);
    EXPECT_GE(dot(e.hessian * n, n), 0);
    EXPECT_LE(e.value,
              tubular::internal::Metric_energy::height_weight * tubular::internal::Metric_energy::height_bound);
    EXPECT_GE(e.value, at(1 / scale).value);
  }
  const auto best = at(1 / scale, true);
  EXPECT_NEAR(best.value, 0, 1e-12);
  EXPECT_NEAR((at((1 - d) / scale).value + at((1 + d) / scale).value - 2 * best.value) / (d * d),
              dot(best.hessian * n, n) / (scale * scale), 1e-3);
  tubular::internal::Metric_energy e;
  EXPECT_FALSE(e.add_height(n, -0.01 * n, m, true)); // beyond the facet
}

TEST(Metric_frame, TurnsTheMetricIntoTheIdentity) {
  const Metric m = sizes(0.01, 1, 5, normalized(Vector_3d(1, 2, 2)), normalized(Vector_3d(2, 1, -2)),
                         normalized(Vector_3d(2, -2, 1)));
  const tubular::internal::Metric_frame frame(m);
  const Vector_3d v(0.3, -0.7, 0.2), g(1, 2, -1);
  EXPECT_NEAR(squared_norm(frame.vector_into(v)), m.squared_length(v), 1e-9 * m.squared_length(v));
  EXPECT_NEAR(norm(frame.vector_out_of(frame.vector_into(v)) - v), 0, 1e-9);
  // gradients go with vectors
  EXPECT_NEAR(dot(frame.covector_into(g), frame.vector_into(v)), dot(g, v), 1e-9);
}

TEST(Tetrahedron_store, RenumbersWithoutTheUnused) {
  Mesh m = make_cube(2);
  m.points.insert(m.points.begin(), Point(9, 9, 9)); // of no tetrahedron
  for (auto& t : m.tetrahedra.vertices)
    for (auto& v : t)
      ++v;
  for (auto& t : m.triangles.vertices)
    for (auto& v : t)
      ++v;
  Tetrahedron_store store(m);
  std::vector<Tetrahedron_store::Index> order;
  for (Tetrahedron_store::Index v = store.number_of_vertices(); v-- > 0;)
    if (store.is_used(v))
      order.push_back(v);
  store.renumber(order);
  EXPECT_EQ(store.number_of_vertices(), 27u);
  EXPECT_EQ(Point(store.point(0).x, store.point(0).y, store.point(0).z), m.points.back());
  Mesh back;
  store.write_to(back);
  expect_valid(back, 1);
  EXPECT_EQ(back.triangles.size(), m.triangles.size());
}

// A fan of many tetrahedra around an edge.
TEST(Tetrahedron_store, FindsTheStarOfAVertexOfAnyDegree) {
  for (std::uint32_t n : {5u, 63u, 64u, 65u, 300u}) {
    Mesh m;
    m.points = {Point(0, 0, 0), Point(0, 0, 1)};
    for (std::uint32_t k = 0; k < n; ++k) {
      m.points.push_back(Point(std::cos(2 * CGAL_PI * k / n), std::sin(2 * CGAL_PI * k / n), 0));
      m.tetrahedra.push_back({0, 2 + k, 2 + (k + 1) % n, 1}, 1);
    }
    std::vector<Tetrahedron_store::Index> star;
    Tetrahedron_store(m).star(1, star);
    std::sort(star.begin(), star.end());
    EXPECT_EQ(star.size(), n);
    EXPECT_EQ(std::unique(star.begin(), star.end()), star.end());
  }
}

/* Pairs of neighbours are formed where both are single: each pair that is possible rules out others of its batch, which
 * have to be looked at once more. */
TEST(Speculation, DoesWhatOneAfterTheOtherWould) {
  const auto make_pairs = [](int threads, std::size_t batch) {
    std::vector<std::size_t> order(5000);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), std::mt19937(7));
    std::vector<int> paired_at(order.size() + 1, 0); // 0 for the single
    int now = 0;
    tubular::internal::Speculation<std::size_t> workers(threads, batch, std::size_t(0));
    workers.run(
        [&] { return order.size(); }, [&] { return now; },
        [&](std::size_t& at, std::size_t k) {
          at = order[k];
          return paired_at[at] == 0 && paired_at[at + 1] == 0;
        },
        [&](std::size_t at, std::size_t, int since) { return paired_at[at] <= since && paired_at[at + 1] <= since; },
        [&](std::size_t at, std::size_t k) {
          EXPECT_EQ(at, order[k]);
          EXPECT_EQ(paired_at[at] + paired_at[at + 1], 0);
          paired_at[at] = paired_at[at + 1] = ++now;
        });
    std::vector<int> serial(order.size() + 1, 0);
    now = 0;
    for (std::size_t at : order)
      if (serial[at] == 0 && serial[at + 1] == 0)
        serial[at] = serial[at + 1] = ++now;
    EXPECT_EQ(paired_at, serial);
  };
  for (std::size_t batch : {1u, 7u, 512u})
    for (int threads : {1, 2})
      make_pairs(threads, batch);
}

// Whether the vertex v may be pulled onto w, to which an edge joins it.
bool link_condition_holds(const Mesh& m, std::uint32_t v, std::uint32_t w) {
  const Tetrahedron_store store(m);
  std::vector<Tetrahedron_store::Index> star;
  store.star(v, star);
  for (auto t : star) {
    const int j = store.corner(t, w);
    if (store[t].v[j] != w)
      continue;
    Tetrahedron_store::Ring ring;
    store.ring(t, store.corner(t, v), j, ring);
    return tubular::internal::Link_condition(store).holds(v, w, ring, star);
  }
  ADD_FAILURE() << v << " and " << w << " are not joined";
  return false;
}

// A cap of one facet, 0 1 2: were its rim to lose a vertex, it would be gone.
TEST(Link_condition, KeepsRimsOfThreeVertices) {
  Mesh m;
  m.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0.3, 0.3, -1)};
  m.tetrahedra.push_back({0, 2, 1, 3}, 1);
  m.triangles.push_back({0, 1, 2}, 2); // a cap, and the wall around
  m.triangles.push_back({1, 0, 3}, 1);
  m.triangles.push_back({2, 1, 3}, 1);
  m.triangles.push_back({0, 2, 3}, 1);
  ASSERT_TRUE(tubular::validity_report(m).is_valid()) << tubular::validity_report(m).defects();
  EXPECT_FALSE(link_condition_holds(m, 0, 1));
}

TEST(Link_condition, HoldsOnASideAndAlongARim) {
  const Mesh m = make_cube(4);
  const auto at = [](int i, int j, int k) { return std::uint32_t((i * 5 + j) * 5 + k); };
  EXPECT_TRUE(link_condition_holds(m, at(2, 2, 0), at(3, 2, 0)));
  EXPECT_TRUE(link_condition_holds(m, at(2, 0, 0), at(3, 0, 0)));
}

/* A rod of two prisms, with a triangle for its waist that is no facet of the surface: were two of its vertices to
 * become one, the surface would touch itself along an edge. */
TEST(Link_condition, KeepsAWaistOfThreeVertices) {
  Mesh m;
  for (int k = 0; k < 3; ++k)
    for (const Point& p : {Point(0, 0, k), Point(1, 0, k), Point(0, 1, k)})
      m.points.push_back(p);
  std::map<std::array<std::uint32_t, 3>, std::vector<std::array<std::uint32_t, 3>>> facets;
  for (std::uint32_t base : {0u, 3u})
    for (std::array<std::uint32_t, 4> t : {std::array<std::uint32_t, 4>{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}}) {
      for (std::uint32_t& v : t)
        v += base;
      if (volume_of(m, t) < 0)
        std::swap(t[0], t[1]);
      m.tetrahedra.push_back(t, 1);
      for (int f = 0; f < 4; ++f) {
        const auto& c = Tetrahedron_store::facet_corners(f);
        std::array<std::uint32_t, 3> facet = {t[c[0]], t[c[1]], t[c[2]]}, key = facet;
        std::sort(key.begin(), key.end());
        facets[key].push_back(facet);
      }
    }
  for (const auto& f : facets)
    if (f.second.size() == 1)
      m.triangles.push_back(f.second[0], 1);
  ASSERT_TRUE(tubular::validity_report(m).is_valid()) << tubular::validity_report(m).defects();
  EXPECT_FALSE(link_condition_holds(m, 3, 4));
  EXPECT_FALSE(link_condition_holds(m, 4, 5));
}

TEST(Anisotropic_remeshing, IsotropicCube) {
  for (double h : {0.12, 0.09}) {
    const Field field = [h](const Point&) { return Metric::isotropic(h); };
    const Mesh input = make_cube(5), m = remeshed(input, field);
    expect_valid(m, 1);
    expect_unit_mesh(m, ideal_number(input, field));
    const auto q = tubular::quality_report(m);
    EXPECT_GE(q.gamma_tau.mean(), 0.76);
    EXPECT_GE(q.gamma_tau.min(), 0.25);
    for (int side = 1; side <= 6; ++side)
      EXPECT_NEAR(area(m, side), 1, 1e-9);
  }
}

TEST(Anisotropic_remeshing, CoarsensAFineCube) {
  const Field field = [](const Point&) { return Metric::isotropic(0.2); };
  const Mesh input = make_cube(14), m = remeshed(input, field);
  expect_valid(m, 1);
  EXPECT_LT(m.tetrahedra.size(), 1.3 * ideal_number(input, field));
  EXPECT_GE(tubular::quality_report(m).efficiency, 0.85);
}

TEST(Anisotropic_remeshing, UniformOneToHundred) {
  const Field field = [](const Point&) { return sizes(0.007, 0.07, 0.7); };
  const Mesh input = make_cube(5), m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(input, field));
}

TEST(Anisotropic_remeshing, UniformRatiosOfHundredsAndThousands) {
  for (double ratio : {100., 1e3}) {
    const Field field = [=](const Point&) { return sizes(0.6 / ratio, 0.6, 0.6); };
    const Mesh input = make_cube(4), m = remeshed(input, field);
    expect_valid(m, 1);
    expect_unit_mesh(m, ideal_number(input, field));
  }
}

TEST(Anisotropic_remeshing, LayersWithRatiosOfThousands) {
  const double h = 0.4, first = 4e-5, slope = 0.3;
  const Field field = [=](const Point& p) { return sizes(h, h, first + slope * p.z()); };
  const Mesh m = remeshed(make_cube(4), field);
  expect_valid(m, 1);
  expect_unit_mesh(m, std::log(1 + slope / first) / slope / (h * h) / (std::sqrt(2.) / 12));
}

// Uniform metrics that elements of a cube cannot follow, being longer than it: there is an end, and nothing is
// inverted.
TEST(Anisotropic_remeshing, RatiosOfThousandsComeToAnEnd) {
  for (double ratio : {1e3, 1e4}) {
    const double thin = std::sqrt(6e-3 / ratio);
    const Field field = [=](const Point&) { return sizes(thin, 0.6, ratio * thin); };
    const Mesh input = make_cube(3), m = remeshed(input, field);
    expect_valid(m, 1);
    EXPECT_LT(double(m.tetrahedra.size()), 4 * ideal_number(input, field));
  }
}

TEST(Anisotropic_remeshing, BoundaryLayer) {
  const Field field = [](const Point& p) { return sizes(0.12, 0.12, (std::min)(0.01 + 0.26 * p.z(), 0.12)); };
  const Mesh input = make_cube(6), m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(input, field));
}

// The tetrahedra on a side whose layer counts are as high as the size across it; regular ones are 0.8 as high.
TEST(Anisotropic_remeshing, HeightOfTheFirstLayer) {
  const Field field = [](const Point& p) { return sizes(0.12, 0.12, (std::min)(0.01 + 0.3 * p.z(), 0.12)); };
  Mesh m = make_cube(6);
  tubular::anisotropic_tetrahedral_remeshing(
      m, field, tubular::parameters::boundary_layer_patches(std::vector<int>{5}).number_of_threads(1));
  expect_valid(m, 1);
  std::size_t number = 0, fits = 0;
  for (const auto& t : m.tetrahedra.vertices) {
    int on_side = 0;
    double height = 0;
    for (auto v : t) {
      on_side += m.points[v].z() == 0;
      height += m.points[v].z();
    }
    if (on_side == 3) {
      ++number;
      fits += height > 0.007 && height < 0.013;
    }
  }
  EXPECT_GT(number, 100u);
  EXPECT_GE(double(fits), 0.95 * double(number));
  const auto q = tubular::quality_report(m);
  EXPECT_LE(q.Q_tau.mean(), 1.4);
  EXPECT_GE(q.efficiency, 0.86);
}

TEST(Anisotropic_remeshing, RotatingMetric) {
  const Field field = [](const Point& p) {
    const Vector_3d u = normalized(Vector_3d(p.x() + 0.3, p.y() + 0.3, 0));
    return sizes(0.024, 0.19, 0.07, u, {-u.y, u.x, 0});
  };
  const Mesh input = make_cube(6), m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(input, field));
}

TEST(Anisotropic_remeshing, Shock) {
  const Vector_3d u = normalized(Vector_3d(1, 1, 1)), v = normalized(Vector_3d(1, -1, 0));
  const Field field = [=](const Point& p) {
    const double d = std::abs(dot(u, Vector_3d(p)) - 0.8);
    return sizes((std::min)(0.008 + 0.3 * d, 0.12), 0.12, 0.12, u, v, cross(u, v));
  };
  const Mesh input = make_cube(6), m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(input, field));
}

// Seen by no vertex of the input: none lies within ten times the feature's thickness.
TEST(Anisotropic_remeshing, FindsASmallFeature) {
  const Field field = [](const Point& p) {
    return sizes((std::min)(0.01 + 0.3 * std::abs(p.x() - 0.375), 0.2), 0.2, 0.2);
  };
  const Mesh input = make_cube(4), m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(make_cube(16), field));
}

// A vessel's: thin at the wall, by (4), and bounded around it by the smoothing ratio, by (9).
Metric tube_metric(const Point& p) {
  const double r = std::hypot(p.x(), p.y()), core = 0.15, h_n = (std::min)(0.01 + 0.26 * (std::max)(0.5 - r, 0.), core);
  if (r < 1e-9)
    return sizes(h_n, h_n, 0.5);
  const double k = r * r * (1.5 * 1.5 - 1), u = (-1 + std::sqrt(1 + 4 * k / (h_n * h_n))) / (2 * k);
  const double around = (std::max)((std::min)(core, 1 / std::sqrt(u)), h_n);
  const Vector_3d out(p.x() / r, p.y() / r, 0);
  return sizes(h_n, around, 0.5, out, {-out.y, out.x, 0});
}

TEST(Anisotropic_remeshing, TubeOnItsOwnSurface) {
  const Mesh input = make_tube(8), m = remeshed(input, tube_metric);
  expect_valid(m, volume(input), 0.01);
  expect_unit_mesh(m, ideal_number(input, tube_metric));
  for (int patch = 1; patch <= 3; ++patch)
    EXPECT_NEAR(area(m, patch), area(input, patch), 0.02 * area(input, patch));
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    for (std::uint32_t v : m.triangles.vertices[i])
      if (m.triangles.label[i] != 1) {
        EXPECT_NEAR(m.points[v].z(), m.triangles.label[i] == 2 ? 0 : 3, 1e-12);
      }
}

// A fine cylinder, with its ends.
struct Cylinder {
  Surface surface;
  Surface::Property_map<Surface::Face_index, int> patch;

  explicit Cylinder(unsigned sides) {
    patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 1).first;
    for (double z : {0., 3.})
      for (unsigned k = 0; k < sides; ++k)
        surface.add_vertex(Point(0.5 * std::cos(2 * pi * k / sides), 0.5 * std::sin(2 * pi * k / sides), z));
    const auto low = surface.add_vertex(Point(0, 0, 0)), high = surface.add_vertex(Point(0, 0, 3));
    typedef Surface::Vertex_index V;
    for (unsigned k = 0; k < sides; ++k) {
      const V a(k), b((k + 1) % sides), c(sides + k), d(sides + (k + 1) % sides);
      surface.add_face(a, b, d);
      surface.add_face(a, d, c);
      patch[surface.add_face(b, a, low)] = 2;
      patch[surface.add_face(c, d, high)] = 3;
    }
  }
};

TEST(Anisotropic_remeshing, TubeOnAGivenSurface) {
  const Cylinder cylinder(128);
  Mesh m = make_tube(5); // a coarse polygon around
  tubular::anisotropic_tetrahedral_remeshing(m, cylinder.surface, cylinder.patch, &tube_metric);
  expect_valid(m, 0.75 * pi, 0.01);
  const double sagitta = 0.5 * (1 - std::cos(pi / 128));
  std::size_t wall = 0, far = 0;
  std::set<std::uint32_t> seen;
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    for (std::uint32_t v : m.triangles.vertices[i])
      if (m.triangles.label[i] == 1 && seen.insert(v).second) {
        ++wall;
        far += std::abs(std::hypot(m.points[v].x(), m.points[v].y()) - 0.5) > sagitta + 1e-9;
      }
  EXPECT_GT(wall, 300u);
  EXPECT_EQ(far, 0u);
}

TEST(Anisotropic_remeshing, KeepsTheBoundary) {
  const Mesh input = make_cube(5);
  const Field field = [](const Point& p) {
    const double d = (std::min)({p.x(), p.y(), p.z(), 1 - p.x(), 1 - p.y(), 1 - p.z()});
    return Metric::isotropic(0.2 - 0.2 * d);
  };
  Mesh m = input;
  tubular::anisotropic_tetrahedral_remeshing(m, field, tubular::parameters::keep_boundary(true));
  expect_valid(m, 1);
  EXPECT_NE(m.tetrahedra.size(), input.tetrahedra.size());
  typedef std::pair<std::set<Point>, int> Facet;
  const auto facets = [](const Mesh& mesh) {
    std::set<Facet> all;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles.vertices[i];
      all.insert({{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}, mesh.triangles.label[i]});
    }
    return all;
  };
  EXPECT_EQ(facets(m), facets(input));
  EXPECT_EQ(m.triangles.size(), input.triangles.size());
}

TEST(Anisotropic_remeshing, KeepsRegionsAndTheirInterface) {
  Mesh input = make_cube(6);
  const auto middle = [&](std::uint32_t v) { return input.points[v].x() == 0.5; };
  for (std::size_t i = 0; i < input.tetrahedra.size(); ++i) {
    const auto& t = input.tetrahedra.vertices[i];
    double x = 0;
    for (std::uint32_t v : t)
      x += input.points[v].x() / 4;
    input.tetrahedra.label[i] = x < 0.5 ? 1 : 2;
    for (int f = 0; f < 4 && x < 0.5; ++f) {
      const auto& c = Tetrahedron_store::facet_corners(f);
      if (middle(t[c[0]]) && middle(t[c[1]]) && middle(t[c[2]]))
        input.triangles.push_back({t[c[0]], t[c[1]], t[c[2]]}, 9);
    }
  }
  const Field field = [](const Point& p) { return sizes(0.03 + 0.3 * std::abs(p.x() - 0.5), 0.12, 0.12); };
  const Mesh m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(input, field));
  EXPECT_NEAR(volume(m, 1), 0.5, 1e-9);
  EXPECT_NEAR(volume(m, 2), 0.5, 1e-9);
  EXPECT_NEAR(area(m, 9), 1, 1e-9);
}

TEST(Anisotropic_remeshing, ASecondRunChangesLittle) {
  const Mesh once = remeshed(make_tube(6), tube_metric), twice = remeshed(once, tube_metric);
  EXPECT_NEAR(double(twice.tetrahedra.size()) / double(once.tetrahedra.size()), 1, 0.03);
  const auto a = tubular::quality_report(once), b = tubular::quality_report(twice);
  EXPECT_NEAR(a.efficiency, b.efficiency, 0.01);
  EXPECT_LE(b.Q_tau.mean(), a.Q_tau.mean() + 0.02);
}

TEST(Anisotropic_remeshing, IsTheSameForAnyNumberOfThreads) {
  const Mesh a = remeshed(make_tube(6), tube_metric, 1), b = remeshed(make_tube(6), tube_metric, 2);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tetrahedra.vertices, b.tetrahedra.vertices);
}

TEST(Anisotropic_remeshing, ScalesWithItsUnits) {
  const double unit = std::ldexp(1., -20); // exact, so that roundings are the same
  Mesh small = make_tube(4);
  for (Point& p : small.points)
    p = Point(unit * p.x(), unit * p.y(), unit * p.z());
  const Field field = [=](const Point& p) {
    return (1 / (unit * unit)) * tube_metric(Point(p.x() / unit, p.y() / unit, p.z() / unit));
  };
  const Mesh a = remeshed(make_tube(4), tube_metric), b = remeshed(small, field);
  EXPECT_EQ(a.tetrahedra.vertices, b.tetrahedra.vertices);
}

TEST(Anisotropic_remeshing, GivesTheMetricAtThePoints) {
  Mesh m = make_cube(4);
  m.point_arrays.push_back({"pressure", 1, std::vector<double>(m.points.size(), 1)});
  const Field field = [](const Point& p) { return sizes(0.1 + 0.1 * p.x(), 0.2, 0.2 + 0.1 * p.y()); };
  m = remeshed(m, field);
  ASSERT_EQ(m.point_arrays.size(), 1u);
  EXPECT_EQ(m.point_arrays[0].name, "metric");
  ASSERT_EQ(m.point_arrays[0].values.size(), 6 * m.points.size());
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    const auto expected = field(m.points[i]).components();
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), m.point_arrays[0].values.begin() + 6 * std::ptrdiff_t(i)));
  }
}

void expect_refused(const Mesh& input, const Field& field, const std::string& words) {
  Mesh m = input;
  try {
    tubular::anisotropic_tetrahedral_remeshing(m, field);
    ADD_FAILURE() << "accepted, where it should say: " << words;
  } catch (const tubular::Input_error& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
  }
  EXPECT_EQ(m.points, input.points);
  EXPECT_EQ(m.tetrahedra.vertices, input.tetrahedra.vertices);
  EXPECT_EQ(m.triangles.vertices, input.triangles.vertices);
  EXPECT_TRUE(m.point_arrays.empty());
}

TEST(Anisotropic_remeshing, RefusesMetricsThatAreNone) {
  const Mesh cube = make_cube(3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(
      cube, [](const Point&) { return Metric(1, 0, 0, 1, 0, -1); }, "not positive definite");
  expect_refused(
      cube, [](const Point&) { return Metric(1, 2, 0, 1, 0, 1); }, "not positive definite");
  expect_refused(
      cube, [=](const Point&) { return Metric(1, 0, nan, 1, 0, 1); }, "finite");
  expect_refused(
      cube, [](const Point&) { return Metric::isotropic(0); }, "finite");
  expect_refused(
      cube, [](const Point&) { return Metric::isotropic(1e-9); }, "tetrahedra");
  expect_refused(
      cube, [](const Point&) { return Metric::isotropic(50); }, "far beyond");
  expect_refused(
      cube, [](const Point&) { return sizes(1e-6, 0.1, 1); }, "ratio");
  // only where new points come to lie
  expect_refused(
      cube,
      [=](const Point& p) { return p.x() > 0.4 && p.x() < 0.6 ? Metric(nan, 0, 0, 1, 0, 1) : Metric::isotropic(0.1); },
      "finite");
}

TEST(Anisotropic_remeshing, RefusesMeshesThatAreNotValid) {
  const Field field = [](const Point&) { return Metric::isotropic(0.3); };
  Mesh m = make_cube(3);
  std::swap(m.tetrahedra.vertices[7][0], m.tetrahedra.vertices[7][1]);
  expect_refused(m, field, "1 inverted cells");
  m = make_cube(3);
  m.triangles = {};
  expect_refused(m, field, "unlabelled boundary faces");
  m = make_cube(3);
  m.triangles.label[5] = 0;
  expect_refused(m, field, "Triangle 5");
  m = make_cube(3);
  m.tetrahedra.vertices[2][1] = 12345;
  expect_refused(m, field, "12345");
  m = make_cube(3);
  m.tetrahedra.push_back(m.tetrahedra.vertices[0], 1);
  expect_refused(m, field, "overlapping");
  m = make_cube(3);
  m.points[0] = Point(std::numeric_limits<double>::infinity(), 0, 0);
  expect_refused(m, field, "Point 0");
  m = make_cube(3);
  m.hexahedra.push_back({0, 1, 2, 3, 4, 5, 6, 7}, 1);
  expect_refused(m, field, "other than tetrahedra");
  expect_refused(Mesh(), field, "no tetrahedra");
}

TEST(Anisotropic_remeshing, LetsTheFieldsExceptionsThrough) {
  Mesh m = make_cube(3);
  int calls = 0;
  const Field field = [&](const Point&) {
    if (++calls > 500)
      throw std::domain_error("enough");
    return Metric::isotropic(0.05);
  };
  EXPECT_THROW(tubular::anisotropic_tetrahedral_remeshing(m, field, tubular::parameters::number_of_threads(1)),
               std::domain_error);
  EXPECT_EQ(m.points, make_cube(3).points);
  EXPECT_THROW(tubular::anisotropic_tetrahedral_remeshing(m, field, tubular::parameters::number_of_threads(-1)),
               tubular::Parameter_error);
}

} // namespace

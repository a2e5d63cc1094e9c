// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the remesher to a metric is made of: its measures, its store, its conditions, one by one.

#include <CGAL/Tubular_meshing/Quality/shape_measures.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Volume/internal/Colored_stars.h>
#include <CGAL/Tubular_meshing/Volume/internal/Speculation.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Facet_turning.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Link_condition.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_relocation.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Uniform_refinement.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/metric_quality.h>

#include "cubes_to_remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace cubes_to_remesh;
using tubular::internal::Metric_point;
using tubular::internal::Tetrahedron_store;

TEST(Metric_quality, Is_that_of_the_report) {
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
    // the report integrates by four Gauss points
    EXPECT_NEAR(tubular::internal::metric_length(v[0], v[1]), tubular::metric_length(p[0], p[1], metric[0], metric[1]),
                1e-3);
  }
}

TEST(Metric_quality, Of_regular_elements_is_one) {
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

// Of two tetrahedra; what fills the lanes counts nothing.
TEST(Metric_energy, Derivatives_are_those_of_its_value) {
  const Metric mean = sizes(0.3, 1, 2, normalized(Vector_3d(1, 1, 0)), normalized(Vector_3d(-1, 1, 0)));
  const Vector_3d a(1, 0.1, 0), b(0.2, 1, 0.1), c(0.1, 0.2, 1.2), d(0.9, -1, 0.3), x(0.05, -0.1, 0.02);
  const auto facets = [&](std::vector<std::array<Vector_3d, 3>> corners) {
    tubular::internal::Four_facets f;
    int k = 0;
    for (const auto& v : corners)
      f.set(k++, {v[0], mean}, {v[1], mean}, {v[2], mean});
    f.fill(k);
    return f;
  };
  const auto two = facets({{a, b, c}, {a, c, d}});
  const auto value = [&](const Vector_3d& p) {
    tubular::internal::Metric_energy e;
    EXPECT_TRUE(e.add<false>(two, {p, mean}));
    return e.value;
  };
  tubular::internal::Metric_energy e, sum;
  ASSERT_TRUE(e.add<true>(two, {x, mean}));
  ASSERT_TRUE(sum.add<true>(facets({{a, b, c}}), {x, mean}));
  ASSERT_TRUE(sum.add<true>(facets({{a, c, d}}), {x, mean}));
  EXPECT_NEAR(e.value, sum.value, 1e-12 * sum.value);
  EXPECT_NEAR(e.value, value(x), 1e-12 * sum.value);
  EXPECT_FALSE(sum.add<true>(facets({{b, a, c}}), {x, mean})); // inverted
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

TEST(Metric_energy, Of_heights_is_least_at_the_size_across) {
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

TEST(Metric_frame, Turns_the_metric_into_the_identity) {
  const Metric m = sizes(0.01, 1, 5, normalized(Vector_3d(1, 2, 2)), normalized(Vector_3d(2, 1, -2)),
                         normalized(Vector_3d(2, -2, 1)));
  const tubular::internal::Metric_frame frame(m);
  const Vector_3d v(0.3, -0.7, 0.2), g(1, 2, -1);
  EXPECT_NEAR(squared_norm(frame.vector_into(v)), m.squared_length(v), 1e-9 * m.squared_length(v));
  EXPECT_NEAR(norm(frame.vector_out_of(frame.vector_into(v)) - v), 0, 1e-9);
  // gradients go with vectors
  EXPECT_NEAR(dot(frame.covector_into(g), frame.vector_into(v)), dot(g, v), 1e-9);
}

// By steps of 30 degrees, none of which is far, facets that lie in a plane together stay near it; one that has turned
// may turn back, and no further.
TEST(Facet_turning, Does_not_add_up) {
  const auto normal = [](double degrees) {
    return 0.1 * Vector_3d(std::sin(degrees * CGAL_PI / 180), 0, std::cos(degrees * CGAL_PI / 180));
  };
  const auto allows = [&](double from, double to) {
    tubular::internal::Facet_turning turning;
    turning.add(1, 0, normal(from));
    turning.add(1, 0, Vector_3d(0, 0, 3)); // the others
    turning.add(2, 0, Vector_3d(5, 0, 0)); // of another patch, and of another region
    turning.add(1, 7, Vector_3d(0, 0, -9));
    return turning.allows(1, 0, normal(from), normal(to));
  };
  EXPECT_TRUE(allows(0, 30));
  EXPECT_FALSE(allows(0, 60));
  EXPECT_FALSE(allows(30, 60));
  EXPECT_FALSE(allows(60, 90));
  EXPECT_FALSE(allows(90, 120));
  EXPECT_TRUE(allows(90, 60));
  EXPECT_TRUE(allows(60, 30));
  EXPECT_FALSE(allows(-60, 30));
}

TEST(Tetrahedron_store, Renumbers_without_the_unused) {
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
TEST(Tetrahedron_store, Finds_the_star_of_a_vertex_of_any_degree) {
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

// From whichever tetrahedron it starts, the link is the same polygon; on the boundary it is open, and begins there.
TEST(Tetrahedron_store, Finds_the_ring_of_an_edge) {
  typedef Tetrahedron_store::Index Index;
  const Tetrahedron_store store(make_cube(3));
  Tetrahedron_store::Ring ring;
  std::map<std::pair<Index, Index>, std::vector<Index>> links;
  std::size_t open = 0;
  for (Index t = 0; t < store.number_of_slots(); ++t)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        if (i == j)
          continue;
        store.ring(t, i, j, ring);
        EXPECT_NE(std::find(ring.tetrahedra.begin(), ring.tetrahedra.end(), t), ring.tetrahedra.end());
        ASSERT_EQ(ring.link.size(), ring.tetrahedra.size() + (ring.closed ? 0 : 1));
        for (std::size_t k = 0; k < ring.tetrahedra.size(); ++k)
          for (Index v : {ring.a, ring.b, ring.link[k], ring.link[(k + 1) % ring.link.size()]})
            EXPECT_EQ(store[ring.tetrahedra[k]].v[store.corner(ring.tetrahedra[k], v)], v);
        std::vector<Index> link(ring.link.begin(), ring.link.end());
        if (ring.closed)
          std::rotate(link.begin(), std::min_element(link.begin(), link.end()), link.end());
        EXPECT_EQ(links.insert({{ring.a, ring.b}, link}).first->second, link);
        open += ring.closed ? 0 : 1;
        const Index last = ring.tetrahedra.back();
        EXPECT_FALSE(store.ring(t, i, j, ring, [&](Index other) { return other != last; }));
      }
  EXPECT_GT(open, 0u);
}

// Blocks of one color have no tetrahedron in common; each vertex is visited once, those of a block in their order.
TEST(Colored_stars, Visit_blocks_that_are_no_neighbors_together) {
  typedef Tetrahedron_store::Index Index;
  const Tetrahedron_store store(make_cube(6));
  for (Index block : {1u, 8u, 50u}) {
    tubular::internal::Colored_stars stars;
    stars.build(
        store, [](Index v) { return v % 5 != 0; }, block);
    std::vector<int> color_of(store.number_of_vertices(), -1);
    std::vector<Index> last(store.number_of_vertices() / block + 1, 0);
    int color = -1;
    stars.for_each_movable(
        1,
        [&](Index v) {
          EXPECT_EQ(color_of[v], -1);
          EXPECT_LE(last[v / block], v);
          last[v / block] = v;
          color_of[v] = color;
        },
        [&] { ++color; });
    for (Index v = 0; v < store.number_of_vertices(); ++v)
      EXPECT_EQ(color_of[v] == -1, v % 5 == 0);
    for (Index t = 0; t < store.number_of_slots(); ++t)
      for (Index v : store[t].v)
        for (Index w : store[t].v)
          EXPECT_TRUE(v / block == w / block || color_of[v] == -1 || color_of[v] != color_of[w]);
  }
}

// Each facet is that of its other side.
void expect_connected(const Tetrahedron_store& store) {
  const auto sorted = [&](Tetrahedron_store::Index facet) {
    auto v = store.vertices(facet);
    std::sort(v.begin(), v.end());
    return v;
  };
  for (Tetrahedron_store::Index f = 0; f < 4 * store.number_of_slots(); ++f) {
    const auto g = store.other_side(f);
    if (g == Tetrahedron_store::none)
      continue;
    EXPECT_EQ(store.other_side(g), f);
    EXPECT_EQ(sorted(g), sorted(f));
    EXPECT_EQ(store.label(g), store.label(f));
  }
}

TEST(Uniform_refinement, Makes_eight_of_each) {
  const Mesh input = make_cube(3);
  Tetrahedron_store store(input);
  const tubular::internal::Patch_projection projection(store);
  const auto field = [](const Point& p) { return Metric::isotropic(0.1 + 0.1 * p.x()); };
  tubular::internal::Metric_mesh mesh(store, tubular::internal::Metric_function(field), projection, false, {}, 2);
  tubular::internal::Uniform_refinement(mesh).run();
  expect_connected(store);
  Mesh m;
  store.write_to(m);
  expect_valid(m, 1);
  EXPECT_EQ(m.tetrahedra.size(), 8 * input.tetrahedra.size());
  EXPECT_EQ(m.triangles.size(), 4 * input.triangles.size());
  for (Tetrahedron_store::Index v = 0; v < store.number_of_vertices(); ++v) {
    const Vector_3d& p = store.point(v);
    EXPECT_EQ(mesh.metric(v), field(Point(p.x, p.y, p.z)));
    const auto sides = [](double x) { return x == 0 || x == 1 ? 1 : 0; };
    EXPECT_EQ(mesh.location(v).dimension, 3 - sides(p.x) - sides(p.y) - sides(p.z));
  }
}

/* A quarter of a round shell, of three cells round: new vertices of its walls lie on finer ones, and the layers next to
 * them keep their distance. */
TEST(Uniform_refinement, Follows_a_curved_wall) {
  const auto shell = [](int layers, int round) {
    return Tetrahedron_store(make_grid(
        layers, round, 2,
        [](double x, double y, double z) {
          const double r = 0.5 + 0.5 * x, angle = y * CGAL_PI / 2;
          return Point(r * std::cos(angle), r * std::sin(angle), z);
        },
        [](int axis, int end) { return 1 + 2 * axis + end; }));
  };
  const tubular::internal::Patch_projection projection(shell(1, 48));
  Tetrahedron_store store = shell(8, 3);
  const auto field = [](const Point& p) {
    const Vector_3d radial = normalized(Vector_3d(p.x(), p.y(), 0)), z(0, 0, 1);
    return sizes(0.06, 0.4, 0.4, radial, cross(z, radial), z);
  };
  tubular::internal::Metric_mesh mesh(store, tubular::internal::Metric_function(field), projection, false, {}, 1);
  const auto old = store.number_of_vertices();
  tubular::internal::Uniform_refinement(mesh).run();
  expect_connected(store);
  std::size_t on_wall = 0, next_to_wall = 0;
  const double sagitta = 1 - std::cos(CGAL_PI / 12);
  for (auto v = old; v < store.number_of_vertices(); ++v) {
    const double r = std::hypot(store.point(v).x, store.point(v).y);
    if (mesh.location(v).dimension == 2 && mesh.location(v).id <= 2) {
      EXPECT_NEAR(r, mesh.location(v).id == 1 ? 0.5 : 1, 1e-3);
      ++on_wall;
    } else if (r > 0.93 * std::cos(CGAL_PI / 12)) {
      // halves of layers, of which the walls are the ends, but for a fifth of what the edges' middles are off
      const double layers = 32 * (1 - r);
      EXPECT_NEAR(layers, std::round(layers), 0.2 * 32 * sagitta) << r;
      ++next_to_wall;
    }
  }
  EXPECT_GT(on_wall, 20u);
  EXPECT_GT(next_to_wall, 40u);
}

/* Pairs of neighbours are formed where both are single: each pair that is possible rules out others of its batch, which
 * have to be looked at once more. */
TEST(Speculation, Does_what_one_after_the_other_would) {
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
TEST(Link_condition, Keeps_rims_of_three_vertices) {
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

TEST(Link_condition, Holds_on_a_side_and_along_a_rim) {
  const Mesh m = make_cube(4);
  const auto at = [](int i, int j, int k) { return std::uint32_t((i * 5 + j) * 5 + k); };
  EXPECT_TRUE(link_condition_holds(m, at(2, 2, 0), at(3, 2, 0)));
  EXPECT_TRUE(link_condition_holds(m, at(2, 0, 0), at(3, 0, 0)));
}

/* A rod of two prisms, with a triangle for its waist that is no facet of the surface: were two of its vertices to
 * become one, the surface would touch itself along an edge. */
TEST(Link_condition, Keeps_a_waist_of_three_vertices) {
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

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Patches mapped onto the plane: shapes whose conformal map is known, and patches that provoke flips.

#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Point_2 Point_2;
typedef tubular::Indexed_patch Patch;
typedef tubular::Patch_parameterization Map;
typedef tubular::Parameterization_method Method;

const double pi = 3.14159265358979323846;

// --- patches ---

typedef std::function<Point(double, double)> Shape; // of the angle, and of the height in [0, 1]

/* A tube of `sides` x `rings` quads, each of two triangles; its outside is where the shape's is, if the shape turns
 * counterclockwise as seen from its top. */
Patch tube(const Shape& shape, int sides, int rings) {
  Patch patch;
  for (int k = 0; k <= rings; ++k)
    for (int i = 0; i < sides; ++i)
      patch.points.push_back(shape(2 * pi * i / sides, double(k) / rings));
  for (int k = 0; k < rings; ++k)
    for (int i = 0; i < sides; ++i) {
      const int j = (i + 1) % sides, a = k * sides + i, b = k * sides + j;
      patch.triangles.push_back({{a, b, b + sides}});
      patch.triangles.push_back({{a, b + sides, a + sides}});
    }
  patch.loops = tubular::border_loops(patch);
  return patch;
}

Shape cylinder(double length, double radius = 1) {
  return [=](double a, double t) { return Point(radius * std::cos(a), radius * std::sin(a), length * t); };
}

/* The upper half of the unit sphere. */
Patch half_sphere(int sides, int rings) {
  Patch patch = tube(
      [&](double a, double t) {
        const double b = pi / 2 * t * rings / (rings + 1);
        return Point(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
      },
      sides, rings);
  const int top = int(patch.points.size());
  patch.points.push_back(Point(0, 0, 1));
  for (int i = 0; i < sides; ++i)
    patch.triangles.push_back({{rings * sides + i, rings * sides + (i + 1) % sides, top}});
  patch.loops = tubular::border_loops(patch);
  return patch;
}

/* Of some triangles of a patch, the one piece that has the first of them, so that its loops are new. */
Patch part_of(const Patch& patch, const std::function<bool(std::size_t)>& is_kept) {
  Patch part;
  std::vector<int> image(patch.points.size(), -1);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    if (!is_kept(t))
      continue;
    part.triangles.push_back(patch.triangles[t]);
    for (int& v : part.triangles.back()) {
      int& w = image[std::size_t(v)];
      if (w < 0) {
        w = int(part.points.size());
        part.points.push_back(patch.points[std::size_t(v)]);
      }
      v = w;
    }
  }
  part.loops = tubular::border_loops(part);
  return part;
}

/* A tube with a round hole in its side for each branch: a junction of 2 + n loops, whose branches are drawn out of the
 * holes along their normals. */
Patch junction(int branches, int sides, int rings, double length) {
  Patch whole = tube(cylinder(length), sides, rings);
  const auto place = [&](std::size_t t, double& a, double& z) {
    const auto& c = whole.triangles[t / 2 * 2];
    a = std::atan2(whole.points[std::size_t(c[0])].y(), whole.points[std::size_t(c[0])].x());
    z = whole.points[std::size_t(c[0])].z() / length;
  };
  Patch patch = part_of(whole, [&](std::size_t t) {
    double a, z;
    place(t, a, z);
    for (int b = 0; b < branches; ++b) {
      const double at = (b + 0.5) / branches, side = b % 2 ? 0.3 : 2.1;
      if (std::hypot(a - side, (z - at) * length) < 0.4)
        return false;
    }
    return true;
  });
  // a collar of two rings around each hole but the tube's ends
  for (std::size_t l = 0; l < patch.loops.size(); ++l) {
    std::vector<int> loop = patch.loops[l];
    bool is_end = true;
    for (int v : loop)
      is_end = is_end && (patch.points[std::size_t(v)].z() < 1e-9 * length ||
                          patch.points[std::size_t(v)].z() > (1 - 1e-9) * length);
    for (int ring = 0; !is_end && ring < 2; ++ring) {
      const int first = int(patch.points.size()), n = int(loop.size());
      for (int v : loop) {
        const Point p = patch.points[std::size_t(v)];
        patch.points.push_back(Point(1.3 * p.x(), 1.3 * p.y(), p.z()));
      }
      for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        patch.triangles.push_back({{loop[std::size_t(j)], loop[std::size_t(i)], first + i}});
        patch.triangles.push_back({{loop[std::size_t(j)], first + i, first + j}});
      }
      for (int i = 0; i < n; ++i)
        loop[std::size_t(i)] = first + i;
    }
  }
  patch.loops = tubular::border_loops(patch);
  return patch;
}

/* Each vertex moved by a part of its shortest edge, each edge flipped with some probability. */
Patch perturbed(Patch patch, double amplitude, double flips, std::mt19937& random) {
  const auto in_0_1 = [&] { return random() / 4294967296.; };
  std::map<std::pair<int, int>, std::size_t> triangle_of;
  const auto edges_of = [&](std::size_t t, bool add) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair<int, int> e(patch.triangles[t][i], patch.triangles[t][(i + 1) % 3]);
      if (add)
        triangle_of[e] = t;
      else
        triangle_of.erase(e);
    }
  };
  std::vector<double> shortest(patch.points.size(), 1e300);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    edges_of(t, true);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = std::size_t(patch.triangles[t][i]), b = std::size_t(patch.triangles[t][(i + 1) % 3]);
      const double l = std::sqrt(CGAL::squared_distance(patch.points[a], patch.points[b]));
      shortest[a] = std::min(shortest[a], l);
      shortest[b] = std::min(shortest[b], l);
    }
  }
  const std::size_t tries = std::size_t(flips * 3 * double(patch.triangles.size()) / 2);
  for (std::size_t k = 0; k < tries; ++k) {
    const std::size_t t = random() % patch.triangles.size(), i = random() % 3;
    const int a = patch.triangles[t][i], b = patch.triangles[t][(i + 1) % 3], c = patch.triangles[t][(i + 2) % 3];
    const auto other = triangle_of.find({b, a});
    if (other == triangle_of.end())
      continue;
    const std::size_t s = other->second;
    int d = -1;
    for (int v : patch.triangles[s])
      d = v != a && v != b ? v : d;
    if (triangle_of.count({c, d}) || triangle_of.count({d, c}))
      continue;
    edges_of(t, false);
    edges_of(s, false);
    patch.triangles[t] = {{a, d, c}};
    patch.triangles[s] = {{d, b, c}};
    edges_of(t, true);
    edges_of(s, true);
  }
  for (std::size_t v = 0; v < patch.points.size(); ++v) {
    const double r = amplitude * shortest[v];
    patch.points[v] =
        patch.points[v] + Kernel::Vector_3(r * (2 * in_0_1() - 1), r * (2 * in_0_1() - 1), r * (2 * in_0_1() - 1));
  }
  return patch;
}

// --- measures ---

double norm(const Point_2& p) {
  return std::hypot(p.x(), p.y());
}

/* Checks by other means than the map's own: the triangles' areas add up to what the loops enclose, none is negative, no
 * loop meets itself, all is in the unit circle, and the loops turn as they should. */
void expect_bijective(const Map& map, const std::string& what = "") {
  double sum = 0, enclosed = 0;
  std::size_t flipped = 0;
  for (const auto& t : map.patch().triangles) {
    flipped += CGAL::orientation(map.uv(t[0]), map.uv(t[1]), map.uv(t[2])) != CGAL::LEFT_TURN;
    sum += CGAL::area(map.uv(t[0]), map.uv(t[1]), map.uv(t[2]));
  }
  EXPECT_EQ(flipped, 0u) << what;
  for (std::size_t l = 0; l < map.number_of_loops(); ++l) {
    std::vector<Point_2> polygon;
    for (int v : map.patch().loops[l])
      polygon.push_back(map.uv(v));
    ASSERT_TRUE(CGAL::is_simple_2(polygon.begin(), polygon.end())) << what;
    EXPECT_EQ(CGAL::orientation_2(polygon.begin(), polygon.end()),
              l == map.outer_loop() ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE)
        << what;
    double area;
    CGAL::area_2(polygon.begin(), polygon.end(), area, Kernel());
    enclosed += area;
  }
  EXPECT_NEAR(sum, enclosed, 1e-9) << what;
  for (int v = 0; v < int(map.number_of_vertices()); ++v)
    ASSERT_LE(norm(map.uv(v)), 1 + 1e-12) << what;
}

/* The largest relative error of uv against a conformal map whose modulus is known, up to a rotation. */
double error_of_ring(const Map& map, const std::function<double(const Point&)>& radius) {
  double worst = 0;
  const Point& p0 = map.patch().points[0];
  const double turn = std::atan2(map.uv(0).y(), map.uv(0).x()) - std::atan2(p0.y(), p0.x());
  const bool same_way = [&] { // whether the outer loop goes round the axis as its image does
    const auto& loop = map.patch().loops[map.outer_loop()];
    const Point &a = map.patch().points[std::size_t(loop[0])], &b = map.patch().points[std::size_t(loop[1])];
    return a.x() * b.y() - a.y() * b.x() > 0;
  }();
  for (int v = 0; v < int(map.number_of_vertices()); ++v) {
    const Point& p = map.patch().points[std::size_t(v)];
    const double a = std::atan2(p.y(), p.x());
    const double a0 = std::atan2(p0.y(), p0.x());
    const double angle = a0 + turn + (same_way ? 1 : -1) * (a - a0), r = radius(p);
    worst = std::max(worst, std::hypot(map.uv(v).x() - r * std::cos(angle), map.uv(v).y() - r * std::sin(angle)) / r);
  }
  return worst;
}

/* The largest deviation of the continuous metric's stretches from equality, at inner vertices. */
double anisotropy_at_vertices(const Map& map) {
  std::vector<char> is_border(map.number_of_vertices(), 0);
  for (const auto& loop : map.patch().loops)
    for (int v : loop)
      is_border[std::size_t(v)] = 1;
  double worst = 0;
  for (int t = 0; t < int(map.number_of_triangles()); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_border[std::size_t(map.patch().triangles[std::size_t(t)][i])])
        continue;
      tubular::Patch_location at;
      at.triangle = t;
      at.barycentric = {{0, 0, 0}};
      at.barycentric[i] = 1;
      const tubular::Plane_metric m = map.induced_metric(at, 1.);
      const double mean = (m.xx + m.yy) / 2, radius = std::hypot((m.xx - m.yy) / 2, m.xy);
      worst = std::max(worst, std::sqrt((mean + radius) / (mean - radius)) - 1);
    }
  return worst;
}

// --- shapes whose map is known ---

TEST(Parameterization, A_cylinder_goes_onto_a_ring_by_the_exponential) {
  for (double aspect_ratio : {1., 2., 4., 20.}) {
    const int sides = 48;
    const Patch patch = tube(cylinder(2 * aspect_ratio), sides, int(sides * aspect_ratio / pi));
    const Map map = tubular::parameterize_patch(patch);
    EXPECT_EQ(map.method(), Method::conformal);
    EXPECT_EQ(map.number_of_flips(), 0u);
    expect_bijective(map);
    const bool from_bottom = patch.points[std::size_t(patch.loops[map.outer_loop()][0])].z() == 0;
    const double error =
        error_of_ring(map, [&](const Point& p) { return std::exp(from_bottom ? -p.z() : p.z() - 2 * aspect_ratio); });
    EXPECT_LT(error, 0.01 * std::max(1., aspect_ratio)) << aspect_ratio;
    EXPECT_LT(anisotropy_at_vertices(map), 0.01) << aspect_ratio;
  }
}

TEST(Parameterization, A_catenoid_and_a_cone_go_onto_the_rings_of_their_moduli) {
  const double reach = 1.5; // the catenoid's conformal parameters are its angle and its height
  const Map catenoid = tubular::parameterize_patch(tube(
      [&](double a, double t) {
        const double z = reach * (2 * t - 1);
        return Point(std::cosh(z) * std::cos(a), std::cosh(z) * std::sin(a), z);
      },
      80, 40));
  expect_bijective(catenoid);
  EXPECT_EQ(catenoid.method(), Method::conformal);
  const bool from_bottom =
      catenoid.patch().points[std::size_t(catenoid.patch().loops[catenoid.outer_loop()][0])].z() < 0;
  EXPECT_LT(
      error_of_ring(catenoid, [&](const Point& p) { return std::exp(from_bottom ? -p.z() - reach : p.z() - reach); }),
      0.01);

  const double slope = 0.5, half_angle_sine = slope / std::hypot(1, slope); // radius r: modulus r^(1 / sin)
  const Map cone = tubular::parameterize_patch(tube(
      [&](double a, double t) {
        const double r = 1 + slope * 3 * t;
        return Point(r * std::cos(a), r * std::sin(a), 3 * t);
      },
      80, 40));
  expect_bijective(cone);
  EXPECT_LT(error_of_ring(
                cone, [&](const Point& p) { return std::pow(std::hypot(p.x(), p.y()) / 2.5, 1 / half_angle_sine); }),
            0.01);
  EXPECT_LT(anisotropy_at_vertices(cone), 0.01);
}

TEST(Parameterization, A_half_sphere_goes_onto_the_disk_by_stereographic_projection) {
  const Map map = tubular::parameterize_patch(half_sphere(64, 20));
  expect_bijective(map);
  EXPECT_EQ(map.method(), Method::conformal);
  double worst = 0;
  for (int v = 0; v < int(map.number_of_vertices()); ++v) {
    const Point& p = map.patch().points[std::size_t(v)];
    worst = std::max(worst, std::abs(norm(map.uv(v)) - std::hypot(p.x(), p.y()) / (1 + p.z())));
  }
  EXPECT_LT(worst, 0.005);
  EXPECT_LT(anisotropy_at_vertices(map), 0.02);
}

TEST(Parameterization, Junctions_keep_their_holes) {
  for (int branches : {1, 2, 5}) {
    const Map map = tubular::parameterize_patch(junction(branches, 48, 15 * branches + 15, 2. * branches + 2));
    ASSERT_EQ(map.number_of_loops(), std::size_t(branches) + 2);
    expect_bijective(map);
    EXPECT_LE(map.method(), Method::conformal_repaired);
    std::vector<double> ratio;
    for (int t = 0; t < int(map.number_of_triangles()); ++t)
      ratio.push_back(map.stretch_ratio(t));
    std::sort(ratio.begin(), ratio.end());
    EXPECT_LT(ratio[ratio.size() / 2], 1.15);
    EXPECT_LT(ratio[ratio.size() * 9 / 10], 1.5);
  }
}

TEST(Parameterization, The_map_does_not_depend_on_unit_and_place) {
  const Patch patch = junction(1, 40, 30, 4);
  Patch moved = patch;
  for (Point& p : moved.points)
    p = Point(1024 * p.x(), 1024 * p.y(), 1024 * p.z()); // exact
  const Map a = tubular::parameterize_patch(patch), b = tubular::parameterize_patch(moved);
  for (int v = 0; v < int(a.number_of_vertices()); ++v)
    ASSERT_LT(std::hypot(a.uv(v).x() - b.uv(v).x(), a.uv(v).y() - b.uv(v).y()), 1e-9);
  for (double scale : {1e-6, 1e6}) {
    for (std::size_t v = 0; v < patch.points.size(); ++v)
      moved.points[v] = Point(scale * patch.points[v].x(), scale * patch.points[v].y(), scale * patch.points[v].z());
    expect_bijective(tubular::parameterize_patch(moved));
  }
}

TEST(Parameterization, Wide_triangles_are_divided_without_a_change_of_the_surface) {
  for (int sides : {4, 5, 6}) {
    const Patch patch = tube(cylinder(7), sides, 1);
    const Map map = tubular::parameterize_patch(patch);
    expect_bijective(map);
    EXPECT_EQ(map.method(), Method::conformal) << sides;
    EXPECT_GT(map.number_of_triangles(), patch.triangles.size());
    EXPECT_LT(map.number_of_triangles(), 2000u);
    std::vector<double> ratio, area(patch.triangles.size(), 0.);
    for (int t = 0; t < int(map.number_of_triangles()); ++t) {
      ratio.push_back(map.stretch_ratio(t));
      const auto& c = patch.triangles[std::size_t(map.input_triangle(t))];
      const Kernel::Plane_3 plane(patch.points[std::size_t(c[0])], patch.points[std::size_t(c[1])],
                                  patch.points[std::size_t(c[2])]);
      for (int v : map.patch().triangles[std::size_t(t)])
        EXPECT_LT(CGAL::squared_distance(plane, map.patch().points[std::size_t(v)]), 1e-28);
      const auto& d = map.patch().triangles[std::size_t(t)];
      area[std::size_t(map.input_triangle(t))] +=
          std::sqrt(CGAL::squared_area(map.patch().points[std::size_t(d[0])], map.patch().points[std::size_t(d[1])],
                                       map.patch().points[std::size_t(d[2])]));
    }
    for (std::size_t t = 0; t < area.size(); ++t) {
      const auto& c = patch.triangles[t];
      EXPECT_NEAR(area[t],
                  std::sqrt(CGAL::squared_area(patch.points[std::size_t(c[0])], patch.points[std::size_t(c[1])],
                                               patch.points[std::size_t(c[2])])),
                  1e-12);
    }
    std::sort(ratio.begin(), ratio.end());
    EXPECT_LT(ratio[ratio.size() / 2], 1.5) << sides;
    EXPECT_LT(ratio[ratio.size() * 9 / 10], 2.) << sides;
    for (std::size_t v = 0; v < patch.points.size(); ++v)
      EXPECT_EQ(map.patch().points[v], patch.points[v]);
  }
}

// --- flips ---

TEST(Parameterization, Coarse_tubes) {
  for (int sides : {3, 4, 5, 6, 8})
    for (int rings : {1, 2, 5, 40})
      for (double length : {0.1, 1., 4., 16.}) {
        const std::string what =
            std::to_string(sides) + " sides, " + std::to_string(rings) + " rings, length " + std::to_string(length);
        expect_bijective(tubular::parameterize_patch(tube(cylinder(length), sides, rings)), what);
        const Shape twisted = [&](double a, double t) { return cylinder(length)(a + pi / sides * t * rings, t); };
        expect_bijective(tubular::parameterize_patch(tube(twisted, sides, rings)), what + ", twisted");
      }
}

TEST(Parameterization, Flipped_triangles_are_mended_or_another_method_is_taken) {
  // needles along and around a tube, and vertices that almost are on an edge
  std::mt19937 random(1);
  std::size_t provoked = 0;
  for (double squeeze : {1e-2, 1e-4, 1e-8}) {
    Patch patch = tube(cylinder(6), 30, 30);
    for (std::size_t v = 0; v < patch.points.size(); ++v)
      if (v / 30 % 3 == 1) // every third ring almost on the one below, and turned
        patch.points[v] = cylinder(6)(2 * pi * (double(v % 30) + 0.45) / 30, (double(v / 30 - 1) + squeeze) / 30);
    const Map map = tubular::parameterize_patch(perturbed(patch, 0, 0.5, random));
    expect_bijective(map, std::to_string(squeeze));
    provoked += map.number_of_flips();
    EXPECT_EQ(map.method() == Method::conformal, map.number_of_flips() == 0);
  }
  EXPECT_GT(provoked, 0u);
}

TEST(Parameterization, Each_method_gives_a_bijection) {
  std::mt19937 random(6);
  for (const Patch& patch : {tube(cylinder(5), 20, 16), half_sphere(20, 8), junction(3, 30, 40, 6)})
    for (Method first : {Method::conformal, Method::conformal_repaired, Method::harmonic, Method::mean_value,
                         Method::uniform, Method::shortened}) {
      const Map map = tubular::parameterize_patch(patch, first);
      EXPECT_EQ(map.method(), first);
      expect_bijective(map, tubular::name_of(first));
      const Map other = tubular::parameterize_patch(perturbed(patch, 0.3, 0.3, random), first);
      EXPECT_GE(other.method(), first);
      expect_bijective(other, tubular::name_of(first));
    }
}

TEST(Parameterization, A_thousand_random_patches_are_mapped_one_to_one) {
  std::mt19937 random(2026);
  std::map<Method, int> taken;
  for (int i = 0; i < 1000; ++i) {
    const double length = 0.3 + 8 * (random() / 4294967296.), bend = 0.8 * (random() / 4294967296.);
    const int sides = 5 + int(random() % 12), rings = 2 + int(random() % 12);
    Patch patch;
    if (i % 3 == 0)
      patch =
          tube([&](double a, double t) { return cylinder(length, 1 + bend * std::sin(7 * t))(a, t); }, sides, rings);
    else if (i % 3 == 1)
      patch = half_sphere(sides, rings);
    else
      patch = junction(1 + i % 2, 16 + sides, 2 * rings + 8, length + 2);
    const Map map =
        tubular::parameterize_patch(perturbed(patch, 0.05 * (i % 10), i % 4 == 0 ? 0 : 0.2 * (i % 5), random));
    expect_bijective(map, "patch " + std::to_string(i));
    ++taken[map.method()];
    if (HasFailure())
      break;
  }
  for (const auto& t : taken)
    RecordProperty(tubular::name_of(t.first), t.second);
  EXPECT_GT(taken[Method::conformal], 300);
}

TEST(Parameterization, A_long_blind_branch_is_mapped_one_to_one) {
  for (int rings : {40, 200, 600}) { // about 8, 40, 120 of its diameters
    Patch patch = junction(1, 40, 30, 4);
    const auto is_collar = [&](const std::vector<int>& loop) {
      return std::abs(patch.points[std::size_t(loop[0])].z() - 2) < 1;
    };
    std::vector<int> loop = *std::find_if(patch.loops.begin(), patch.loops.end(), is_collar);
    const std::size_t n = loop.size();
    for (int ring = 0; ring <= rings; ++ring) {
      const int first = int(patch.points.size());
      for (std::size_t i = 0; i < n; ++i) {
        const Point p = patch.points[std::size_t(loop[i])];
        patch.points.push_back(Point(p.x() + 0.16 * std::cos(2.1), p.y() + 0.16 * std::sin(2.1), p.z()));
      }
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        patch.triangles.push_back({{loop[j], loop[i], first + int(i)}});
        patch.triangles.push_back({{loop[j], first + int(i), first + int(j)}});
      }
      for (std::size_t i = 0; i < n; ++i)
        loop[i] = first + int(i);
    }
    Kernel::Vector_3 sum(0, 0, 0);
    for (int v : loop)
      sum = sum + (patch.points[std::size_t(v)] - CGAL::ORIGIN) / double(n);
    for (std::size_t i = 0; i < n; ++i)
      patch.triangles.push_back({{loop[(i + 1) % n], loop[i], int(patch.points.size())}});
    patch.points.push_back(CGAL::ORIGIN + sum);
    patch.loops = tubular::border_loops(patch);
    ASSERT_EQ(patch.loops.size(), 2u);
    const Map map = tubular::parameterize_patch(patch);
    expect_bijective(map, std::to_string(rings));
    RecordProperty("method_" + std::to_string(rings), tubular::name_of(map.method()));
  }
}

TEST(Parameterization, Points_on_top_of_each_other) {
  Patch patch = tube(cylinder(4), 20, 20);
  patch.points[105] = patch.points[104];
  patch.points[205] = patch.points[204] = patch.points[224];
  patch.points[20 * 20 + 3] = patch.points[20 * 20 + 4]; // on the border
  expect_bijective(tubular::parameterize_patch(patch));
}

// --- locations ---

TEST(Parameterization, Locations_and_points) {
  const Map map = tubular::parameterize_patch(junction(2, 40, 45, 6));
  std::mt19937 random(3);
  int hint = -1;
  for (int i = 0; i < 20000; ++i) {
    const int t = int(random() % map.number_of_triangles());
    double a = random() / 4294967296., b = random() / 4294967296.;
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    tubular::Patch_location at;
    at.triangle = t;
    at.barycentric = {{1 - a - b, a, b}};
    const tubular::Patch_location found = map.locate(map.uv(at), hint);
    const double size = std::sqrt(CGAL::area(map.uv(map.patch().triangles[std::size_t(t)][0]),
                                             map.uv(map.patch().triangles[std::size_t(t)][1]),
                                             map.uv(map.patch().triangles[std::size_t(t)][2])));
    ASSERT_LT(std::sqrt(found.squared_distance), 1e-9 * size);
    ASSERT_LT(std::sqrt(CGAL::squared_distance(map.point(found), map.point(at))), 1e-9);
    if (i % 2)
      hint = found.triangle; // otherwise far away, as often as not
  }
}

TEST(Parameterization, Points_outside_get_the_nearest_point) {
  const Map map = tubular::parameterize_patch(tube(cylinder(3), 12, 6));
  std::mt19937 random(4);
  for (int i = 0; i < 300; ++i) {
    const double a = 2 * pi * random() / 4294967296., r = i % 2 ? 1 + 0.1 * (i % 5) : 0.01;
    const Point_2 p(r * std::cos(a), r * std::sin(a));
    double nearest = 1e300;
    for (const auto& loop : map.patch().loops)
      for (std::size_t k = 0; k < loop.size(); ++k)
        nearest = std::min(nearest, CGAL::squared_distance(
                                        p, Kernel::Segment_2(map.uv(loop[k]), map.uv(loop[(k + 1) % loop.size()]))));
    for (int hint : {-1, 0, 70}) {
      const tubular::Patch_location at = map.locate(p, hint);
      ASSERT_NEAR(at.squared_distance, nearest, 1e-12);
      ASSERT_NEAR(CGAL::squared_distance(map.uv(at), p), nearest, 1e-12);
    }
  }
}

/* By the given loops, whose edges may have been halved. */
void expect_loops_by_arc_length(const Patch& patch) {
  const Map map = tubular::parameterize_patch(patch);
  for (std::size_t l = 0; l < map.number_of_loops(); ++l) {
    const auto& loop = patch.loops[l];
    const double total = map.loop_length(l);
    double s = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point &p = patch.points[std::size_t(loop[k])], &q = patch.points[std::size_t(loop[(k + 1) % loop.size()])];
      const double length = std::sqrt(CGAL::squared_distance(p, q));
      for (double t : {0., 0.25, 0.9}) {
        const Point expected = p + t * (q - p);
        EXPECT_LT(CGAL::squared_distance(map.point(map.on_loop(l, s + t * length)), expected), 1e-20 * total * total);
        EXPECT_LT(CGAL::squared_distance(map.point(map.on_loop(l, s + t * length - total)), expected),
                  1e-20 * total * total);
        const tubular::Patch_location at = map.on_loop_edge(l, k, t);
        EXPECT_LT(CGAL::squared_distance(map.point(at), expected), 1e-28 * total * total);
        // on a chord of the polygon in the plane
        const auto& parts = map.patch().loops[l];
        double nearest = 1e300;
        for (std::size_t i = 0; i < parts.size(); ++i)
          nearest = std::min(
              nearest, CGAL::squared_distance(
                           map.uv(at), Kernel::Segment_2(map.uv(parts[i]), map.uv(parts[(i + 1) % parts.size()]))));
        EXPECT_LT(nearest, 1e-30);
      }
      s += length;
    }
    EXPECT_NEAR(s, total, 1e-12 * total);
  }
}

TEST(Parameterization, Loops_by_arc_length) {
  for (const Patch& patch : {junction(1, 40, 30, 4), tube(cylinder(5), 5, 3)})
    expect_loops_by_arc_length(patch);
}

// --- metrics ---

TEST(Parameterization, The_induced_metric_is_that_of_finite_differences) {
  const Map map = tubular::parameterize_patch(junction(1, 40, 30, 4));
  Eigen::Matrix3d metric;
  metric << 4, 1, 0, 1, 9, 2, 0, 2, 3;
  std::mt19937 random(5);
  for (int t = 0; t < int(map.number_of_triangles()); ++t) {
    tubular::Patch_location a, b;
    a.triangle = b.triangle = t;
    a.barycentric = {{0.2, 0.3, 0.5}};
    const double d = 0.1 * (random() / 4294967296.), e = 0.1 * (random() / 4294967296.);
    b.barycentric = {{0.2 + d, 0.3 + e, 0.5 - d - e}};
    const Point x = map.point(a), y = map.point(b);
    const Eigen::Vector3d dx(y.x() - x.x(), y.y() - x.y(), y.z() - x.z());
    const double du = map.uv(b).x() - map.uv(a).x(), dv = map.uv(b).y() - map.uv(a).y();
    const double expected = dx.dot(metric * dx);
    ASSERT_NEAR(map.induced_metric(t, metric).squared_length(du, dv), expected, 1e-8 * expected);
    const auto derivatives = map.derivatives(t);
    ASSERT_LT((derivatives * Eigen::Vector2d(du, dv) - dx).norm(), 1e-9 * dx.norm() + 1e-14);
  }
}

TEST(Parameterization, The_metric_between_vertices_is_continuous_and_has_the_shapes_scale) {
  const double size = 0.1;
  const Map map = tubular::parameterize_patch(tube(cylinder(6), 48, 46));
  for (int h = 0; h < int(3 * map.number_of_triangles()); ++h) {
    const int t = h / 3, i = h % 3;
    tubular::Patch_location at;
    at.triangle = t;
    at.barycentric = {{0, 0, 0}};
    at.barycentric[std::size_t(i)] = at.barycentric[std::size_t((i + 1) % 3)] = 0.5;
    // just across the edge
    const Point_2 p = map.uv(at);
    const auto& c = map.patch().triangles[std::size_t(t)];
    const Point_2 q = map.uv(c[std::size_t((i + 2) % 3)]);
    const Point_2 beyond = p + 1e-9 * (p - q), before = p - 1e-9 * (p - q);
    const auto m = map.induced_metric(map.locate(beyond, t), size), n = map.induced_metric(map.locate(before, t), size);
    ASSERT_NEAR(m.xx, n.xx, 1e-6 * m.xx);
    ASSERT_NEAR(m.yy, n.yy, 1e-6 * m.yy);
    // x,u = 1 / rho on the ring of a cylinder of radius 1; vertices of a loop have triangles on one side only
    const double rho = norm(p), step = 2 * pi / 48;
    const bool is_near_loop = rho > std::exp(-1.5 * step) || rho < std::exp(-6 + 1.5 * step);
    ASSERT_NEAR(std::sqrt(m.determinant()) * size * size * rho * rho, 1, is_near_loop ? step : 0.02);
  }
  // a field of metrics: isotropic, of a size that depends on the place
  const auto logs = map.log_vertex_metrics(
      [](const Point& p) { return Eigen::Matrix3d(Eigen::Matrix3d::Identity() * (1 + p.z() * p.z())); });
  tubular::Patch_location at;
  at.triangle = 200;
  at.barycentric = {{0.2, 0.3, 0.5}};
  const double z = map.point(at).z();
  EXPECT_NEAR(map.interpolate(logs, at).xx, (1 + z * z) * map.induced_metric(at, 1.).xx,
              0.02 * map.interpolate(logs, at).xx);
}

// --- what cannot be mapped ---

TEST(Parameterization, Patches_that_are_no_spheres_with_holes_are_refused) {
  Patch closed = half_sphere(12, 4);
  const int n = int(closed.points.size());
  for (int i = 0; i < 12; ++i)
    closed.triangles.push_back({{(i + 1) % 12, i, n}});
  closed.points.push_back(Point(0, 0, 0));
  closed.loops = tubular::border_loops(closed);
  EXPECT_TRUE(closed.loops.empty());
  EXPECT_THROW(tubular::parameterize_patch(closed), tubular::Meshing_error);

  Patch two = tube(cylinder(1), 8, 2), other = two;
  for (auto t : other.triangles)
    two.triangles.push_back({{t[0] + 24, t[1] + 24, t[2] + 24}});
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  two.loops = tubular::border_loops(two);
  EXPECT_THROW(tubular::parameterize_patch(two), tubular::Meshing_error);

  Patch torus = tube(
      [](double a, double t) {
        const double b = 2 * pi * t, r = 3 + std::cos(a);
        return Point(r * std::cos(b), r * std::sin(b), std::sin(a));
      },
      10, 20);
  for (auto& t : torus.triangles)
    for (int& v : t)
      v = v % 200;
  torus.points.resize(200);
  torus.triangles.pop_back();
  torus.loops = tubular::border_loops(torus);
  EXPECT_EQ(torus.loops.size(), 1u);
  EXPECT_THROW(tubular::parameterize_patch(torus), tubular::Meshing_error);

  Patch wrong = tube(cylinder(1), 8, 2);
  for (auto& loop : wrong.loops)
    std::reverse(loop.begin(), loop.end());
  EXPECT_THROW(tubular::parameterize_patch(wrong), tubular::Input_error);
  wrong = tube(cylinder(1), 8, 2);
  wrong.loops.pop_back();
  EXPECT_THROW(tubular::parameterize_patch(wrong), tubular::Meshing_error);
  wrong = tube(cylinder(1), 8, 2);
  wrong.triangles.push_back(wrong.triangles[0]);
  EXPECT_THROW(tubular::parameterize_patch(wrong), tubular::Input_error);
  wrong = tube(cylinder(1), 8, 2);
  wrong.triangles[3][1] = 1000;
  EXPECT_THROW(tubular::parameterize_patch(wrong), tubular::Input_error);
  wrong = tube(cylinder(1), 8, 2);
  wrong.points[3] = Point(std::nan(""), 0, 0);
  EXPECT_THROW(tubular::parameterize_patch(wrong), tubular::Input_error);
}

// --- patches of a surface ---

TEST(Parameterization, Patches_of_a_cut_surface_share_their_curves) {
  typedef CGAL::Surface_mesh<Point> Mesh;
  typedef tubular::Cut_curve Curve;
  const int sides = 24, rings = 40, middle = 17;
  const Patch whole = tube(cylinder(8), sides, rings);
  Mesh mesh;
  for (const Point& p : whole.points)
    mesh.add_vertex(p);
  tubular::Surface_cut cut;
  cut.patches.resize(2);
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    const auto& c = whole.triangles[t];
    const auto f = mesh.add_face(Mesh::Vertex_index(c[0]), Mesh::Vertex_index(c[1]), Mesh::Vertex_index(c[2]));
    cut.patches[int(t) < 2 * sides * middle ? 0 : 1].faces.push_back(f);
  }
  for (int ring : {0, middle, rings}) {
    Curve curve;
    for (int i = 0; i < sides; ++i) // the patch above is on its left
      curve.vertices.push_back(Mesh::Vertex_index(ring * sides + i));
    cut.curves.push_back(curve);
  }
  cut.patches[0].loops = {{0, true, Curve::none}, {1, false, 1}};
  cut.patches[1].loops = {{1, true, 0}, {2, false, Curve::none}};
  for (int threads : {1, 2}) {
    const auto maps = tubular::parameterize_patches(mesh, cut, tubular::parameters::number_of_threads(threads));
    ASSERT_EQ(maps.size(), 2u);
    for (const Map& map : maps) {
      EXPECT_EQ(map.method(), Method::conformal);
      expect_bijective(map);
    }
    for (std::size_t e = 0; e < std::size_t(sides); ++e) {
      const Point below = maps[0].point(maps[0].on_loop_edge(1, std::size_t(sides) - 1 - e, 0.75));
      const Point above = maps[1].point(maps[1].on_loop_edge(0, e, 0.25));
      EXPECT_LT(CGAL::squared_distance(below, above), 1e-28);
    }
  }
}

TEST(Parameterization, A_hundred_thousand_triangles_in_a_hundred_patches) {
  std::vector<Patch> patches;
  for (int i = 0; i < 50; ++i) {
    patches.push_back(tube(cylinder(6), 22, 22));
    patches.push_back(junction(1, 26, 20, 3));
  }
  std::size_t triangles = 0;
  for (const Patch& patch : patches)
    triangles += patch.triangles.size();
  EXPECT_GT(triangles, 95000u);
  const auto start = std::chrono::steady_clock::now();
  for (const Patch& patch : patches)
    tubular::parameterize_patch(patch);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("milliseconds", int(1000 * seconds));
#ifdef NDEBUG
  EXPECT_LT(seconds, 4); // 1 on a machine that does nothing else
#endif
}

} // namespace

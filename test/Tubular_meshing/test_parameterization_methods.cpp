// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Patches that provoke flips: one method after another, until a map is one to one.

#include "patch_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace patch_shapes;

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

TEST(Parameterization, Flipped_triangles_are_repaired_or_another_method_is_taken) {
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

} // namespace

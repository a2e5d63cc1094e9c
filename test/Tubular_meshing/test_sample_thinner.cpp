// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which vertices of a wall centerlines are computed from.

#include "computed_centerlines.h"

#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_surface.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/base/Canonical_frame.h>

#include <cstddef>
#include <vector>

namespace {

using namespace computed_centerlines;
using tubular::internal::Canonical_frame;
using tubular::internal::Double_kernel;
using tubular::internal::Sampled_surface;

struct Sampled {
  Closed closed;
  Canonical_frame frame;
  Sampled_surface samples;

  explicit Sampled(const Mesh& open, int threads = 0)
      : closed(open)
      , frame(points_of(closed.mesh))
      , samples(closed.mesh, closed.patch, frame, threads) {}

  static std::vector<Double_kernel::Point_3> points_of(const Mesh& mesh) {
    std::vector<Double_kernel::Point_3> points;
    for (auto v : mesh.vertices())
      points.push_back(tubular::internal::to_double_point(mesh.point(v)));
    return points;
  }

  double share_in_use() const { return double(samples.number_in_use()) / double(samples.points.size()); }
};

// What stands for a vertex of the wall is a sample, no further away than this.
void expect_to_be_near(const Sampled& sampled, double most) {
  const Sampled_surface& s = sampled.samples;
  for (auto v : sampled.closed.mesh.vertices()) {
    const std::size_t sample = s.sample_of(std::size_t(v));
    if (sample >= s.points.size())
      continue; // in a cap
    EXPECT_FALSE(s.is_left_out(sample));
    const auto p = sampled.frame.from_canonical(s.points[sample]);
    EXPECT_LE(distance(Point(p.x(), p.y(), p.z()), sampled.closed.mesh.point(v)), most);
  }
}

TEST(Sample_thinner, Leaves_a_wall_of_twenty_points_round_as_it_is) {
  EXPECT_EQ(Sampled(surface_of(tubular::curved_tube(), 20)).share_in_use(), 1);
}

TEST(Sample_thinner, Takes_as_many_points_of_a_finer_wall) {
  const Sampled once(surface_of(tubular::curved_tube(), 50)), twice(surface_of(tubular::curved_tube(), 100));
  EXPECT_LT(once.share_in_use(), 0.6);
  EXPECT_LT(twice.share_in_use(), 0.2);
  EXPECT_GT(double(twice.samples.number_in_use()), 0.75 * double(once.samples.number_in_use()));
  EXPECT_LT(double(twice.samples.number_in_use()), 1.5 * double(once.samples.number_in_use()));
  expect_to_be_near(once, 0.26);
  expect_to_be_near(twice, 0.26);
}

TEST(Sample_thinner, Does_not_depend_on_the_threads) {
  const Mesh mesh = surface_of(tubular::curved_tube(), 60, 0.01);
  const Sampled one(mesh, 1), all(mesh, 0);
  for (std::size_t i = 0; i < one.samples.points.size(); ++i)
    EXPECT_EQ(one.samples.is_left_out(i), all.samples.is_left_out(i));
}

} // namespace

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Schedule.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double least = 0.005; // seconds: no stage takes nothing

} // namespace

// Microseconds a triangle of the surface.
void Schedule::expect_preparation(const Options& options, double triangles) {
  expect("repair", 16e-6 * triangles + least);
  expect(options.centerlines.empty() ? "centerlines" : "branches, openings",
         (options.centerlines.empty() ? 35e-6 : 8e-6) * triangles + least);
  expect("size field", 30e-6 * triangles + least);
}

// Microseconds a triangle, a cell, a facet; there are about as many facets as that many tetrahedra have in a ball.
void Schedule::expect_meshing(const Options& o, double triangles, double tetrahedra) {
  const double facets = 9 * std::pow((std::max)(tetrahedra, 1.), 2. / 3);
  const double micro = 1e-6;
  double cells = tetrahedra;
  const bool in_blocks = o.is_hexahedral() && o.hex_method == "blocks";
  if (in_blocks) {
    expect("blocks", micro * 20 * cells + micro * 5 * triangles + least);
    expect("volume", micro * 20 * cells + least);
  } else {
    expect("cut", micro * 4 * triangles + least);
    expect("parameterization", micro * 5 * triangles + least);
    expect(o.is_mixed() ? "quads" : "surface mesh", micro * (o.is_mixed() ? 120 : 15) * facets + least);
    if (!o.is_anisotropic())
      expect("volume", micro * 20 * facets + least);
  }
  if (o.makes_surface_only())
    cells = 0;
  else if (o.is_mixed())
    expect("pyramids and tetrahedra", micro * 20 * cells + least);
  else if (!in_blocks) {
    expect("tetrahedra", micro * 12 * cells + least);
    expect("optimization", micro * 4 * cells + least);
  }
  if (o.is_anisotropic()) {
    cells *= 8; // with layers of the default height
    expect("metric field", micro * 40 * triangles + least);
    expect("anisotropic remeshing", micro * 110 * cells + least);
    expect("volume", micro * 2 * cells + least);
  }
  if (o.is_hexahedral() && !in_blocks)
    expect("optimization of hexahedra", micro * 40 * cells + least);
  if (o.boundary_layer_prisms > 0)
    expect("boundary layer", micro * 10 * o.boundary_layer_prisms * facets + least);
  expect("check", micro * 1.5 * cells + least);
  if (o.has_wall())
    expect("wall", micro * 40 * facets + micro * 10 * o.wall.number * facets + least);
  if (o.is_quadratic())
    expect("quadratic elements", micro * 60 * cells + least);
  expect("report", micro * 5 * (cells + facets) + least);
  expect("write", micro * 2 * (cells + facets) + least);
  is_complete_ = true;
}

void Schedule::begin(const std::string& stage) {
  stage_ = stage;
}

void Schedule::end(const std::string& stage, double seconds) {
  for (Entry& e : entries_)
    if (e.stage == stage && !e.is_done) {
      e.is_done = true;
      expected_ += e.expected;
      taken_ += seconds;
      break;
    }
  stage_.clear();
}

const Schedule::Entry* Schedule::current() const {
  for (const Entry& e : entries_)
    if (e.stage == stage_ && !e.is_done)
      return &e;
  return nullptr;
}

std::optional<Schedule::State> Schedule::state(double seconds) const {
  if (!is_complete_)
    return std::nullopt;
  // how much longer than expected all takes here: what is expected counts as well as a second that was taken
  const double one = 1, pace = (std::min)((std::max)((taken_ + one) / (expected_ + one), 0.2), 5.);
  double all = 0, left = 0;
  for (const Entry& e : entries_) {
    all += e.expected;
    left += e.is_done ? 0 : e.expected;
  }
  if (const Entry* e = current()) { // a stage that takes longer than expected is nearly done, and never is
    const double x = seconds / (pace * e->expected);
    left -= e->expected * (x < 0.8 ? x : 1 - 0.2 * std::exp(-(x - 0.8) / 0.2));
  }
  return State{(std::min)((std::max)(1 - left / all, 0.), 0.99), pace * (std::max)(left, 0.)};
}

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reduced_model.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

// The mean round a section.
double thickness_at(const tubular::Cross_section& s, const tubular::Wall_thickness& thickness) {
  if (thickness.is_relative())
    return thickness.radii() * s.inscribed_radius;
  const tubular::Vector_3 n = s.normal;
  const tubular::Vector_3 axis = std::abs(n.x()) < 0.6 ? tubular::Vector_3(1, 0, 0) : tubular::Vector_3(0, 1, 0);
  tubular::Vector_3 u = CGAL::cross_product(n, axis);
  u = u / std::sqrt(u.squared_length());
  const tubular::Vector_3 v = CGAL::cross_product(n, u);
  const double radius = s.area > 0 ? s.radius() : s.inscribed_radius, eighth = std::acos(-1.) / 4;
  double sum = 0;
  for (int k = 0; k < 8; ++k)
    sum += thickness(s.center + radius * (std::cos(k * eighth) * u + std::sin(k * eighth) * v), radius);
  return sum / 8;
}

tubular::Zero_d_options zero_d_options(const Run& run) {
  const Options& o = run.options;
  tubular::Zero_d_options options; // whose units are cm, g and s
  options.length_unit = 100 * o.physics.meters();
  options.density = o.physics.density / 1000;
  options.viscosity = 10 * o.physics.viscosity;
  options.youngs_modulus = 10 * o.physics.youngs_modulus;
  options.flow_rate = o.physics.flow_rate;
  options.murray = o.murray;
  options.mean_pressure = 10 * o.mean_pressure;
  if (!o.has_wall())
    return options;
  tubular::Wall_thickness thickness = run.walls.thickness;
  if (!o.wall_table.empty()) // of all vessels
    thickness =
        tubular::thickness_of_branches(run.model.centerlines, run.walls.of_branches, run.walls.of_other_branches);
  options.wall_thickness = [thickness](const tubular::Cross_section& s) { return thickness_at(s, thickness); };
  return options;
}

} // namespace

void make_reduced_model(Run& run, Stage_clock& clock) {
  const Options& o = run.options;
  if (o.sections_output.empty() && o.zero_d_output.empty())
    return;
  clock.begin("cross-sections");
  run.sections = tubular::cross_sections(run.model.surface, run.model.centerlines, o.section_spacing, o.threads);
  if (o.zero_d_output.empty())
    return;
  std::vector<tubular::Opening> openings = run.model.openings;
  for (tubular::Opening& opening : openings)
    opening.name = run.cells().patch_names.at(opening.patch);
  std::vector<std::size_t> inlets;
  std::size_t first = 0;
  for (std::size_t number : run.openings_of_parts) {
    inlets.push_back(first);
    first += number;
  }
  run.zero_d = tubular::make_zero_d_model(run.model.centerlines, openings, run.sections, zero_d_options(run), inlets);
  for (const std::string& name : run.zero_d.openings_left_out)
    run.notes.push_back("No centerline leads to " + name + ", which the zero-dimensional model therefore lacks.");
}

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../command_line/Points.h"
#include "stages.h"

#include <CGAL/Tubular_meshing/IO/read_centerlines.h>

#include <string>
#include <vector>

namespace {

// Where the centerlines that are to be computed begin and end, beside the openings.
std::vector<Point_3> seeds_of(const Options& o) {
  if (!o.seeds.empty())
    return command_line::read_points<Point_3>(o.seeds);
  std::vector<Point_3> seeds;
  if (o.outlets.empty())
    return seeds;
  seeds.push_back(command_line::point_of<Point_3>(o.inlet));
  for (const std::string& p : o.outlets)
    seeds.push_back(command_line::point_of<Point_3>(p));
  return seeds;
}

tubular::Tubular_model with_computed_centerlines(const Options& o, const Surface& surface,
                                                 const Flow_extensions& extensions) {
  const auto np = tubular::parameters::loops(o.loops).seeds(seeds_of(o));
  if (!extensions.openings.empty()) // the inlet has moved
    return tubular::make_tubular_model(surface, np.inlet(extensions.openings.front().center));
  if (!o.inlet.empty())
    return tubular::make_tubular_model(surface, np.inlet(command_line::point_of<Point_3>(o.inlet)));
  return tubular::make_tubular_model(surface, np);
}

tubular::Tubular_model with_given_centerlines(const Options& o, const Surface& surface,
                                              const tubular::Centerline_polylines& lines) {
  if (o.inlet.empty())
    return tubular::make_tubular_model(surface, lines);
  return tubular::make_tubular_model(surface, lines,
                                     tubular::parameters::inlet(command_line::point_of<Point_3>(o.inlet)));
}

} // namespace

tubular::Tubular_model prepare(const Options& o, const Surface& surface, const Flow_extensions& extensions,
                               Stage_clock& clock) {
  if (o.centerlines.empty()) {
    clock.begin("centerlines");
    return with_computed_centerlines(o, surface, extensions);
  }
  tubular::Centerline_polylines lines;
  tubular::IO::read_centerlines(o.centerlines, lines);
  clock.begin("branches, openings");
  return with_given_centerlines(o, surface, lines);
}

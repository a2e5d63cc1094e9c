// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>

#include <array>
#include <cstddef>
#include <vector>

namespace {

tubular::Repair_mode repair_mode(const Options& o) {
  typedef tubular::Repair_mode Mode;
  return o.repair == "off" ? Mode::off : o.repair == "wrap" ? Mode::wrap : Mode::automatic;
}

} // namespace

tubular::Repair_report read_surface(const Options& o, Surface& surface, Stage_clock& clock) {
  clock.begin("read");
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  tubular::IO::read_triangle_soup(o.surface, points, triangles);
  clock.begin("repair");
  return tubular::repair_surface(points, triangles, surface,
                                 tubular::parameters::repair_mode(repair_mode(o)).smooth(o.smooth));
}

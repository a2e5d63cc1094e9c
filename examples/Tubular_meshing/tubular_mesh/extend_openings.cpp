// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../command_line/Points.h"
#include "stages.h"

#include <CGAL/Tubular_meshing/Openings/flow_extensions.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>

Flow_extensions extend_openings(const Options& o, Surface& surface, Stage_clock& clock) {
  Flow_extensions result;
  if (o.flow_extensions > 0) {
    clock.begin("flow extensions");
    result.openings =
        o.inlet.empty()
            ? tubular::find_openings(surface)
            : tubular::find_openings(surface, tubular::parameters::inlet(command_line::point_of<Point_3>(o.inlet)));
    result.lengths = tubular::add_flow_extensions(surface, result.openings,
                                                  tubular::parameters::extension_length(o.flow_extensions));
  }
  return result;
}

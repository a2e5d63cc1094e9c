// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include <CGAL/tubular_meshing.h>

tubular::Mixed_mesh<Point_3> make_mesh(const Options& o, const tubular::Tubular_model<Point_3>& model,
                                       Stage_clock& clock) {
  const auto np = tubular::parameters::points_per_circumference(o.points_per_circumference)
                      .min_size(o.min_size)
                      .max_size(o.max_size)
                      .gradation(o.gradation)
                      .number_of_threads(o.threads)
                      .observer([&](const char* stage) { clock.begin(stage); });
  return tubular::make_isotropic_mesh(model, np);
}

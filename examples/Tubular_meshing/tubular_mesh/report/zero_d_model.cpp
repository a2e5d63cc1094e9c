// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "zero_d_model.h"

#include <algorithm>
#include <cstdio>

namespace tubular = CGAL::Tubular_meshing;

void add_zero_d_model(Json& report, const tubular::Zero_d_model& model) {
  double resistance = 0;
  for (const auto& v : model.vessels)
    resistance = (std::max)(resistance, v.resistance);
  report["zero_d_model"] = {{"vessels", model.vessels.size()},
                            {"junctions", model.junctions.size()},
                            {"boundary_conditions", model.boundary_conditions.size()},
                            {"flow_rate", model.flow_rate},
                            {"largest_resistance", resistance},
                            {"openings_left_out", model.openings_left_out}};
}

void print_zero_d_model(const Json& m) {
  std::printf("0D model: %ld vessels, %ld junctions, %ld ends; flow at the inlet %g ml/s\n", m["vessels"].get<long>(),
              m["junctions"].get<long>(), m["boundary_conditions"].get<long>(), m["flow_rate"].get<double>());
}

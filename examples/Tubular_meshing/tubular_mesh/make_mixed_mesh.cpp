// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include <CGAL/Tubular_meshing/Pipelines/make_mixed_mesh.h>

tubular::Mixed_mesh make_mixed_mesh(const Options& o, const tubular::Tubular_model& model,
                                    tubular::Remeshed_surface& surface, tubular::Layer_report& boundary_layer,
                                    Stage_clock& clock) {
  return tubular::make_mixed_mesh(model, surface, lumen_parameters(o, boundary_layer, clock));
}

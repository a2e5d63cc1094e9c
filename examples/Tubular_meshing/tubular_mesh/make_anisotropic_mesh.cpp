// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include <CGAL/tubular_meshing.h>

tubular::Mixed_mesh make_anisotropic_mesh(const Options& o, const tubular::Tubular_model& model, Stage_clock& clock) {
  return tubular::make_anisotropic_mesh(model, metric_parameters(o, clock).volume_mesher(volume_mesher(o)));
}

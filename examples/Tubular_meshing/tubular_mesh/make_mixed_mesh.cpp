// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include <CGAL/Tubular_meshing/make_mixed_mesh.h>

tubular::Mixed_mesh<Point_3> make_mixed_mesh(const Options& o, const tubular::Tubular_model<Point_3>& model,
                                             tubular::Remeshed_surface<Point_3>& surface, Stage_clock& clock) {
  return tubular::make_mixed_mesh(model, surface, meshing_parameters(o, clock).volume_mesher(volume_mesher(o)));
}

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include <CGAL/Tubular_meshing/Pipelines/make_anisotropic_surface_mesh.h>
#include <CGAL/Tubular_meshing/Pipelines/make_isotropic_surface_mesh.h>
#include <CGAL/Tubular_meshing/Pipelines/make_quad_surface_mesh.h>

tubular::Remeshed_surface make_surface_mesh(const Options& o, const tubular::Tubular_model& model, Stage_clock& clock) {
  if (o.is_anisotropic_surface())
    return tubular::make_anisotropic_surface_mesh(model, metric_parameters(o, clock));
  const auto np = meshing_parameters(o, clock);
  return o.surface_elements == "quads" ? tubular::make_quad_surface_mesh(model, np)
                                       : tubular::make_isotropic_surface_mesh(model, np);
}

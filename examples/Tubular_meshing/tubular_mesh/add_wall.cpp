// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>

tubular::Layer_report add_wall(const Options& o, const tubular::Tubular_model& model, tubular::Mixed_mesh& mesh,
                               Stage_clock& clock) {
  clock.begin("wall");
  const auto or_as_the_wall = [](auto given, auto of_the_wall) { return given > 0 ? given : of_the_wall; };
  return tubular::extrude_wall(mesh, tubular::Centerline_field(model.centerlines),
                               tubular::parameters::wall_thickness(o.wall.thickness)
                                   .wall_layers(o.wall.number)
                                   .wall_growth(o.wall.growth)
                                   .tetrahedral_wall(o.wall_elements == "tetrahedra")
                                   .second_wall_thickness(o.second_wall.thickness)
                                   .second_wall_layers(or_as_the_wall(o.second_wall.number, o.wall.number))
                                   .second_wall_growth(or_as_the_wall(o.second_wall.growth, o.wall.growth))
                                   .number_of_threads(o.threads));
}

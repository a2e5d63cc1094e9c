// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stages.h"

#include <CGAL/tubular_meshing.h>

#include <cstddef>
#include <string>

namespace {

// The library's advice in the words of this tool.
std::string in_terms_of_options(std::string sentence) {
  const std::string function = "fill_with_mesh_3()", option = "--volume-mesher mesh_3";
  const std::size_t at = sentence.find(function);
  return at == std::string::npos ? sentence : sentence.replace(at, function.size(), option);
}

} // namespace

tubular::Volume_mesher volume_mesher(const Options& o) {
  if (o.volume_mesher.empty())
    return tubular::default_volume_mesher();
  return o.volume_mesher == "tetgen" ? tubular::Volume_mesher::tetgen
         : o.volume_mesher == "ccdt" ? tubular::Volume_mesher::ccdt
                                     : tubular::Volume_mesher::mesh_3;
}

std::string why_not_filled_by(const std::string& volume_mesher) {
  if (volume_mesher == "tetgen" && !tubular::has_tetgen())
    return "This program was built without TetGen; use --volume-mesher mesh_3, or build it where TetGen's library is "
           "installed (libtet1.5-dev).";
  if (volume_mesher == "ccdt" && !tubular::has_ccdt())
    return "This program was built with a version of CGAL before 6.1, which has no constrained triangulations in "
           "space; use --volume-mesher tetgen or mesh_3.";
  return "";
}

tubular::Mixed_mesh make_mesh(const Options& o, const tubular::Tubular_model& model, tubular::Remeshed_surface& surface,
                              tubular::Layer_report& boundary_layer, Stage_clock& clock) {
  if (!o.is_anisotropic() && !o.meshes_patches())
    return tubular::make_isotropic_mesh(model, meshing_parameters(o, clock));
  try {
    if (o.is_anisotropic())
      return make_anisotropic_mesh(o, model, clock);
    if (o.is_mixed())
      return make_mixed_mesh(o, model, surface, boundary_layer, clock);
    return tubular::make_isotropic_mesh(model, surface, lumen_parameters(o, boundary_layer, clock));
  } catch (const tubular::Meshing_error& e) {
    throw tubular::Meshing_error(in_terms_of_options(e.what()));
  }
}

// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hexahedra.h"

#include <cstdio>
#include <string>

namespace tubular = CGAL::Tubular_meshing;

namespace {

void print_places_without_blocks(const Json& places, bool has_blocks) {
  for (const auto& p : places) {
    std::printf("note: no blocks near (%g, %g, %g): %s", p["place"][0].get<double>(), p["place"][1].get<double>(),
                p["place"][2].get<double>(), p["reason"].get<std::string>().c_str());
    const long pyramids = p["pyramids"].get<long>(), tetrahedra = p["tetrahedra"].get<long>();
    if (has_blocks && pyramids + tetrahedra > 0)
      std::printf("; %ld pyramids and %ld tetrahedra there", pyramids, tetrahedra);
    else if (has_blocks)
      std::printf("; filled together with the place before");
    std::printf("\n");
  }
}

} // namespace

void add_hexahedral(Json& report, const tubular::Hexahedral_report& h) {
  Json places = Json::array();
  for (const auto& p : h.places_without_blocks)
    places.push_back(
        {{"place", vector_of(p.place)}, {"reason", p.reason}, {"pyramids", p.pyramids}, {"tetrahedra", p.tetrahedra}});
  report["hexahedral"] = {{"method", tubular::name_of(h.method)},
                          {"junctions", h.number_of_junctions},
                          {"places_without_blocks", places},
                          {"blocks", h.number_of_blocks},
                          {"points_per_circumference", h.points_per_circumference},
                          {"irregular_edges", h.irregular_edges},
                          {"twist", h.twist},
                          {"boundary",
                           {{"largest_shift", h.boundary.largest_shift},
                            {"vertices_not_found", h.boundary.not_found},
                            {"vertices_held_back", h.boundary.held_back}}},
                          {"optimization",
                           {{"min_scaled_jacobian_before", h.optimization.min_scaled_jacobian_before},
                            {"min_scaled_jacobian", h.optimization.min_scaled_jacobian},
                            {"mean_scaled_jacobian_before", h.optimization.mean_scaled_jacobian_before},
                            {"mean_scaled_jacobian", h.optimization.mean_scaled_jacobian},
                            {"inverted_before", h.optimization.inverted_before},
                            {"inverted", h.optimization.inverted},
                            {"vertices_left_off_surface", h.optimization.held_vertices}}}};
}

void print_hexahedral(const Json& h) {
  const bool has_blocks = h["method"] == "blocks";
  if (has_blocks)
    std::printf("%ld blocks of hexahedra, %ld points round each vessel, %ld junctions; %ld irregular edges inside\n",
                h["blocks"].get<long>(), h["points_per_circumference"].get<long>(), h["junctions"].get<long>(),
                h["irregular_edges"].get<long>());
  else
    std::printf("hexahedra by subdivision of tetrahedra and prisms\n");
  const Json& o = h["optimization"];
  std::printf("optimized, scaled Jacobian: %.3f at least, %.3f on average; before, %.3f and %.3f\n",
              o["min_scaled_jacobian"].get<double>(), o["mean_scaled_jacobian"].get<double>(),
              o["min_scaled_jacobian_before"].get<double>(), o["mean_scaled_jacobian_before"].get<double>());
  if (const long held = o["vertices_left_off_surface"].get<long>())
    std::printf(
        "note: %ld vertices of the boundary stay a little off the surface: on it, hexahedra would be inverted\n", held);
  print_places_without_blocks(h["places_without_blocks"], has_blocks);
  const long off = h["boundary"]["vertices_not_found"].get<long>() + h["boundary"]["vertices_held_back"].get<long>();
  if (off > 0)
    std::printf("note: %ld vertices could not go all of the way to the surface; cells would have turned over, or the "
                "wall met itself\n",
                off);
}
